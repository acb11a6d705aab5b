"""How the figures look; SVG files that are the same bytes from run to run."""

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

matplotlib.rcParams.update({
    "svg.hashsalt": "skylut",
    "font.size": 9,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "figure.constrained_layout.use": True,
})

COLOURS = ["#1b6ca8", "#d1495b", "#edae49", "#3a7d44", "#7a5195"]


def save(context, figure, name):
    """figures/<name>.svg for the report, and a PNG in the work folder to look at."""
    figure.savefig(context.figures / f"{name}.svg", metadata={"Date": None, "Creator": "tools/validate"})
    figure.savefig(context.work / f"{name}.png", dpi=110)
    plt.close(figure)

"""Published coefficients beside the table: Preetham 1999 and the UTM report."""

import json

from .text import Section, percent, table


def compared(context, against):
    return json.loads(context.program.run("compare", context.table(), "--against", against, "--json")[0])


def add_preetham(context, section):
    answer = compared(context, "preetham1999")
    rows = []
    for row in answer["rows"]:
        if row["sun_azimuth_deg"] > 180:
            continue  # the mirror image
        cells = [f"{row['turbidity']:g}", f"{row['preetham_t']:.2f}", f"{row['sun_zenith_deg']:g}",
                 f"{row['Y_zenith_kcd_m2']:.3g}",
                 f"{row['Y_zenith_kcd_m2_preetham1999']:.3g}", f"{row['x_zenith']:.3f}, {row['y_zenith']:.3f}",
                 f"{row['x_zenith_preetham1999']:.3f}, {row['y_zenith_preetham1999']:.3f}"]
        if row["rmse_Y_rel"] is None:
            cells += ["–", "–", "–", "–"]
        else:
            cells += [percent(row["rmse_Y_rel"]), percent(row["mean_Y_rel"], sign=True), f"{row['rmse_x']:.4f}",
                      f"{row['rmse_y']:.4f}"]
        rows.append(cells + [row["range"]])
    section.add("### Preetham, Shirley and Smits 1999 at 0 km")
    section.add("aod500 becomes Preetham's T = (τ_R + τ_A)/τ_R at 550 nm. Dome: root mean square over the 271 directions of "
                "our fitted sky against his, Y relative to his. His coefficients are meant for T = 2–6. Another atmosphere "
                "and another simulation: nothing here is tuned to it.")
    section.add(table(["aod500", "T", "sun/°", "Y zenith ours", "Preetham", "x, y ours", "Preetham", "dome Y",
                       "mean of Y", "dome x", "dome y", ""], rows))
    inside = [row for row in answer["rows"] if row["range"] == "in range"]
    if inside:
        worst = max(row["rmse_Y_rel"] for row in inside)
        section.check("Preetham 1999", f"{len(inside)} rows with T in 2–6", f"dome RMSE of Y up to {percent(worst)}",
                      "none: another atmosphere", None)


def add_utm(context, section):
    answer = compared(context, "utm2005")
    counts = {}
    for row in answer["rows"]:
        for verdict in row["verdict"].split("+"):
            counts[verdict] = counts.get(verdict, 0) + 1
    section.add("### UTM report 2005, appendix A")
    section.add("The legible published rows and what is impossible in each (`docs/errata.md`):")
    section.add("\n".join(f"- {note}" for note in answer["notes"]))
    section.add(table(["verdict", "rows"], [[name, count] for name, count in sorted(counts.items())]))
    plausible = sum(row["verdict"] == "plausible" for row in answer["rows"])
    section.check("UTM report 2005", f"{len(answer['rows'])} legible published rows",
                  f"{plausible} of theirs physically possible", "none: not reproducible", None)


def run(context):
    section = Section("Published models")
    add_preetham(context, section)
    add_utm(context, section)
    section.add("Rerun: `tools/validate --only models`; alone: `skylut compare DIR --against preetham1999`, `skylut "
                "compare DIR --against utm2005`.")
    return section

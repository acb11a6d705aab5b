"""Runs the sections and writes validation.md."""

import dataclasses
import importlib
import json
import pathlib
import platform
import sys

from . import text
from .program import Program, ProgramFailed

PROFILES = pathlib.Path(__file__).resolve().parents[2] / "profiles"

OPENING = """# Validation

How far skylut is from independent references: figures that `tools/validate` measures and writes here, with the commands that
measure them again. Errors are relative unless a unit says otherwise. *RMS, noise removed*: root of the mean square deviation less the
mean variance of a Monte Carlo reference. A direction passes if it is within max(3σ of the reference, x %).

The reference sets are not part of this repository: `--reference DIR` names a folder that holds `solver/` (libRadtran 2.0.2: MYSTIC in
spherical shells, DISORT with 64 streams; 41 cases) and `disort/` (DISORT's own test problems; 13 cases). Sections that need them
are skipped without it. Everything else needs only the program."""


@dataclasses.dataclass
class Context:
    """What every section gets."""

    program: Program
    reference: pathlib.Path
    figures: pathlib.Path
    profiles: pathlib.Path
    work: pathlib.Path
    quick: bool
    reuse_monte_carlo: bool
    made_tables: list = dataclasses.field(default_factory=list)

    def table(self):
        """The table of the UTM report's recipe with its maps, made once in a run."""
        folder = self.work / "table"
        if not self.made_tables:
            self.program.table(folder, "--directions", "utm271", "--save-maps")
            self.made_tables.append(folder)
        return folder

    def say(self, message):
        """Progress, on a terminal or in a log."""
        print(f"  {message}", file=sys.stderr, flush=True)


def processor():
    """The name of the processor, for the times."""
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.machine()


def run_section(name, context):
    """A section's parts as plain data; a failure of the program is itself a finding."""
    module = importlib.import_module("." + name.replace("-", "_"), __package__)
    try:
        section = module.run(context)
    except ProgramFailed as failure:
        section = text.Section(name)
        section.add(f"Could not be run: {failure}")
        section.check(name, "", "the program failed", "", False)
    return dataclasses.asdict(section)


def write(options, names):
    """Runs the sections asked for and puts the report together from them and what earlier runs left of the rest."""
    options.work.mkdir(parents=True, exist_ok=True)
    figures = options.out / "figures"
    figures.mkdir(parents=True, exist_ok=True)
    context = Context(Program(options.program), options.reference.resolve(), figures, PROFILES, options.work,
                      options.quick,
                      options.reuse_monte_carlo)
    for name in options.only:
        print(f"{name}", file=sys.stderr, flush=True)
        section = run_section(name, context)
        (options.work / f"{name}.json").write_text(json.dumps(section, indent=1), encoding="utf-8")
    sections = {}
    for name in names:
        kept = options.work / f"{name}.json"
        if kept.exists():
            sections[name] = json.loads(kept.read_text(encoding="utf-8"))
    path = options.out / "validation.md"
    path.write_text(page(sections, context), encoding="utf-8")
    verdicts = [check[-1] for section in sections.values() for check in section["checks"]]
    print(f"wrote {path}; {len(verdicts)} checks, {sum('no' in verdict for verdict in verdicts)} not met")


def page(sections, context):
    """The whole document."""
    blocks = [OPENING, f"skylut {context.program.version}; times are CPU seconds of one thread on {processor()}.",
              "## Summary"]
    blocks.append(text.table(["reference", "conditions", "our error", "tolerance", "met", "rerun"],
                             [[*check, f"`tools/validate --only {name}`"]
                              for name, section in sections.items() for check in section["checks"]]))
    missed = [check for section in sections.values() for check in section["checks"] if "no" in check[-1]]
    if missed:
        blocks.append("**What falls short:**")
        blocks.append("\n".join(f"- {reference} ({conditions}): {error}; asked for: {tolerance}."
                                for reference, conditions, error, tolerance, _ in missed))
    for number, section in enumerate(sections.values(), 1):
        blocks.append(f"## {number}. {section['title']}")
        blocks.extend(section["blocks"])
    return "\n\n".join(blocks) + "\n"

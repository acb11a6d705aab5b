"""Markdown: numbers, tables, sections."""

import dataclasses
import re


def percent(fraction, sign=False):
    """A fraction as a percentage with two significant digits or two decimals, whichever is shorter to read."""
    value = 100.0 * float(fraction)
    if value == 0.0:
        return "0 %"
    digits = 0 if abs(value) >= 100 else 1 if abs(value) >= 10 else 2 if abs(value) >= 0.1 else 3
    if abs(value) < 1e-3:
        return f"{value:+.1e} %" if sign else f"{value:.1e} %"
    return f"{value:+.{digits}f} %" if sign else f"{value:.{digits}f} %"


def table(header, rows):
    """A Markdown table; cells of numbers are aligned right."""
    def numeric(column):
        return bool(rows) and all(re.fullmatch(r"[-+<≤]?[\d.]+(e[-+]\d+)?( ?[%s])?|–|",
                                               str(row[column])) for row in rows)

    marks = ["--:" if numeric(i) else "---" for i in range(len(header))]
    lines = [header, marks, *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


@dataclasses.dataclass
class Section:
    """One section of the report, and its lines in the summary at the top."""

    title: str
    blocks: list = dataclasses.field(default_factory=list)
    checks: list = dataclasses.field(default_factory=list)

    def add(self, block):
        self.blocks.append(block)

    def figure(self, name, caption):
        self.blocks.append(f"![{name}](figures/{name}.svg)\n\n*{caption}.*")

    def check(self, reference, conditions, error, tolerance, passed):
        """A line of the summary; `passed` is None where there is nothing to pass."""
        verdict = {True: "yes", False: "**no**", None: "–"}[None if passed is None else bool(passed)]
        self.checks.append([reference, conditions, error, tolerance, verdict])

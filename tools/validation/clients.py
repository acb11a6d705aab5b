"""What renderers see of our pictures: tools/clients/check as a section."""

import json
import pathlib
import subprocess
import sys

from .text import Section, table

CHECK = pathlib.Path(__file__).resolve().parents[1] / "clients/check"


def run(context):
    section = Section("Pictures in other programs")
    found = context.work / "clients.json.findings"
    interpreter = "/usr/bin/python3" if pathlib.Path("/usr/bin/python3").exists() else sys.executable
    done = subprocess.run([interpreter, CHECK, "--program", context.program.path, "--work", context.work / "clients", "--json", found],
                          capture_output=True, text=True, check=False)
    if not found.exists():
        section.add(f"Could not be run: {done.stderr.strip()}")
        section.check("clients", "", "tools/clients/check failed", "", False)
        return section
    findings = json.loads(found.read_text(encoding="utf-8"))
    section.add("A sky with the sun at 55°, aerosol optical depth 0.1, loaded by other programs, which are asked for its radiance in ten "
                "directions and within 1° of the sun. Compared with our lines of sight there (`skylut map --directions --exact`), channel "
                "by channel in linear Rec. 709; the worst of each. White planes: against `skylut sun`. pbrt, Mitsuba and OpenEXR's latlong "
                "are looked up by a few lines of Python after their documentation, not by the programs themselves. Pictures: latlong 1536 "
                "rows, cube 768, octahedral 3072.")
    section.add(table(["what", "found", "asked for"], [[f["what"], f["found"], f["wanted"]] for f in findings]))
    skipped = [line for line in done.stdout.splitlines() if ": skipped: " in line]
    if skipped:
        section.add("Not installed, and so not asked: " + "; ".join(skipped) + ".")
    for client in dict.fromkeys(f["client"] for f in findings):
        own = [f for f in findings if f["client"] == client]
        missed = [f["what"] for f in own if not f["met"]]
        section.check(f"pictures in {client}", f"{len(own)} comparisons", "; ".join(missed) or "all met", "0.5 % radiance, see section",
                      not missed)
    section.add("Rerun: `tools/clients/check`, which says what each client needs.")
    return section

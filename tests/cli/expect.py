#!/usr/bin/env python3
"""Runs the program once in an empty folder and checks what a user sees of it.

    expect.py PROGRAM [--exit N] [--stderr REGEX] [--stdout REGEX] [--input NAME=TEXT]...
              [--folder NAME]... [--link NAME=TARGET]... [--stdout-to PATH] [--warning REGEX]
              [--memory-kb N] -- ARGUMENT...

With --exit other than 0: standard error must be exactly one line that begins with "skylut: " and
matches REGEX, standard output must be empty, and no file or folder may have appeared or changed.
With --warning one line "skylut: warning: ..." that matches it must come before that, without it none may.
The other tests of this folder import `Workplace`.
"""

import argparse
import pathlib
import re
import resource
import subprocess
import sys
import tempfile


class Workplace:
    """An empty folder in which the program runs."""

    def __init__(self, program):
        self.program = str(pathlib.Path(program).resolve())
        self._temporary = tempfile.TemporaryDirectory(prefix="skylut-test-")
        self.folder = pathlib.Path(self._temporary.name)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._temporary.cleanup()

    def path(self, name):
        return self.folder / name

    def write(self, name, text):
        self.path(name).parent.mkdir(parents=True, exist_ok=True)
        self.path(name).write_text(text, encoding="utf-8")

    def run(self, *arguments, stdout=subprocess.PIPE, memory_kb=None):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (memory_kb * 1024, memory_kb * 1024))
        return subprocess.run([self.program, *arguments], cwd=self.folder, stdout=stdout, stderr=subprocess.PIPE,
                              stdin=subprocess.DEVNULL, text=True, timeout=600, preexec_fn=limit if memory_kb else None)

    def succeed(self, *arguments, warning=None):
        """Runs the program, which must end with 0 and say nothing on standard error but, if that is expected,
        one warning."""
        result = self.run(*arguments)
        assert result.returncode == 0, f"{arguments}: exit {result.returncode}: {result.stderr}"
        rest, wrong = without_warning(result.stderr, warning)
        assert not wrong and rest == "", f"{arguments}: standard error: {result.stderr}"
        return result.stdout

    def contents(self):
        """Every file with its bytes, every folder and link with what it is."""
        found = {}
        for path in sorted(self.folder.rglob("*")):
            name = str(path.relative_to(self.folder))
            if path.is_symlink():
                found[name] = f"link to {path.readlink()}"
            else:
                found[name] = path.read_bytes() if path.is_file() else "folder"
        return found


def without_warning(text, regex):
    """Standard error without the one warning that is expected, and what is wrong about it."""
    if not regex:
        return text, "an unexpected warning" if "skylut: warning: " in text else ""
    first, _, rest = text.partition("\n")
    good = first.startswith("skylut: warning: ") and re.search(regex, first) and "skylut: warning: " not in rest
    return rest, "" if good else f"no single warning that matches {regex!r}"


def failures(result, before, after, options):
    """What is not as expected, one text each."""
    if result.returncode != options.exit:
        yield f"exit code {result.returncode}, expected {options.exit}"
    if options.stdout and not re.search(options.stdout, result.stdout or ""):
        yield f"standard output does not match {options.stdout!r}"
    errors, wrong = without_warning(result.stderr, options.warning)
    if wrong:
        yield wrong
    if options.exit == 0:
        if errors:
            yield "standard error is not empty"
        return
    lines = errors.split("\n")
    if len(lines) != 2 or lines[1] != "" or not lines[0].startswith("skylut: "):
        yield "standard error is not one line that begins with 'skylut: '"
    if not re.search(options.stderr, lines[0]):
        yield f"standard error does not match {options.stderr!r}"
    if result.stdout:
        yield "standard output is not empty"
    if before != after:
        changed = sorted(name for name in before.keys() | after.keys() if before.get(name) != after.get(name))
        yield f"left behind or changed: {', '.join(changed)}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--exit", type=int, default=0)
    parser.add_argument("--stderr", default="")
    parser.add_argument("--stdout", default="")
    parser.add_argument("--input", action="append", default=[])
    parser.add_argument("--folder", action="append", default=[])
    parser.add_argument("--link", action="append", default=[])
    parser.add_argument("--stdout-to")
    parser.add_argument("--warning", default="")
    parser.add_argument("--memory-kb", type=int)
    split = sys.argv.index("--")
    options = parser.parse_args(sys.argv[1:split])
    arguments = sys.argv[split + 1:]

    with Workplace(options.program) as work:
        for name, _, text in (entry.partition("=") for entry in options.input):
            work.write(name, text.replace("\\n", "\n"))
        for name in options.folder:
            work.path(name).mkdir(parents=True)
        for name, _, target in (entry.partition("=") for entry in options.link):
            work.path(name).parent.mkdir(parents=True, exist_ok=True)
            work.path(name).symlink_to(target)
        before = work.contents()
        if options.stdout_to:
            with open(options.stdout_to, "w", encoding="utf-8") as sink:
                result = work.run(*arguments, stdout=sink, memory_kb=options.memory_kb)
        else:
            result = work.run(*arguments, memory_kb=options.memory_kb)
        wrong = list(failures(result, before, work.contents(), options))
    if not wrong:
        return 0
    print("skylut", *arguments)
    print("\n".join(wrong))
    print(f"standard error was:\n{result.stderr}standard output was:\n{result.stdout}")
    return 1


if __name__ == "__main__":
    sys.exit(main())

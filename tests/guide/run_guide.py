#!/usr/bin/env python3
"""Does what the guide says: run_guide.py GUIDE STRIATE WORK [PAGE...]

Of every page of GUIDE, from top to bottom and in a folder of its own:
  ```sh                      is run by bash; it must end with exit code 0
  ```sh title="exit 2"       the same with another exit code
  ```sh title="elsewhere"    needs what a test has not (a robot, a screen): each of its commands and options must
                             be known to the program, which is asked by --help
  ```yaml title="FILE"       is written to FILE; so with every other language
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

BLOCK = re.compile(r"^```(\w+)(?: title=\"([^\"]+)\")?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def run(script, folder, environment, expected):
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=folder, env=environment, text=True,
                          stdin=subprocess.DEVNULL, capture_output=True, check=False)
    if done.returncode != expected:
        raise SystemExit(f"exit code {done.returncode}, not {expected}, of\n{script}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def ask(script, folder, environment):
    """Every line that calls the program is known to it."""
    for line in script.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        if not words or words[0] != "striate":
            continue
        told = run(shlex.join([*words[:2], "--help"]), folder, environment, 0)
        if words[1] in ("memory", "world", "task", "ros", "eval", "view"):
            continue  # commands of commands, and files first
        for option in (word.split("=")[0] for word in words if word.startswith("--")):
            if option not in told:
                raise SystemExit(f"'striate {words[1]}' has no {option}: {line}")


def walk(page, guide, environment, work):
    folder = work / page.stem
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    ran = 0
    content = page.read_text(encoding="utf-8")
    for language, title, text in BLOCK.findall(content):
        if language == "sh":
            ran += 1
            if title == "elsewhere":
                ask(text, folder, environment)
            else:
                run(text, folder, environment, int(title.split()[1]) if title else 0)
        elif title:
            (folder / title).parent.mkdir(parents=True, exist_ok=True)
            (folder / title).write_text(text, encoding="utf-8")
    if ran != len(re.findall(r"^ *```sh", content, re.MULTILINE)):
        raise SystemExit(f"{page}: a block is not written as this program reads them")
    print(f"{page.relative_to(guide)}: {ran} blocks")


def main():
    guide, striate, work = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    environment = dict(os.environ)
    environment["PATH"] = f"{striate.parent}:/usr/bin:{environment['PATH']}"  # the module is for Debian's Python
    environment["PYTHONPATH"] = str(striate.parent / "python")
    environment["XDG_CONFIG_HOME"] = str(work / "no_configuration")
    pages = [guide / f"{name}.md" for name in sys.argv[4:]] or sorted(guide.glob("*.md"))
    for page in pages:
        walk(page, guide, environment, work)


main()

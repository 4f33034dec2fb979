#!/usr/bin/env python3
"""Follows "Add a behaviour" of CONTRIBUTING.md letter by letter.

In a copy of behaviours/, the file that step 1 names gets the code that step 1 shows, and behaviours/registry.cpp
the two lines of step 2. Both are compiled as they would be in the tree and linked with the built libraries in a
program that reads a task script with the line of step 3. Fails where the text does not lead there.

usage: contributing_walk.py ROOT BUILD NINJA
"""
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

PROGRAM = r'''
#include <cstdio>
#include <string>

#include "striate/behaviours/registry.hpp"
#include "striate/config/diagnostics.hpp"
#include "striate/tasks/task_reader.hpp"

int main(int /*argc*/, char** argv) {
  striate::config::Diagnostics diagnostics("the script of step 3", 'T');
  const std::string script = std::string("striate: 1\nmission: walk\ndo:\n  ") + argv[1] + "\n";
  (void)striate::tasks::read_task(script, diagnostics, striate::RobotDescription{});
  std::fputs(diagnostics.text().c_str(), stderr);
  const auto* entry = striate::behaviours::find_behaviour(argv[2]);
  if (entry == nullptr || entry->parameters().empty() || entry->help.empty()) {
    std::fprintf(stderr, "'%s' is not listed with its parameters\n", argv[2]);
    return 1;
  }
  return diagnostics.none() ? 0 : 1;
}
'''


def fail(why):
    sys.exit(f"CONTRIBUTING.md, 'Add a behaviour': {why}")


def steps_of(text):
    """{number of a step: (its prose, [its blocks of code])}"""
    section = re.search(r"^## Add a behaviour\n(.*?)^## ", text, re.M | re.S)
    if not section:
        fail("there is no such section")
    steps = {}
    for part in re.split(r"^(?=\d\. )", section.group(1), flags=re.M)[1:]:
        blocks = re.findall(r"^   ```\w+\n(.*?)^   ```$", part, re.M | re.S)
        prose = re.sub(r"^   ```\w+\n.*?^   ```$", "", part, flags=re.M | re.S)
        steps[int(part[0])] = (prose, [re.sub(r"^ {1,3}", "", block, flags=re.M) for block in blocks])
    return steps


def only(blocks, count, step):
    if len(blocks) != count:
        fail(f"step {step} shows {len(blocks)} blocks of code, {count} are looked for")
    return blocks


def named(prose, pattern, step):
    found = re.search(pattern, prose)
    if not found:
        fail(f"step {step} does not say `{pattern}`")
    return found.group(1)


def follow(steps, tree):
    """Does steps 1 and 2 in the tree. @return the path of the registry"""
    prose, blocks = steps[1]
    with open(os.path.join(tree, named(prose, r"`(behaviours/\w+\.hpp)`", 1)), "x") as file:
        file.write(only(blocks, 1, 1)[0])
    prose, blocks = steps[2]
    registry = os.path.join(tree, named(prose, r"`(behaviours/\w+\.cpp)`", 2))
    place = named(prose, r"list of `(\w+)\(\)`", 2)
    include, entry = only(blocks, 2, 2)
    with open(registry) as file:
        text = file.read()
    beside = text.rindex('#include "striate/behaviours/')
    text = text[:beside] + include + text[beside:]
    listed = re.search(rf"{place}\(\) {{\n.*?\n((?=\s*behaviour_entry))", text, re.S)
    if not listed:
        fail(f"behaviours/registry.cpp has no list in {place}()")
    with open(registry, "w") as file:
        file.write(text[:listed.end()] + entry + text[listed.end():])
    return registry


def compile_like(build, target, include, what, output):
    """Compiles as a file of `target` is compiled in the build, but with other headers before its own."""
    with open(os.path.join(build, "compile_commands.json")) as file:
        commands = [entry["command"] for entry in json.load(file) if f"/{target}.dir/" in entry["command"]]
    words = shlex.split(next(command for command in commands if "-x c++-header" not in command))
    words = words[:words.index("-o")] + ["-O0", "-o", output, "-c", what]
    words = [word.replace(os.path.join(build, "include"), include) if word.startswith("-I") else word
             for word in words]
    if subprocess.run(words, cwd=build).returncode != 0:
        fail("what it says does not compile")


def link_like(build, ninja, target, objects, output):
    lines = subprocess.run([ninja, "-C", build, "-t", "commands", target], check=True, capture_output=True,
                           text=True).stdout.strip().splitlines()
    words = shlex.split(lines[-1].split("&&")[1])
    at = words.index("-o")
    words[at + 1] = output
    words = [word for word in words if not word.endswith(".o")]
    at = words.index("-o")
    # The changed registry goes before the library's own, which is compiled together with other files.
    objects = objects + ["-Wl,--allow-multiple-definition"]
    if subprocess.run(words[:at] + objects + words[at:], cwd=build).returncode != 0:
        fail("what it says does not link")


def main(root, build, ninja):
    with open(os.path.join(root, "CONTRIBUTING.md")) as file:
        steps = steps_of(file.read())
    for step in (1, 2, 3):
        if step not in steps:
            fail(f"there is no step {step}")
    with tempfile.TemporaryDirectory() as scratch:
        tree = os.path.join(scratch, "include", "striate")
        os.makedirs(tree)
        for folder in os.listdir(os.path.join(build, "include", "striate")):
            if folder != "behaviours":
                os.symlink(os.path.join(root, folder), os.path.join(tree, folder))
        shutil.copytree(os.path.join(root, "behaviours"), os.path.join(tree, "behaviours"))
        registry = follow(steps, tree)
        program = os.path.join(scratch, "program.cpp")
        with open(program, "w") as file:
            file.write(PROGRAM)
        objects = []
        for source in (registry, program):
            objects.append(os.path.join(scratch, os.path.basename(source) + ".o"))
            compile_like(build, "striate_behaviours", os.path.join(scratch, "include"), source, objects[-1])
        walk = os.path.join(scratch, "walk")
        link_like(build, ninja, "tests/unit_tasks", objects, walk)
        line = only(steps[3][1], 1, 3)[0].strip()
        name = re.match(r"- (\w+)", line)
        if not name or subprocess.run([walk, line, name.group(1)]).returncode != 0:
            fail("the script of step 3 cannot be read")


if __name__ == "__main__":
    main(*sys.argv[1:4])

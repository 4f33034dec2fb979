#!/usr/bin/env python3
"""Who may include whom.

Reads every #include "striate/..." of the layers and fails where a layer includes one that the table in
the root CMakeLists.txt does not allow, and where files of one layer include each other in a ring: a
header and its source count as one, so `a.cpp -> b.hpp -> a.hpp` is a ring, too. A `-inl.hpp` is a part of the one
file that includes it.

usage: include_rule.py ROOT "layer folder allowed,allowed|layer folder ..."
"""
import collections
import os
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include "striate/([^"]+)"', re.M)


def read_table(text):
    """{layer: (folder, {allowed layers})}"""
    table = {}
    for row in text.split("|"):
        fields = row.split(" ")
        allowed = fields[2].split(",") if len(fields) > 2 and fields[2] else []
        table[fields[0]] = (fields[1], set(allowed))
    return table


def layer_of(path, table):
    fitting = [name for name, (folder, _) in table.items() if path.startswith(folder + "/")]
    return max(fitting, key=lambda name: len(table[name][0]), default=None)


def sources(root, folder):
    for where, _, names in os.walk(os.path.join(root, folder)):
        for name in sorted(names):
            if name.endswith((".hpp", ".cpp")) and not name.endswith("-inl.hpp"):
                yield os.path.relpath(os.path.join(where, name), root)


def rings(graph):
    """Strongly connected parts of more than one node (Tarjan)."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in sorted(graph[node]):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            ring = []
            while True:
                ring.append(stack.pop())
                if ring[-1] == node:
                    break
            if len(ring) > 1:
                found.append(sorted(ring))

    for node in sorted(graph):
        if node not in index:
            visit(node)
    return found


def main():
    root, table = sys.argv[1], read_table(sys.argv[2])
    if len(table) < 12:
        sys.exit(f"the layer table was not understood: {sys.argv[2]}")
    sys.setrecursionlimit(10000)
    wrong, read = [], 0
    graph = collections.defaultdict(set)
    for layer, (folder, allowed) in table.items():
        for path in sources(root, folder):
            if layer_of(path, table) != layer:
                continue
            read += 1
            stem = re.sub(r"\.[ch]pp$", "", path)
            with open(os.path.join(root, path), encoding="utf-8") as file:
                text = file.read()
            for target in INCLUDE.findall(text):
                other = layer_of(target, table)
                if other is None:
                    wrong.append(f"{path}: {target} belongs to no layer")
                elif other != layer and other not in allowed:
                    wrong.append(f"{path}: layer {layer} may not include {other} ({target})")
                elif other == layer:
                    target_stem = re.sub(r"\.[ch]pp$", "", target)
                    if target_stem != stem:
                        graph[stem].add(target_stem)
                        graph[target_stem]
    wrong += ["a ring of includes: " + " <-> ".join(ring) for ring in rings(graph)]
    if read < 500:
        wrong.append(f"only {read} files were found below {root}")
    if wrong:
        sys.exit("include rule broken:\n  " + "\n  ".join(wrong))
    print(f"include rule: {read} files of {len(table)} layers are clean")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""`striate eval odometry` against figures that are computed here in another way.

Trajectories with noise, drift, missing and repeated times and lines that are no numbers are written as
TUM, KITTI and EuRoC; ATE (Horn's quaternion and power iteration instead of a singular value
decomposition), RPE and KITTI's figures are computed from their definitions and compared.

usage: odometry_by_hand.py STRIATE
"""
import json
import math
import os
import random
import subprocess
import sys
import tempfile


def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(len(b))) for j in range(len(b[0]))] for i in range(len(a))]


def transposed(a):
    return [list(row) for row in zip(*a)]


def apply(r, v):
    return [sum(r[i][k] * v[k] for k in range(3)) for i in range(3)]


def turn(axis, angle):
    n = math.sqrt(sum(x * x for x in axis))
    x, y, z = (v / n for v in axis)
    c, s = math.cos(angle), math.sin(angle)
    d = 1 - c
    return [[c + x * x * d, x * y * d - z * s, x * z * d + y * s],
            [y * x * d + z * s, c + y * y * d, y * z * d - x * s],
            [z * x * d - y * s, z * y * d + x * s, c + z * z * d]]


def quaternion(r):
    """x y z w by the eigenvector of Bar-Itzhack's matrix, with power iteration: slow and plain."""
    k = [[r[0][0] - r[1][1] - r[2][2], r[1][0] + r[0][1], r[2][0] + r[0][2], r[2][1] - r[1][2]],
         [r[1][0] + r[0][1], r[1][1] - r[0][0] - r[2][2], r[2][1] + r[1][2], r[0][2] - r[2][0]],
         [r[2][0] + r[0][2], r[2][1] + r[1][2], r[2][2] - r[0][0] - r[1][1], r[1][0] - r[0][1]],
         [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1], r[0][0] + r[1][1] + r[2][2]]]
    return largest([[v / 3 for v in row] for row in k])


def largest(matrix):
    """Eigenvector of the largest eigenvalue of a symmetric 4x4 matrix: by repeated squaring."""
    shift = 1 + max(sum(abs(v) for v in row) for row in matrix)
    m = [[matrix[i][j] + (shift if i == j else 0) for j in range(4)] for i in range(4)]
    for _ in range(60):
        m = multiply(m, m)
        most = max(abs(v) for row in m for v in row)
        m = [[v / most for v in row] for row in m]
    best = max(range(4), key=lambda j: m[j][j])
    v = [m[i][best] for i in range(4)]
    n = math.sqrt(sum(x * x for x in v))
    return [x / n for x in v]


def rotation(q):
    x, y, z, w = q
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]


def horn(truth, estimate):
    """Rotation and shift of the estimate onto the truth (Horn 1987)."""
    n = len(truth)
    a = [sum(p[i] for p in estimate) / n for i in range(3)]
    b = [sum(p[i] for p in truth) / n for i in range(3)]
    s = [[sum((e[i] - a[i]) * (t[j] - b[j]) for e, t in zip(estimate, truth)) for j in range(3)] for i in range(3)]
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = s
    big = max(abs(v) for row in s for v in row)
    m = [[xx + yy + zz, yz - zy, zx - xz, xy - yx],
         [yz - zy, xx - yy - zz, xy + yx, zx + xz],
         [zx - xz, xy + yx, yy - xx - zz, yz + zy],
         [xy - yx, zx + xz, yz + zy, zz - xx - yy]]
    w, x, y, z = largest([[v / big for v in row] for row in m])
    r = rotation([x, y, z, w])
    return r, [b[i] - apply(r, a)[i] for i in range(3)]


def angle(r):
    return math.acos(max(-1.0, min(1.0, 0.5 * (r[0][0] + r[1][1] + r[2][2] - 1))))


def relative(a, b):
    """Pose b seen from pose a."""
    back = transposed(a[0])
    return multiply(back, b[0]), apply(back, [b[1][i] - a[1][i] for i in range(3)])


def error(truth_a, truth_b, estimate_a, estimate_b):
    r, t = relative(relative(estimate_a, estimate_b), relative(truth_a, truth_b))
    return math.sqrt(sum(v * v for v in t)), math.degrees(angle(r))


def scores(times, truth, estimate):
    r, t = horn([p[1] for p in truth], [p[1] for p in estimate])
    off = []
    for a, b in zip(truth, estimate):
        moved = apply(r, b[1])
        off.append(math.sqrt(sum((moved[i] + t[i] - a[1][i]) ** 2 for i in range(3))))
    rpe = []
    for i in range(len(times)):
        j = next((k for k in range(i, len(times)) if times[k] - times[i] >= 1.0 - 1e-9), None)
        if j is not None and times[j] - times[i] <= 1.5 + 1e-9:
            rpe.append(error(truth[i], truth[j], estimate[i], estimate[j]))
    ways = [0.0]
    for a, b in zip(truth, truth[1:]):
        ways.append(ways[-1] + math.sqrt(sum((b[1][i] - a[1][i]) ** 2 for i in range(3))))
    stretches = []
    for length in range(100, 900, 100):
        for first in range(0, len(truth), 10):
            last = next((k for k in range(first, len(truth)) if ways[k] > ways[first] + length), None)
            if last is not None:
                e = error(truth[first], truth[last], estimate[first], estimate[last])
                stretches.append((100 * e[0] / length, e[1] / length))

    def rmse(values):
        return math.sqrt(sum(v * v for v in values) / len(values))

    return {"ate": rmse(off), "most": max(off), "rpe_m": rmse([e[0] for e in rpe]),
            "rpe_deg": rmse([e[1] for e in rpe]), "rpe_count": len(rpe),
            "percent": sum(s[0] for s in stretches) / len(stretches),
            "deg_per_m": sum(s[1] for s in stretches) / len(stretches)}


def drive(seed, poses):
    """A way with hills and bends, and an estimate that drifts, trembles and lives in another frame."""
    rng = random.Random(seed)
    truth, estimate = [], []
    at, heading = [0.0, 0.0, 0.0], 0.0
    guess, guess_r = [0.0, 0.0, 0.0], turn([0, 0, 1], 0.0)
    other_r, other_t = turn([rng.gauss(0, 1) for _ in range(3)], rng.uniform(0, 3)), [rng.uniform(-50, 50) for _ in range(3)]
    for k in range(poses):
        r = multiply(turn([0, 0, 1], heading), turn([0, 1, 0], 0.1 * math.sin(0.05 * k)))
        truth.append((r, list(at)))
        estimate.append((multiply(other_r, guess_r), [a + b for a, b in zip(apply(other_r, guess), other_t)]))
        step = apply(r, [1.1, 0, 0])
        at = [a + s for a, s in zip(at, step)]
        heading += 0.02 * math.sin(0.01 * k) + 0.004
        next_r = multiply(turn([0, 0, 1], heading), turn([0, 1, 0], 0.1 * math.sin(0.05 * (k + 1))))
        felt = multiply(multiply(transposed(r), next_r), turn([rng.gauss(0, 1) for _ in range(3)], rng.gauss(0.0003, 0.002)))
        guess = [a + s for a, s in zip(guess, apply(guess_r, [1.1 * rng.gauss(1.01, 0.02), rng.gauss(0, 0.01), 0]))]
        guess_r = multiply(guess_r, felt)
    return truth, estimate


def tum(times, poses):
    return "".join("%.6f %.12f %.12f %.12f %s\n" % (t, *p[1], " ".join("%.12f" % v for v in quaternion(p[0])))
                   for t, p in zip(times, poses))


def kitti(poses):
    return "".join(" ".join("%.12e" % v for i in range(3) for v in p[0][i] + [p[1][i]]) + "\n" for p in poses)


def euroc(times, poses):
    lines = "#timestamp [ns],px,py,pz,qw,qx,qy,qz,vx,vy,vz\r\n"
    for t, p in zip(times, poses):
        x, y, z, w = quaternion(p[0])
        lines += "%d,%s,0,0,0\r\n" % (round(t * 1e6) * 1000, ",".join("%.12f" % v for v in p[1] + [w, x, y, z]))
    return lines


def run(striate, folder, estimate, truth, *more):
    words = [striate, "eval", "odometry", estimate, "--truth", truth, "--json", "--out", os.path.join(folder, "out"), *more]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit("%s\n%s" % (" ".join(words), done.stderr))
    return json.loads(done.stdout), done.stderr


def compare(name, told, ours):
    pairs = [("ATE rmse", told["ate_m"]["rmse"], ours["ate"]), ("ATE most", told["ate_m"]["max"], ours["most"]),
             ("RPE m", told["rpe_m"]["rmse"], ours["rpe_m"]), ("RPE deg", told["rpe_deg"]["rmse"], ours["rpe_deg"]),
             ("RPE count", told["rpe_m"]["count"], ours["rpe_count"]),
             ("percent", told["kitti_percent"], ours["percent"]), ("deg per m", told["kitti_deg_per_m"], ours["deg_per_m"])]
    for what, theirs, mine in pairs:
        if abs(theirs - mine) > 1e-5 * max(1.0, abs(mine)):
            sys.exit("%s: %s is %.9g, by hand %.9g" % (name, what, theirs, mine))
    print("%s: " % name + ", ".join("%s %.6g" % (what, mine) for what, _, mine in pairs))


def main():
    striate = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:

        def write(name, text):
            path = os.path.join(folder, name)
            with open(path, "w", newline="") as file:
                file.write(text)
            return path

        for seed in range(3):
            truth, estimate = drive(seed, 320)
            times = [1403636580.0 + 0.1 * k for k in range(len(truth))]
            by_hand = scores(times, truth, estimate)
            told, _ = run(striate, folder, write("e.tum", tum(times, estimate)), write("t.csv", euroc(times, truth)))
            compare("TUM against EuRoC, seed %d" % seed, told, by_hand)
            # In an estimate some poses are missing, some stand twice, some are no numbers.
            rng = random.Random(100 + seed)
            keep = [k for k in range(len(truth)) if rng.random() > 0.2]
            lines = tum([times[k] for k in keep], [estimate[k] for k in keep]).splitlines()
            lines.insert(40, lines[39].replace(lines[39].split()[1], "7"))
            lines.insert(90, lines[91].split()[0] + " nan 0 0 0 0 0 1")
            lines.insert(120, "# a remark")
            some = [keep, [truth[k] for k in keep], [estimate[k] for k in keep]]
            told, said = run(striate, folder, write("e.tum", "\r\n".join(lines)), os.path.join(folder, "t.csv"))
            compare("with gaps, seed %d" % seed, told, scores([times[k] for k in some[0]], some[1], some[2]))
            if "no pose" not in said or "time of another" not in said:
                sys.exit("what was left out is not said:\n" + said)
            told, _ = run(striate, folder, write("e.txt", kitti(estimate)), write("k.txt", kitti(truth)), "--over-s", "10")
            # Without times a pose is a second: ten of them are one of these seconds.
            compare("KITTI, seed %d" % seed, told, by_hand)


main()

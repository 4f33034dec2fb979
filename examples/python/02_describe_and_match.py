"""Keypoints of both eyes, matched by their 256-bit descriptors, and how far away they are."""

import numpy as np
import striate

world = striate.Simulator("short")
for _ in range(12):
    senses = world.step()

left = striate.keypoints_to_learn(senses.left)
right = striate.keypoints_to_learn(senses.right)
found = striate.match_nearest(left.descriptors, right.descriptors, below_bits=80)
sure = found["first_bits"] < 0.8 * found["second_bits"]
here, there = left.points[sure], right.points[found["first"][sure]]

same_row = np.abs(here["v_px"] - there["v_px"]) < 2.0  # of a rectified pair
disparity_px = (here["u_px"] - there["u_px"])[same_row]
depth_m = senses.focal_px * senses.baseline_m / disparity_px[disparity_px > 1.0]
print(f"{len(left)} and {len(right)} keypoints, {sure.sum()} matched, {same_row.sum()} of them on one row")
print(f"they are {np.percentile(depth_m, 10):.1f} m to {np.percentile(depth_m, 90):.1f} m away")
assert same_row.sum() > 0.5 * sure.sum() > 10

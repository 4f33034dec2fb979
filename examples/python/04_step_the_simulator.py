"""A robot that you drive yourself: it turns away from what its vision sees ahead."""

import numpy as np
import striate

world = striate.Simulator("short", seed=4)
senses = world.step()
while world.now_s < 8.0 and not world.over:
    command = {"forward_m_s": 0.4}
    if senses.left is not None:
        percept = striate.perceive(senses.left, senses.right, focal_px=senses.focal_px, baseline_m=senses.baseline_m,
                                   camera_height_m=1.2, tilt_deg=-13.0)
        ahead = np.abs(percept.columns["bearing_rad"]) < 0.3
        nearest_m = percept.columns["obstacle_m"][ahead].min()
        if nearest_m < 2.0:
            command = {"forward_m_s": 0.15, "turn_rad_s": 0.4}
    senses = world.step(**command)
print(f"after {world.now_s:.1f} s at {world.pose}, {world.clearance_m:.2f} m from the nearest thing")
assert not world.collisions, world.collisions

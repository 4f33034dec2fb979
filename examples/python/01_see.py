"""An image pair in; what stands in the way and where the corridor leads out."""

import math

import striate

# Two rectified images with their camera: here the simulated robot's, 3 m before a box.
world = striate.Simulator("short", start=striate.Pose(3.3, 0.0, 0.0))
for _ in range(12):  # the exposure settles
    senses = world.step()

percept = striate.perceive(
    senses.left,
    senses.right,
    focal_px=senses.focal_px,
    baseline_m=senses.baseline_m,
    camera_height_m=world.robot.camera_height_m,
    tilt_deg=math.degrees(senses.image_tilt_rad),
)
for thing in percept.obstacles:
    print(f"{thing['distance_m']:.2f} m away, {math.degrees(thing['bearing_rad']):+.0f} deg: "
          f"something {thing['width_m']:.2f} m wide and {thing['height_m']:.2f} m high")
if percept.corridor:
    print(f"the corridor leads {math.degrees(percept.corridor.heading_rad):+.1f} deg from straight ahead")
print(f"the floor is seen free in {(percept.columns['free_to_m'] > 0).sum()} of {len(percept.columns)} columns")

nearest_m = percept.obstacles["distance_m"].min()
assert abs(nearest_m - 3.0) < 0.3, nearest_m  # the box's near side

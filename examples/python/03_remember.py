"""Looks into a memory and recognises what it knows. usage: 03_remember.py MEMORY PICTURE"""

import sys

import striate

if len(sys.argv) != 3:
    sys.exit("usage: 03_remember.py MEMORY PICTURE\n"
             "    striate teach book --image cover.png --memory home.db makes a memory")
picture = striate.read_image(sys.argv[2])
with striate.Memory(sys.argv[1]) as memory:
    for landmark in memory.landmarks():
        print(f"{landmark.name}: {landmark.kind}, strength {landmark.strength:.2f}, {landmark.views} views, "
              f"{landmark.keypoints} keypoints")
    for thing in memory.recognise(picture):
        corners = ", ".join(f"({u:.0f}, {v:.0f})" for u, v in thing.quad)
        print(f"{thing.name} is at {corners}: {thing.inliers} keypoints agree")

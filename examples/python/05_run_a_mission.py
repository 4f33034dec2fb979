"""A mission in the simulator, with a callback that looks on and a pilot that drives for a while."""

import pathlib
import tempfile

import striate

TASK = """
striate: 1
mission: from python
goal: line
vars: {way: 10 m}
do:
  - traverse_corridor: {speed: 0.5 m/s}
    until: {progress: $way}
    within: 2 min
finally:
  - stop: {}
"""


def look(cycle):
    """Every two seconds: where the robot is, what it does and why."""
    if cycle.number % 20 == 0:
        print(f"{cycle.senses.now_s:5.1f} s  {cycle.progress_m:4.1f} m  {cycle.senses.forward_m_s:.2f} m/s  "
              f"{len(cycle.percept.obstacles)} obstacles  {cycle.driver}: {cycle.doing}")


def pilot(memory):
    """Waits for a second before it lets the task drive."""
    return striate.Wish(why="waits") if memory.now_s < 1.0 else None


with tempfile.TemporaryDirectory() as folder:
    task = pathlib.Path(folder, "task.yaml")
    task.write_text(TASK)
    result = striate.run(task, world="short", seed=3, each_cycle=look, pilot=pilot)
print(f"{result.outcome} after {result.distance_m:.1f} m and {result.duration_s:.1f} s; "
      f"nearest pass {result.nearest_pass_m:.2f} m")
assert result.outcome == "success", result

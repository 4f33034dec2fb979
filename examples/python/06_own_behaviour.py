"""A behaviour and a condition of your own, in a task script."""

import pathlib
import tempfile

import striate


@striate.behaviour("arc", main="by", motors="wheels", arguments={
    "by": striate.Argument(0.5, "angle", -6.3, 6.3, "how far it turns; negative: to the right"),
    "radius": striate.Argument(1.0, "length", 0.2, 20.0, "of the arc"),
    "speed": striate.Argument(0.3, "speed", 0.05, 0.75, "along it"),
})
class Arc:
    """Drives along an arc."""

    def __init__(self, arguments, robot):
        self.by_rad = arguments["by"]
        self.speed_m_s = min(arguments["speed"], robot.max_forward_m_s)
        self.turn_rad_s = self.speed_m_s / arguments["radius"] * (1 if self.by_rad > 0 else -1)

    def start(self, memory):
        self.begin_rad = memory.pose.heading_rad

    def tick(self, memory):
        """Once a cycle. It says what it wants; the safety limiter may let less of it through."""
        if abs(memory.pose.heading_rad - self.begin_rad) >= abs(self.by_rad):
            return striate.Wish(progress="succeeded", why="the arc is driven")
        return striate.Wish(forward_m_s=self.speed_m_s, turn_rad_s=self.turn_rad_s, why="drives an arc")


@striate.condition("is_left_of", unit="length", low=-2.0, high=2.0, example="0.3 m")
def is_left_of(memory, limit):
    """The robot is so far left of the corridor's middle."""
    return memory.corridor["offset_left_m"] > limit


with tempfile.TemporaryDirectory() as folder:
    task = pathlib.Path(folder, "task.yaml")
    task.write_text("""
striate: 1
mission: swerve
goal: steps
do:
  - arc: {by: 60 deg, radius: 1.5 m}
    until: {is_left_of: 0.15 m}
  - arc: {by: -20 deg, radius: 1.5 m}
finally:
  - stop: {}
""")
    said = []
    result = striate.run(task, world="short", seed=3, each_cycle=lambda cycle: said.append(cycle.wish.why))
print(result.outcome, f"after {result.distance_m:.2f} m")
assert result.outcome == "success" and "drives an arc" in said, result

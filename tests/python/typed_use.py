"""Code as people write it, for the type checker alone."""

import pathlib

import numpy as np

import striate


def nearest(left: np.ndarray[tuple[int, ...], np.dtype[np.uint8]]) -> float:
    percept = striate.perceive(left, None, mode="paper", focal_px=500, baseline_m=0.12)
    if percept.corridor is not None:
        print(percept.corridor.heading_rad)
    return float(percept.obstacles["distance_m"][0])


@striate.behaviour("nod", arguments={"tilt": striate.Argument(0.2, "angle", 0.0, 0.5, "how far")}, motors="head")
class Nod:
    def __init__(self, arguments: dict[str, float], robot: striate.Robot) -> None:
        self.tilt_rad = arguments["tilt"]

    def tick(self, memory: striate.ShortTermMemory) -> striate.Wish:
        return striate.Wish(tilt_rad=self.tilt_rad, progress="succeeded")


def look(cycle: striate.Cycle) -> bool:
    return cycle.number < 10 and cycle.memory.light_level > 0.1


def drive(file: pathlib.Path) -> str:
    result = striate.run("corridor", world=file, start=striate.Pose(1.0, 0.0, 0.0), each_cycle=look)
    with striate.Memory(file) as memory:
        names = [one.name for one in memory.landmarks()]
    return ", ".join([result.outcome, *names])

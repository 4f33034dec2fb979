"""Striate: a cognitive robot that sees with a model of the visual cortex.

    import striate
    percept = striate.perceive(left, right, focal_px=500, baseline_m=0.12, camera_height_m=1.2)
    percept.disparity_px, percept.obstacles, percept.salience

Images are numpy arrays of uint8, (height, width) or (height, width, 3); colours are BGR, as OpenCV
has them, unless channels='rgb' says otherwise. Quantities are SI units and radians and say so in
their names. The robot frame has x forward and y left, angles are counter-clockwise.
"""

from . import _place
from ._additions import Argument, behaviour, condition
from ._errors import Problem, UserError
from ._memory import Memory
from ._missions import run
from ._records import (
    Episode,
    KnownThing,
    Landmark,
    ObstacleCell,
    Record,
    Route,
    RunResult,
    Session,
)
from ._striate import (
    GRID_CELL_M,
    OBSTACLE_CELL_M,
    Command,
    Corridor,
    Cycle,
    Keypoints,
    Perceiver,
    Percept,
    Pose,
    RecordedCycle,
    Recording,
    Robot,
    Senses,
    ShortTermMemory,
    Simulator,
    V1Responses,
    View,
    Wish,
    __version__,
    actions,
    conditions,
    keypoints,
    keypoints_to_learn,
    match_below,
    match_nearest,
    perceive,
    read_image,
    read_pair,
    use_plugin,
    v1_responses,
)

_place.tell()

__all__ = [
    "Argument",
    "Command",
    "Corridor",
    "Cycle",
    "Episode",
    "GRID_CELL_M",
    "Keypoints",
    "KnownThing",
    "Landmark",
    "Memory",
    "OBSTACLE_CELL_M",
    "ObstacleCell",
    "Perceiver",
    "Percept",
    "Pose",
    "Problem",
    "Record",
    "RecordedCycle",
    "Recording",
    "Robot",
    "Route",
    "RunResult",
    "Senses",
    "Session",
    "ShortTermMemory",
    "Simulator",
    "UserError",
    "V1Responses",
    "View",
    "Wish",
    "__version__",
    "actions",
    "behaviour",
    "condition",
    "conditions",
    "keypoints",
    "keypoints_to_learn",
    "match_below",
    "match_nearest",
    "perceive",
    "read_image",
    "read_pair",
    "run",
    "use_plugin",
    "v1_responses",
]

"""Types of the module. Descriptions stand in the docstrings: help(striate)."""

import os
from collections.abc import Callable, Iterator, Sequence
from types import TracebackType
from typing import Any, Final, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

__version__: str
GRID_CELL_M: float
OBSTACLE_CELL_M: float

_Path = str | os.PathLike[str]
_Image = NDArray[np.uint8]
_Records = NDArray[np.void]
_Channels = Literal["bgr", "rgb"]
_Made = TypeVar("_Made")

class Problem:
    file: str
    line: int
    column: int
    message: str
    def __init__(self, file: str, line: int, column: int, message: str) -> None: ...

class UserError(ValueError):
    problems: Final[list[Problem]]
    file: Final[str | None]
    line: Final[int | None]
    column: Final[int | None]

class Pose:
    def __init__(self, x_m: float = ..., y_m: float = ..., heading_rad: float = ...) -> None: ...
    x_m: Final[float]
    y_m: Final[float]
    heading_rad: Final[float]
    def __iter__(self) -> Iterator[float]: ...

class Robot:
    front_m: Final[float]
    rear_m: Final[float]
    half_width_m: Final[float]
    max_forward_m_s: Final[float]
    max_turn_rad_s: Final[float]
    max_acceleration_m_s2: Final[float]
    camera_height_m: Final[float]
    camera_forward_m: Final[float]
    view_rad: Final[float]
    resting_tilt_rad: Final[float]
    max_pan_rad: Final[float]
    max_tilt_rad: Final[float]
    cycle_s: Final[float]

class Corridor:
    heading_rad: Final[float]
    left_m: Final[float]
    right_m: Final[float]
    confidence: Final[float]

class Percept:
    disparity_px: Final[NDArray[np.float32]]
    confidence: Final[NDArray[np.float32]]
    salience: Final[NDArray[np.float32]]
    columns: Final[_Records]
    obstacles: Final[_Records]
    moving: Final[_Records]
    regions: Final[_Records]
    keypoints: Final[_Records]
    descriptors: Final[NDArray[np.uint8]]
    stamp_s: Final[float]
    corridor: Final[Corridor | None]
    light_level: Final[float]
    noise_level: Final[float]
    right_lower_px: Final[float]
    focal_px: Final[float]
    centre_u_px: Final[float]
    centre_v_px: Final[float]
    baseline_m: Final[float]
    unit: Final[str]
    method: Final[str]
    floor_known: Final[bool]
    doffs_px: Final[float]
    warnings: Final[list[str]]
    def write(self, folder: _Path, left: _Path = ..., right: _Path = ...) -> None: ...
    def overview(self) -> _Image: ...

class Perceiver:
    def __init__(
        self,
        *,
        mode: Literal["robust", "paper"] | None = ...,
        width_px: int | None = ...,
        candidates: int | None = ...,
        focal_px: float | None = ...,
        baseline_m: float | None = ...,
        centre_u_px: float | None = ...,
        centre_v_px: float | None = ...,
        right_centre_u_px: float | None = ...,
        doffs_px: float | None = ...,
        camera_height_m: float | None = ...,
        tilt_deg: float | None = ...,
        near_px: float | None = ...,
        calibration: _Path | Sequence[_Path] | None = ...,
        rectified: bool | None = ...,
        exchanged: bool | None = ...,
    ) -> None: ...
    def see(self, left: _Image, right: _Image | None = ..., *, channels: _Channels = ...) -> Percept: ...
    remarks: Final[list[str]]

def perceive(
    left: _Image,
    right: _Image | None = ...,
    *,
    channels: _Channels = ...,
    mode: Literal["robust", "paper"] | None = ...,
    width_px: int | None = ...,
    candidates: int | None = ...,
    focal_px: float | None = ...,
    baseline_m: float | None = ...,
    centre_u_px: float | None = ...,
    centre_v_px: float | None = ...,
    right_centre_u_px: float | None = ...,
    doffs_px: float | None = ...,
    camera_height_m: float | None = ...,
    tilt_deg: float | None = ...,
    near_px: float | None = ...,
    calibration: _Path | Sequence[_Path] | None = ...,
    rectified: bool | None = ...,
    exchanged: bool | None = ...,
) -> Percept: ...
def read_image(file: _Path) -> _Image: ...
def read_pair(left: _Path, right: _Path) -> tuple[_Image, _Image]: ...

class V1Responses:
    even: Final[tuple[NDArray[np.int16], ...]]
    odd: Final[tuple[NDArray[np.int16], ...]]
    complex: Final[NDArray[np.float32]]
    wavelength_px: Final[float]
    gain: Final[float]

def v1_responses(
    image: _Image,
    *,
    wavelength_px: float = ...,
    sigma_factor: float = ...,
    gamma: float = ...,
    channels: _Channels = ...,
) -> V1Responses: ...

class Keypoints:
    points: Final[_Records]
    descriptors: Final[NDArray[np.uint8]]
    def __len__(self) -> int: ...

def keypoints(
    image: _Image,
    *,
    wavelength_px: float = ...,
    scales: int = ...,
    most: int = ...,
    threshold: float = ...,
    channels: _Channels = ...,
) -> Keypoints: ...
def keypoints_to_learn(image: _Image, *, channels: _Channels = ...) -> Keypoints: ...
def match_nearest(
    queries: NDArray[np.uint8], stored: NDArray[np.uint8], *, below_bits: int = ...
) -> _Records: ...
def match_below(queries: NDArray[np.uint8], stored: NDArray[np.uint8], below_bits: int) -> _Records: ...

class Command:
    forward_m_s: Final[float]
    turn_rad_s: Final[float]
    pan_rad: Final[float]
    tilt_rad: Final[float]

class Senses:
    left: Final[_Image | None]
    right: Final[_Image | None]
    image_stamp_s: Final[float]
    focal_px: Final[float]
    centre_u_px: Final[float]
    centre_v_px: Final[float]
    baseline_m: Final[float]
    image_pan_rad: Final[float]
    image_tilt_rad: Final[float]
    now_s: Final[float]
    pose: Final[Pose]
    forward_m_s: Final[float]
    turn_rad_s: Final[float]
    pan_rad: Final[float]
    tilt_rad: Final[float]
    battery_v: Final[float]
    bumper: Final[bool]
    motors_stalled: Final[bool]
    sonar: Final[_Records]
    laser: Final[_Records]

class Record(dict[str, Any]):
    def __getattr__(self, name: str) -> Any: ...

class Landmark(Record):
    id: int
    session: int
    name: str
    kind: str
    position: dict[str, float] | None
    strength: float
    uses: int
    first_use_s: float
    recent_uses_s: list[float]
    pinned: bool
    retired_s: float | None
    retired_why: str
    views: int
    keypoints: int
    activation: float

class Episode(Record):
    id: int
    session: int | None
    time_s: float
    kind: str
    x_m: float | None
    y_m: float | None
    heading_rad: float | None
    landmark: str
    text: str

class Session(Record):
    id: int
    kind: str
    state: str
    started_unix_s: int
    operating_start_s: float
    operating_s: float
    software: str
    settings: str
    outcome: str

class Route(Record):
    to: int
    distance_m: float
    turn_rad: float
    distance_var_m2: float
    turn_var_rad2: float
    successes: int
    failures: int

class ObstacleCell(Record):
    column: int
    row: int
    log_odds: float
    seen_s: float

class KnownThing(Record):
    name: str
    view: int
    inliers: int
    score: float
    matched: float
    scale: float
    turned_rad: float
    quad: list[list[float]]

class RunResult(Record):
    outcome: str
    reason: str
    reached_goal: bool
    distance_m: float
    duration_s: float
    cycles: int
    json: Final[str]
    losses: Final[str]
    notices: Final[str]

class View:
    id: Final[int]
    session: Final[int]
    width_px: Final[float]
    height_px: Final[float]
    range_m: Final[float | None]
    bearing_rad: Final[float | None]
    damaged: Final[bool]
    descriptors: Final[NDArray[np.uint8]]
    keypoints: Final[_Records]
    jpeg: Final[bytes]
    def picture(self) -> _Image | None: ...

class Memory:
    def __init__(self, file: _Path) -> None: ...
    def __enter__(self) -> Memory: ...
    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None: ...
    def close(self) -> None: ...
    path: Final[str]
    closed: Final[bool]
    notices: Final[list[str]]
    def landmarks(self, forgotten: bool = ...) -> list[Landmark]: ...
    def landmark(self, name: str) -> Landmark: ...
    def views(self, name: str) -> list[View]: ...
    def episodes(self, most: int = ...) -> list[Episode]: ...
    def sessions(self) -> list[Session]: ...
    def routes(self) -> list[Route]: ...
    def obstacle_cells(self) -> list[ObstacleCell]: ...
    def recognise(
        self, image: _Image, only: Sequence[str] = ..., channels: _Channels = ...
    ) -> list[KnownThing]: ...

class RecordedCycle:
    number: Final[int]
    senses: Final[Senses]
    wish: Final[Command]
    sent: Final[Command]
    why: Final[str]
    limited_by: Final[str]
    action: Final[str]

class Recording:
    def __init__(self, file: _Path) -> None: ...
    def __iter__(self) -> Iterator[RecordedCycle]: ...
    def recall(self, *, cycle: int | None = ..., at_s: float | None = ...) -> dict[str, Any]: ...
    file: Final[str]
    software: Final[str]
    task: Final[str]
    world: Final[str]
    seed: Final[int]
    robot: Final[Robot]
    settings: Final[dict[str, str]]
    variables: Final[dict[str, str]]
    task_files: Final[dict[str, str]]

class Simulator:
    def __init__(
        self, world: _Path, *, seed: int = ..., robot: _Path = ..., start: Pose | None = ...
    ) -> None: ...
    def step(
        self,
        forward_m_s: float = ...,
        turn_rad_s: float = ...,
        pan_rad: float = ...,
        tilt_rad: float | None = ...,
    ) -> Senses: ...
    pose: Final[Pose]
    collisions: Final[list[dict[str, Any]]]
    reached_goal: Final[bool]
    distance_driven_m: Final[float]
    clearance_m: Final[float]
    over: Final[bool]
    now_s: Final[float]
    robot: Final[Robot]
    world: Final[str]
    start: Final[Pose]
    goal_beyond_m: Final[float]

class ShortTermMemory:
    now_s: Final[float]
    robot: Final[Robot]
    pose: Final[Pose]
    forward_m_s: Final[float]
    turn_rad_s: Final[float]
    pan_rad: Final[float]
    tilt_rad: Final[float]
    battery_v: Final[float]
    bumper: Final[bool]
    stalled: Final[bool]
    distance_travelled_m: Final[float]
    progress_m: Final[float]
    action: Final[str]
    trajectory: Final[NDArray[np.float64]]
    image_age_s: Final[float]
    light_level: Final[float]
    noise_level: Final[float]
    seen_share: Final[float]
    def figure(self, name: str) -> float: ...
    corridor: Final[dict[str, Any]]
    salient_regions: Final[list[dict[str, Any]]]
    landmarks: Final[list[dict[str, Any]]]
    def polar_map(self) -> dict[str, NDArray[Any]]: ...
    def grid(self) -> NDArray[np.float32]: ...

class Wish:
    forward_m_s: float
    turn_rad_s: float
    pan_rad: float
    tilt_rad: float | None
    progress: str
    why: str
    def __init__(
        self,
        forward_m_s: float = ...,
        turn_rad_s: float = ...,
        pan_rad: float = ...,
        tilt_rad: float | None = ...,
        progress: Literal["running", "succeeded", "failed"] = ...,
        why: str = ...,
    ) -> None: ...

class Cycle:
    number: Final[int]
    senses: Final[Senses]
    percept: Final[Percept]
    wish: Final[Wish]
    sent: Final[Command]
    driver: Final[str]
    limited_by: Final[str]
    action: Final[str]
    doing: Final[str]
    hold: Final[str]
    waits_for_reset: Final[bool]
    progress_m: Final[float]
    memory: Final[ShortTermMemory]
    def memory_state(self) -> dict[str, Any]: ...
    def reset(self) -> None: ...

class Argument:
    default: float | int | bool | str
    unit: str
    low: float
    high: float
    help: str
    choices: list[str]
    def __init__(
        self,
        default: float | int | bool | str,
        unit: str = ...,
        low: float = ...,
        high: float = ...,
        help: str = ...,
        choices: Sequence[str] = ...,
    ) -> None: ...

def behaviour(
    name: str,
    *,
    arguments: dict[str, Argument] | None = ...,
    main: str = ...,
    required: Sequence[str] = ...,
    motors: Literal["nothing", "wheels", "head", "both"] = ...,
    ends_by_itself: bool = ...,
    can_fail: bool = ...,
    help: str = ...,
) -> Callable[[_Made], _Made]: ...
def condition(
    name: str,
    *,
    unit: str = ...,
    low: float = ...,
    high: float = ...,
    example: str = ...,
    help: str = ...,
) -> Callable[[_Made], _Made]: ...
def actions() -> list[str]: ...
def conditions() -> list[str]: ...
def use_plugin(file: _Path) -> None: ...
def run(
    task: _Path,
    *,
    world: _Path = ...,
    seed: int = ...,
    robot: _Path = ...,
    memory: _Path = ...,
    record: _Path = ...,
    result: _Path = ...,
    variables: dict[str, str] | None = ...,
    emergency: bool = ...,
    baseline: str = ...,
    start: Pose | None = ...,
    real_time: bool = ...,
    each_cycle: Callable[[Cycle], object] | None = ...,
    pilot: Callable[[ShortTermMemory], Wish | None] | None = ...,
) -> RunResult: ...

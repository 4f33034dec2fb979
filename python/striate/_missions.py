"""Missions."""

import atexit
import contextlib
import os
import signal
import sys
import threading

from ._errors import UserError
from ._records import RunResult
from ._striate import _end_missions, _run

# Threads that Python does not wait for get no lock any more once it ends: their robots stop before.
atexit.register(_end_missions)


@contextlib.contextmanager
def _ended_by_sigterm(listens):
    """SIGTERM, which would end the process at once, ends it as Ctrl-C does, where nobody else listens."""
    if not listens or signal.getsignal(signal.SIGTERM) is not signal.SIG_DFL:
        yield
        return
    before = signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def run(task, *, world="", seed=1, robot="", memory="", record="", result="", variables=None,
        emergency=True, baseline="", start=None, real_time=False, each_cycle=None, pilot=None):
    """Runs a task script to its end, as `striate run` does, and returns a RunResult.

    task, world, robot: files, or names of shipped ones; task "": the pilot alone drives; without a
    world the robot is the one that `robot` tells of.  seed: the same seed is the same run, bit for
    bit.  memory: long-term memory that is used and written.  record, result: files to write.
    variables: dict of the task's variables, {'way': '20 m'}.  emergency: sonar and laser may stop
    the robot.  baseline: drive by the disparities of 'paper', 'sgbm' or 'truth'.  start: Pose along
    the corridor.  real_time: a simulated robot goes no faster than the clock on the wall.

    each_cycle: called as each_cycle(cycle) after every cycle with a Cycle. What is false, but not
    None, asks for a safe end: the task's `finally` runs. What it raises stops the wheels at once and
    is raised here.
    pilot: called as pilot(memory) once a cycle; a Wish takes the wheel through the safety limiter,
    None leaves it to the task. It is not asked any more once each_cycle asked for the end.

    Ctrl-C stops the wheels at the end of the cycle and raises KeyboardInterrupt here; what was
    driven until then is in memory, recording and result. SIGTERM does the same with SystemExit (143),
    where nobody else listens to it. Both are of the main thread: in another one neither ends a
    mission, but the end of the interpreter does where it does not wait for that thread.
    Raises UserError before anything moves; of what happens on the way RunResult.outcome tells.
    """
    if not os.fspath(task) and pilot is None:
        raise UserError("run needs a task script; without one only a pilot can drive: pilot=")
    in_main_thread = threading.current_thread() is threading.main_thread()
    with _ended_by_sigterm(in_main_thread):
        found = _run(task=task, world=world, seed=seed, robot=robot, memory=memory, record=record,
                     result=result, baseline=baseline, variables=dict(variables or {}),
                     emergency=emergency, real_time=real_time, hears_signals=in_main_thread, start=start,
                     each_cycle=each_cycle, pilot=pilot)
    return RunResult(*found)

"""Missions from Python: the program's own, looked at, steered and ended."""

import json
import math
import os
import signal
import threading
import time
import traceback
import unittest

import numpy as np

import striate
from support import MISSION, SHORT, InScratchFolder, program, without_clock

TASK, WORLD = MISSION / "task.yaml", MISSION / "world.yaml"


class Missions(InScratchFolder):
    def test_come_out_as_those_of_the_program_bit_for_bit(self):
        mine, its = self.folder / "mine.json", self.folder / "its.json"
        program("run", TASK, "--world", WORLD, "--seed", 3, "--result", its, "--quiet", "--var", "cruise=0.5 m/s")
        seen = []
        result = striate.run(TASK, world=WORLD, seed=3, result=mine, variables={"cruise": "0.5 m/s"},
                             each_cycle=lambda cycle: seen.append(cycle.percept.disparity_px.sum()))
        self.assertEqual(without_clock(mine), without_clock(its))
        self.assertEqual(result, json.loads(mine.read_text()))
        self.assertEqual(result.json, mine.read_text())
        self.assertEqual(result.outcome, "success")
        self.assertEqual(len(seen), result.cycles)
        self.assertEqual(result.losses, "")

    def test_a_callback_sees_the_whole_cycle(self):
        kept, regions = [], []

        def known(part):
            return {name: None if value == math.inf else value for name, value in part.items()}

        def look(cycle):
            memory = cycle.memory
            state = cycle.memory_state()
            self.assertEqual(state["cycle"], cycle.number)
            self.assertEqual(memory.pose.x_m, state["pose"]["x_m"])
            self.assertEqual(memory.progress_m, cycle.progress_m)
            self.assertEqual(memory.now_s, cycle.senses.now_s)
            self.assertEqual(memory.polar_map()["state"].shape, (72, 16))
            self.assertEqual(memory.grid().shape, (256, 256))
            self.assertEqual(memory.trajectory.shape[1], 2)
            self.assertEqual(known(memory.corridor), state["corridor"])
            self.assertEqual([known(one) for one in memory.salient_regions], state["salient_regions"])
            self.assertEqual(memory.landmarks, state["landmarks"])
            regions.extend(memory.salient_regions)
            self.assertGreater(memory.robot.max_forward_m_s, 0.1)
            kept.append(cycle)
            return cycle.number < 6

        result = striate.run(TASK, world=WORLD, seed=3, each_cycle=look)
        self.assertEqual(result.outcome, "interrupted")
        self.assertGreater(len(regions), 0)
        self.assertIn("traverse_corridor", {cycle.action for cycle in kept})
        self.assertTrue(any(cycle.senses.left is not None for cycle in kept))
        last = kept[5]
        self.assertEqual(last.number, 6)
        self.assertIn(last.driver, ("behaviour", "guard", "nobody", "pilot", "emergency"))
        self.assertIsInstance(last.wish, striate.Wish)
        self.assertIsInstance(last.doing + last.limited_by + last.hold, str)
        self.assertFalse(last.waits_for_reset)
        with self.assertRaisesRegex(RuntimeError, "is over"):
            last.memory.pose
        for ask in (last.memory_state, last.reset):
            with self.assertRaisesRegex(RuntimeError, "is over"):
                ask()
        self.assertEqual(last.percept.disparity_px.shape, (120, 160))
        with self.assertRaisesRegex(striate.UserError, "running robot"):
            last.percept.write(self.folder)

    def test_what_the_callback_raises_ends_it_and_is_raised_with_its_traceback(self):
        def look(cycle):
            if cycle.number == 4:
                raise ZeroDivisionError("the callback's own")

        recording = self.folder / "run.rec"
        told = ""
        try:  # assertRaises() takes the traceback away
            striate.run(TASK, world=WORLD, seed=3, each_cycle=look, record=recording)
        except ZeroDivisionError:
            told = traceback.format_exc()
        self.assertIn("in look", told)
        self.assertIn("the callback's own", told)
        self.assertEqual(len(list(striate.Recording(recording))), 4)  # closed, whole
        striate.run(TASK, world=WORLD, seed=3, each_cycle=lambda cycle: cycle.number < 2)  # and nothing is left

    def test_what_is_false_to_python_asks_for_the_end_and_none_does_not(self):
        def cycles_with(answer):
            look = lambda cycle: False if cycle.number == 8 else answer if cycle.number == 3 else None
            return striate.run(TASK, world=WORLD, seed=3, each_cycle=look).cycles

        ended, later = cycles_with(False), cycles_with(None)
        self.assertLess(ended, later)
        for answer, cycles in ((np.bool_(False), ended), (0, ended), (np.bool_(True), later), (1, later)):
            self.assertEqual(cycles_with(answer), cycles, repr(answer))
        with self.assertRaisesRegex(ValueError, "ambiguous"):
            striate.run(TASK, world=WORLD, seed=3, each_cycle=lambda cycle: np.zeros(2))

    def test_ctrl_c_stops_it_and_is_raised(self):
        result = self.folder / "result.json"
        began = time.monotonic()

        def press():
            time.sleep(1.5)
            os.kill(os.getpid(), signal.SIGINT)

        finger = threading.Thread(target=press)
        finger.start()
        with self.assertRaises(KeyboardInterrupt):
            striate.run(TASK, world=SHORT, seed=3, real_time=True, result=result)  # without any Python of ours
        finger.join()
        self.assertLess(time.monotonic() - began, 10.0)
        self.assertEqual(json.loads(result.read_text())["outcome"], "lost")
        drove = []

        def look(cycle):
            drove.append(cycle.action)
            if cycle.number == 3:
                signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            striate.run(TASK, world=WORLD, seed=3, each_cycle=look)
        self.assertEqual(drove[-1], "traverse_corridor")  # no safe end: at once
        self.assertEqual(len(drove), 3)

    def test_a_pilot_takes_the_wheel_behind_the_limiter(self):
        sent = []

        def pilot(memory):
            if memory.now_s > 1.0:
                return None
            return striate.Wish(forward_m_s=5.0, turn_rad_s=-0.2, why="the pilot's")

        def look(cycle):
            sent.append((cycle.driver, cycle.sent.forward_m_s))
            return cycle.number < 20

        striate.run(TASK, world=WORLD, seed=3, pilot=pilot, each_cycle=look)
        self.assertEqual(sent[5][0], "pilot")
        self.assertEqual(sent[18][0], "behaviour")
        self.assertLessEqual(max(speed for _, speed in sent), 0.75)

    def test_a_pilot_leaves_the_safe_end_to_the_task(self):
        drivers = []

        def look(cycle):
            drivers.append(cycle.driver)
            return cycle.number != 5 and cycle.number < 80

        for task in (TASK, ""):
            drivers.clear()
            result = striate.run(task, world=WORLD, seed=3, each_cycle=look,
                                 pilot=lambda memory: striate.Wish(forward_m_s=0.3))
            self.assertEqual(result.outcome, "interrupted")
            self.assertLess(result.cycles, 60)
            self.assertNotIn("pilot", drivers[6:])

    def test_a_pilot_that_fails_ends_it(self):
        for pilot, says in ((lambda memory: 7, "must return a striate.Wish, not int"),
                            (lambda memory: striate.Wish(forward_m_s=float("nan")), "finite"),
                            (lambda memory: memory.nothing, "nothing")):
            with self.assertRaisesRegex(Exception, says):
                striate.run(TASK, world=WORLD, seed=3, pilot=pilot)

    def test_mistakes_are_told_as_on_the_command_line_before_anything_moves(self):
        broken = self.file("task.yaml", TASK.read_text().replace("keep: middle", "kept: middle"))
        with self.assertRaises(striate.UserError) as caught:
            striate.run(broken, world=WORLD)
        said = program("run", broken, "--world", WORLD, code=2)[1]
        self.assertEqual(said.strip(), str(caught.exception).strip())
        self.assertEqual((caught.exception.file, caught.exception.line), (str(broken), 8))
        with self.assertRaisesRegex(striate.UserError, "has no variable"):
            striate.run(TASK, world=WORLD, variables={"crusie": "1 m/s"})
        with self.assertRaisesRegex(striate.UserError, "needs a task script"):
            striate.run("", world=WORLD)
        with self.assertRaises(striate.UserError):
            striate.run(TASK, world=WORLD, baseline="best")
        with self.assertRaises(striate.UserError):
            striate.run(TASK, world=WORLD, result=self.folder)

    def test_no_file_is_written_over_another_that_is_named(self):
        task = self.file("task.yaml", TASK.read_text())
        out = self.folder / "out"
        for says, options in (("task and record are the same file", {"record": task}),
                              ("record and result are the same file", {"record": out, "result": out}),
                              ("memory and record are the same file",
                               {"memory": out, "record": self.folder / "." / "out"})):
            with self.assertRaisesRegex(striate.UserError, says):
                striate.run(task, world=WORLD, seed=3, each_cycle=lambda cycle: False, **options)
        self.assertEqual(task.read_text(), TASK.read_text())
        self.assertFalse(out.exists())

    def test_memory_keeps_what_happened(self):
        home = self.folder / "home.db"
        striate.run(TASK, world=WORLD, seed=3, memory=home, each_cycle=lambda cycle: cycle.number < 5)
        with striate.Memory(home) as memory:
            self.assertTrue(memory.sessions()[0].outcome.startswith("interrupted"))
            self.assertRegex(memory.sessions()[0].settings, f"^{TASK} in .*, seed 3$")
            self.assertEqual({"start", "end"} & {one.kind for one in memory.episodes()}, {"start", "end"})

    def test_missions_in_threads_do_not_disturb_each_other(self):
        results = {}

        def drive(seed):
            results[seed] = without_clock(
                striate.run(TASK, world=WORLD, seed=seed, each_cycle=lambda cycle: cycle.number < 30))

        threads = [threading.Thread(target=drive, args=(seed,)) for seed in (3, 4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for seed in (3, 4):
            alone = striate.run(TASK, world=WORLD, seed=seed, each_cycle=lambda cycle: cycle.number < 30)
            self.assertEqual(without_clock(alone), results[seed])


if __name__ == "__main__":
    unittest.main()

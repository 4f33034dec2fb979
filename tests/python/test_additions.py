"""Behaviours and conditions that are written in Python, in task scripts."""

import threading
import unittest

import numpy as np

import striate
from support import MISSION, InScratchFolder, noted_robot

WORLD = MISSION / "world.yaml"
calls = []


@striate.behaviour("arc_of_python", main="by", motors="wheels", arguments={
    "by": striate.Argument(0.5, "angle", -6.3, 6.3, "how far it turns"),
    "speed": striate.Argument(0.3, "speed", 0.05, 0.75, "along it"),
    "times": striate.Argument(1, low=1, high=5, help="how often"),
    "loud": striate.Argument(False, help="says more"),
    "words": striate.Argument("turns", help="what it says"),
    "side": striate.Argument("left", choices=("left", "right"), help="which way"),
})
class Arc:
    """Drives along an arc.

    And more that is no help line.
    """

    def __init__(self, arguments, robot):
        self.arguments = arguments
        self.robot = robot
        calls.append(("made", dict(arguments)))

    def start(self, memory):
        self.begin_rad = memory.pose.heading_rad
        calls.append(("start", memory.now_s))

    def tick(self, memory):
        if abs(memory.pose.heading_rad - self.begin_rad) >= abs(self.arguments["by"]):
            return striate.Wish(progress="succeeded", why="the arc is driven")
        return striate.Wish(forward_m_s=self.arguments["speed"], turn_rad_s=self.arguments["by"], why="drives an arc")

    def halt(self, memory):
        calls.append(("halt", memory.now_s))
        return True


@striate.condition("on_python_for", unit="duration", low=0, high=100, example="2 s")
def on_for(memory, limit):
    """Holds when the clock says so."""
    return memory.now_s >= limit


class Additions(InScratchFolder):
    def setUp(self):
        super().setUp()
        calls.clear()

    def task(self, steps):
        return self.file("task.yaml", f"striate: 1\nmission: test\ngoal: steps\ndo:\n{steps}\nfinally:\n  - stop: {{}}\n")

    def test_a_behaviour_drives_and_ends(self):
        why = set()
        result = striate.run(self.task("  - arc_of_python: {by: 20 deg, speed: 0.2 m/s, times: 2, loud: true, "
                                       "words: hello, side: right}"),
                             world=WORLD, each_cycle=lambda cycle: why.add(cycle.wish.why))
        self.assertEqual(result.outcome, "success")
        made = [what for name, what in calls if name == "made"][-1]
        self.assertAlmostEqual(made["by"], 0.349, places=3)
        self.assertEqual({key: made[key] for key in ("speed", "times", "loud", "words", "side")},
                         {"speed": 0.2, "times": 2, "loud": True, "words": "hello", "side": "right"})
        self.assertEqual(sum(name == "start" for name, _ in calls), 1)
        self.assertIn("drives an arc", why)
        self.assertGreater(result.distance_m, 0.1)

    def test_its_arguments_are_checked_like_any_others(self):
        with self.assertRaises(striate.UserError) as caught:
            striate.run(self.task("  - arc_of_python: {by: 20 kg}\n  - arc_of_python: {sped: 1 m/s}"), world=WORLD)
        self.assertEqual([one.line for one in caught.exception.problems], [5, 6])
        self.assertIn("did you mean 'speed'?", str(caught.exception))

    def test_a_condition_ends_a_step(self):
        at = []
        result = striate.run(self.task("  - drive_straight: {distance: 5 m, speed: 0.3 m/s}\n"
                                       "    until: {on_python_for: 1.5 s}"),
                             world=WORLD, each_cycle=lambda cycle: at.append(cycle.senses.now_s))
        self.assertEqual(result.outcome, "success")
        self.assertLess(at[-1], 4.0)
        with self.assertRaises(striate.UserError):
            striate.run(self.task("  - wait: 1 s\n    until: {on_python_for: 2 m}"), world=WORLD)

    def test_a_condition_may_be_a_class(self):
        @striate.condition("ticks_of_python", low=1, high=50, example="3", help="so many cycles")
        class Ticks:
            def __init__(self, limit):
                self.limit = limit

            def start(self, memory):
                self.count = 0

            def holds(self, memory):
                self.count += 1
                return self.count >= self.limit

        result = striate.run(self.task("  - wait: {for: 30 s}\n    until: {ticks_of_python: 4}"), world=WORLD)
        self.assertLess(result.cycles, 15)

    def test_what_a_behaviour_raises_ends_the_mission_at_a_stand_and_is_raised(self):
        @striate.behaviour("breaks_in_python")
        class Breaks:
            def __init__(self, arguments, robot):
                pass

            def tick(self, memory):
                if memory.now_s > 0.5:
                    raise LookupError("broken within")
                return striate.Wish(forward_m_s=0.3)

        recording = self.folder / "run.rec"
        with self.assertRaisesRegex(LookupError, "broken within"):
            striate.run(self.task("  - breaks_in_python: {}"), world=WORLD, record=recording, real_time=False)
        self.assertLess(len(list(striate.Recording(recording))), 8)
        robot, stops = noted_robot(self.folder)
        with self.assertRaisesRegex(LookupError, "broken within"):
            striate.run(self.task("  - breaks_in_python: {}"), robot=robot)
        self.assertIn("stopped", stops.read_text())

    def test_what_is_no_wish_is_told(self):
        for back, says in ((None, "must return a striate.Wish, not NoneType"), (3, "not int"),
                           (striate.Wish(turn_rad_s=float("inf")), "finite")):
            @striate.behaviour("says_what_it_likes")
            class Says:
                def __init__(self, arguments, robot):
                    pass

                def tick(self, memory, back=back):
                    return back

            with self.assertRaisesRegex((TypeError, ValueError), says):
                striate.run(self.task("  - says_what_it_likes: {}"), world=WORLD)

    def test_what_its_maker_raises_is_raised(self):
        @striate.behaviour("cannot_be_made")
        class Cannot:
            def __init__(self, arguments, robot):
                raise PermissionError("not today")

            def tick(self, memory):
                return striate.Wish()

        with self.assertRaisesRegex(PermissionError, "not today"):
            striate.run(self.task("  - cannot_be_made: {}"), world=WORLD)

    def test_memory_that_is_kept_says_that_it_is_over(self):
        kept = []

        @striate.behaviour("keeps_memory")
        class Keeps:
            def __init__(self, arguments, robot):
                pass

            def tick(self, memory):
                kept.append(memory)
                return striate.Wish(progress="succeeded")

        striate.run(self.task("  - keeps_memory: {}"), world=WORLD)
        with self.assertRaisesRegex(RuntimeError, "is over"):
            kept[0].pose

    def test_names_that_are_taken_or_none_are_refused(self):
        class Any:
            def tick(self, memory):
                return striate.Wish()

        for name, says in (("stop", "taken"), ("repeat", "taken"), ("Nod!", "which is none"), ("", "which is none")):
            with self.assertRaisesRegex(striate.UserError, says):
                striate.behaviour(name)(Any)
        with self.assertRaisesRegex(striate.UserError, "taken"):
            striate.condition("travelled")(lambda memory, limit: True)
        with self.assertRaisesRegex(striate.UserError, "motors 'legs'"):
            striate.behaviour("legged", motors="legs")(Any)
        with self.assertRaisesRegex(striate.UserError, "unit 'feet'"):
            striate.condition("footed", unit="feet")(lambda memory, limit: True)
        with self.assertRaisesRegex(striate.UserError, "argument 'far'"):
            striate.behaviour("far_one", main="far")(Any)
        with self.assertRaisesRegex(TypeError, "must be a striate.Argument, not int"):
            striate.behaviour("with_a_number", arguments={"far": 3})(Any)
        with self.assertRaisesRegex(striate.UserError, "nothing lies"):
            striate.condition("from_three_to_one", low=3, high=1)(lambda memory, limit: True)
        self.assertNotIn("legged", striate.actions())
        with self.assertRaisesRegex(striate.UserError, "argument with the name 'Big Name: {', which is none"):
            striate.behaviour("with_a_big_name", arguments={"Big Name: {": striate.Argument(1)})(Any)
        for example, says in (("banana", "'banana'"), ("3", "unit"), ("12 m", "range")):
            with self.assertRaisesRegex(striate.UserError, f"with the example.*{says}"):
                striate.condition("with_an_example", unit="length", low=1, high=10, example=example)(lambda m, l: True)
        striate.condition("without_an_example", unit="length", low=2, high=10)(lambda memory, limit: True)

    def test_arguments_that_can_be_none_are_refused_where_they_are_written(self):
        Argument = striate.Argument
        for says, options in (("outside of its range", {"default": 50.0, "low": 0, "high": 1}),
                              ("outside of its range", {"default": 7, "low": 0, "high": 5}),
                              ("outside of its range", {"default": 2**40, "high": 2**50}),
                              ("outside of its range", {"default": float("nan")}),
                              ("outside of its range", {"default": float("inf"), "high": float("inf")}),
                              ("nothing lies", {"default": 1.0, "low": 3, "high": 1}),
                              ("nothing lies", {"default": 1.0, "low": float("nan")}),
                              ("none of its choices, a, b", {"default": "c", "choices": ["a", "b"]}),
                              ("none of its choices", {"default": 1, "choices": ["a", "b"]})):
            with self.subTest(options=options), self.assertRaisesRegex(striate.UserError, says):
                Argument(**options)
        for says, options in (("a default is a float", {"default": None}), ("numbers", {"default": 1.0, "low": "0"}),
                              ("give a list of words", {"default": "a", "choices": "ab"}),
                              ("is no word", {"default": "a", "choices": ["a", 3]})):
            with self.subTest(options=options), self.assertRaisesRegex(TypeError, says):
                Argument(**options)
        self.assertIs(type(Argument(np.float32(0.5)).default), float)
        self.assertIs(type(Argument(np.int64(3)).default), int)

    def test_what_is_no_behaviour_or_condition_is_refused_where_it_is_written(self):
        class Neither:
            pass

        for what in (3, None, Neither, Neither(), lambda arguments, robot: Neither()):
            with self.assertRaisesRegex(TypeError, "must be a class with tick"):
                striate.behaviour("is_none")(what)
        for what in (3, None, Neither, Neither()):
            with self.assertRaisesRegex(TypeError, "must be a function, or a class with holds"):
                striate.condition("is_none")(what)
        with self.assertRaisesRegex(TypeError, "required: give a list"):
            striate.behaviour("is_none", arguments={"for": striate.Argument(1.0)}, required="for")
        self.assertNotIn("is_none", striate.actions() + striate.conditions())

    def test_one_of_your_own_may_be_written_anew(self):
        for speed in (0.1, 0.2):
            @striate.behaviour("written_twice")
            class Twice:
                def __init__(self, arguments, robot):
                    pass

                def tick(self, memory, speed=speed):
                    return striate.Wish(forward_m_s=speed, why=f"at {speed}")

            why = set()
            striate.run(self.task("  - written_twice: {}"), world=WORLD,
                        each_cycle=lambda cycle: (why.add(cycle.wish.why), cycle.number < 4)[1])
            self.assertIn(f"at {speed}", why)
        self.assertEqual(striate.actions().count("written_twice"), 1)

    def test_one_whose_making_adds_others_is_still_what_it_was(self):
        @striate.condition("adds_others", example="1")
        class Adds:
            def __init__(self, limit):
                for k in range(200):  # more than have room beside it where they are kept
                    striate.condition(f"added_{k}_by_another")(lambda memory, limit: False)
                striate.condition("adds_others")(Adds)  # also in its own place

            def holds(self, memory):
                return memory.now_s >= 1.0

        class AddsItself:
            def __init__(self, arguments, robot):
                add(AddsItself)
                self.words = arguments["far"]

            def tick(self, memory):
                return striate.Wish(why=self.words)

        add = striate.behaviour("adds_itself", arguments={"far": striate.Argument("away")})
        add(AddsItself)
        why = set()
        result = striate.run(self.task("  - adds_itself: {far: beyond}\n    until: {adds_others: 1}"), world=WORLD,
                             each_cycle=lambda cycle: why.add(cycle.wish.why))
        self.assertEqual(result.outcome, "success")
        self.assertIn("beyond", why)
        self.assertIn("added_199_by_another", striate.conditions())

    def test_some_may_be_added_while_missions_run(self):
        done = threading.Event()

        def add():
            for k in range(2000):
                striate.condition(f"added_{k}_meanwhile")(lambda memory, limit: False)
            done.set()

        adds = threading.Thread(target=add)
        adds.start()
        while not done.is_set():
            striate.run(self.task("  - wait: 1 s\n    until: {on_python_for: 0.1 s}"), world=WORLD)
        adds.join()

    def test_they_are_listed(self):
        self.assertIn("arc_of_python", striate.actions())
        self.assertIn("stop", striate.actions())
        self.assertIn("on_python_for", striate.conditions())
        self.assertIn("travelled", striate.conditions())


if __name__ == "__main__":
    unittest.main()

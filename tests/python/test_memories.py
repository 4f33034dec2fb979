"""Long-term memories and recordings, as the command line shows them."""

import ast
import json
import math
import os
import unittest

import numpy as np

import striate
from support import MISSION, InScratchFolder, members_in, pair, program, script, tree_of_stub, write_ppm


class Memories(InScratchFolder):
    def setUp(self):
        super().setUp()
        self.image = pair()[0]
        self.book = self.image[60:220, 80:260]
        self.home = self.folder / "home.db"
        program("teach", "book", "--image", write_ppm(self.folder / "book.ppm", self.book), "--memory", self.home)
        program("teach", "wall", "--image", write_ppm(self.folder / "wall.ppm", pair()[1]), "--memory", self.home)

    def test_holds_what_the_command_lists(self):
        with striate.Memory(self.home) as memory:
            listed = json.loads(program("memory", self.home, "--json", "list")[0])
            self.assertEqual(memory.landmarks(), listed)
            self.assertEqual({one.name for one in memory.landmarks()}, {"book", "wall"})
            shown = json.loads(program("memory", self.home, "--json", "show", "book")[0])
            book = memory.landmark("book")
            self.assertEqual(book.strength, shown["strength"])
            self.assertEqual(book["kind"], "taught")
            episodes = json.loads(program("memory", self.home, "--json", "episodes")[0])
            self.assertEqual(memory.episodes(), episodes[::-1])  # the command has the newest last
            self.assertEqual(len(memory.episodes(1)), 1)
            self.assertEqual(memory.routes(), [])
            self.assertEqual(memory.obstacle_cells(), [])
            self.assertEqual(memory.sessions()[0].kind, "teach")
            self.assertEqual(memory.path, str(self.home))
            with self.assertRaises(KeyError):
                memory.landmark("cup")
            with self.assertRaisesRegex(striate.UserError, "cup"):
                memory.views("cup")
            with self.assertRaisesRegex(AttributeError, "has no 'colour'; it has: id"):
                book.colour

    def test_views_have_keypoints_descriptors_and_a_picture(self):
        with striate.Memory(self.home) as memory:
            view = memory.views("book")[0]
        self.assertEqual(len(view.keypoints), len(view.descriptors))
        self.assertEqual(view.descriptors.shape[1], 32)
        self.assertEqual(view.keypoints.dtype.names, ("x_px", "y_px", "size_px", "angle_rad"))
        self.assertEqual(view.picture().shape, (160, 180, 3))
        self.assertLess(np.abs(view.picture().astype(int) - self.book).mean(), 6)  # JPEG
        self.assertEqual(view.jpeg[:2], b"\xff\xd8")
        self.assertIsNone(view.range_m)
        self.assertFalse(view.damaged)

    def test_recognises_what_the_command_recognises(self):
        with striate.Memory(self.home) as memory:
            found = memory.recognise(self.image, only=["book"])
            self.assertEqual(memory.recognise(self.image, ["book"], channels="bgr"), found)
            with self.assertRaisesRegex(striate.UserError, "cup"):
                memory.recognise(self.image, only=["cup"])
        picture = write_ppm(self.folder / "scene.ppm", self.image)
        told = json.loads(
            program("recognise", picture, "--memory", self.home, "--json", "--only", "book")[0].splitlines()[0])
        self.assertEqual(len(found), 1)
        self.assertEqual(told["things"][0]["inliers"], found[0].inliers)
        self.assertTrue(np.allclose(told["things"][0]["quad"], found[0].quad, atol=1e-4))
        middle = np.mean(found[0].quad, axis=0)
        self.assertLess(np.hypot(*(middle - (169.5, 139.5))), 5.0)  # where the book was cut out

    def test_is_the_same_from_another_folder(self):
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        with striate.Memory("home.db") as memory:
            os.chdir(before)
            self.assertEqual([one.name for one in memory.recognise(self.image, ["book"])], ["book"])
            self.assertEqual(memory.path, "home.db")

    def test_recognising_says_nothing_beside(self):
        # A memory of a crashed program is told of by `notices`; a library prints nothing.
        code = ("import sys, striate\nmemory = striate.Memory(sys.argv[1])\n"
                "memory.recognise(striate.read_image(sys.argv[2]))\n")
        crashed = script("import os, sys, striate\n"
                         "striate.run('corridor', world='short', memory=sys.argv[1],\n"
                         "            each_cycle=lambda cycle: cycle.number < 3 or os._exit(0))\n", self.home)
        self.assertEqual(crashed.communicate()[1], "")
        self.assertEqual(script(code, self.home, self.folder / "book.ppm").communicate(), ("", ""))

    def test_records_have_the_fields_of_the_stub(self):
        kept = json.loads(program("memory", self.home, "export", "-")[0])
        ids = [one["id"] for one in kept["landmarks"]]
        kept["routes"] = [{"from": ids[0], "to": ids[1], "distance_m": 2.0, "turn_rad": 0.1, "distance_var_m2": 0.1,
                           "turn_var_rad2": 0.1, "successes": 1, "failures": 0}]
        kept["obstacle_cells"] = [{"column": 3, "row": -2, "log_odds": 1.5, "seen_s": 0.5}]
        filled = self.folder / "filled.db"
        program("memory", filled, "import", self.file("filled.json", json.dumps(kept)))
        with striate.Memory(filled) as memory:
            records = [memory.landmarks()[0], memory.episodes()[0], memory.sessions()[0], memory.routes()[0],
                       memory.obstacle_cells()[0], memory.recognise(self.image)[0]]
        stub = {node.name: members_in(node) for node in tree_of_stub().values() if isinstance(node, ast.ClassDef)}
        for record in records:
            with self.subTest(record=type(record).__name__):
                self.assertEqual(set(record) - {"from"}, stub[type(record).__name__])  # a word of Python's
        result = striate.run("corridor", world="short", each_cycle=lambda cycle: False)
        self.assertEqual(stub["RunResult"] - set(result), {"json", "losses", "notices"})

    def test_what_was_taught_since_is_recognised(self):
        with striate.Memory(self.home) as memory:
            self.assertEqual({one.name for one in memory.recognise(self.image)} & {"corner"}, set())
            program("teach", "corner", "--image",
                    write_ppm(self.folder / "corner.ppm", self.image[20:180, 100:300]), "--memory", self.home)
            self.assertIn("corner", {one.name for one in memory.recognise(self.image)})


class Recordings(InScratchFolder):
    def setUp(self):
        super().setUp()
        self.recording = self.folder / "run.rec"
        self.cycles = []

        def look(cycle):
            senses = cycle.senses
            self.cycles.append((senses.now_s, tuple(senses.pose), cycle.sent.forward_m_s, cycle.action,
                                None if senses.left is None else senses.left.copy()))
            return cycle.number < 8

        striate.run(MISSION / "task.yaml", world=MISSION / "world.yaml", seed=3, record=self.recording,
                    each_cycle=look)

    def test_holds_the_cycles_bit_for_bit(self):
        recording = striate.Recording(self.recording)
        again = list(recording)
        self.assertEqual([one.number for one in again], list(range(1, len(again) + 1)))
        self.assertEqual(len(again), len(self.cycles))
        for cycle, (now_s, pose, forward_m_s, action, left) in zip(again, self.cycles):
            self.assertEqual(cycle.senses.now_s, now_s)
            self.assertEqual(tuple(cycle.senses.pose), pose)
            self.assertEqual(cycle.sent.forward_m_s, forward_m_s)
            self.assertEqual(cycle.action, action)
            if left is not None:
                self.assertTrue((cycle.senses.left == left).all())
        self.assertEqual(len(list(recording)), len(again))  # once more from the beginning
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        named = striate.Recording("run.rec")
        os.chdir(before)
        self.assertEqual(named.file, "run.rec")
        self.assertEqual(len(list(named)), len(again))
        self.assertEqual(named.recall(cycle=2)["cycle"], 2)
        self.assertEqual(recording.seed, 3)
        self.assertTrue(recording.world.endswith("world.yaml"))
        self.assertIn("perception.stereo.mode", recording.settings)
        self.assertGreater(again[0].senses.laser.shape[0], 100)
        self.assertTrue(math.isfinite(again[0].senses.battery_v))

    def test_tells_what_memory_held_as_the_command_does(self):
        told = json.loads(program("recall", self.recording, "--cycle", 5, "--json")[0])
        self.assertEqual(striate.Recording(self.recording).recall(cycle=5), told)
        last = striate.Recording(self.recording).recall()
        self.assertEqual(last["cycle"], len(self.cycles))
        with self.assertRaisesRegex(striate.UserError, "ends with cycle"):
            striate.Recording(self.recording).recall(cycle=10_000)

    def test_damage_is_told(self):
        bytes_ = bytearray(self.recording.read_bytes())
        bytes_[len(bytes_) // 2] ^= 255
        self.recording.write_bytes(bytes_)
        with self.assertRaisesRegex(striate.UserError, "run.rec"):
            list(striate.Recording(self.recording))
        self.recording.write_bytes(b"no recording at all")
        with self.assertRaises(striate.UserError):
            striate.Recording(self.recording)


if __name__ == "__main__":
    unittest.main()

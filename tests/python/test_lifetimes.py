"""Arrays outlive what they look into, and nothing is left behind."""

import gc
import os
import pathlib
import threading
import unittest
import weakref

import numpy as np

import striate
from support import InScratchFolder, pair, program, write_ppm


def open_files():
    return len(os.listdir("/proc/self/fd"))


def resident_kb():
    for line in pathlib.Path("/proc/self/status").read_text().splitlines():
        if line.startswith("VmRSS"):
            return int(line.split()[1])
    return 0


class Lifetimes(InScratchFolder):
    def memory_file(self):
        image = write_ppm(self.folder / "book.ppm", pair()[0])
        file = self.folder / "home.db"
        program("teach", "book", "--image", image, "--memory", file)
        return file

    def test_arrays_outlive_their_percept(self):
        left, right, camera = pair()
        percept = striate.perceive(left, right, **camera)
        gone = weakref.ref(percept)
        arrays = [percept.disparity_px, percept.confidence, percept.salience, percept.columns,
                  percept.obstacles, percept.regions, percept.keypoints, percept.descriptors]
        before = [array.tobytes() for array in arrays]
        column = percept.columns["bearing_rad"][5:9]
        wanted = column.tolist()
        del percept
        gc.collect()
        self.assertIsNone(gone())
        junk = [striate.perceive(right, left, **camera) for _ in range(3)]
        self.assertEqual([array.tobytes() for array in arrays], before)
        self.assertEqual(column.tolist(), wanted)
        self.assertEqual(len(junk), 3)

    def test_arrays_are_views_that_nobody_can_write_to(self):
        percept = striate.perceive(*pair()[:2])
        for name in ("disparity_px", "confidence", "salience", "columns", "keypoints", "descriptors"):
            array = getattr(percept, name)
            self.assertFalse(array.flags.writeable, name)
            self.assertFalse(array.flags.owndata, name)
            with self.assertRaises(ValueError):
                array.flags.writeable = True
            self.assertEqual(array.__array_interface__["data"][0],
                             getattr(percept, name).__array_interface__["data"][0], name)

    def test_what_a_percept_saw_may_change_afterwards(self):
        left, right = (image.copy() for image in pair()[:2])
        percept = striate.perceive(left, right)
        picture = percept.overview()
        left[:] = 0
        self.assertTrue((percept.overview() == picture).all())

    def test_views_outlive_their_memory(self):
        with striate.Memory(self.memory_file()) as memory:
            views = memory.views("book")
        self.assertTrue(memory.closed)
        descriptors, keypoints = views[0].descriptors, views[0].keypoints
        before = descriptors.tobytes(), keypoints.tobytes()
        del views, memory
        gc.collect()
        self.assertEqual((descriptors.tobytes(), keypoints.tobytes()), before)
        self.assertEqual(descriptors.shape[1], 32)

    def test_a_thousand_memories_leave_no_file_open(self):
        file = self.memory_file()
        striate.Memory(file).close()
        before = open_files()
        for i in range(1000):
            memory = striate.Memory(file)
            if i % 2 == 0:
                memory.close()
        del memory
        gc.collect()
        self.assertEqual(open_files(), before)

    def test_a_closed_memory_says_so(self):
        memory = striate.Memory(self.memory_file())
        memory.close()
        memory.close()
        with self.assertRaisesRegex(striate.UserError, "has been closed"):
            memory.landmarks()

    def test_many_percepts_leave_no_memory_behind(self):
        left, right, camera = pair()
        small = [np.ascontiguousarray(image[::4, ::4]) for image in (left, right)]
        for _ in range(20):
            striate.perceive(*small).disparity_px.sum()
        before = resident_kb()
        for _ in range(200):
            striate.perceive(*small).disparity_px.sum()
        self.assertLess(resident_kb() - before, 20_000)  # 200 percepts that stay are 40 MB

    def test_threads_see_side_by_side_what_one_sees(self):
        left, right, camera = pair()
        alone = striate.perceive(left, right, **camera).disparity_px.tobytes()
        shared = striate.Perceiver(**camera)
        seen = []

        def look(perceive):
            for _ in range(3):
                seen.append(perceive(left, right).disparity_px.tobytes())

        threads = [threading.Thread(target=look, args=(shared.see,)) for _ in range(3)]
        threads += [threading.Thread(target=look, args=(striate.Perceiver(**camera).see,)) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(seen, [alone] * 18)


if __name__ == "__main__":
    unittest.main()

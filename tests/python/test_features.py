"""V1, keypoints, descriptors and their matching."""

import unittest

import numpy as np

import striate
from support import pair


def bits_apart(a, b):
    return int(np.unpackbits(np.bitwise_xor(a, b)).sum())


class Features(unittest.TestCase):
    def test_v1_answers_to_its_orientation(self):
        v, u = np.mgrid[0:64, 0:64]
        bars = (127 + 100 * np.sin(2 * np.pi * u / 4.0)).astype(np.uint8)  # upright bars, 4 px
        v1 = striate.v1_responses(bars)
        self.assertEqual(len(v1.even), 8)
        self.assertEqual(v1.odd[3].shape, (64, 64))
        self.assertEqual(v1.odd[3].dtype, np.int16)
        self.assertEqual(v1.complex.shape, (8, 64, 64))
        strength = v1.complex[:, 20:44, 20:44].mean(axis=(1, 2))
        self.assertEqual(strength.argmax(), 0)
        self.assertGreater(strength[0], 5 * strength[4])
        energy = v1.even[0].astype(float) ** 2 + v1.odd[0].astype(float) ** 2
        inside = np.sqrt(energy)[20:44, 20:44]
        self.assertLess(np.abs(v1.complex[0][20:44, 20:44] / inside - 1).max(), 0.02)  # a code of leading bits
        self.assertGreater(v1.gain, 0.0)

    def test_keypoints_are_those_of_a_percept(self):
        image = pair()[0]
        found = striate.keypoints(image)
        percept = striate.perceive(image)
        self.assertEqual(found.points.tobytes(), percept.keypoints.tobytes())
        self.assertEqual(found.descriptors.tobytes(), percept.descriptors.tobytes())
        self.assertEqual(len(found), len(found.points))
        self.assertLessEqual(len(striate.keypoints(image, most=7)), 7)

    def test_matching_is_exact(self):
        random = np.random.default_rng(3)
        stored = random.integers(0, 256, (200, 32), np.uint8)
        queries = stored[[5, 77, 199]].copy()
        queries[1, 0] ^= 7
        found = striate.match_nearest(queries, stored)
        self.assertEqual(found["first"].tolist(), [5, 77, 199])
        self.assertEqual(found["first_bits"].tolist(), [0, 3, 0])
        for query, row in zip(queries, found):
            distances = sorted((bits_apart(query, one), i) for i, one in enumerate(stored))
            self.assertEqual((row["second_bits"], row["second"]), distances[1])
        near = striate.match_below(queries, stored, 4)
        self.assertEqual([tuple(row) for row in near.tolist()], [(0, 5, 0), (1, 77, 3), (2, 199, 0)])
        self.assertEqual(len(striate.match_nearest(queries[:0], stored)), 0)
        self.assertEqual(striate.match_nearest(queries, stored[:0])["first_bits"].tolist(), [257] * 3)

    def test_both_eyes_see_the_same_keypoints(self):
        left, right, _ = pair()
        a, b = striate.keypoints_to_learn(left), striate.keypoints_to_learn(right)
        found = striate.match_nearest(a.descriptors, b.descriptors)
        sure = found["first_bits"] < 0.6 * found["second_bits"]
        rows = a.points["v_px"][sure] - b.points["v_px"][found["first"][sure]]
        self.assertGreater(sure.sum(), 20)
        self.assertLess(np.median(np.abs(rows)), 1.0)  # of a rectified pair


if __name__ == "__main__":
    unittest.main()

"""perceive() and Perceiver: what they find is what `striate perceive` finds."""

import json
import math
import unittest

import numpy as np

import striate
from support import InScratchFolder, pair, program, read_pfm, write_ppm

FILES = ("disparity.pfm", "confidence.pfm", "obstacles.json", "keypoints.json", "saliency.png", "overview.png")


class Seeing(InScratchFolder):
    def by_program(self, left, right, options):
        """What the program writes for the same pair."""
        l, r = write_ppm(self.folder / "l.ppm", left), write_ppm(self.folder / "r.ppm", right)
        words = []
        for name, value in options.items():
            words += ["--" + name.replace("_", "-"), repr(value)] if not isinstance(value, str) else [
                "--" + name.replace("_", "-"), value]
        out = self.folder / "program"
        program("perceive", "--left", l, "--right", r, "--out", out, *words)
        return out, l, r

    def test_gives_what_the_program_writes_bit_for_bit(self):
        left, right, camera = pair()
        handed_in = left.tobytes(), right.tobytes()
        for options in (
            {**camera, "camera_height_m": 1.2, "tilt_deg": -13.0},
            {**camera, "mode": "paper", "width_px": 96},
            {},
            {**camera, "camera_height_m": 1.2, "doffs_px": 4.5},
        ):
            with self.subTest(options=options):
                out, l, r = self.by_program(left, right, options)
                percept = striate.perceive(left, right, **options)
                mine = self.folder / "mine"
                percept.write(mine, left=l, right=r)
                for name in FILES:
                    self.assertEqual((mine / name).read_bytes(), (out / name).read_bytes(), name)
                self.assertEqual(read_pfm(out / "disparity.pfm").tobytes(), percept.disparity_px.tobytes())
                self.assertEqual(read_pfm(out / "confidence.pfm").tobytes(), percept.confidence.tobytes())
                told = json.loads((out / "obstacles.json").read_text())
                self.assertEqual(len(told["obstacles"]), len(percept.obstacles))
                self.assertEqual(told["unit"], percept.unit)
                self.assertEqual(told["method"], percept.method)
                keys = json.loads((out / "keypoints.json").read_text())["keypoints"]
                self.assertEqual(len(keys), len(percept.keypoints))
                words = np.ascontiguousarray(percept.descriptors[0]).view("<u8")
                self.assertEqual(keys[0]["descriptor"], "".join(f"{int(w):016x}" for w in words))
                self.assertEqual((left.tobytes(), right.tobytes()), handed_in)

    def test_tells_obstacles_floor_and_corridor(self):
        left, right, camera = pair()
        percept = striate.perceive(left, right, **camera, camera_height_m=1.2, tilt_deg=-13.0)
        nearest = percept.obstacles[0]
        self.assertAlmostEqual(nearest["distance_m"], 2.8, delta=0.3)  # the box, 3 m on; its near side
        self.assertEqual(percept.disparity_px.shape, (120, 160))
        self.assertEqual(percept.disparity_px.dtype, np.float32)
        self.assertEqual(percept.columns.shape, (160,))
        self.assertGreater(percept.columns["bearing_rad"][0], 0.3)
        self.assertLess(percept.columns["bearing_rad"][-1], -0.3)
        self.assertIsNotNone(percept.corridor)
        self.assertLess(abs(percept.corridor.heading_rad), 0.1)
        self.assertTrue(percept.floor_known)
        self.assertGreater(percept.salience.max(), 0.0)
        self.assertGreater(len(percept.regions), 0)
        known = np.isfinite(percept.disparity_px) & (percept.disparity_px > 0)
        self.assertGreater(known.mean(), 0.3)
        depth_m = percept.focal_px * percept.baseline_m / percept.disparity_px[known]
        self.assertGreater(depth_m.min(), 0.5)
        self.assertEqual(percept.overview().shape[2], 3)

    def test_one_eye_gives_saliency_and_keypoints_alone(self):
        percept = striate.perceive(pair()[0])
        self.assertEqual(percept.disparity_px.shape, (0, 0))
        self.assertEqual(len(percept.obstacles), 0)
        self.assertGreater(len(percept.keypoints), 10)
        self.assertEqual(percept.salience.shape, (120, 160))

    def test_colours_in_rgb_and_grey_are_understood(self):
        left, right, camera = pair()
        bgr = striate.perceive(left, right, **camera)
        rgb = striate.perceive(np.ascontiguousarray(left[:, :, ::-1]), np.ascontiguousarray(right[:, :, ::-1]),
                               channels="rgb", **camera)
        self.assertEqual(bgr.disparity_px.tobytes(), rgb.disparity_px.tobytes())
        self.assertEqual(bgr.salience.tobytes(), rgb.salience.tobytes())
        grey = np.ascontiguousarray(left[:, :, 1])
        self.assertGreater(len(striate.perceive(grey).keypoints), 10)

    def test_a_cut_out_is_seen_where_it_lies(self):
        left = pair()[0]
        cut = left[40:220, 60:300]
        self.assertFalse(cut.flags.c_contiguous)
        a, b = striate.perceive(cut), striate.perceive(np.ascontiguousarray(cut))
        self.assertEqual(a.salience.tobytes(), b.salience.tobytes())

    def test_a_perceiver_is_perceive_again_and_again(self):
        left, right, camera = pair()
        perceiver = striate.Perceiver(**camera)
        first, second = perceiver.see(left, right), perceiver.see(left, right)
        once = striate.perceive(left, right, **camera)
        for percept in (first, second):
            self.assertEqual(percept.disparity_px.tobytes(), once.disparity_px.tobytes())
            self.assertEqual(percept.descriptors.tobytes(), once.descriptors.tobytes())

    def test_a_calibration_file_serves_as_for_the_program(self):
        left, right, camera = pair()
        height, width = left.shape[:2]
        f, u, v = camera["focal_px"], (width - 1) / 2, (height - 1) / 2
        calibration = self.file("calib.txt", "\n".join([
            f"cam0=[{f} 0 {u}; 0 {f} {v}; 0 0 1]", f"cam1=[{f} 0 {u}; 0 {f} {v}; 0 0 1]", "doffs=0",
            f"baseline={1000 * camera['baseline_m']}", f"width={width}", f"height={height}", "ndisp=64", ""]))
        out, l, r = self.by_program(left, right, {"calibration": str(calibration)})
        percept = striate.perceive(left, right, calibration=calibration)
        self.assertEqual(read_pfm(out / "disparity.pfm").tobytes(), percept.disparity_px.tobytes())
        self.assertAlmostEqual(percept.baseline_m, camera["baseline_m"], places=6)
        self.assertIsInstance(striate.Perceiver(calibration=[calibration]).remarks, list)

    def test_image_files_are_read_as_the_program_reads_them(self):
        left, right, _ = pair()
        l, r = write_ppm(self.folder / "l.ppm", left), write_ppm(self.folder / "r.ppm", right)
        self.assertTrue((striate.read_image(l) == left).all())
        both = striate.read_pair(str(l), r)
        self.assertTrue((both[0] == left).all() and (both[1] == right).all())

    def test_a_percept_of_a_strange_pair_says_so(self):
        left, _, camera = pair()
        percept = striate.perceive(left, left, **camera)
        self.assertEqual(len(percept.warnings), 1)
        self.assertTrue(math.isfinite(percept.light_level))


if __name__ == "__main__":
    unittest.main()

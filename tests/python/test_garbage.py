"""What cannot be seen is refused with one clear sentence."""

import math
import re
import unittest
import unittest.mock

import numpy as np

import striate
from support import InScratchFolder, pair, program, write_ppm


class Garbage(InScratchFolder):
    def refused(self, error, says, call, *arguments, **options):
        with self.assertRaises(error) as caught:
            call(*arguments, **options)
        self.assertIn(says, str(caught.exception))
        return caught.exception

    def test_arrays_that_are_no_images_are_refused_by_name(self):
        good = pair()[0]
        height, width = good.shape[:2]
        for says, image in (
            ("left: an image is a numpy array of uint8, but this is list", [[1, 2], [3, 4]]),
            ("left: an image is a numpy array of uint8, but this is NoneType", None),
            ("left: an image has pixels of uint8, but this array has float64", good.astype(float)),
            ("left: an image has pixels of uint8, but this array has int8", good.astype(np.int8)),
            ("left: an image has pixels of uint8, but this array has bool", good > 3),
            ("left: an image has pixels of uint8, but this array has object", good.astype(object)),
        ):
            self.refused(TypeError, says, striate.perceive, image)
        for says, image in (
            (f"but this array has ({height},)", good[:, 0, 0].copy()),
            ("but this array has (480, 640, 4)", np.zeros((480, 640, 4), np.uint8)),
            (f"but this array has ({height}, {width}, 1)", good[:, :, :1].copy()),
            (f"but this array has (0, {width}, 3)", good[:0]),
            ("but this array has (480, 0)", np.zeros((480, 0), np.uint8)),
            (f"but this array has (1, {height}, {width}, 3)", good[None]),
            ("but this array has ()", np.array(7, np.uint8)),
            ("must follow one another in memory", good[::-1]),
            ("must follow one another in memory", good[:, ::-1]),
            ("must follow one another in memory", good[:, ::2]),
            ("must follow one another in memory", good[:, :, ::-1]),
            ("must follow one another in memory", np.asfortranarray(good)),
            ("must follow one another in memory", np.broadcast_to(good[:1], good.shape)),
            ("must follow one another in memory", good.transpose(1, 0, 2)),
            ("sides of 16 to 16384 px can be used", np.zeros((15, 15), np.uint8)),
            ("sides of 16 to 16384 px can be used", np.zeros((17, 400), np.uint8)),
        ):
            self.refused(striate.UserError, says, striate.perceive, image)
        self.refused(TypeError, "right: an image", striate.perceive, good, 3)
        self.refused(striate.UserError, "channels 'grb'", striate.perceive, good, channels="grb")

    def test_eyes_of_different_size_are_refused(self):
        left, right, camera = pair()
        self.refused(striate.UserError, "the right one", striate.perceive, left, right[:200], **camera)

    def test_cameras_that_can_be_none_are_refused_as_on_the_command_line(self):
        left, right, camera = pair()
        l, r = write_ppm(self.folder / "l.ppm", left), write_ppm(self.folder / "r.ppm", right)
        for options in (
            {"focal_px": math.nan, "baseline_m": 0.12},
            {"focal_px": math.nan, "baseline_m": math.nan},
            {"focal_px": math.inf, "baseline_m": 0.12},
            {"focal_px": 500.0},
            {"focal_px": -500.0, "baseline_m": -0.1},
            {"focal_px": 500.0, "baseline_m": 1e9},
            {**camera, "camera_height_m": -1.0},
            {**camera, "camera_height_m": math.nan},
            {**camera, "camera_height_m": 1.0, "tilt_deg": math.nan},
            {**camera, "doffs_px": math.nan},
            {**camera, "centre_u_px": math.inf},
            {"mode": "best"},
            {"width_px": 4000},
            {"width_px": -1},
            {"candidates": -3},
            {"candidates": 257},
            {**camera, "camera_height_m": 1.0, "tilt_deg": 100.0},
            {**camera, "baseline_m": math.nan},
            {**camera, "centre_v_px": math.nan},
            {**camera, "right_centre_u_px": math.nan},
        ):
            with self.subTest(options=options):
                words = [word for name, value in options.items()
                         for word in ("--" + name.replace("_", "-"), str(value))]
                try:
                    _, said = program("perceive", "--left", l, "--right", r, "--out", self.folder / "o", *words,
                                      code=2)
                except AssertionError as error:
                    self.fail(f"the program takes it: {error}")
                error = self.refused(striate.UserError, "", striate.perceive, left, right, **options)
                self.assertNotIn("--", str(error))  # options are called otherwise here
                same = str(error).replace("left: ", "", 1).splitlines()[0]
                said = re.sub(r"--([a-z-]+)", lambda found: found[1].replace("-", "_"), said)
                # What the parser of the command line says itself is of its options.
                if not any(its in said for its in ("not in range", "requires", "not in {")):
                    self.assertIn(same, said)

    def test_what_the_command_has_no_option_for_is_refused_as_clearly(self):
        left, right, camera = pair()
        for near_px in (-1.0, math.nan, math.inf):
            self.refused(striate.UserError, f"near_px {near_px:g}: ", striate.perceive, left, right, near_px=near_px)
        for tilt_deg in (math.nan, -61.0):
            self.refused(striate.UserError, f"tilt_deg {tilt_deg:g}: ", striate.perceive, left, right, **camera,
                         tilt_deg=tilt_deg)
        self.refused(striate.UserError, "width_px 4000: ", striate.Perceiver, width_px=4000)
        self.refused(striate.UserError, "both focal_px and baseline_m", striate.Perceiver, focal_px=500)

    def test_options_of_another_kind_are_refused_by_name(self):
        left = pair()[0]
        self.refused(TypeError, "width_px: 'wide' is of the wrong kind", striate.perceive, left, width_px="wide")
        self.refused(TypeError, "width_px: 1.5", striate.perceive, left, width_px=1.5)
        self.refused(TypeError, "focal_px: [1]", striate.perceive, left, focal_px=[1])
        self.refused(TypeError, "perceive() got an unexpected keyword argument 'focal'", striate.perceive, left,
                     focal=500)
        self.refused(TypeError, "Perceiver() got an unexpected keyword argument 'focal'", striate.Perceiver, focal=500)
        self.refused(TypeError, "calibration: 3 is of", striate.Perceiver, calibration=3)
        self.refused(TypeError, "only: give a list of words, ['book']", striate.Memory.recognise, unittest.mock.Mock(),
                     left, only="book")
        self.assertEqual(striate.perceive(left, width_px=np.int64(96)).salience.shape[1], 96)
        self.assertEqual(striate.perceive(left, width_px=None).salience.shape[1], 160)

    def test_a_broken_calibration_is_told_with_its_place(self):
        left, right, _ = pair()
        broken = self.file("cam.yaml", "%YAML:1.0\n---\nM1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
                                       "   data: [ .Nan, 0., 3., 0., 1., 2., 0., 0., 1. ]\n")
        error = self.refused(striate.UserError, "cam.yaml", striate.perceive, left, right, calibration=broken)
        self.assertIn("cam.yaml", error.file or str(error))
        self.refused(striate.UserError, "none.yaml", striate.perceive, left, calibration=self.folder / "none.yaml")

    def test_files_that_are_missing_are_told_as_by_the_program(self):
        self.refused(striate.UserError, "nothing.png", striate.read_image, self.folder / "nothing.png")
        missing = self.folder / "none.db"
        error = self.refused(striate.UserError, "there is no such memory", striate.Memory, missing)
        self.assertEqual(program("memory", missing, "list", code=2)[1].strip(), str(error))
        self.refused(striate.UserError, "none.rec", striate.Recording, self.folder / "none.rec")
        self.refused(striate.UserError, "no such file", striate.Simulator, "korridor_a")
        self.refused(striate.UserError, "no such file", striate.run, "korridor", world="short")

    def test_descriptors_that_are_none_are_refused(self):
        some = np.zeros((3, 32), np.uint8)
        self.refused(TypeError, "queries: descriptors are a numpy array", striate.match_nearest, [1], some)
        self.refused(TypeError, "stored: descriptors have bytes", striate.match_nearest, some, some.astype(int))
        self.refused(striate.UserError, "(n, 32)", striate.match_nearest, some[:, :31], some)
        self.refused(striate.UserError, "below_bits", striate.match_below, some, some, 300)

    def test_settings_out_of_range_are_refused(self):
        image = pair()[0]
        self.refused(striate.UserError, "wavelength", striate.v1_responses, image, wavelength_px=math.nan)
        self.refused(striate.UserError, "wavelength", striate.v1_responses, image, wavelength_px=400.0)
        self.refused(striate.UserError, "scales", striate.keypoints, image, scales=99)
        self.refused(striate.UserError, "most", striate.keypoints, image, most=0)


if __name__ == "__main__":
    unittest.main()

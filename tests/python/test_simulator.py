"""The simulated Pioneer, a step at a time."""

import math
import threading
import unittest

import striate
from support import SHORT, InScratchFolder


class Simulators(InScratchFolder):
    def drive(self, seed):
        world = striate.Simulator(SHORT, seed=seed)
        felt = []
        for k in range(12):
            senses = world.step(forward_m_s=0.3, turn_rad_s=0.1 * (k % 3))
            felt.append((senses.now_s, tuple(senses.pose), senses.sonar.tobytes(), senses.laser.tobytes(),
                         b"" if senses.left is None else senses.left.tobytes(), senses.battery_v))
        return felt, world

    def test_the_same_seed_and_commands_give_the_same_senses(self):
        first, _ = self.drive(7)
        second, _ = self.drive(7)
        other, _ = self.drive(8)
        self.assertEqual(first, second)
        self.assertNotEqual([one[1] for one in first], [one[1] for one in other])

    def test_moves_as_it_is_told(self):
        felt, world = self.drive(7)
        self.assertAlmostEqual(world.now_s, 1.2)
        self.assertGreater(world.pose.x_m, world.start.x_m + 0.1)
        self.assertGreater(world.distance_driven_m, 0.1)
        self.assertGreater(world.clearance_m, 0.0)
        self.assertFalse(world.over)
        self.assertFalse(world.reached_goal)
        self.assertEqual(world.collisions, [])
        self.assertEqual(world.world, "short")
        self.assertEqual(world.goal_beyond_m, 12.0)
        senses = world.step(pan_rad=0.5)
        self.assertEqual(senses.left.shape, senses.right.shape)
        self.assertGreater(senses.focal_px, 100.0)
        self.assertFalse(senses.bumper)
        self.assertTrue(math.isfinite(senses.forward_m_s))
        self.assertLessEqual(felt[0][0], felt[-1][0])

    def test_images_stay_as_they_were_taken(self):
        world = striate.Simulator(SHORT, seed=2)
        kept = [world.step(turn_rad_s=1.0) for _ in range(6)]
        images = [senses.left.tobytes() for senses in kept if senses.left is not None]
        for _ in range(6):
            world.step(turn_rad_s=-1.0)
        self.assertEqual([senses.left.tobytes() for senses in kept if senses.left is not None], images)
        self.assertGreater(len(set(images)), 2)

    def test_a_touch_is_told(self):
        world = striate.Simulator(SHORT, start=striate.Pose(5.0, -0.5, 0.0))
        while not world.collisions and world.now_s < 10.0:
            world.step(forward_m_s=0.5)
        self.assertIn("box", world.collisions[0]["hit"])
        self.assertEqual(world.clearance_m, 0.0)

    def test_a_pose_is_unlike_anything_else(self):
        pose = striate.Pose(1.0, 2.0, 0.5)
        self.assertEqual(pose, striate.Pose(1.0, 2.0, 0.5))
        self.assertNotEqual(pose, striate.Pose(1.0, 2.0, 0.6))
        self.assertFalse(pose == None)  # noqa: E711: what is asked here
        self.assertTrue(pose != 3)
        self.assertNotIn(pose, [3, None, "pose"])

    def test_is_asked_by_one_thread_while_another_steps_it(self):
        world = striate.Simulator(SHORT, seed=2)
        steps = threading.Thread(target=lambda: [world.step(forward_m_s=0.3) for _ in range(20)])
        steps.start()
        times_s, lengths_m = [], []
        while steps.is_alive():
            times_s.append(world.now_s)
            lengths_m.append(world.distance_driven_m)
            self.assertEqual((world.collisions, world.over, world.reached_goal), ([], False, False))
            self.assertGreater(world.clearance_m, 0.0)
        steps.join()
        self.assertEqual(times_s, sorted(times_s))
        self.assertEqual(lengths_m, sorted(lengths_m))
        self.assertAlmostEqual(world.now_s, 2.0)

    def test_starts_where_it_is_put_or_says_why_not(self):
        world = striate.Simulator("short", start=striate.Pose(4.0, 0.2, 0.1))
        self.assertAlmostEqual(world.step().pose.x_m, 0.0, places=3)  # odometry begins there
        self.assertAlmostEqual(world.start.x_m, 4.0)
        with self.assertRaisesRegex(striate.UserError, "the start"):
            striate.Simulator("short", start=striate.Pose(4.0, 9.0, 0.0))
        with self.assertRaisesRegex(striate.UserError, "finite"):
            world.step(forward_m_s=math.nan)

    def test_mistakes_of_a_world_are_told_with_their_places(self):
        broken = self.file("bad.yaml", SHORT.read_text().replace("width: 2.4 m", "width: 2.4 kg"))
        with self.assertRaises(striate.UserError) as caught:
            striate.Simulator(broken)
        self.assertEqual(caught.exception.file, str(broken))
        self.assertEqual(caught.exception.line, 4)
        self.assertGreater(caught.exception.column, 1)
        self.assertEqual(len(caught.exception.problems), 1)


if __name__ == "__main__":
    unittest.main()

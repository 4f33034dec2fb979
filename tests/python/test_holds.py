"""A Pioneer behind the protocols of a real one, from Python: its gate holds it, and is told to let it go on."""

import subprocess
import time
import unittest

import striate
from support import PROGRAM, InScratchFolder


class Holds(InScratchFolder):
    def served_robot(self):
        """A robot's file of a simulated Pioneer that is served until the test is over."""
        served = subprocess.Popen([PROGRAM, "sim", "short", "--serve", "--port", "0"], text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.addCleanup(served.stdout.close)
        self.addCleanup(served.wait)
        self.addCleanup(served.kill)
        served.stdout.readline()
        places = dict(served.stdout.readline().split() for _ in range(4))
        lines = "".join(f"    {name}: {place}\n" for name, place in places.items())
        return self.file("robot.yaml", f"pioneer:\n  devices:\n{lines}")

    def test_a_robot_whose_program_stood_still_stands_until_the_callback_lets_it_go_on(self):
        seen, again = [], []

        def look(cycle):
            drives = cycle.senses.forward_m_s > 0.05
            seen.append((cycle.waits_for_reset, cycle.hold, drives))
            times_held = sum(waits for waits, _, _ in seen)
            if drives and times_held == 0:
                time.sleep(2.0)  # nobody decides, in the midst of motion
            if cycle.waits_for_reset and times_held % 5 == 0:
                cycle.reset()
            if drives and not cycle.hold and times_held >= 5:
                again.append(cycle.number)
            return not again and cycle.number < 200

        striate.run("", robot=self.served_robot(), each_cycle=look,
                    pilot=lambda memory: striate.Wish(forward_m_s=0.2))
        self.assertEqual([hold for waits, hold, _ in seen if waits][:4], ["the program stood still"] * 4)
        self.assertNotEqual(again, [])  # it drives again


if __name__ == "__main__":
    unittest.main()

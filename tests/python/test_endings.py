"""How missions end that the interpreter, a signal or a person ends: at a stand, and written down."""

import json
import signal
import threading
import unittest

import striate
from support import SHORT, InScratchFolder, noted_robot, script

# It would drive for ever.
DRIVE = """
import sys, threading
import striate

def drive():
    striate.run("", robot=sys.argv[1], result=sys.argv[2], memory=sys.argv[3], **options)

started = threading.Event()
options = {"pilot": lambda memory: started.set()}
"""
IN_A_DAEMON = DRIVE + """
threading.Thread(target=drive, daemon=True).start()
started.wait()
"""
IN_THE_MAIN_THREAD = DRIVE + """
options = {"pilot": lambda memory: started.set() or print("drives", flush=True)}
drive()
"""


class Endings(InScratchFolder):
    def setUp(self):
        super().setUp()
        self.result = self.folder / "result.json"
        self.robot, self.notes = noted_robot(self.folder)

    def start(self, text):
        process = script(text, self.robot, self.result, self.folder / "home.db")
        self.addCleanup(process.kill)
        return process

    def ended(self, process):
        _, said = process.communicate(timeout=60)
        return process.returncode, said

    def expect_at_a_stand(self):
        self.assertEqual(set(self.notes.read_text().splitlines()), {"stopped"})
        self.assertEqual(json.loads(self.result.read_text())["outcome"], "lost")

    def test_the_end_of_the_interpreter_ends_the_missions_of_threads_that_it_does_not_wait_for(self):
        for text in (IN_A_DAEMON, IN_A_DAEMON + "raise SystemExit(0)\n"):
            self.notes.unlink(missing_ok=True)
            self.assertEqual(self.ended(self.start(text)), (0, ""))
            self.expect_at_a_stand()
            self.assertIn("interpreter ends", json.loads(self.result.read_text())["reason"])

    def test_sigterm_ends_it_as_ctrl_c_does(self):
        for number, code in ((signal.SIGTERM, 143), (signal.SIGINT, -signal.SIGINT)):
            self.notes.unlink(missing_ok=True)
            process = self.start(IN_THE_MAIN_THREAD)
            self.assertEqual(process.stdout.readline(), "drives\n")
            process.send_signal(number)
            self.assertEqual(self.ended(process)[0], code)
            self.expect_at_a_stand()

    def test_whoever_listens_to_sigterm_goes_on_doing_so(self):
        heard = []

        def look(cycle):
            if cycle.number == 2:
                signal.raise_signal(signal.SIGTERM)
            return cycle.number < 4

        before = signal.signal(signal.SIGTERM, lambda *_: heard.append(True))
        self.addCleanup(signal.signal, signal.SIGTERM, before)
        self.assertEqual(striate.run("corridor", world=SHORT, each_cycle=look).outcome, "interrupted")
        self.assertEqual(heard, [True])
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        self.assertEqual(striate.run("corridor", world=SHORT, each_cycle=lambda cycle: False).outcome, "interrupted")
        self.assertIs(signal.getsignal(signal.SIGTERM), signal.SIG_DFL)

    def test_a_thread_hears_no_ctrl_c(self):
        outcomes = []
        drive = threading.Thread(target=lambda: outcomes.append(
            striate.run("corridor", world=SHORT, each_cycle=lambda cycle: cycle.number < 20).outcome))
        drive.start()
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt:
            pass
        drive.join()
        self.assertEqual(outcomes, ["interrupted"])


if __name__ == "__main__":
    unittest.main()

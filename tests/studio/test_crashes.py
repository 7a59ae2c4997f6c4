"""A crash of the studio: it is reported, and its work comes back."""
import glob
import os
import signal
import unittest

from studio_session import StudioTest


class Crashes(StudioTest):
    def test_a_crash_of_the_studio_is_reported_and_its_work_comes_back(self):
        studio = self.open_sample()
        studio.click('mixer.key.mute')
        recovery = self.path('.local/state/swaplight/recovery')
        studio.wait(lambda _: any(name.endswith('.swaplight') for name in os.listdir(recovery)), 'the autosave')
        studio.process.send_signal(signal.SIGSEGV)
        said = studio.process.communicate(timeout=20)[1]
        self.assertEqual(studio.process.returncode, -signal.SIGSEGV)
        [report] = glob.glob(self.path('.local/state/swaplight/crash/crash-*'))
        self.assertIn(report, said)
        with open(report) as file:
            words = file.read()
        for expected in ('SIGSEGV', 'graphics: ', 'engine: ', 'colour: ', 'system: ', 'swaplight('):
            self.assertIn(expected, words)
        studio = self.start()
        studio.item('recovery.recover')
        studio.item('message.0')
        studio.screenshot('crash_reported')
        studio.click('recovery.recover')
        studio.wait_ready()
        self.assertIn('edited', studio.state('title'))
        studio.kill()
        studio = self.start()
        studio.item('recovery.recover')
        self.assertFalse(studio.has('message.0'), 'said once')


if __name__ == '__main__':
    unittest.main()

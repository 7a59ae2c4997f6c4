"""What crashes and what does not: a picture that crashes its decoder, and the studio itself, whose crash is
reported and whose work comes back."""
import glob
import json
import os
import shutil
import signal
import sys
import unittest

from studio import HERE, SAMPLES, StudioTest

sys.path.append(os.path.join(HERE, '../cli'))
from bad_tiff import crashing_tiff, ink_tiff  # noqa: E402


class Crashes(StudioTest):
    def test_a_picture_that_crashes_its_decoder_is_a_line(self):
        self.opens_with_a_line(crashing_tiff, 'bad.tif: cannot be decoded: it crashed its decoder')

    def test_a_picture_that_would_be_read_wrongly_is_a_line(self):
        self.opens_with_a_line(ink_tiff, 'bad.tif: is a TIFF of four inks (CMYK) in tiles')

    def opens_with_a_line(self, write, words):
        """The studio opens a set with such a shot, says so, and lives."""
        shutil.copytree(os.path.join(SAMPLES, 'three_point'), self.path('set'))
        write(self.path('set/bad.tif'))
        manifest = os.path.join(self.path('set'), 'capture.json')
        with open(manifest) as file:
            capture = json.load(file)
        capture['shots'][0]['image'] = 'bad.tif'
        with open(manifest, 'w') as file:
            json.dump(capture, file)
        studio = self.start(manifest)
        studio.item('message.0')
        studio.screenshot(write.__name__)
        with open(self.path('.local/state/swaplight/swaplight.log')) as file:
            [line] = [line for line in file if 'bad.tif' in line]
        self.assertIn('error: ', line)
        self.assertIn(words, line)
        self.assertTrue(studio.quit(), 'the studio lives, and ends as it should')
        self.assertEqual(glob.glob(self.path('.local/state/swaplight/crash/crash-*')), [])

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

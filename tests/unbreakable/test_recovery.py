"""What is left of a session when the studio is killed: by its files, and by opening it again."""
import json
import os
import random
import signal
import time
import unittest

import numpy as np

from killed_studio import kill_after
from studio import StudioTest


class Recovery(StudioTest):
    def test_a_killed_session_is_whole_and_loses_little(self):
        moments = random.Random(4)
        for _ in range(4):
            found = kill_after(moments.uniform(0, 8))
            self.assertLess(found['seconds_lost'], 10, found)

    def test_what_was_killed_is_offered_and_comes_back(self):
        studio = self.open_sample()
        studio.click('mixer.key.mute')
        studio.move(640, 705)
        picture = studio.picture('recovery_before')
        recovery = os.path.join(self.folder, '.local/state/swaplight/recovery')
        studio.wait(lambda _: any(name.endswith('.swaplight') for name in os.listdir(recovery)), 'the autosave')
        studio.kill()
        studio = self.start()
        studio.item('recovery.recover')
        studio.screenshot('recovery_offered')
        studio.click('recovery.recover')
        studio.wait_ready()
        studio.move(640, 705)
        self.assertLess(np.abs(studio.picture('recovery_after') - picture).max(), 2)
        self.assertIn('edited', studio.state('title'), 'it is not in a file yet')
        studio.kill()

    def test_a_signal_ends_it_at_once_and_nothing_is_lost(self):
        studio = self.open_sample()
        studio.click('mixer.key.mute')
        recovery = os.path.join(self.folder, '.local/state/swaplight/recovery')
        kept = lambda: [os.path.join(recovery, name) for name in os.listdir(recovery) if name.endswith('.swaplight')]
        studio.wait(lambda _: kept(), 'the autosave')
        studio.click('mixer.fill.mute')  # the next autosave is two seconds away
        begin = time.time()
        studio.process.send_signal(signal.SIGTERM)
        studio.process.communicate(timeout=20)
        self.assertLess(time.time() - begin, 5)
        self.assertEqual(studio.process.returncode, 128 + signal.SIGTERM)
        with open(kept()[0]) as file:
            muted = {light['name']: light.get('mute', False) for light in json.load(file)['rig']['lights']}
        self.assertEqual(muted, {'key': True, 'fill': True, 'back': False})
        studio = self.start()
        studio.click('recovery.recover')
        studio.wait_ready()
        self.assertEqual(studio.state('mixer.fill.live'), 'muted')
        studio.kill()

    def test_a_file_that_stopped_the_studio_can_be_opened_without_its_pictures(self):
        state = os.path.join(self.folder, '.local/state/swaplight/recovery')
        os.makedirs(state)
        sample = os.path.abspath(os.path.join(os.path.dirname(__file__), '../samples/three_point/capture.json'))
        with open(os.path.join(state, '1-1.lock'), 'w') as file:
            file.write(sample)
        studio = self.start()
        studio.item('recovery.safe')
        studio.screenshot('recovery_safe')
        studio.click('recovery.safe')
        studio.wait(lambda layout: layout.get('title', '').startswith('three_point'), 'the session without pictures')
        studio.screenshot('recovery_without_pictures')
        self.assertTrue(studio.quit())


if __name__ == '__main__':
    unittest.main()

"""Every state of the studio that scripts/screenshots shows can still be come to, in the smallest window: what its script
clicks is in sight. A list that has grown beyond the window hides its last lines, and nothing else says so."""
import os
import subprocess
import tempfile
import unittest

import numpy as np

from studio_session import PROGRAM, read_png

HERE = os.path.dirname(os.path.abspath(__file__))
STATES = os.path.join(HERE, 'states')


class States(unittest.TestCase):
    def test_every_state_fits_into_the_smallest_window(self):
        # The wizard looks for colour charts in every photograph, which takes long; test_wizard has it in sight.
        for state in sorted(name for name in os.listdir(STATES) if not name.startswith('wizard')):
            with self.subTest(state), tempfile.TemporaryDirectory(prefix='swaplight_state_') as home:
                picture = os.path.join(home, 'state.png')
                environment = {**os.environ, 'HOME': home}
                for name in ('XDG_STATE_HOME', 'XDG_CONFIG_HOME', 'XDG_DATA_HOME', 'XDG_CACHE_HOME'):
                    environment.pop(name, None)
                result = subprocess.run([PROGRAM, 'studio', '-q', '--size', '1280x720', '--scale', '1', '--screenshot', picture,
                                         '--script', os.path.join(STATES, state)], env=environment, cwd=os.path.join(HERE, '../..'),
                                        stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
                self.assertEqual(result.returncode, 0, result.stderr)
                pixels = read_png(picture)
                self.assertEqual(pixels.shape, (720, 1280, 3))
                self.assertGreater(np.ptp(pixels), 100, 'something is to be seen')


if __name__ == '__main__':
    unittest.main()

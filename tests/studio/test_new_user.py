"""What a new user does first: from the first page to an exported frame with the key light at 3200 K, one stop up,
and the fill off."""
import os
import subprocess
import time
import unittest

import numpy as np
import OpenImageIO as oiio

from studio_session import PROGRAM, SAMPLES, StudioTest


class NewUser(StudioTest):
    def test_from_the_first_page_to_an_exported_frame_within_a_minute(self):
        studio = self.start()
        studio.item('welcome.sample.three_point')
        begun = time.time()
        studio.click('welcome.sample.three_point')
        studio.wait_ready()
        studio.click('mixer.key.chip')
        studio.click('light.kelvin.presets')
        studio.click('kelvin.3200')
        x, y = studio.point('mixer.key.number')
        studio.move(x, y)
        studio.xdotool('click', '--repeat', '2', '--delay', '80', '1')
        studio.settle()
        studio.key('ctrl+a')
        studio.type('1')
        studio.key('Return')
        studio.click('mixer.fill.on')
        studio.screenshot('new_user')
        studio.key('ctrl+e')
        studio.item('export.file')
        studio.key('ctrl+a')
        studio.type(self.path('frame.exr'))
        studio.key('Return')
        studio.wait(lambda _: os.path.exists(self.path('frame.exr')), 'the frame')
        seconds = time.time() - begun
        print(f'a frame after {seconds:.1f} s')
        self.assertLess(seconds, 60)
        subprocess.run([PROGRAM, 'relight', os.path.join(SAMPLES, 'three_point'), '--light', 'key=3200K,+1st', '--light',
                        'fill=off', '-o', self.path('again.exr')], check=True, capture_output=True)
        read = lambda name: np.asarray(oiio.ImageInput.open(self.path(name)).read_image('float'))
        header = oiio.ImageInput.open(self.path('frame.exr')).spec().getattribute('swaplight/rig')
        self.assertTrue(np.array_equal(read('frame.exr'), read('again.exr')), header)


if __name__ == '__main__':
    unittest.main()

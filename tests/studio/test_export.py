"""A frame that the studio exports is the one that the command line makes of its session, to the bit."""
import json
import os
import subprocess
import unittest

import numpy as np
import OpenImageIO as oiio

from studio_session import PROGRAM, SAMPLES, StudioTest


def pixels(path):
    source = oiio.ImageInput.open(path)
    assert source, oiio.geterror()
    values = np.asarray(source.read_image('float'))
    source.close()
    return values


class Export(StudioTest):
    def test_studio_and_command_line_write_the_same_frame(self):
        for sample in ('three_point', 'two_swapped', 'film_set'):
            with open(os.path.join(SAMPLES, sample, 'capture.json')) as file:
                lights = [light['name'] for light in json.load(file)['lights']]
            script = self.path(sample + '.txt')
            session = self.path(sample + '.swaplight')
            with open(script, 'w') as file:
                file.write('\n'.join([
                    f'open {os.path.join(SAMPLES, sample)}', 'wait', f'light {lights[0]} 3200K,+1st,green:+0.3',
                    f'light {lights[1]} #4060ff,-0.7st', 'action view.false_color', f'save {session}',
                    f'export {self.path(sample + ".exr")}', 'wait', f'export {self.path(sample + ".png")}', 'wait',
                    'sleep 1', 'frames 3', 'quit']))
            subprocess.run([PROGRAM, 'studio', '--screenshot', self.path('x.png'), '--script', script, '--size', '640x480'],
                           check=True, env={**os.environ, 'HOME': self.folder}, capture_output=True)
            for extension in ('exr', 'png'):
                again = self.path(f'{sample}_again.{extension}')
                subprocess.run([PROGRAM, 'relight', '--session', session, '-o', again], check=True, capture_output=True)
                self.assertTrue(np.array_equal(pixels(self.path(f'{sample}.{extension}')), pixels(again)),
                                f'{sample}.{extension}')


if __name__ == '__main__':
    unittest.main()

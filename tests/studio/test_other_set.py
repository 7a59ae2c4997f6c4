"""The lighting and the gallery of a set on another set of the same lights: a wide and a close photograph of one scene."""
import json
import os
import subprocess
import unittest

import numpy as np

from studio_session import PROGRAM, SAMPLES, StudioTest, read_float


class OtherSet(StudioTest):
    def test_the_gallery_goes_along_and_what_does_not_is_said(self):
        # The same photographs, closer, and with a lamp less and one that has another name.
        with open(os.path.join(SAMPLES, 'three_point', 'capture.json')) as file:
            manifest = json.load(file)
        folder = os.path.abspath(os.path.join(SAMPLES, 'three_point'))
        names = [light['name'] for light in manifest['lights']]
        self.assertEqual(names, ['key', 'fill', 'back'])
        manifest['lights'][2]['name'] = 'window'
        for shot in manifest['shots']:
            shot['image'] = os.path.join(folder, shot['image'])
        manifest.pop('truth', None)
        manifest |= {'crop': [120, 40, 200, 160], 'name': 'close'}
        close = self.path('close.json')
        with open(close, 'w') as file:
            json.dump(manifest, file)
        solved = self.path('close.exr')
        subprocess.run([PROGRAM, 'solve', close, '-o', solved, '-q'], check=True, capture_output=True)

        studio = self.open_sample()
        studio.key('F8')
        studio.key('ctrl+l')
        studio.settle()
        studio.type('key @ 50')
        studio.key('Return')
        studio.type('fill off')
        studio.key('Return')
        studio.key('Escape')
        studio.key('shift+v')
        studio.item('gallery.0')
        studio.settle()
        show, _ = self.save_as('show')

        studio.key('ctrl+shift+p')
        studio.settle()
        studio.type('another set')
        studio.key('Return')
        studio.item('chooser.name')
        studio.settle()
        studio.key('ctrl+a')
        studio.type(solved)
        studio.screenshot('other_set_chooser')
        studio.key('Return')
        studio.wait(lambda layout: layout.get('title', '').startswith('close.exr (edited)'), 'a new session on the other set')
        studio.wait_ready()
        studio.screenshot('other_set')
        x0, y0, x1, y1 = studio.item('viewer.picture')
        self.assertAlmostEqual((x1 - x0) / (y1 - y0), 200 / 160, delta=.03)
        self.assertTrue(studio.has('mixer.window.chip'))
        path, session = self.save_as('close')
        lights = {light['name']: light for light in session['rig']['lights']}
        self.assertEqual(list(lights), ['key', 'fill', 'window'])
        self.assertEqual((lights['key']['stops'], lights['fill']['on'], lights['window']['on']), (-1, False, True))
        self.assertEqual([look['name'] for look in session['looks']], ['Version 1'])
        self.assertEqual([light['name'] for light in session['looks'][0]['rig']['lights']], list(lights))
        with open(show) as file:
            self.assertEqual([light['name'] for light in json.load(file)['rig']['lights']], names, 'the first one stays')
        # The command line writes the same frame.
        frames = [self.path(name) for name in ('a.exr', 'b.exr')]
        for frame, source in zip(frames, ([path], [solved, '--from', show])):
            subprocess.run([PROGRAM, 'relight', *source, '-o', frame, '-q'], check=True, capture_output=True)
        np.testing.assert_array_equal(read_float(frames[0])[0], read_float(frames[1])[0])


if __name__ == '__main__':
    unittest.main()

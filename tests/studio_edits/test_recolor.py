"""Surfaces recoloured, and an unknown gel chosen by eye, in a real window."""
import json
import os
import subprocess
import unittest

import numpy as np

from studio import PROGRAM, SAMPLES, StudioTest


class Recolor(StudioTest):
    def drag_slider(self, item, start, end):
        self.studio.drag(self.studio.point(item, start), self.studio.point(item, end))

    def test_a_selected_surface_is_recoloured_and_put_back(self):
        studio = self.open_edits('left', 'two_swapped')
        studio.click('button.select.take')
        studio.click('select.similar')
        studio.item('select.tolerance')
        studio.click_at(*studio.point('viewer.picture', 0.32, 0.42))
        studio.settle()
        before = studio.picture('recolor_before')
        self.add('recolor')
        self.assertFalse(studio.has('parameters.lights'), 'a surface has one colour under all lights')
        neutral = studio.picture('recolor_neutral')
        self.drag_slider('parameters.hue', 0.5, 0.8)
        turned = studio.picture('recolor_hue')
        height, width = turned.shape[:2]
        square = np.s_[round(.4 * height):round(.44 * height), round(.31 * width):round(.33 * width)]
        self.assertGreater(np.abs(turned - neutral)[square].mean(), 10)
        self.assertLess(np.abs(turned - neutral)[:, :width // 5].max(), 1, 'other surfaces stay')
        self.drag_slider('parameters.saturation', 0.5, 0.8)
        self.drag_slider('parameters.lightness', 0.31, 0.5)
        studio.screenshot('recolor_panel')
        path, session = self.save_as('recolored')
        edit = session['edits']['edits'][0]
        self.assertEqual((edit['operation'], edit['lights'], edit['kind']), ('recolor', [], 'shift'))
        self.assertAlmostEqual(edit['hue'], 108, delta=12)
        self.assertAlmostEqual(edit['saturation'], 1.6, delta=.15)
        self.assertEqual(edit['mask'][0]['shape'], 'selection')
        self.assertNotEqual(edit['from'], [1, 1, 1], 'the mean of what is selected')
        out = self.path('line.png')
        subprocess.run([PROGRAM, 'relight', '--session', path, '-o', out, '-q'], check=True)
        for _ in range(4):
            studio.key('ctrl+z')
        studio.settle()
        self.assertLess(np.abs(studio.picture('recolor_undone') - before).mean(), 0.3)

    def test_an_unknown_gel_is_chosen_by_eye(self):
        with open(os.path.join(SAMPLES, 'two_swapped', 'capture.json')) as file:
            capture = json.load(file)
        known = capture['shots'][0]['light_colors'][0]
        capture['shots'][0]['light_colors'] = [known, '?a']
        capture['shots'][1]['light_colors'] = ['?a', known]
        for shot in capture['shots']:
            shot['image'] = os.path.join(os.path.abspath(SAMPLES), 'two_swapped', shot['image'])
        capture.pop('truth', None)
        with open(self.path('open.json'), 'w') as file:
            json.dump(capture, file)
        subprocess.run([PROGRAM, 'solve', self.path('open.json'), '-o', self.path('open.exr'), '-q'], check=True)
        studio = self.start(self.path('open.exr'))
        studio.wait_ready()
        studio.key('F4')
        studio.item('edits.add')
        before = studio.picture('gel_before')
        self.add('unknown_gel')
        self.assertLess(np.abs(studio.picture('gel_neutral') - before).mean(), 0.3, 'as it was solved')
        color = studio.state('parameters.gel')
        self.drag_slider('parameters.position', 0.02, 0.6)
        self.assertNotEqual(studio.state('parameters.gel'), color)
        self.assertGreater(np.abs(studio.picture('gel_other') - before).mean(), 0.5)
        studio.screenshot('gel_panel')
        _, session = self.save_as('gel')
        self.assertAlmostEqual(session['edits']['edits'][0]['position'], 0.6, delta=.05)

    def test_a_set_whose_colours_are_known_has_no_unknown_gel(self):
        studio = self.open_edits('left', 'two_swapped')
        studio.click('edits.add')
        studio.item('add.recolor')
        self.assertFalse(studio.has('add.unknown_gel'))


if __name__ == '__main__':
    unittest.main()

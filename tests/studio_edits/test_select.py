"""Selections, stencils, gradients and painted lights in a real window: the picture, and what the command line makes."""
import json
import subprocess
import time
import unittest

import numpy as np

from studio import PROGRAM, StudioTest, read_float


class Tools(StudioTest):
    def open(self, light='fill', key='shift+l'):
        studio = self.open_sample()
        studio.click(f'mixer.{light}.chip')
        studio.move(*studio.point('viewer.picture', 0.5, 0.2))
        studio.key(key)
        return studio

    def at(self, x, y):
        return self.studio.point('viewer.picture', x, y)

    def drag(self, x0, y0, x1, y1, steps=8):
        self.studio.drag(self.at(x0, y0), self.at(x1, y1), steps=steps)

    def lasso(self, *places):
        studio = self.studio
        studio.move(*self.at(*places[0]))
        studio.xdotool('mousedown', 1)
        for place in places[1:]:
            studio.move(*self.at(*place))
        studio.xdotool('mouseup', 1)
        studio.settle()

    def part(self, picture, x0, y0, x1, y1):
        height, width = picture.shape[:2]
        return picture[int(height * y0):int(height * y1), int(width * x0):int(width * x1)].astype(float)

    def same_as_command_line(self, name):
        path, session = self.save_as(name)
        frame, other = self.export_frame('studio.exr'), self.path('line.exr')
        subprocess.run([PROGRAM, 'relight', '--session', path, '-o', other, '-q'], check=True)
        np.testing.assert_array_equal(read_float(frame)[0], read_float(other)[0])
        return session


class Select(Tools):
    def test_a_stroke_stays_inside_a_lasso(self):
        studio = self.open()
        studio.click('select.lasso')
        before = studio.picture('select_before')
        self.lasso((0.3, 0.1), (0.5, 0.1), (0.5, 0.4), (0.3, 0.4), (0.3, 0.12))
        studio.key('shift+b')
        self.drag(0.1, 0.25, 0.9, 0.25, steps=10)
        studio.move(*self.at(0.5, 0.8))
        after = studio.picture('select_stroke_in_lasso')
        inside = self.part(after, 0.35, 0.22, 0.45, 0.28) - self.part(before, 0.35, 0.22, 0.45, 0.28)
        self.assertGreater(inside.mean(), 8)
        for x0, x1 in ((0.12, 0.27), (0.53, 0.88)):
            outside = self.part(after, x0, 0.22, x1, 0.28) - self.part(before, x0, 0.22, x1, 0.28)
            self.assertEqual(np.abs(outside).max(), 0, 'beside the lasso nothing changes')
        session = self.same_as_command_line('lasso')
        shapes = [shape['shape'] for shape in session['edits']['edits'][0]['mask']]
        self.assertEqual(shapes, ['painted', 'selection'])
        self.assertEqual(session['selection'][0]['parts'][0]['shape'], 'polygon')

    def test_a_lasso_drawn_as_a_line_is_refused(self):
        studio = self.open()
        studio.click('select.lasso')
        self.lasso((0.2, 0.3), (0.35, 0.302), (0.5, 0.299), (0.65, 0.3))
        studio.item('message.0')
        studio.screenshot('select_line')
        self.assertFalse(self.save_as('line')[1].get('selection'))
        self.lasso((0.3, 0.1), (0.5, 0.1), (0.5, 0.4), (0.3, 0.4), (0.3, 0.12))
        self.assertTrue(self.save_as('area')[1].get('selection'))

    def test_parts_are_added_taken_away_inverted_and_cleared(self):
        studio = self.open()
        studio.click('select.rectangle')
        self.drag(0.2, 0.2, 0.5, 0.6)
        studio.xdotool('keydown', 'shift')
        self.drag(0.6, 0.2, 0.8, 0.6)
        studio.xdotool('keyup', 'shift')
        studio.xdotool('keydown', 'alt')
        self.drag(0.3, 0.3, 0.4, 0.5)
        studio.xdotool('keyup', 'alt')
        studio.picture('select_parts')
        studio.key('ctrl+shift+i')
        _, session = self.save_as('parts')
        self.assertEqual([part['combine'] for part in session['selection'][0]['parts']], ['add', 'add', 'subtract'])
        self.assertTrue(session['selection'][0]['invert'])
        self.assertFalse(studio.has('select.none'))
        studio.key('ctrl+d')
        studio.item('select.none')
        studio.key('ctrl+z')
        studio.wait(lambda layout: 'select.none' not in layout['items'], 'it is selected again')

    def test_what_is_alike_is_selected_by_a_click(self):
        studio = self.open()
        studio.click('select.similar')
        studio.item('select.tolerance')
        studio.click_at(*self.at(0.5, 0.15))
        studio.picture('select_similar')
        _, session = self.save_as('alike')
        part = session['selection'][0]['parts'][0]
        self.assertEqual((part['shape'], part['by'], part['connected']), ('similar', 'color', True))

    def test_the_list_of_edits_stays_where_it_is(self):
        """Whatever kind of selection is taken, whatever gets selected: nothing moves from under the pointer."""
        studio = self.open()
        place = studio.item('edits.add')
        for kind in ('lasso', 'similar', 'shadow', 'rectangle'):
            studio.click(f'select.{kind}')
            self.assertEqual(studio.item('edits.add'), place, kind)
        self.drag(0.2, 0.2, 0.5, 0.6)
        studio.wait(lambda layout: 'select.none' not in layout['items'], 'something is selected')
        self.assertEqual(studio.item('edits.add'), place)
        studio.click('edits.add')
        studio.click('add.gain')
        studio.item('edits.0')
        self.assertEqual(studio.item('edits.add'), place, 'an edit is selected')
        studio.key('ctrl+d')
        studio.item('select.none')
        self.assertEqual(studio.item('edits.add'), place, 'nothing is selected')

    def test_the_outline_marches_light_and_dark_and_costs_little(self):
        studio = self.open()
        studio.click('select.rectangle')
        self.drag(0.3, 0.2, 0.7, 0.7)
        studio.move(*self.at(0.9, 0.95))
        x, top = self.at(0.5, 0.2)
        bottom = self.at(0.5, 0.7)[1]
        rest = studio.screenshot('select_march')
        # Dashes come round: a picture may happen to be taken when they stand as in the first.
        steps = []
        while len(steps) < 3 or len(steps) < 20 and np.ptp([step[top, x - 60:x + 60] for step in (rest, *steps)], axis=0).max() == 0:
            steps.append(studio.screenshot(f'select_march_{min(len(steps), 2)}'))
        line = rest[top - 2:top + 3, x - 60:x + 60].max(axis=(0, 2))
        self.assertGreater(line.max(), 180, 'light dashes')
        self.assertLess(rest[top - 2:top + 3, x - 60:x + 60].min(axis=(0, 2)).min(), 40, 'and dark ones')
        moved = np.max([np.abs(step - rest).max(axis=2) for step in steps], axis=0)
        self.assertGreater(moved[top - 2:top + 3, x - 60:x + 60].max(), 100, 'they march')
        inside = moved[top + 6:bottom - 6, x - 60:x + 60]
        self.assertEqual(inside.max(), 0, 'the picture stays')
        begun = studio.processor_seconds()
        time.sleep(3)
        marching = (studio.processor_seconds() - begun) / 3
        print(f'marching: {100 * marching:.0f} % of a core')
        self.assertLess(marching, 0.5, 'a few frames a second')

    def test_all_shadows_of_a_light_are_selected(self):
        studio = self.open('key')
        studio.click('select.shadow')
        studio.click('select.all_shadows')
        studio.settle()
        studio.settle()
        studio.picture('select_shadows')
        _, session = self.save_as('shadows')
        self.assertEqual(session['selection'][0]['parts'][0], {'shape': 'shadow', 'light': 'key', 'combine': 'add'})


class Stencil(Tools):
    def test_a_word_is_written_in_light(self):
        studio = self.open(key='shift+t')
        studio.click('stencil.text')
        studio.click('stencil.words')
        studio.key('ctrl+a')
        studio.type('HI')
        before = studio.picture('stencil_before')
        self.drag(0.3, 0.1, 0.5, 0.4)
        studio.move(*self.at(0.9, 0.9))
        after = studio.picture('stencil_text')
        change = np.abs(after - before).sum(axis=2)
        height, width = change.shape
        inside = change[int(height * 0.1):int(height * 0.38), int(width * 0.31):int(width * 0.49)]
        lit = (inside > 12).mean()
        self.assertGreater(lit, 0.1, 'the letters are lit')
        self.assertLess(lit, 0.9, 'and what is between them is not')
        session = self.same_as_command_line('word')
        edit = session['edits']['edits'][0]
        self.assertEqual((edit['mask'][0]['shape'], edit['mask'][0]['text']), ('text', 'HI'))
        self.assertEqual(edit['lights'], ['fill'])

        # Dragged from inside it is moved, not copied; typed again it says something else.
        x0, y0, x1, y1 = studio.item('stencil.frame')
        middle = ((x0 + x1) / 2, (y0 + y1) / 2)
        studio.drag(middle, (middle[0] + 80, middle[1] + 20))
        moved = studio.item('stencil.frame')
        self.assertAlmostEqual(moved[0] - x0, 80, delta=4)
        studio.click('stencil.words')
        studio.key('ctrl+a')
        studio.type('OH')
        studio.key('Return')
        _, session = self.save_as('moved')
        self.assertEqual([edit['mask'][0]['text'] for edit in session['edits']['edits']], ['OH'])

    def test_light_falls_off_along_a_gradient(self):
        studio = self.open(key='shift+t')
        studio.click('stencil.linear')
        before = studio.picture('gradient_before')
        self.drag(0.2, 0.3, 0.8, 0.3)
        studio.move(*self.at(0.9, 0.9))
        after = studio.picture('gradient')
        gain = [(self.part(after, x, 0.15, x + 0.04, 0.25) - self.part(before, x, 0.15, x + 0.04, 0.25)).mean()
                for x in (0.1, 0.45, 0.9)]
        self.assertGreater(gain[0], 4)  # the view is not linear, and the wall not evenly bright
        self.assertGreater(gain[1], 2)
        self.assertLess(abs(gain[2]), 1)
        self.same_as_command_line('gradient')


class PaintedLight(Tools):
    def test_a_new_light_is_painted_and_gets_a_row(self):
        studio = self.open(key='shift+b')
        before = studio.picture('light_before')
        studio.click('button.brush.new_light')
        studio.item('mixer.painted.chip')
        self.drag(0.3, 0.25, 0.6, 0.25)
        studio.move(*self.at(0.5, 0.8))
        after = studio.picture('light_painted')
        self.assertGreater((self.part(after, 0.4, 0.22, 0.5, 0.28) - self.part(before, 0.4, 0.22, 0.5, 0.28)).mean(), 8)
        session = self.same_as_command_line('light')
        self.assertEqual(session['edits']['new_lights'], ['painted'])
        self.assertEqual(session['edits']['edits'][0]['lights'], ['painted'])
        studio.key('ctrl+z', 'ctrl+z')
        studio.wait(lambda layout: 'mixer.painted.chip' not in layout['items'], 'the row has gone')


if __name__ == '__main__':
    unittest.main()

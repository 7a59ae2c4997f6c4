"""The list of edits in a real window: every kind is added and changed, the curve, names, order."""
import json
import os
import subprocess
import unittest

import numpy as np

from shadow_truth import read_float
from studio import PROGRAM, StudioTest


class Edits(StudioTest):
    def save(self, name):
        path, session = self.save_as(name)
        return path, session['edits']['edits']

    def same_as_command_line(self, session):
        frame, line = self.export_frame('studio.exr'), self.path('line.exr')
        subprocess.run([PROGRAM, 'relight', '--session', session, '-o', line, '-q'], check=True)
        np.testing.assert_array_equal(read_float(frame)[0], read_float(line)[0])

    def saved(self, path):
        """The edits as they are now, by saving over the session."""
        before = os.stat(path).st_mtime_ns
        self.studio.key('ctrl+s')
        self.studio.wait(lambda layout: os.stat(path).st_mtime_ns != before, 'it is saved')
        with open(path) as file:
            return json.load(file)['edits']['edits']

    def choose_from_menu(self, row, what):
        self.studio.click(row, x=0.8, button=3)
        self.studio.item(what)
        self.studio.settle()
        self.studio.click(what)
        self.studio.settle()

    def curve_at(self, x, y):
        """Where a point of the curve lies on the screen; y up."""
        x0, y0, x1, y1 = self.studio.item('curve')
        air = 5
        return round(x0 + air + x * (x1 - x0 - 2 * air)), round(y1 - air - y * (y1 - y0 - 2 * air))

    def drag_slider(self, item, start, end):
        self.studio.drag(self.studio.point(item, start), self.studio.point(item, end))

    def test_points_of_a_curve_are_added_dragged_and_removed(self):
        studio = self.open_edits()
        before = studio.picture('curve_before')
        self.add('curve')
        self.studio.item('parameters.not_seen')  # all lights are white: what one gets and another loses is not seen
        studio.item('curve.point.1')
        self.assertLess(np.abs(studio.picture('curve_identity') - before).mean(), 0.5, 'a new curve changes nothing')
        studio.click('parameters.add')  # white lights that share leave the picture as it is
        studio.click_at(*self.curve_at(0.5, 0.5))
        studio.item('curve.point.2')
        studio.drag(self.curve_at(0.5, 0.5), self.curve_at(0.45, 0.1))
        studio.move(*studio.point('viewer.picture', 0.5, 0.02))
        bent = studio.picture('curve_bent')
        self.assertGreater(np.abs(bent - before).mean(), 0.3)
        path, edits = self.save('bent')
        self.assertEqual(edits[0]['operation'], 'curve')
        self.assertEqual(len(edits[0]['points']), 3)
        x, y = edits[0]['points'][1]
        self.assertAlmostEqual(x, 0.45, delta=0.03)
        self.assertAlmostEqual(y, 0.1, delta=0.03)
        self.same_as_command_line(path)

        studio.key('ctrl+z')
        _, edits = self.save('undone')
        self.assertAlmostEqual(edits[0]['points'][1][1], 0.5, delta=0.03, msg='a drag is one step')
        studio.key('ctrl+shift+z')
        # Out of the field and it is gone; a double-click does the same.
        x0, y0, x1, y1 = studio.item('curve')
        studio.drag(self.curve_at(0.45, 0.1), ((x0 + x1) // 2, int(y1) + 60))
        _, edits = self.save('dragged_out')
        self.assertEqual(edits[0]['points'], [[0, 0], [1, 1]])
        studio.click_at(*self.curve_at(0.3, 0.6))
        studio.item('curve.point.2')
        studio.settle()
        studio.double_click(*self.curve_at(0.3, 0.6))
        studio.wait(lambda layout: 'curve.point.2' not in layout['items'], 'a double-click removes the point')
        studio.click_at(*self.curve_at(0.3, 0.6))
        studio.item('curve.point.2')
        studio.click('curve.reset')
        _, edits = self.save('straight')
        self.assertEqual(edits[0]['points'], [[0, 0], [1, 1]])

    def beside_the_lamp(self, picture):
        """The picture's pixels with what is drawn at the lamp's handle left out."""
        left, top, _, _ = self.studio.item('viewer.picture')
        x0, y0, x1, y1 = self.studio.item('lamp.handle')
        picture = picture.copy()
        picture[round(y0 - top) - 4:round(y1 - top) + 4, round(x0 - left) - 4:round(x1 - left) + 4] = 0
        return picture

    def test_a_lamp_is_moved_and_turned_by_sliders_and_put_back(self):
        studio = self.open_edits()
        before = studio.picture('lamp_before')
        self.add('move')
        change = self.beside_the_lamp(np.abs(studio.picture('lamp_neutral') - before))
        self.assertLess(change.mean(), .05, 'a lamp that has not moved changes nothing')
        self.drag_slider('parameters.right', 0.5, 0.8)
        moved = studio.picture('lamp_moved')
        self.assertGreater(np.abs(moved - before).mean(), 0.5)
        studio.screenshot('lamp_panel')
        self.assertNotIn('parameters.share', studio.layout()['items'], 'lamps always add')
        self.add('turn')
        self.drag_slider('parameters.tilt', 0.5, 0.7)
        studio.screenshot('lamp_turned')
        path, edits = self.save('lamps')
        self.assertEqual([edit['operation'] for edit in edits], ['move', 'turn'])
        self.assertAlmostEqual(edits[0]['right'], 0.3, delta=0.05)
        self.assertAlmostEqual(edits[1]['tilt'], 18, delta=3)
        self.same_as_command_line(path)
        for _ in range(4):
            studio.key('ctrl+z')
        studio.settle()
        self.assertLess(np.abs(studio.picture('lamp_undone') - before).mean(), .05)

    def test_a_lamp_is_dragged_in_the_picture(self):
        studio = self.open_edits()
        before = studio.picture('lamp_drag_before')
        self.add('move')
        x0, y0, x1, y1 = studio.item('viewer.picture')
        width = x1 - x0
        start = studio.point('lamp.handle')
        studio.drag(start, (start[0] + round(.5 * width), start[1]))
        studio.item('parameters.lamp.warning')
        studio.key('ctrl+z')
        studio.drag(start, (start[0] + round(.1 * width), start[1] + round(.05 * width)))
        studio.move(*studio.point('viewer.picture', .95, .95))
        studio.screenshot('lamp_dragged')
        path, edits = self.save('dragged')
        self.assertAlmostEqual(edits[0]['right'], .1, delta=.01)
        self.assertAlmostEqual(edits[0]['up'], -.05, delta=.01)
        self.assertEqual(edits[0]['distance'], 1)
        self.same_as_command_line(path)
        end = studio.point('lamp.handle')
        self.assertAlmostEqual(end[0] - start[0], .1 * width, delta=3)
        studio.key('ctrl+z')  # one step
        self.assertLess(self.beside_the_lamp(np.abs(studio.picture('lamp_drag_undone') - before)).mean(), .05)
        self.add('turn')
        start = studio.point('lamp.handle')
        studio.drag(start, (start[0] - round(.15 * width), start[1]))
        self.assertFalse(studio.has('parameters.lamp.warning'), 'a lamp that turns throws the same shadows')
        studio.move(*studio.point('viewer.picture', .95, .95))
        studio.screenshot('lamp_turned_by_hand')
        edits = self.saved(path)
        self.assertEqual([edit['operation'] for edit in edits], ['move', 'turn'])
        self.assertLess(edits[1]['pan'], -5)

    def test_a_lamp_that_is_turned_far_is_held_at_the_viewers_edge(self):
        studio = self.open_edits()
        self.add('turn')
        start = studio.point('lamp.handle')
        left, top, right, bottom = studio.item('viewer.picture')
        self.drag_slider('parameters.pan', 0.5, 0.98)
        studio.settle()
        x0, y0, x1, y1 = studio.item('lamp.handle')
        self.assertTrue(left < x0 and x1 < right and top < y0 and y1 < bottom, 'it is in the window')
        studio.item('parameters.lamp.warning')
        studio.screenshot('lamp_turned_far')
        path, edits = self.save('far')
        far = edits[0]['pan']
        self.assertGreater(far, 35)
        edge = studio.point('lamp.handle')
        studio.drag(edge, (edge[0] - 4, edge[1]))
        self.assertAlmostEqual(self.saved(path)[0]['pan'], far, delta=3)  # it is not torn to the hand
        studio.drag(studio.point('lamp.handle'), start)
        self.assertAlmostEqual(self.saved(path)[0]['pan'], 0, delta=1)

    def test_a_beam_is_widened_by_its_ring(self):
        studio = self.open_edits()
        self.add('spread')
        start = studio.point('lamp.handle')
        middle = studio.point('lamp.middle')
        self.assertGreater(abs(start[0] - middle[0]), 10)
        studio.drag(start, (round(middle[0] + 1.5 * (start[0] - middle[0])), start[1]))
        studio.move(*studio.point('viewer.picture', .95, .95))
        studio.screenshot('lamp_ring')
        path, edits = self.save('ring')
        self.assertAlmostEqual(edits[0]['width'], 1.5, delta=.05)
        self.same_as_command_line(path)
        end = studio.point('lamp.handle')
        self.assertAlmostEqual(end[0] - middle[0], 1.5 * (start[0] - middle[0]), delta=3)
        studio.key('ctrl+z')
        self.assertAlmostEqual(studio.point('lamp.handle')[0], start[0], delta=2)

    def test_every_kind_is_added_and_its_numbers_changed(self):
        studio = self.open_edits()
        self.add('gain')
        self.drag_slider('parameters.gain', 0.25, 0.5)
        self.drag_slider('parameters.offset', 0.5, 0.6)
        studio.click('parameters.add')
        self.add('fill')
        self.drag_slider('parameters.value', 0.25, 0.4)
        self.drag_slider('edits.opacity', 0.98, 0.5)
        self.add('blur')
        self.drag_slider('parameters.radius', 0.3, 0.7)
        self.add('sharpen')
        self.drag_slider('parameters.amount', 0.25, 0.75)
        self.add('invert')
        studio.click('parameters.lights')
        studio.item('parameters.lights.fill')
        studio.settle()
        studio.click('parameters.lights.fill')
        studio.click('edits.4', x=0.7, y=0.2)  # beside the list of lights: closes it
        studio.settle()
        studio.click('place')
        studio.item('place.rectangle')
        studio.settle()
        studio.click('place.rectangle')
        studio.item('place.x')
        studio.click('place.outside')
        studio.screenshot('edits_every_kind')
        path, edits = self.save('kinds')
        self.assertEqual([edit['operation'] for edit in edits], ['gain', 'fill', 'blur', 'sharpen', 'invert'])
        gain, fill, blur, sharpen, invert = edits
        self.assertAlmostEqual(gain['gain'], 2, delta=0.15)
        self.assertAlmostEqual(gain['offset'], 0.2, delta=0.05)
        self.assertEqual(gain['meaning'], 'add')
        self.assertAlmostEqual(fill['value'], 0.8, delta=0.05)
        self.assertAlmostEqual(fill['opacity'], 0.5, delta=0.04)
        self.assertGreater(blur['radius'], 20)
        self.assertAlmostEqual(sharpen['amount'], 3, delta=0.15)
        self.assertEqual(invert['lights'], ['key', 'fill'])
        self.assertEqual(invert['mask'][0]['shape'], 'rectangle')
        self.assertTrue(invert['mask'][0]['invert'])
        self.same_as_command_line(path)

    def test_the_other_lights_give_way_or_stay(self):
        studio = self.open_edits()
        before = studio.picture('edits_fill_before')
        self.add('fill')
        self.drag_slider('parameters.value', 0.25, 0.02)
        studio.move(*studio.point('viewer.picture', 0.5, 0.02))
        self.assertLess(np.abs(studio.picture('edits_filled') - before)[:, 10:-10].mean(), 0.6,
                        'under white lights the others give what it loses')
        studio.click('parameters.add')
        studio.move(*studio.point('viewer.picture', 0.5, 0.02))
        self.assertLess(studio.picture('edits_light_gone').mean(), before.mean() - 5)

    def test_edits_are_renamed_by_f2_and_by_a_double_click(self):
        studio = self.open_edits()
        self.add('blur')
        self.add('gain')
        studio.click('edits.0', x=0.6, y=0.5)
        studio.key('F2')
        studio.item('edits.name_field')
        studio.key('ctrl+a')
        studio.type('Soft key')
        studio.key('Return')
        studio.wait(lambda layout: 'edits.name_field' not in layout['items'], 'the name is taken')
        studio.double_click(*studio.point('edits.1', 0.6, 0.5))
        studio.item('edits.name_field')
        studio.key('ctrl+a')
        studio.type('Stronger')
        studio.key('Return')
        _, edits = self.save('names')
        self.assertEqual([edit['name'] for edit in edits], ['Soft key', 'Stronger'])
        # Escape keeps the name; a click into the mixer gives F2 back to the light.
        studio.click('edits.0', x=0.6, y=0.5)
        studio.key('F2')
        studio.item('edits.name_field')
        studio.type('no')
        studio.key('Escape')
        studio.wait(lambda layout: 'edits.name_field' not in layout['items'], 'the name is kept')
        studio.click('mixer.fill.chip')
        studio.key('F2')
        studio.settle()
        self.assertFalse(studio.has('edits.name_field'))
        studio.key('Escape')
        _, edits = self.save('names_kept')
        self.assertEqual([edit['name'] for edit in edits], ['Soft key', 'Stronger'])

    def test_edits_are_put_into_another_order_by_dragging(self):
        studio = self.open_edits()
        for kind in ('fill', 'gain', 'invert'):
            self.add(kind)
        studio.click('edits.2', x=0.6, y=0.5)  # closes it: rows alone
        studio.settle()
        before = studio.picture('order_before')
        studio.drag(studio.point('edits.0', 0.5), studio.point('edits.2', 0.5))
        studio.settle()
        path, edits = self.save('order')
        self.assertEqual([edit['operation'] for edit in edits], ['gain', 'invert', 'fill'])
        self.same_as_command_line(path)
        studio.key('ctrl+z')
        studio.settle()
        self.assertLess(np.abs(studio.picture('order_undone') - before)[:, 10:-10].mean(), 0.5)
        _, edits = self.save('order_back')
        self.assertEqual([edit['operation'] for edit in edits], ['fill', 'gain', 'invert'])
        studio.click('edits.1', x=0.6, y=0.5)
        studio.key('Delete')
        _, edits = self.save('deleted')
        self.assertEqual([edit['operation'] for edit in edits], ['fill', 'invert'])

    def test_each_change_of_the_list_is_one_step_that_undo_takes_back(self):
        studio = self.open_edits()
        self.add('fill')
        self.add('gain')
        studio.click('edits.1', x=0.6, y=0.5)  # closes it: rows alone
        studio.settle()
        path, base = self.save('steps')

        def rename():
            self.choose_from_menu('edits.0', 'edits.rename')
            studio.item('edits.name_field')
            studio.key('ctrl+a')
            studio.type('Half a key')
            studio.key('Return')

        def dim():
            studio.click('edits.1', x=0.6, y=0.5)
            studio.settle()
            self.drag_slider('edits.opacity', 0.98, 0.4)

        names = lambda edits: [edit['name'] for edit in edits]
        fill, gain = names(base)
        steps = [
            ('eye', lambda: studio.click('edits.1.on'), lambda edits: self.assertEqual([e['on'] for e in edits], [True, False])),
            ('rename', rename, lambda edits: self.assertEqual(names(edits), ['Half a key', gain])),
            ('duplicate', lambda: self.choose_from_menu('edits.0', 'edits.duplicate'),
             lambda edits: self.assertEqual(names(edits), [fill, fill + ' copy', gain])),
            ('up', lambda: self.choose_from_menu('edits.0', 'edits.up'), lambda edits: self.assertEqual(names(edits), [gain, fill])),
            ('down', lambda: self.choose_from_menu('edits.1', 'edits.down'), lambda edits: self.assertEqual(names(edits), [gain, fill])),
            ('delete', lambda: self.choose_from_menu('edits.1', 'edits.delete'), lambda edits: self.assertEqual(names(edits), [fill])),
            ('opacity', dim, lambda edits: self.assertAlmostEqual(edits[1]['opacity'], 0.4, delta=0.05)),
            ('meaning', lambda: studio.click('parameters.add'),
             lambda edits: self.assertEqual([e['meaning'] for e in edits], ['share', 'add'])),
        ]
        for name, act, check in steps:
            with self.subTest(name):
                act()
                studio.settle()
                studio.screenshot('steps_' + name)
                check(self.saved(path))
                studio.key('ctrl+z')
                self.assertEqual(self.saved(path), base)


if __name__ == '__main__':
    unittest.main()

"""The page of shadows and beta in a real window: outlines where shadows are, thresholds, a shadow that is clicked and changed."""
import json
import os
import subprocess
import unittest

import numpy as np

from shadow_truth import deepest, labels_of, missing_of, read_float
from studio import PROGRAM, SAMPLES, StudioTest

UMBRA = np.array([60, 214, 255])
SET = os.path.join(SAMPLES, 'three_point')
LIGHT = 'key'
LIGHTS = ('key', 'fill', 'back')


class Shadows(StudioTest):
    size = (1280, 840)

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        import tempfile
        cls.scratch = tempfile.TemporaryDirectory(prefix='swaplight-shadows-')
        capture, umbra = os.path.join(SET, 'capture.json'), 1
        cls.labels = labels_of(capture, LIGHT, cls.scratch.name)
        # Where a cast shadow is deepest: what only turns away is dark of itself, and removing it hardly shows.
        missing = missing_of(capture, LIGHT, cls.scratch.name)
        cls.spot = deepest((cls.labels == umbra) & (missing > np.median(missing[cls.labels == umbra])))

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()
        super().tearDownClass()

    def open_page(self):
        studio = self.open_sample()
        studio.click(f'mixer.{LIGHT}.chip')
        studio.move(*studio.point('viewer.picture', 0.5, 0.02))
        studio.key('F3')
        studio.item('shadows.histogram')
        self.found()
        return studio

    def found(self):
        self.studio.wait(lambda layout: 'button.shadows.outlines' in layout['items'] and layout.get('shadows.outlines') == 'drawn',
                         'the shadows are found')
        self.studio.settle()

    def window(self):
        return [float(number) for number in self.studio.state('viewer.window').split()]

    def screen_of(self, x, y):
        """Where a pixel of the picture is on the screen."""
        left, top, zoom = self.window()
        x0, y0, _, _ = self.studio.item('viewer')
        return round(x0 + (x + 0.5 - left) * zoom), round(y0 + (y + 0.5 - top) * zoom)

    def click_pixel(self, x, y):
        self.studio.click_at(*self.screen_of(x, y))

    def around(self, picture, grow=0):
        """The mean of the picture on the screen where the shadow is deepest."""
        x, y, half = self.spot
        half = max(1, half - 1 + grow)
        x0, y0, _, _ = map(int, self.studio.item('viewer.picture'))
        a, b = self.screen_of(x - half, y - half), self.screen_of(x + half, y + half)
        return picture[a[1] - y0:b[1] - y0, a[0] - x0:b[0] - x0].mean()

    def check_outlines(self, name):
        """Every bright line on the screen lies on a border of the umbra."""
        shot = self.studio.screenshot(name)
        x0, y0, x1, y1 = map(int, self.studio.item('viewer.picture'))
        legend = list(map(int, self.studio.item('shadows.legend')))
        lines = np.abs(shot - UMBRA).max(2) < 40
        lines[:y0] = lines[y1:] = False
        lines[:, :x0] = lines[:, x1:] = False
        lines[legend[1]:legend[3], legend[0]:legend[2]] = False
        if self.studio.has('shadows.mark.0'):  # a label's ring has the colour of what it says
            left, top, right, bottom = map(int, self.studio.item('shadows.mark.0'))
            lines[top - 2:bottom + 2, left - 2:right + 2] = False
        self.assertGreater(lines.sum(), 100, 'there are outlines')
        umbra = self.labels == 1
        left, top, zoom = self.window()
        vx, vy, _, _ = self.studio.item('viewer')
        ys, xs = np.nonzero(lines)
        px, py = (xs + 0.5 - vx) / zoom + left, (ys + 0.5 - vy) / zoom + top
        near = np.zeros(len(px), bool)
        reach = int(np.ceil(2 / zoom)) + 1
        height, width = umbra.shape
        values = []
        for dy in range(-reach, reach + 1):
            for dx in range(-reach, reach + 1):
                values.append(umbra[np.clip((py + dy).astype(int), 0, height - 1), np.clip((px + dx).astype(int), 0, width - 1)])
        near = np.any(values, 0) & ~np.all(values, 0)
        rim = (px < 3) | (py < 3) | (px > width - 3) | (py > height - 3)
        self.assertGreater((near | rim).mean(), 0.97, 'lines lie on borders')

    def test_outlines_lie_on_the_shadows_under_zoom_and_pan(self):
        studio = self.open_page()
        self.check_outlines('shadows_page')
        x, y, _ = self.spot
        studio.move(*self.screen_of(x, y))
        for _ in range(8):
            studio.xdotool('click', 4)
        studio.settle()
        self.check_outlines('shadows_zoomed')
        at = studio.point('viewer.picture', 0.5, 0.5)
        studio.drag(at, (at[0] + 60, at[1] + 30))
        self.check_outlines('shadows_panned')
        studio.key('shift+F3')
        shot = studio.screenshot('shadows_no_outlines')
        self.assertFalse(studio.has('shadows.legend'))
        x0, y0, x1, y1 = map(int, studio.item('viewer.picture'))
        self.assertLess((np.abs(shot[y0:y1, x0:x1] - UMBRA).max(2) < 40).sum(), 20)

    def test_the_threshold_is_dragged_saved_and_found_again(self):
        studio = self.open_page()
        x0, y0, x1, y1 = studio.item('shadows.threshold')
        h0, _, h1, _ = studio.item('shadows.histogram')
        middle, height = (x0 + x1) // 2, (y0 + y1) // 2
        def outlines():
            left, top, right, bottom = map(int, studio.item('viewer.picture'))
            return np.abs(studio.screenshot('shadows_threshold_held')[top:bottom, left:right] - UMBRA).max(2) < 40

        before = outlines()
        studio.move(middle, height)
        studio.xdotool('mousedown', 1)
        studio.move(round(middle + 0.06 * (h1 - h0)), height)
        studio.move(round(middle + 0.12 * (h1 - h0)), height)
        studio.settle()
        self.assertGreater((outlines() != before).sum(), 100, 'outlines follow the hand')
        studio.xdotool('mouseup', 1)
        self.found()
        studio.screenshot('shadows_threshold')
        _, session = self.save_as('threshold')
        moved = session['edits']['shadow_thresholds']
        self.assertEqual(list(moved), [LIGHT])
        self.assertGreater(studio.item('shadows.threshold')[0], x0 + 10)
        self.labels = labels_of(os.path.join(SET, 'capture.json'), LIGHT, self.folder, '--threshold', f'{LIGHT}={moved[LIGHT]}')
        self.check_outlines('shadows_threshold')
        studio.key('ctrl+z')
        studio.settle()
        self.assertEqual(studio.item('shadows.threshold')[0], x0, 'the drag was one step')
        studio.key('ctrl+shift+z')
        studio.click('shadows.auto')
        studio.settle()
        self.assertEqual(studio.item('shadows.threshold')[0], x0)
        _, session = self.save_as('automatic')
        self.assertNotIn('shadow_thresholds', session.get('edits', {}))

    def hatched(self, name):
        """Whether each pixel of the viewer bears the hatching's colour, and what it covers is not told."""
        studio = self.studio
        shot = studio.screenshot(name).astype(int)
        x0, y0, x1, y1 = map(int, studio.item('viewer.picture'))
        ink = (shot[..., 0] > 150) & (np.abs(shot[..., 0] - 1.5 * shot[..., 1]) < 40) & (shot[..., 0] - shot[..., 2] > 90)
        legend = list(map(int, studio.item('shadows.legend')))
        ink[legend[1]:legend[3], legend[0]:legend[2]] = False
        ys, xs = np.nonzero(ink[y0:y1, x0:x1])
        left, top, zoom = self.window()
        vx, vy, _, _ = studio.item('viewer')
        px, py = (xs + x0 + 0.5 - vx) / zoom + left, (ys + y0 + 0.5 - vy) / zoom + top
        height, width = self.labels.shape
        untold = self.labels[np.clip(py.astype(int), 0, height - 1), np.clip(px.astype(int), 0, width - 1)] == 0
        return len(untold), untold.mean() if len(untold) else 0

    def test_what_cannot_be_told_is_hatched_and_explained(self):
        studio = self.open_page()
        light = min(LIGHTS, key=lambda name: (labels_of(os.path.join(SET, 'capture.json'), name, self.folder) == 0).mean() == 0)
        studio.click(f'mixer.{light}.chip')
        self.found()
        self.labels = labels_of(os.path.join(SET, 'capture.json'), light, self.folder)
        share = (self.labels == 0).mean()
        self.assertGreater(share, 0.002, 'the sample has places of which nothing can be told')
        self.assertAlmostEqual(float(studio.state('shadows.untold')), share, delta=0.001)
        count, inside = self.hatched('shadows_hatched')
        self.assertGreater(count, 50)
        self.assertGreater(inside, 0.7)
        x0, y0, x1, y1 = studio.item('shadows.legend')
        studio.move((x0 + x1) // 2, round(y0 + 0.83 * (y1 - y0)))
        studio.settle()
        studio.screenshot('shadows_legend_tip')
        # One click tells it.
        x, y, _ = deepest(self.labels == 0)
        studio.click('button.shadows.mark_shadow')
        self.click_pixel(x, y)
        self.found()
        studio.screenshot('shadows_told')
        self.assertLess(float(studio.state('shadows.untold')), share)

    def test_a_click_says_what_is_lit_and_what_is_shadow(self):
        studio = self.open_page()
        x, y, _ = self.spot
        studio.click('button.shadows.mark_lit')
        self.click_pixel(x, y)
        studio.item('shadows.mark.0')
        self.found()
        studio.screenshot('shadows_called_lit')
        _, session = self.save_as('lit')
        marks = session['edits']['shadow_marks']
        self.assertEqual((list(marks), [mark['is'] for mark in marks[LIGHT]]), ([LIGHT], ['lit']))
        at = marks[LIGHT][0]['at']
        self.assertLessEqual(np.abs(np.subtract(at, (x, y))).max(), 2)
        before = self.labels
        self.labels = labels_of(os.path.join(SET, 'capture.json'), LIGHT, self.folder, '--label-lit', f'{LIGHT}={at[0]},{at[1]}')
        self.assertEqual(self.labels[at[1], at[0]], 3)
        self.assertGreater(((before == 1) & (self.labels == 3)).sum(), 50, 'its surface, not the pixel')
        self.check_outlines('shadows_called_lit')
        # A step of the history; the same click takes it back.
        studio.key('ctrl+z')
        studio.wait(lambda layout: 'shadows.mark.0' not in layout['items'], 'the label is undone')
        studio.key('ctrl+shift+z')
        studio.item('shadows.mark.0')
        self.click_pixel(*at)
        studio.wait(lambda layout: 'shadows.mark.0' not in layout['items'], 'the same click removes it')
        self.found()
        self.labels = before
        self.check_outlines('shadows_label_removed')
        # And the other way round.
        studio.click('button.shadows.mark_shadow')
        lit = deepest(before == 3)
        self.click_pixel(*lit[:2])
        studio.item('shadows.mark.0')
        self.found()
        studio.screenshot('shadows_called_shadow')
        _, session = self.save_as('shadow')
        mark = session['edits']['shadow_marks'][LIGHT][0]
        self.assertEqual(mark['is'], 'shadow')
        where = '{},{}'.format(*mark['at'])
        self.labels = labels_of(os.path.join(SET, 'capture.json'), LIGHT, self.folder, '--label-shadow', f'{LIGHT}={where}')
        self.assertEqual(self.labels[mark['at'][1], mark['at'][0]], 1)
        self.check_outlines('shadows_called_shadow')
        studio.click('button.shadows.clear_marks')
        studio.wait(lambda layout: 'shadows.mark.0' not in layout['items'], 'all labels are cleared')
        _, session = self.save_as('cleared')
        self.assertNotIn('shadow_marks', session.get('edits', {}))

    def test_a_shadow_that_is_clicked_is_removed_alone(self):
        studio = self.open_page()
        studio.key('shift+F3')
        before = studio.picture('shadows_before')
        x, y, half = self.spot
        self.click_pixel(x, y)
        studio.item('shadows.choose_all')
        studio.screenshot('shadows_chosen')
        studio.click('shadows.remove')
        self.save_as('removed')
        studio.key('Escape')
        studio.wait(lambda layout: 'shadows.choose_all' not in layout['items'], 'Escape lets go of the shadow')
        after = studio.picture('shadows_removed')
        self.assertGreater(self.around(after), self.around(before) + 8)
        path, session = self.save_as('removed_one')
        edits = session['edits']['edits']
        self.assertEqual([(edit['operation'], edit['kind'], edit['amount'], edit['lights']) for edit in edits],
                         [('shadow', 'lighten', 1, [LIGHT])])
        self.assertEqual(edits[0]['mask'][0]['shape'], 'shadow')
        ax, ay = edits[0]['mask'][0]['at']
        self.assertIn(self.labels[int(ay), int(ax)], (1, 2))
        frame = self.export_frame('studio.exr')
        line = self.path('line.exr')
        subprocess.run([PROGRAM, 'relight', '--session', path, '-o', line, '-q'], check=True)
        np.testing.assert_array_equal(read_float(frame)[0], read_float(line)[0])
        studio.key('ctrl+z')
        self.assertLess(abs(self.around(studio.picture('shadows_undone')) - self.around(before)), 1)

    def test_each_slider_is_one_edit_and_each_drag_one_step(self):
        studio = self.open_page()
        studio.key('shift+F3')
        before = studio.picture('shadows_sliders_before')

        def drag(item, start, end):
            studio.drag(studio.point(item, start), studio.point(item, end))

        studio.move(*studio.point('shadows.lighten', 0.5))
        studio.xdotool('mousedown', 1)
        for x in (0.6, 0.7, 0.75):
            studio.move(*studio.point('shadows.lighten', x))
        self.assertGreater(self.around(studio.picture('shadows_held')), self.around(before) + 3, 'while it is held')
        studio.xdotool('mouseup', 1)
        lightened = studio.picture('shadows_lightened')
        self.assertGreater(self.around(lightened), self.around(before) + 3)
        drag('shadows.lighten', 0.75, 0.1)
        self.assertLess(self.around(studio.picture('shadows_deepened')), self.around(before) + 0.5)
        drag('shadows.soften', 0.02, 0.8)
        drag('shadows.sharpen', 0.02, 0.6)
        drag('shadows.recolor', 0.02, 0.7)
        colored = studio.picture('shadows_coloured')
        self.assertGreater(self.around(colored), self.around(before) + 2)
        _, session = self.save_as('sliders')
        edits = session['edits']['edits']
        self.assertEqual([edit['kind'] for edit in edits], ['deepen', 'soften', 'sharpen', 'recolor'])
        self.assertGreater(edits[1]['radius'], 20)
        # Another colour, and another kind, are a step each.
        studio.click('shadows.colour')
        studio.settle()
        studio.screenshot('shadows_picker')
        x, _ = studio.point('shadows.colour', 0.5, 1)
        studio.click_at(x + 22, self.size[1] - 248)  # the ring, at its left: the picker stands on the window's lower edge
        studio.key('Escape')
        studio.settle()
        _, session = self.save_as('colour')
        self.assertGreater(np.abs(np.subtract(session['edits']['edits'][3]['color'], edits[3]['color'])).max(), 0.05)
        studio.click('edits.2', x=0.6)
        studio.item('parameters.kind')  # the list scrolls to it
        studio.settle()
        studio.click('parameters.kind')
        studio.item('parameters.kind.deepen')
        studio.settle()
        studio.screenshot('shadows_kinds')
        studio.click('parameters.kind.deepen')
        _, session = self.save_as('kind')
        self.assertEqual([edit['kind'] for edit in session['edits']['edits']], ['deepen', 'soften', 'deepen', 'recolor'])
        for _ in range(6):
            studio.key('ctrl+z')
        self.assertLess(abs(self.around(studio.picture('shadows_one_step_left')) - self.around(lightened)), 1)
        studio.key('ctrl+z')
        self.assertLess(abs(self.around(studio.picture('shadows_all_undone')) - self.around(before)), 1)
        self.assertFalse(studio.has('edits.0'))

    def test_a_light_is_chosen_on_the_page_and_a_place_without_shadow_is_said(self):
        studio = self.open_page()
        key = studio.screenshot('shadows_of_key')
        studio.click('shadows.light')
        studio.item('shadows.light.back')
        studio.settle()
        studio.click('shadows.light.back')
        self.found()
        x0, y0, x1, y1 = map(int, studio.item('viewer.picture'))
        back = studio.screenshot('shadows_of_back')
        lines = [np.abs(shot[y0:y1, x0:x1] - UMBRA).max(2) < 40 for shot in (key, back)]
        self.assertGreater((lines[0] != lines[1]).sum(), 200, 'another light, other outlines')
        studio.click('mixer.key.chip')
        self.found()
        x, y, _ = deepest(self.labels == 3)
        self.click_pixel(x, y)
        studio.item('message.0')
        studio.screenshot('shadows_none_here')
        self.assertFalse(studio.has('shadows.choose_all'))
        studio.click('shadows.remove')
        studio.item('edits.0')
        studio.settle()
        studio.click('shadows.remove')  # brings them back
        studio.wait(lambda layout: 'edits.0' not in layout['items'], 'nothing is changed any more')
        studio.key('ctrl+z')
        studio.item('edits.0')

    def test_the_views_show_beta_light_and_reach(self):
        studio = self.open_page()
        studio.key('shift+F3')
        pictures = {}
        for view in ('beta', 'light', 'reach', 'picture'):
            studio.click('shadows.view.' + view)
            studio.settle()
            pictures[view] = studio.picture('shadows_view_' + view)
        lit = deepest(self.labels == 3)
        x0, y0, _, _ = map(int, studio.item('viewer.picture'))
        at = [tuple(np.subtract(self.screen_of(x, y), (x0, y0))) for x, y in (self.spot[:2], lit[:2])]
        for view in ('beta', 'light', 'reach'):
            shadow, bright = (pictures[view][y, x].mean() for x, y in at)
            self.assertLess(shadow, bright, view)
        self.assertLess(pictures['reach'][at[0][1], at[0][0]].mean(), 40)
        self.assertGreater(pictures['reach'][at[1][1], at[1][0]].mean(), 200)


class LowWindow(StudioTest):
    def test_the_page_leaves_room_for_the_edits_in_a_low_window(self):
        studio = self.open_edits()
        studio.key('F3')
        studio.item('shadows.histogram')
        studio.wait(lambda layout: layout.get('shadows.outlines') == 'drawn', 'the shadows are found')
        studio.settle()
        self.assertLess(studio.item('edits.add')[1], 460, 'of 720')
        outlines, auto = studio.item('button.shadows.outlines'), studio.item('shadows.auto')
        self.assertLess(abs(outlines[1] - auto[1]), 2)
        self.assertLess(outlines[2], auto[0])
        self.assertLess(studio.item('shadows.remove')[3], studio.item('shadows.lighten')[1] + 1)
        studio.screenshot('shadows_low_window')


if __name__ == '__main__':
    unittest.main()

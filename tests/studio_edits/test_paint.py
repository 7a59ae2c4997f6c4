"""Light painting and the list of edits in a real window: the picture, the saved session, the exported frame."""
import json
import subprocess
import unittest

import numpy as np

from studio import PROGRAM, StudioTest, read_float


class Paint(StudioTest):
    def take_brush(self, light='fill'):
        studio = self.open_sample()
        studio.click(f'mixer.{light}.chip')
        studio.move(*studio.point('viewer.picture', 0.5, 0.2))
        studio.key('shift+b')
        studio.item('brush.size')
        return studio

    def stroke(self, x0, x1, y=0.25):
        self.studio.drag(self.studio.point('viewer.picture', x0, y), self.studio.point('viewer.picture', x1, y), steps=6)

    def part(self, picture, x0, x1, y=0.25):
        height, width = picture.shape[:2]
        return picture[int(height * y) - 4:int(height * y) + 4, int(width * x0):int(width * x1)].mean()

    def near(self, picture, other):
        """The same where the stroke was; a tooltip may lie elsewhere."""
        for x in (0.35, 0.45, 0.55, 0.65):
            self.assertLess(abs(self.part(picture, x, x + 0.03) - self.part(other, x, x + 0.03)), 1)

    def test_light_is_painted_on_the_wall_half_of_it_erased_and_both_undone(self):
        studio = self.take_brush()
        before = studio.picture('paint_before')
        self.stroke(0.3, 0.7)
        painted = studio.picture('paint_painted')
        self.assertGreater(self.part(painted, 0.32, 0.45), self.part(before, 0.32, 0.45) + 8)
        self.assertGreater(self.part(painted, 0.55, 0.68), self.part(before, 0.55, 0.68) + 8)
        np.testing.assert_array_equal(painted[-60:], before[-60:], 'far from the stroke nothing changes')

        studio.key('x')
        self.stroke(0.55, 0.72)
        erased = studio.picture('paint_erased')
        self.assertGreater(self.part(erased, 0.32, 0.45), self.part(before, 0.32, 0.45) + 8)
        self.assertLess(abs(self.part(erased, 0.6, 0.66) - self.part(before, 0.6, 0.66)), 2)
        _, session = self.save_as('erased')
        self.assertEqual(len(session['edits']['edits']), 1)
        strokes = session['edits']['edits'][0]['mask'][0]['strokes']
        self.assertEqual([stroke['erase'] for stroke in strokes], [False, True])
        self.assertEqual(session['edits']['edits'][0]['lights'], ['fill'])

        studio.key('ctrl+z')
        self.assertLess(np.abs(studio.picture('paint_undo_1') - painted)[:, 10:-10].mean(), 0.5)
        studio.key('ctrl+z')
        self.assertLess(np.abs(studio.picture('paint_undo_2') - before)[:, 10:-10].mean(), 0.5)
        self.assertFalse(studio.has('edits.0'), 'the list is empty again')

    def test_the_studio_and_the_command_line_write_the_same_frame(self):
        studio = self.take_brush('key')
        self.stroke(0.2, 0.8, 0.4)
        path, _ = self.save_as('painted')
        frame, other = self.export_frame('studio.exr'), self.path('line.exr')
        subprocess.run([PROGRAM, 'relight', '--session', path, '-o', other, '-q'], check=True)
        np.testing.assert_array_equal(read_float(frame)[0], read_float(other)[0])
        plain = self.path('plain.exr')
        with open(path) as file:
            session = json.load(file)
        del session['edits']
        with open(path, 'w') as file:
            json.dump(session, file)
        subprocess.run([PROGRAM, 'relight', '--session', path, '-o', plain, '-q'], check=True)
        self.assertGreater(np.abs(read_float(frame)[0] - read_float(plain)[0]).max(), 0.02)

    def test_paint_follows_edges_where_the_switch_is_on(self):
        studio = self.take_brush('key')
        def picture(name):
            studio.move(*studio.point('viewer.picture', 0.06, 0.12))  # the brush's ring in one place
            return studio.picture(name)
        studio.key('bracketright', 'bracketright', 'bracketright')
        before = picture('edges_before')
        wall = lambda seen: self.part(seen, 0.29, 0.31, 0.79) - self.part(before, 0.29, 0.31, 0.79)
        cloth = lambda seen: self.part(seen, 0.29, 0.31, 0.88) - self.part(before, 0.29, 0.31, 0.88)
        self.stroke(0.30, 0.31, 0.86)  # on the shoulder, and over its rim
        plain = picture('edges_plain')
        self.assertGreater(wall(plain), 3)
        self.assertGreater(cloth(plain), 7)
        studio.key('ctrl+z', 'shift+x')
        self.assertLess(np.abs(picture('edges_undone') - before)[:, 10:-10].mean(), 0.5)
        self.stroke(0.30, 0.31, 0.86)
        painted = picture('edges_painted')
        self.assertLess(wall(painted), 0.3, 'it stops at the edge')
        self.assertAlmostEqual(cloth(painted), cloth(plain), delta=0.3)
        path, session = self.save_as('edges')
        self.assertEqual([stroke.get('edges') for stroke in session['edits']['edits'][0]['mask'][0]['strokes']], [True])
        # From its file it is the same: in the studio, after a further stroke, and on the command line.
        studio.quit()
        studio = self.start(path)
        studio.wait_ready()
        again = studio.picture('edges_again')
        ring = slice(None), slice(painted.shape[1] // 6, None)
        self.assertLess(np.abs(again - painted)[ring].mean(), 0.5)
        studio.click('mixer.key.chip')
        studio.move(*studio.point('viewer.picture', 0.5, 0.2))
        studio.key('shift+b')
        studio.item('brush.size')
        self.stroke(0.2, 0.25, 0.2)
        path, session = self.save_as('more')
        self.assertEqual([stroke.get('edges') for stroke in session['edits']['edits'][0]['mask'][0]['strokes']], [True, None])
        frame, other = self.export_frame('studio.exr'), self.path('line.exr')
        subprocess.run([PROGRAM, 'relight', '--session', path, '-o', other, '-q'], check=True)
        np.testing.assert_array_equal(read_float(frame)[0], read_float(other)[0])

    def test_an_edit_is_switched_off_dimmed_copied_and_deleted(self):
        studio = self.take_brush()
        before = studio.picture('edits_before')
        self.stroke(0.3, 0.7)
        painted = studio.picture('edits_painted')
        studio.click('edits.0.on')
        self.near(studio.picture('edits_off'), before)
        studio.click('edits.0.on')
        x0, y0, x1, y1 = studio.item('edits.opacity')
        studio.drag((x1 - 8, (y0 + y1) // 2), ((x0 + x1) // 2, (y0 + y1) // 2))
        dimmed = self.part(studio.picture('edits_dimmed'), 0.4, 0.6)
        self.assertLess(dimmed, self.part(painted, 0.4, 0.6) - 2)
        self.assertGreater(dimmed, self.part(before, 0.4, 0.6) + 2)
        studio.click('edits.0', x=0.8, button=3)
        studio.click('edits.duplicate')
        studio.item('edits.1')
        _, session = self.save_as('list')
        self.assertEqual(len(session['edits']['edits']), 2)
        self.assertLess(session['edits']['edits'][0]['opacity'], 0.8)
        for _ in range(2):
            studio.click('edits.0', x=0.8, button=3)
            studio.settle()
            studio.click('edits.delete')
            studio.settle()
        self.near(studio.picture('edits_deleted'), before)


if __name__ == '__main__':
    unittest.main()

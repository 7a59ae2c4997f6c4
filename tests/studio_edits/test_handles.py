"""What was placed is moved and reshaped by its handles in a real window: the saved session and the picture follow."""
import unittest

import numpy as np

from test_select import Tools


class Handles(Tools):
    def place(self, kind, *drag):
        studio = self.open(key='shift+t')
        studio.click('stencil.' + kind)
        self.drag(*drag)
        studio.move(*self.at(0.9, 0.95))
        return studio

    def shape(self, name):
        _, session = self.save_as(name)
        self.assertEqual(len(session['edits']['edits']), 1)
        return session['edits']['edits'][0]['mask'][0]

    def per_pixel(self):
        """Pixels of the screen for one of the picture."""
        return float(self.studio.state('viewer.window').split()[2])

    def pull(self, handle, dx, dy):
        start = self.studio.point('handle.' + handle)
        self.studio.drag(start, (start[0] + dx, start[1] + dy))
        self.studio.move(*self.at(0.9, 0.95))

    def test_the_end_of_a_gradient_is_dragged_and_one_undo_takes_it_back(self):
        studio = self.place('linear', 0.2, 0.3, 0.5, 0.3)
        studio.key('Escape')  # the tool is put away: the chosen edit of the list still has its handles
        placed = studio.picture('handles_gradient')
        before = self.shape('placed')
        zoom = self.per_pixel()
        width = studio.item('viewer.picture')[2] - studio.item('viewer.picture')[0]
        self.pull('to', round(0.3 * width), 0)
        after = self.shape('pulled')
        self.assertAlmostEqual(after['x1'] - before['x1'], round(0.3 * width) / zoom, delta=2)
        self.assertAlmostEqual(after['y1'], before['y1'], delta=2)
        self.assertEqual((after['x0'], after['y0']), (before['x0'], before['y0']))
        pulled = studio.picture('handles_gradient_pulled')
        studio.key('F3')
        studio.settle()
        self.assertFalse(studio.has('handle.to'), 'the page of shadows has marks of its own')
        studio.key('F3')
        self.assertTrue(studio.has('handle.to'))
        studio.move(*self.at(0.9, 0.95))
        between = self.part(pulled, 0.48, 0.1, 0.6, 0.2) - self.part(placed, 0.48, 0.1, 0.6, 0.2)
        self.assertGreater(between.mean(), 4, 'the light now reaches further')
        beyond = self.part(pulled, 0.85, 0.1, 0.95, 0.2) - self.part(placed, 0.85, 0.1, 0.95, 0.2)
        self.assertEqual(np.abs(beyond).max(), 0, 'and no further than the handle')
        self.same_as_command_line('gradient')
        studio.key('ctrl+z')
        self.assertEqual(self.shape('undone'), before)

    def test_escape_in_a_drag_takes_it_back_and_the_picture_follows_live(self):
        studio = self.place('radial', 0.3, 0.3, 0.4, 0.3)
        placed = studio.picture('handles_round')
        before = self.shape('placed')
        x, y = studio.point('handle.middle')
        studio.move(x, y)
        studio.xdotool('mousedown', 1)
        for step in range(1, 9):
            studio.move(x + 15 * step, y)
        studio.settle()
        held = studio.picture('handles_round_held')
        lit = self.part(held, 0.5, 0.25, 0.56, 0.35) - self.part(placed, 0.5, 0.25, 0.56, 0.35)
        self.assertGreater(np.abs(lit).mean(), 2, 'the picture follows before the button is let go')
        studio.key('Escape')
        studio.xdotool('mouseup', 1)
        studio.move(*self.at(0.9, 0.95))
        self.assertTrue(studio.has('stencil.radial'), 'the tool stays in the hand')
        self.assertEqual(self.shape('taken_back'), before)
        np.testing.assert_array_equal(studio.picture('handles_round_back'), placed)
        self.pull('outer', 60, 0)
        after = self.shape('wider')
        self.assertAlmostEqual(after['outer'] - before['outer'], 60 / self.per_pixel(), delta=2)
        self.assertEqual((after['x'], after['y'], after['inner']), (before['x'], before['y'], before['inner']))

    def test_a_word_grows_by_its_corner_and_moves_by_its_middle(self):
        studio = self.place('text', 0.3, 0.1, 0.5, 0.4)
        before = self.shape('placed')
        x0, y0, x1, y1 = studio.item('stencil.frame')
        self.pull('top_right', round(0.5 * (x1 - x0)), -round(0.5 * (y1 - y0)))
        grown = self.shape('grown')
        self.assertAlmostEqual(grown['height'] / before['height'], 1.5, delta=0.05)
        self.assertAlmostEqual(grown['x'], before['x'], delta=2)
        self.assertAlmostEqual(grown['y'], before['y'], delta=2)
        studio.picture('handles_word')
        self.pull('middle', 50, 30)
        moved = self.shape('moved')
        self.assertAlmostEqual(moved['x'] - grown['x'], 50 / self.per_pixel(), delta=2)
        self.assertAlmostEqual(moved['y'] - grown['y'], 30 / self.per_pixel(), delta=2)
        self.assertEqual(moved['height'], grown['height'])
        studio.key('ctrl+z', 'ctrl+z')
        self.assertEqual(self.shape('undone'), before)

    def test_the_box_of_an_ellipse_keeps_its_other_corner(self):
        self.place('ellipse', 0.3, 0.2, 0.5, 0.5)
        before = self.shape('placed')
        self.pull('bottom_right', 40, 20)
        after = self.shape('reshaped')
        self.assertAlmostEqual(after['x'] - after['radius_x'], before['x'] - before['radius_x'], delta=0.01)
        self.assertAlmostEqual(after['radius_x'] - before['radius_x'], 20 / self.per_pixel(), delta=1.5)
        self.assertAlmostEqual(after['radius_y'] - before['radius_y'], 10 / self.per_pixel(), delta=1.5)


if __name__ == '__main__':
    unittest.main()

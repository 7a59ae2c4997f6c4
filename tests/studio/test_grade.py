"""The grade of the finished frame in a real window: wheels by mouse, undo, on and off, .cc files, export."""
import subprocess
import unittest

import numpy as np

from drop_files import drop_files
from studio_session import PROGRAM, StudioTest, read_png


class Grade(StudioTest):
    def open_grade(self):
        studio = self.open_sample()
        studio.key('shift+F10')
        studio.item('grade.lift')
        studio.settle()
        return studio

    def seen(self, name):
        """The middle of the picture, where no tooltip lies."""
        self.studio.move(*self.studio.point('viewer.picture', .98, .02))
        picture = self.studio.picture(name)
        height, width = picture.shape[:2]
        return picture[height // 4:height // 2, width // 3:].astype(float)

    def grade(self):
        self.saved = getattr(self, 'saved', 0) + 1
        return self.save_as(f'graded{self.saved}')[1]['display'].get('grade')

    def tint(self, wheel, x, y):
        """Drags the wheel's knob from its middle."""
        self.studio.drag(self.studio.point('grade.' + wheel), self.studio.point('grade.' + wheel, x, y))

    def answer_chooser(self, path):
        self.studio.item('chooser.name')
        self.studio.key('ctrl+a')
        self.studio.type(path)
        self.studio.key('Return')
        self.studio.settle()

    def test_wheels_grade_the_picture_and_are_undone(self):
        studio = self.open_grade()
        plain = self.seen('grade_plain')
        self.tint('gain', .9, .5)  # red
        red = self.seen('grade_red')
        self.assertGreater((red - plain)[..., 0].mean(), 8)
        self.assertLess((red - plain)[..., 2].mean(), -4)
        studio.drag(studio.point('grade.lift.master', .5), studio.point('grade.lift.master', .7))
        lifted = self.seen('grade_lifted')
        self.assertGreater(lifted.mean(), red.mean() + 8)
        studio.drag(studio.point('grade.saturation', .5), studio.point('grade.saturation', .01))
        grey = self.seen('grade_grey')
        self.assertLess(np.ptp(grey, axis=-1).mean(), .4 * np.ptp(lifted, axis=-1).mean())
        grade = self.grade()
        self.assertLess(grade['saturation'], .05)
        self.assertGreater(grade['offset'][0], .02)
        self.assertGreater(grade['slope'][0] + grade['offset'][0], 1.1)
        self.assertAlmostEqual(sum(s + o for s, o in zip(grade['slope'], grade['offset'])) / 3, 1, places=3)
        studio.key('ctrl+z')
        np.testing.assert_array_equal(self.seen('grade_undone'), lifted)
        studio.key('ctrl+z', 'ctrl+z')
        np.testing.assert_array_equal(self.seen('grade_undone_all'), plain)
        self.assertEqual(studio.state('grade'), 'none')

    def test_on_and_off_held_and_reset(self):
        studio = self.open_grade()
        plain = self.seen('grade_before')
        self.tint('gamma', .5, .1)
        graded = self.seen('grade_on')
        self.assertGreater(np.abs(graded - plain).max(), 10)
        studio.key('shift+g')
        np.testing.assert_array_equal(self.seen('grade_off'), plain)
        self.assertEqual(studio.state('grade'), 'off')
        studio.click('grade.on')
        np.testing.assert_array_equal(self.seen('grade_on_again'), graded)
        studio.xdotool('keydown', 'v')
        held = studio.picture('grade_held')
        studio.xdotool('keyup', 'v')
        height, width = held.shape[:2]
        np.testing.assert_array_equal(held[height // 4:height // 2, width // 3:], plain)
        studio.key('shift+g')
        self.tint('gamma', .5, .2)
        self.assertEqual(studio.state('grade'), 'on', 'whoever grades sees it')
        studio.key('ctrl+z')
        studio.settle()
        self.assertEqual(studio.state('grade'), 'off', 'in one step')
        studio.key('ctrl+z')
        np.testing.assert_array_equal(self.seen('grade_as_it_was'), graded)
        studio.double_click(*studio.point('grade.gamma', .5, .3))
        np.testing.assert_array_equal(self.seen('grade_balanced'), plain)
        studio.key('ctrl+z')
        studio.click('grade.gamma.reset')
        self.assertEqual(studio.state('grade'), 'none')
        studio.key('ctrl+z')
        studio.click('button.grade.reset')
        self.assertEqual(studio.state('grade'), 'none')

    def test_typed_numbers_and_a_tint_that_another_wheel_leaves_alone(self):
        studio = self.open_grade()
        for channel, value in (('r', '1.2'), ('b', '0.9')):
            studio.double_click(*studio.point('grade.gain.' + channel))
            studio.key('ctrl+a')
            studio.type(value)
            studio.key('Return')
        studio.drag(studio.point('grade.gamma.master', .5), studio.point('grade.gamma.master', .6))
        grade = self.grade()
        np.testing.assert_allclose([s + o for s, o in zip(grade['slope'], grade['offset'])], [1.2, 1, .9], atol=1e-6)
        self.assertLess(grade['power'][0], 1)

    def test_files_and_exports(self):
        studio = self.open_grade()
        self.tint('lift', .5, .9)
        graded = self.seen('grade_file')
        cc = self.path('mine.cc')
        studio.click('button.grade.save')
        self.answer_chooser(cc)
        self.assertIn('ColorCorrection', open(cc).read())
        kept = self.grade()
        session = self.path('graded1.swaplight')
        out, other = self.path('out.png'), self.path('other.png')
        studio.key('ctrl+e')
        studio.item('export.file')
        studio.key('ctrl+a')
        studio.type(out)
        studio.item('export.grade')
        studio.screenshot('grade_export')
        studio.key('Return')
        studio.settle()
        subprocess.run([PROGRAM, 'relight', session, '-o', other, '-q'], check=True)
        np.testing.assert_array_equal(read_png(out), read_png(other))
        subprocess.run([PROGRAM, 'relight', session, '--cdl', 'none', '-o', other, '-q'], check=True)
        self.assertGreater(np.abs(read_png(out) - read_png(other)).max(), 5)
        studio.key('ctrl+e')
        studio.item('export.file')
        studio.key('ctrl+a')
        studio.type(self.path('ungraded.png'))
        studio.click('export.grade')
        studio.click('export.accept')
        studio.settle()
        np.testing.assert_array_equal(read_png(self.path('ungraded.png')), read_png(other))

        studio.click('button.grade.reset')
        self.assertEqual(studio.state('grade'), 'none')
        studio.click('button.grade.load')
        self.answer_chooser(cc)
        self.assertLess(np.abs(self.seen('grade_loaded') - graded).max(), 2)
        np.testing.assert_allclose(self.grade()['offset'], kept['offset'], atol=1e-6)
        studio.key('ctrl+z')
        self.assertEqual(studio.state('grade'), 'none')
        drop_files(self.display.name, 'graded', [cc], *studio.point('viewer.picture'))
        studio.wait(lambda layout: layout.get('grade') == 'on', 'the dropped grade')

    def test_a_version_holds_its_grade_and_the_view_keeps_it(self):
        studio = self.open_grade()
        self.tint('gain', .2, .2)
        studio.key('shift+v')
        studio.item('gallery.0')
        kept = self.grade()
        studio.click('button.grade.reset')
        studio.click('gallery.0')
        studio.settle()
        self.assertEqual(self.grade(), kept)
        studio.click('bar.view')
        studio.click('view.sRGB.Hable')
        studio.settle()
        saved = self.save_as('hable')[1]['display']
        self.assertEqual((saved['view'], saved['grade']), ('Hable', kept))


if __name__ == '__main__':
    unittest.main()

"""Beta maps in a real window: written, edited by another program, read back as an edit, refused where they are wrong."""
import os
import subprocess
import unittest

import numpy as np
import OpenImageIO as oiio

from shadow_truth import read_float
from studio import PROGRAM, StudioTest


def write_float(path, pixels, names):
    """As an image editor would: the same channels, other values."""
    height, width, count = pixels.shape
    spec = oiio.ImageSpec(width, height, count, 'float')
    spec.channelnames = list(names)
    output = oiio.ImageOutput.create(path)
    assert output.open(path, spec) and output.write_image(np.ascontiguousarray(pixels, np.float32)) and output.close(), output.geterror()


class BetaFile(StudioTest):
    def add(self, what):
        self.studio.click('edits.add')
        self.studio.item('add.' + what)
        self.studio.settle()
        self.studio.screenshot('beta_add_menu')
        self.studio.click('add.' + what)

    def export(self, name):
        """Writes the maps through the list's menu and the dialog."""
        path = self.path(name)
        self.add('export')
        self.studio.item('export.file')
        self.studio.click('export.format' + os.path.splitext(name)[1])
        self.studio.screenshot('beta_export')
        self.studio.click('export.file')
        self.studio.key('ctrl+a')
        self.studio.type(path)
        self.studio.key('Return')
        self.studio.wait(lambda layout: 'message.0' in layout['items'], 'it is written')
        self.dismiss()
        return path

    def choose(self, path):
        self.studio.item('chooser.name')
        self.studio.key('ctrl+a')
        self.studio.type(path)
        self.studio.key('Return')

    def dismiss(self):
        """Clicks messages away."""
        while self.studio.has('message.0'):
            self.studio.click('message.0')
            self.studio.settle()

    def shown(self, name):
        self.studio.move(*self.studio.point('viewer.picture', 0.5, 0.02))
        return self.studio.picture(name)

    def edits(self, name):
        path, session = self.save_as(name)
        return path, session.get('edits', {}).get('edits', [])

    def same(self, picture, other):
        self.assertLess(np.abs(picture - other)[:, 10:-10].mean(), 0.5)

    def refused(self, name):
        """A file that is wrong is said in one line; afterwards all is as it was."""
        self.studio.item('message.0')
        self.studio.screenshot(name)
        self.assertFalse(self.studio.has('message.1'), 'said once')
        self.dismiss()

    def test_a_map_is_written_edited_read_back_and_refused_where_it_is_wrong(self):
        studio = self.open_edits()
        studio.click('mixer.fill.mute')
        studio.click('mixer.back.mute')
        before = self.shown('beta_before')
        path = self.export('beta.exr')
        pixels, names = read_float(path)
        self.assertEqual(sorted(names), ['beta.back', 'beta.fill', 'beta.key'])
        height, width = pixels.shape[:2]
        key = list(names).index('beta.key')
        # The left half of the picture loses its key light.
        edited = pixels.copy()
        edited[:, :width // 2, key] = 0
        write_float(self.path('edited.exr'), edited, names)
        self.add('picture')
        self.choose(self.path('edited.exr'))
        studio.item('parameters.read_again')
        left_dark = self.shown('beta_read')
        half = left_dark.shape[1] // 2
        self.assertLess(left_dark[:, 10:half - 4].mean(), 2, 'no key at the left')
        self.assertGreater(before[:, 10:half - 4].mean(), 15)
        self.same(left_dark[:, half + 4:-10], before[:, half + 4:-10])
        session, edits = self.edits('read')
        self.assertEqual([(e['operation'], e['file'], e['lights'], e['meaning']) for e in edits],
                         [('picture', 'edited.exr', ['key'], 'share')])
        # The command line makes the same frame of the session.
        frame, line = self.path('studio.exr'), self.path('line.exr')
        studio.key('ctrl+e')
        studio.item('export.kind.frame')
        studio.click('export.kind.frame')
        studio.click('export.format.exr')
        studio.click('export.file')
        studio.key('ctrl+a')
        studio.type(frame)
        studio.key('Return')
        studio.wait(lambda layout: 'message.0' in layout['items'], 'the frame')
        self.dismiss()
        subprocess.run([PROGRAM, 'relight', '--session', session, '-o', line, '-q'], check=True)
        np.testing.assert_array_equal(read_float(frame)[0], read_float(line)[0])

        # One undo takes it back, redo brings it again.
        studio.key('ctrl+z')
        self.same(self.shown('beta_undone'), before)
        self.assertFalse(studio.has('edits.0'))
        studio.key('ctrl+shift+z')
        self.same(self.shown('beta_redone'), left_dark)

        # Edited once more, under the same name.
        edited[:, :width // 2, key] = pixels[:, :width // 2, key]
        edited[:, width // 2:, key] = 0
        write_float(self.path('edited.exr'), edited, names)
        studio.click('edits.0', x=0.6)
        studio.click('parameters.read_again')
        studio.settle()
        right_dark = self.shown('beta_again')
        self.assertLess(right_dark[:, half + 4:-10].mean(), 2)
        self.same(right_dark[:, 10:half - 4], before[:, 10:half - 4])

        # What is wrong changes nothing.
        too_much = edited.copy()
        too_much[3, 5, key] = 1.5
        write_float(self.path('too_much.exr'), too_much, names)
        write_float(self.path('small.exr'), edited[::2, ::2], names)
        write_float(self.path('one.exr'), edited[..., :2], ['beta.fill', 'beta.back'])
        for wrong in ('too_much', 'small', 'one', 'nowhere'):
            self.add('picture')
            self.choose(self.path(wrong + '.exr'))
            self.refused('beta_refused_' + wrong)
            self.assertFalse(studio.has('edits.1'), wrong)
        write_float(self.path('edited.exr'), too_much, names)
        studio.click('parameters.read_again')
        self.refused('beta_refused_again')
        self.same(self.shown('beta_kept'), right_dark)
        self.assertEqual(len(self.edits('kept')[1]), 1)

        # All lights share what there is: their maps have to add up.
        write_float(self.path('sums.exr'), np.where(np.arange(3) == key, 0, pixels), names)
        studio.click('parameters.lights')
        studio.item('parameters.lights.all')
        studio.settle()
        studio.click('parameters.lights.all')
        self.dismiss()
        studio.click('parameters.file')
        self.choose(self.path('sums.exr'))
        self.refused('beta_refused_sums')
        self.assertEqual(self.edits('sums')[1][0]['file'], 'edited.exr')
        write_float(self.path('whole.exr'), pixels[..., ::-1], list(names)[::-1])
        studio.click('parameters.file')
        self.choose(self.path('whole.exr'))
        studio.settle()
        self.same(self.shown('beta_whole'), before)

    def test_a_png_a_light_and_a_session_that_is_opened_again(self):
        studio = self.open_edits()
        before = self.shown('beta_png_before')
        self.export('beta.png')
        path = self.path('beta.key.png')
        source = oiio.ImageBuf(path)
        self.assertEqual(str(source.spec().format), 'uint16')
        grey = source.get_pixels(oiio.FLOAT)[..., 0]
        # A colour picture of 8 bits, as a careless editor saves it: white at the left, black at the right.
        grey[:, :grey.shape[1] // 2] = 1
        grey[:, grey.shape[1] // 2:] = 0
        output = oiio.ImageBuf(oiio.ImageSpec(grey.shape[1], grey.shape[0], 3, 'uint8'))
        output.set_pixels(oiio.ROI(0, grey.shape[1], 0, grey.shape[0], 0, 1, 0, 3), np.repeat(grey[..., None], 3, 2))
        output.write(path)
        studio.click('mixer.fill.mute')
        studio.click('mixer.back.mute')
        self.add('picture')
        self.choose(path)
        studio.item('parameters.read_again')
        read = self.shown('beta_png_read')
        half = read.shape[1] // 2
        self.assertLess(read[:, half + 4:-10].mean(), 2)
        self.assertGreater(read[:, 10:half - 4].mean(), before[:, 10:half - 4].mean() - 3, 'the key has all light')
        session, _ = self.edits('png')
        self.assertTrue(studio.quit())
        again = self.start(session)
        again.wait_ready()
        again.settle()
        self.same(self.shown('beta_png_opened'), read)
        # The file comes and goes; the session stays.
        os.rename(path, path + '.away')
        again.click('edits.0', x=0.6)
        again.click('parameters.read_again')
        self.refused('beta_png_away')
        self.same(self.shown('beta_png_kept'), read)
        self.assertTrue(again.quit())
        again = self.start(session)
        again.wait_ready()
        self.refused('beta_png_gone')
        lit = self.shown('beta_png_without')
        self.assertGreater(lit[:, half + 4:-10].mean(), 10, 'without the edit')
        os.rename(path + '.away', path)
        again.click('edits.0', x=0.6)
        again.click('parameters.read_again')
        again.settle()
        self.same(self.shown('beta_png_back'), read)


if __name__ == '__main__':
    unittest.main()

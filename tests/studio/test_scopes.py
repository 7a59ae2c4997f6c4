"""Scopes in a real window: they follow the lights, a region, one light; their choice is remembered."""
import unittest

import numpy as np

from studio_session import StudioTest


class Scopes(StudioTest):
    size = (1600, 900)

    def scope(self, name, picture):
        self.studio.settle()
        shot = self.studio.screenshot(picture)
        x0, y0, x1, y1 = map(int, self.studio.item('scope.' + name))
        return shot[y0:y1, x0:x1]

    def height_of_light(self, waveform):
        """Where the trace lies on average: 0 at the bottom, 1 at the top. The axis and its labels are left out."""
        inner = waveform[12:-12, 60:-10].max(-1).astype(float)
        inner[inner < 90] = 0
        rows = inner.sum(1)
        return 1 - (rows * np.arange(len(rows))).sum() / rows.sum() / len(rows)

    def test_the_waveform_follows_the_light(self):
        studio = self.open_sample()
        studio.key('F6')
        before = self.height_of_light(self.scope('waveform', 'scopes_before'))
        x0, y0, x1, y1 = studio.item('mixer.key.stops')
        studio.drag(((x0 + x1) // 2, (y0 + y1) // 2), (round(x0 + 0.35 * (x1 - x0)), (y0 + y1) // 2))
        darker = self.height_of_light(self.scope('waveform', 'scopes_darker'))
        self.assertLess(darker, before - 0.03)
        studio.click('menu.Lights')
        studio.click('menu.mixer.all_off')
        off = self.scope('vectorscope', 'scopes_off')
        height, width = off.shape[:2]
        self.assertGreater(off[height // 2 - 3:height // 2 + 3, width // 2 - 3:width // 2 + 3].max(), 120,
                           'black lies in the middle of the vectorscope')

    def test_they_look_at_a_region_and_at_one_light(self):
        studio = self.open_sample()
        studio.key('F6')
        frame = self.scope('histogram', 'scopes_frame')
        studio.key('shift+s')
        studio.drag(studio.point('viewer.picture', 0.02, 0.05), studio.point('viewer.picture', 0.2, 0.4))
        region = self.scope('histogram', 'scopes_region')
        self.assertGreater(np.abs(region - frame).mean(), 1)
        studio.key('shift+s')
        self.assertLess(np.abs(self.scope('histogram', 'scopes_frame_again') - frame).mean(), 0.5)
        studio.click('scopes.of')
        studio.click('scopes.of key')
        self.assertGreater(np.abs(self.scope('histogram', 'scopes_light') - frame).mean(), 1)

    def test_their_scales_are_in_the_unit_that_is_asked_for(self):
        studio = self.open_sample()
        studio.key('F6')
        labels = {'8 bit': self.labels('scopes_8_bit')}
        for unit in ('10 bit', 'Per cent', 'Nits'):
            studio.click('scopes.unit')
            studio.click('scopes.' + unit)
            labels[unit] = self.labels('scopes_' + unit.replace(' ', '_'))
            for other in labels:
                if other != unit:
                    self.assertGreater(np.abs(labels[other] - labels[unit]).mean(), .5, f'{other}, {unit}')
        self.assertTrue(studio.quit())
        studio = self.open_sample()
        self.assertLess(np.abs(self.labels('scopes_nits_again') - labels['Nits']).mean(), .1)

    def labels(self, picture):
        """The numbers left of the waveform."""
        return self.scope('waveform', picture)[:, :32].astype(float)

    def test_the_choice_of_scopes_is_remembered(self):
        studio = self.open_sample()
        studio.key('F6')
        studio.click('scopes.Chromaticity')
        studio.click('scopes.Waveform')
        chromaticity = self.scope('chromaticity', 'scopes_chromaticity')
        self.assertGreater(chromaticity.std(), 10)
        x, y = studio.point('splitter.scopes')
        studio.drag((x, y), (x, y - 90))
        top = studio.item('splitter.scopes')[1]
        self.assertTrue(studio.quit())
        studio = self.open_sample()
        self.assertTrue(studio.has('scope.chromaticity') or studio.item('scope.chromaticity'))
        self.assertFalse(studio.has('scope.waveform'))
        self.assertAlmostEqual(studio.item('splitter.scopes')[1], top, delta=3)


class ScopesInASmallWindow(StudioTest):
    size = (1280, 720)

    def test_what_has_no_room_stands_below(self):
        studio = self.open_sample()
        studio.key('F6', 'F10')
        studio.item('scopes.log')
        studio.settle()
        studio.screenshot('scopes_small')
        rows = {studio.item('scopes.' + name)[1] for name in ('Waveform', 'of', 'unit', 'axis', 'log')}
        self.assertGreater(len(rows), 1)
        for name in ('Waveform', 'Parade', 'Chromaticity', 'of', 'unit', 'axis', 'log'):
            self.assertLessEqual(studio.item('scopes.' + name)[2], studio.item('mixer.menu')[0], name)


if __name__ == '__main__':
    unittest.main()

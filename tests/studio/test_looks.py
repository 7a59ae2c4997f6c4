"""Three-point panel and gallery in a real window: ratios, presets, their amount; looks kept, recalled, compared, faded."""
import json
import unittest

import numpy as np

from studio_session import StudioTest


def mean(pixels):
    return pixels.reshape(-1, 3).mean(0)


class Looks(StudioTest):
    def save(self, name='lit'):
        _, session = self.save_as(name)
        return session, {light['name']: light for light in session['rig']['lights']}

    def along(self, name, start, end):
        x0, y0, x1, y1 = self.studio.item(name)
        y = (y0 + y1) // 2
        self.studio.drag((round(x0 + start * (x1 - x0)), y), (round(x0 + end * (x1 - x0)), y))

    def test_the_ratio_dims_the_fill_and_the_split_warms_the_key(self):
        studio = self.open_sample()
        studio.key('F9')
        studio.click('three_point.ratio.2')
        flat = mean(studio.picture('three_point_2'))
        _, before = self.save('flat')
        studio.click('three_point.ratio.16')
        _, after = self.save('steep')
        self.assertAlmostEqual(before['fill']['stops'] - after['fill']['stops'], 3, delta=0.01)
        self.assertEqual(after['key'], before['key'])
        self.assertTrue((mean(studio.picture('three_point_16')) < flat).all())
        self.along('three_point.split', 0.5, 0.9)
        studio.screenshot('three_point_split')
        _, split = self.save('split')
        kelvin = lambda name: float(split[name]['color'].rstrip('K'))
        self.assertLess(kelvin('key'), 4000)
        self.assertGreater(kelvin('fill'), 8000)
        studio.key('ctrl+z', 'ctrl+z')
        self.assertLess(np.abs(mean(studio.picture('three_point_undone')) - flat).max(), 0.5)

    def test_a_preset_is_applied_blended_and_undone(self):
        studio = self.open_sample()
        studio.key('F9')
        white = studio.picture('preset_before')
        studio.click('three_point.look.Candle')
        candle = studio.picture('preset_candle')
        self.assertGreater(mean(candle)[0] / mean(candle)[2], 3, 'a candle is warm')
        self.along('three_point.amount', 0.97, 0.3)
        part = mean(studio.picture('preset_part'))
        self.assertTrue(mean(candle)[2] + 5 < part[2] < mean(white)[2] - 5, f'{mean(white)} {part} {mean(candle)}')
        studio.click('three_point.look.Silhouette')
        _, lights = self.save()
        self.assertFalse(lights['fill']['on'])
        studio.key('ctrl+z')
        self.assertLess(np.abs(mean(studio.picture('preset_part_again')) - part).max(), 0.5)
        studio.key('ctrl+z', 'ctrl+z')
        self.assertLess(np.abs(studio.picture('preset_undone') - white).max(), 2)

    def test_a_light_is_given_the_role_of_the_key(self):
        studio = self.open_sample('two_swapped')
        studio.key('F9')
        studio.click('three_point.look.Neon')
        studio.item('message.0')
        studio.screenshot('no_roles')
        names = [name.split('.')[1] for name in studio.layout()['items'] if name.endswith('.chip')]
        for role, name in zip(('key', 'fill'), names):
            studio.click(f'three_point.role.{role}')
            studio.click(f'three_point.role.{role}.{name}')
        studio.click('three_point.ratio.8')
        studio.screenshot('roles_given')
        _, lights = self.save()
        self.assertEqual([lights[name]['role'] for name in names], ['key', 'fill'])

    def test_looks_are_kept_recalled_named_and_saved(self):
        studio = self.open_sample()
        white = studio.picture('gallery_white')
        studio.key('shift+k')
        studio.click('mixer.key.mute')
        studio.click('mixer.back.mute')
        studio.click('gallery.keep')
        studio.move(640, 400)
        dark = studio.picture('gallery_dark')
        studio.click('gallery.0')
        studio.move(640, 400)
        self.assertLess(np.abs(mean(studio.picture('gallery_recalled')) - mean(white_at(white, dark))).max(), 6)
        studio.click('gallery.1')
        studio.move(640, 400)
        self.assertLess(np.abs(studio.picture('gallery_recalled_dark') - dark).max(), 2)
        studio.click('gallery.1.menu')
        studio.click('gallery.name')
        studio.key('ctrl+a')
        studio.type('Only fill')
        studio.key('Return')
        studio.click('gallery.1.menu')
        studio.click('gallery.note')
        studio.type('for scene 4')
        studio.key('Return')
        studio.screenshot('gallery_named')
        session, _ = self.save()
        self.assertEqual([look['name'] for look in session['looks']], ['Look 1', 'Only fill'])
        self.assertEqual(session['looks'][1]['note'], 'for scene 4')
        self.assertTrue(studio.quit())
        studio = self.start(self.path('lit.swaplight'))
        studio.wait_ready()
        studio.item('gallery.1')
        studio.click('gallery.1.menu')
        studio.click('gallery.remove')
        studio.settle()
        self.assertFalse(studio.has('gallery.1'))
        studio.key('ctrl+z')
        studio.item('gallery.1')

    def test_a_look_is_wiped_against(self):
        studio = self.open_sample()
        studio.key('shift+k')
        for light in ('key', 'fill', 'back'):
            studio.click(f'mixer.{light}.mute')
        studio.click('gallery.0.wipe')
        studio.move(640, 15)
        shown = studio.picture('gallery_wipe')
        middle = shown.shape[1] // 2
        self.assertLess(shown[:, :middle - 12].mean(), 2, 'A is dark')
        self.assertGreater(shown[:, middle + 12:].mean(), 10, 'B is the look')
        studio.click('gallery.0.wipe')
        studio.move(640, 15)
        self.assertLess(studio.picture('gallery_no_wipe').mean(), 2)

    def test_a_bar_fades_between_two_looks(self):
        studio = self.open_sample()
        studio.key('shift+k')
        studio.click('menu.Lights')
        studio.click('menu.mixer.all_off')
        studio.click('gallery.keep')
        self.along('gallery.fader', 0.04, 0.5)
        studio.screenshot('gallery_fader')
        half, lights = self.save('half')
        for name in ('key', 'fill', 'back'):
            self.assertAlmostEqual(lights[name]['stops'], -1, delta=0.1)
        self.along('gallery.fader', 0.5, 0.97)
        self.assertLess(studio.picture('gallery_faded').mean(), 4)
        studio.key('ctrl+z', 'ctrl+z')
        _, lights = self.save('undone')
        self.assertFalse(lights['key']['on'], 'each pull of the bar is one step')


def white_at(white, like):
    """The picture of the smaller viewer: the gallery has taken its room."""
    step = max(1, round(white.shape[0] / like.shape[0]))
    return white[::step, ::step]


if __name__ == '__main__':
    unittest.main()

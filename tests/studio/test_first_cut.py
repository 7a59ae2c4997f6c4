"""The studio's main path, in a real window with a real mouse: open, light again, look, export."""
import json
import os
import unittest

import numpy as np
import OpenImageIO as oiio

from studio_session import SAMPLES, StudioTest


def mean(pixels):
    return pixels.reshape(-1, 3).mean(0)


def on_disc(studio, degrees, saturation):
    """The place of a hue and saturation on the disc of colours."""
    x0, y0, x1, y1 = studio.item('light.disc')
    away = saturation * ((x1 - x0) / 2 - 8)
    angle = np.radians(degrees)
    return round((x0 + x1) / 2 + away * np.cos(angle)), round((y0 + y1) / 2 + away * np.sin(angle))


class FirstCut(StudioTest):
    def test_a_light_is_recoloured_by_one_drag_in_the_disc(self):
        studio = self.open_sample()
        before = studio.picture('first_open')
        self.assertGreater(before.std(), 20, 'the picture shows nothing')
        studio.click('mixer.key.chip')
        # White is the middle; blue lies at 240 degrees, clockwise from the right: up and left of it.
        studio.drag(studio.point('light.disc', 0.5, 0.5), on_disc(studio, 240, 0.9))
        after = studio.picture('first_recoloured')
        change = mean(after) - mean(before)
        self.assertLess(change[0], -15, f'red should fall: {change}')
        self.assertGreater(change[2] - change[0], 15, f'blue should gain on red: {change}')
        studio.screenshot('first_disc')
        studio.key('ctrl+z')
        self.assertLess(np.abs(studio.picture('first_undone') - before).max(), 2, 'one drag is one step')

    def test_colours_that_were_used_or_kept_are_a_click_away(self):
        studio = self.open_sample()
        studio.click('mixer.key.chip')
        for degrees in (20, 120):
            studio.click_at(*on_disc(studio, degrees, 0.8))
        red = self.light_color('swatches_before')
        studio.click('swatch.recent.1')
        orange = self.light_color('swatches_given')
        self.assertNotEqual(red, orange)
        studio.click('swatch.keep')
        studio.screenshot('first_swatches')
        self.assertTrue(studio.has('swatch.kept.0') and studio.has('swatch.recent.0'))
        self.assertFalse(studio.has('swatch.recent.1'), 'a kept colour is listed once')
        # It is there in the next studio, for another light.
        studio.quit()
        studio = self.open_sample()
        studio.click('mixer.fill.chip')
        studio.click('swatch.kept.0')
        self.assertEqual(self.light_color('swatches_kept', 'fill'), orange)
        studio.click('swatch.kept.0', button=3)
        studio.click('swatch.menu')
        self.assertFalse(studio.has('swatch.kept.0'))

    def light_color(self, name, light='key'):
        _, session = self.save_as(name)
        return next(setting['color'] for setting in session['rig']['lights'] if setting['name'] == light)

    def test_stops_solo_and_mute_change_the_picture(self):
        studio = self.open_sample()
        before = mean(studio.picture('first_stops_before'))
        x0, y0, x1, y1 = studio.item('mixer.key.stops')
        y = (y0 + y1) // 2
        studio.drag(((x0 + x1) // 2, y), (round(x0 + 0.62 * (x1 - x0)), y))
        brighter = mean(studio.picture('first_stops'))
        self.assertTrue((brighter > before + 10).all(), f'{before} -> {brighter}')
        studio.key('ctrl+z')
        self.assertTrue(np.allclose(mean(studio.picture('first_stops_undone')), before, atol=0.5),
                        'one drag is one step')
        studio.click('mixer.fill.solo')
        fill = mean(studio.picture('first_solo'))
        studio.click('mixer.fill.solo')
        studio.click('mixer.fill.mute')
        others = mean(studio.picture('first_mute'))
        self.assertTrue((fill < before).all() and (others < before).all())
        studio.click('mixer.fill.mute')
        studio.click('mixer.key.on')
        self.assertTrue((mean(studio.picture('first_off')) < before - 5).any())

    def test_zoom_holds_the_point_under_the_mouse_and_fit_returns(self):
        studio = self.open_sample()
        before = studio.picture('first_fit')
        x0, y0, x1, y1 = studio.item('viewer.picture')
        studio.move(round(x0 + 0.7 * (x1 - x0)), round(y0 + 0.4 * (y1 - y0)))
        under = studio.screenshot('first_zoom_before')
        x, y = studio.point('viewer.picture', 0.7, 0.4)
        for _ in range(6):
            studio.xdotool('click', 4)
        zoomed = studio.screenshot('first_zoom')
        patch = lambda image: image[y - 3:y + 4, x - 3:x + 4].reshape(-1, 3).mean(0)
        self.assertTrue(np.allclose(patch(under), patch(zoomed), atol=24), 'the point under the mouse moved')
        studio.drag((x, y), (x - 150, y - 80))
        self.assertGreater(np.abs(studio.screenshot('first_pan') - zoomed).mean(), 2, 'the picture did not move')
        studio.key('f')
        self.assertTrue(np.array_equal(studio.picture('first_fit_again'), before))

    def test_a_session_is_saved_and_opened_again(self):
        studio = self.open_sample()
        studio.click('mixer.back.mute')
        studio.key('ctrl+s')
        studio.item('chooser.name')
        studio.key('ctrl+a')
        studio.type(self.path('mine'))
        studio.key('Return')
        studio.wait(lambda layout: layout.get('title', '').startswith('mine.swaplight'), 'the session has a name')
        with open(self.path('mine.swaplight')) as file:
            session = json.load(file)
        self.assertEqual(session['format'], 'swaplight-session')
        self.assertFalse(os.path.isabs(session['source']))
        picture = studio.picture('first_saved')
        self.assertTrue(studio.quit(), 'nothing unsaved, so nothing to ask')
        studio = self.start(self.path('mine.swaplight'))
        studio.wait_ready()
        self.assertLess(np.abs(studio.picture('first_reopened') - picture).max(), 2)

    def test_the_frame_is_exported(self):
        studio = self.open_sample()
        studio.click('mixer.fill.mute')
        source = oiio.ImageInput.open(self.export_frame('frame.exr'))
        spec = source.spec()
        self.assertEqual([*spec.channelnames][:3], ['R', 'G', 'B'])
        self.assertIn('mute', spec.getattribute('swaplight/rig'))

    def test_the_chooser_opens_a_capture(self):
        studio = self.start()
        studio.item('welcome.open')
        studio.screenshot('first_welcome')
        studio.click('welcome.open')
        studio.item('chooser.name')
        studio.type(os.path.join(SAMPLES, 'two_swapped', 'capture.json'))
        studio.screenshot('first_chooser')
        studio.key('Return')
        studio.wait_ready()

    def test_what_cannot_be_opened_is_said(self):
        with open(self.path('broken.json'), 'w') as file:
            file.write('{"format": ')
        studio = self.start(self.path('broken.json'))
        studio.item('message.0')
        studio.screenshot('first_broken')
        self.assertTrue(studio.quit())


if __name__ == '__main__':
    unittest.main()

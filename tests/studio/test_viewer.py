"""The viewer in a real window: comparisons, subjects, channels, false colour, zebra, probe, exposure."""
import os
import unittest

import numpy as np
import OpenImageIO as oiio

from studio_session import SAMPLES, StudioTest


def mean(pixels):
    return pixels.reshape(-1, 3).mean(0)


class Viewer(StudioTest):
    def set_key(self, setting):
        self.studio.click('mixer.key.chip')
        self.studio.click('light.hex')
        self.studio.key('ctrl+a')
        self.studio.type(setting)
        self.studio.key('Return')
        self.studio.move(640, 705)

    def differing(self, a, b):
        return np.abs(a - b).max(-1) > 3

    def test_a_wipe_is_dragged_and_turned_and_stays_in_the_picture_under_zoom(self):
        studio = self.open_sample()
        white = studio.picture('viewer_white')
        self.set_key('off')
        dark = studio.picture('viewer_dark')
        studio.key('w')
        studio.move(640, 705)
        wipe = studio.picture('viewer_wipe')
        height, width = wipe.shape[:2]
        left, right = slice(0, width // 2 - 20), slice(width // 2 + 20, width)
        self.assertFalse(self.differing(wipe, dark)[30:-90, left].any(), 'A is left of the line')
        self.assertFalse(self.differing(wipe, white)[30:-90, right].any(), 'B is right of it')
        # Dragged by the line, away from its handles.
        x, y = studio.point('viewer.wipe')
        studio.drag((x, y - 60), (x - 200, y - 60))
        studio.move(640, 705)
        moved = studio.picture('viewer_wipe_moved')
        self.assertFalse(self.differing(moved, white)[30:-90, slice(width // 2 - 160, width)].any())
        # The line's point stays on the same point of the picture.
        at = lambda: (np.array(studio.point('viewer.wipe')) - studio.item('viewer.picture')[:2]) / (
            np.array(studio.item('viewer.picture')[2:]) - studio.item('viewer.picture')[:2])
        before = at()
        studio.key('ctrl+minus')
        self.assertTrue(np.allclose(at(), before, atol=0.02), f'{before} -> {at()}')
        studio.key('f')
        # Turned by its end: upright to lying.
        center = studio.point('viewer.wipe')
        studio.drag(studio.point('viewer.wipe.turn'), (center[0] - 120, center[1]))
        studio.move(640, 705)
        turned = studio.picture('viewer_wipe_turned')
        rows = self.differing(turned, dark)[:, width // 2:].any(1)
        self.assertFalse(rows[:height // 2 - 20].any(), 'A is above the lying line')
        self.assertFalse(self.differing(turned, white)[height // 2 + 20:-90, 30:-30].any(), 'B is below it')

    def test_toggle_split_and_difference(self):
        studio = self.open_sample()
        white = studio.picture('viewer_compare_white')
        self.set_key('off')
        studio.key('t')
        b = studio.picture('viewer_toggled')
        self.assertFalse(self.differing(b, white)[:-90].any(), 'B is all white')
        studio.key('d')
        difference = studio.picture('viewer_difference')
        self.set_key('on')
        self.assertGreater(difference[:-90].mean(), 20)
        self.assertLess(studio.picture('viewer_no_difference')[:-90].mean(), 2)
        studio.key('shift+w')
        studio.item('viewer.picture_b')
        split = studio.screenshot('viewer_split')
        crop = lambda name: split[slice(*map(int, studio.item(name)[1::2])), slice(*map(int, studio.item(name)[::2]))]
        self.assertFalse(self.differing(crop('viewer.picture')[:-90], crop('viewer.picture_b')[:-90]).any())

    def test_kept_lighting_is_what_b_shows(self):
        studio = self.open_sample()
        self.set_key('#ff0000')
        red = studio.picture('viewer_kept')
        studio.key('k')
        self.set_key('#0000ff')
        studio.key('t')
        self.assertFalse(self.differing(studio.picture('viewer_kept_again'), red)[:-120].any())

    def test_every_subject_shows_something_of_its_own(self):
        studio = self.open_sample()
        seen = {'Relit': studio.picture('viewer_subject_relit')}
        names = ['Photograph 1', 'Photograph 2', 'Light: key', 'Beta of key', 'Reflectance', 'Residual', 'Standard error (σ)',
                 'Flags']
        within = {'Beta of key': 'Beta maps'}
        within.update((name, 'Diagnostics') for name in names[-3:])
        for number, name in enumerate(names):
            self.show(name, within.get(name))
            seen[name] = studio.picture(f'viewer_subject_{number}')
            if name not in ('Reflectance', 'Flags'):  # under white light nothing is between the relit set and its sum
                self.assertGreater(np.abs(seen[name] - seen['Relit']).mean(), 3, name)
        beta = seen['Beta of key']
        self.assertEqual(np.ptp(beta.astype(int), axis=-1)[:-90].max(), 0, 'a share is grey')
        self.assertTrue(studio.has('viewer.legend'))
        # The photograph is the file's, through the view.
        source = oiio.ImageInput.open(os.path.join(SAMPLES, 'three_point', 'shot_01.exr'))
        linear = np.asarray(source.read_image('float'))[..., :3]
        codes = 255 * np.where(linear > 0.0031308, 1.055 * np.clip(linear, 1e-9, 1) ** (1 / 2.4) - 0.055, 12.92 * linear)
        self.assertTrue(np.allclose(mean(seen['Photograph 1']), mean(np.clip(codes, 0, 255)), atol=2))
        studio.click('bar.subject')
        studio.click('subject.Relit')
        studio.key('o')
        studio.move(640, 705)
        self.assertFalse(self.differing(studio.picture('viewer_photograph_key'), seen['Photograph 1']).any())

    def test_channels_false_colour_and_zebra(self):
        studio = self.open_sample()
        color = studio.picture('viewer_color')
        for key, channel in zip('rgb', range(3)):
            studio.key(key)
            shown = studio.picture('viewer_channel_' + key)[60:]
            self.assertLess(np.abs(shown - color[60:, :, channel:channel + 1]).max(), 2, key)
        studio.key('a')
        self.assertLess(np.abs(studio.picture('viewer_all_channels') - color).max(), 2)
        studio.key('c')
        self.assertTrue(studio.has('viewer.legend'))
        self.assertLess(len(np.unique(studio.picture('viewer_false')[:, :400].reshape(-1, 3), axis=0)), 16)
        studio.key('c', 'z')
        zebra = studio.picture('viewer_zebra')
        changed = self.differing(zebra, color)
        self.assertTrue(changed.any())
        self.assertGreaterEqual(color.max(-1)[changed].min(), 240, 'stripes only over what is bright')

    def test_exposure_is_the_viewers_alone(self):
        studio = self.open_sample()
        before = studio.picture('viewer_exposure_before')
        self.assertFalse(studio.has('viewer.badge'))
        x, y = studio.point('viewer.picture', 0.3, 0.8)
        studio.xdotool('keydown', 'e')
        studio.drag((x, y), (x + 100, y))
        studio.xdotool('keyup', 'e')
        self.assertGreater(mean(studio.picture('viewer_exposure')).sum(), mean(before).sum() + 30)
        self.assertTrue(studio.has('viewer.badge'))
        self.assertNotIn('edited', studio.state('title'), 'the session is as it was')
        studio.key('shift+e')
        self.assertLess(np.abs(studio.picture('viewer_exposure_reset') - before).max(), 2)

    def test_the_probe_tells_the_pixel_under_the_mouse(self):
        studio = self.open_sample()
        studio.key('p')
        x, y = studio.point('viewer.picture', 0.5, 0.6)
        studio.move(x, y)
        studio.item('viewer.probe')
        shot = studio.screenshot('viewer_probe')
        column, row, *codes = map(int, studio.state('probe').split())
        self.assertAlmostEqual(column, 240, delta=2)
        self.assertAlmostEqual(row, 162, delta=2)
        self.assertLess(np.abs(shot[y - 1:y + 2, x - 8:x - 4].reshape(-1, 3).mean(0) - codes).max(), 40)

    def test_another_view_changes_the_picture_and_is_one_step(self):
        studio = self.open_sample()
        before = studio.picture('viewer_view_before')
        studio.click('bar.view')
        names = [name for name in studio.layout()['items'] if name.startswith('view.')]
        self.assertGreater(len(names), 2)
        studio.screenshot('viewer_view_list')
        studio.click(sorted(name for name in names if 'ACES' in name or 'raw' in name.lower())[0])
        studio.move(640, 705)
        self.assertGreater(np.abs(studio.picture('viewer_view') - before).mean(), 3)
        studio.key('ctrl+z')
        self.assertLess(np.abs(studio.picture('viewer_view_undone') - before).max(), 2)


if __name__ == '__main__':
    unittest.main()

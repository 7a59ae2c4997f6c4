"""A folder of camera raw files: brought in, solved, and held against the same light in linear EXR."""
import json
import os
import unittest

import numpy as np
import cli
from camera_raw import write_dng

COLORS = '0.9/0.2/0.15,0.15/0.8/0.25'
INSIDE = (slice(4, -4), slice(4, -4))  # a mosaic has no neighbours to guess from at its edge


class CameraRaw(cli.CliTest):
    def photographs(self, brightness=1.6):
        capture = cli.Capture(self.path('made'), height=96, width=128)
        self.light = [brightness * shot for shot in capture.shots]
        for folder in ('raw', 'exr'):
            os.makedirs(self.path(folder))
        for k, pixels in enumerate(self.light):
            write_dng(self.path('raw', f'IMG_{k}.dng'), pixels, f'2026:11:21 10:00:0{k}')
            cli.write_image(self.path('exr', f'IMG_{k}.exr'), pixels)
        self.made = {}
        for folder in ('raw', 'exr'):
            self.made[folder] = self.succeed_json('new', self.path(folder), '--lights', 'key,fill', '--colors', COLORS)

    def solved(self, folder):
        out = self.path(folder + '.exr')
        return out, self.succeed_json('solve', self.path(folder), '-o', out, '--model', 'lambert', '--float')

    def test_contributions_are_those_of_linear_photographs_to_the_error_of_the_mosaic(self):
        self.photographs()
        with open(self.path('raw', 'capture.json')) as file:
            manifest = json.load(file)
        self.assertEqual([shot['image'] for shot in manifest['shots']], ['IMG_0.dng', 'IMG_1.dng'])
        self.assertEqual(manifest['color_space'], 'lin_rec709')
        raw, _ = self.solved('raw')
        linear, _ = self.solved('exr')
        for light in ('key', 'fill'):
            ours, truth = cli.read_rgb(raw, light)[INSIDE], cli.read_rgb(linear, light)[INSIDE]
            self.assertLess(np.abs(ours - truth).mean() / truth.mean(), 0.01, light)
            self.assertLess(np.abs(ours - truth).max(), 0.05 * truth.max(), light)
            ratio = (ours.mean(axis=(0, 1)) / truth.mean(axis=(0, 1)))
            np.testing.assert_allclose(ratio, 1, atol=2e-3, err_msg='no white balance, no brightening, no gamma')

    def test_what_is_saturated_is_clipped_and_said(self):
        self.photographs(brightness=6)
        self.assertGreater(max(shot.max() for shot in self.light), 1)
        self.assertIn('clipped', ' '.join(self.made['raw']['warnings']))
        raw, _ = self.solved('raw')
        flags = cli.read_image(raw)['quality.flags'].astype(int)
        over = np.max([shot.max(axis=2) for shot in self.light], axis=0) > 1.05
        under = np.max([shot.max(axis=2) for shot in self.light], axis=0) < 0.9
        self.assertTrue((flags[INSIDE][over[INSIDE]] & 1).mean() > 0.97)
        self.assertTrue((flags[INSIDE][under[INSIDE]] & 1).mean() < 0.03)

    def test_a_broken_one_is_one_clear_line(self):
        self.photographs()
        with open(self.path('raw', 'IMG_1.dng'), 'r+b') as file:
            file.truncate(400)
        self.deny('solve', self.path('raw'), '-o', self.path('never.exr'), naming='IMG_1.dng')


if __name__ == '__main__':
    cli.main()

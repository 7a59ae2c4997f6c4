"""A light's highlights made stronger, weaker, and looked at, in a real window."""
import json
import subprocess
import unittest

import numpy as np
import OpenImageIO as oiio

from studio import PROGRAM, StudioTest

HEIGHT, WIDTH = 288, 480
SWAPPED = [[[.9, .2, .15], [.15, .8, .25]], [[.15, .8, .25], [.9, .2, .15]]]


def write(path, pixels):
    spec = oiio.ImageSpec(WIDTH, HEIGHT, 3, 'float')
    out = oiio.ImageOutput.create(path)
    assert out.open(path, spec) and out.write_image(np.ascontiguousarray(pixels, np.float32)), out.geterror()
    out.close()


class Shine(StudioTest):
    def glossy(self, peak):
        """A red plate under two lights, each with a round highlight, solved."""
        y, x = np.mgrid[:HEIGHT, :WIDTH]
        spots = [peak * np.exp(-((x - at) ** 2 + (y - 144) ** 2) / 60) for at in (144, 336)]
        along = [(WIDTH - x) / WIDTH, x / WIDTH]
        truth = np.array([np.array([.5, .15, .1]) * (.1 + .3 * a[..., None]) + s[..., None]
                          for a, s in zip(along, spots)])
        random = np.random.default_rng(5)
        for k, colors in enumerate(SWAPPED):
            shot = np.einsum('ic,ihwc->hwc', np.array(colors), truth)
            write(self.path(f'shot_{k}.exr'), shot + random.normal(size=shot.shape) * np.sqrt(shot / 5e4 + 1e-6))
        with open(self.path('capture.json'), 'w') as file:
            json.dump({'format': 'swaplight-capture', 'version': 1, 'color_space': 'lin_rec709',
                       'lights': [{'name': 'left'}, {'name': 'right'}],
                       'shots': [{'image': f'shot_{k}.exr', 'light_colors': c} for k, c in enumerate(SWAPPED)],
                       'noise': {'read': .001, 'full_well': 50000}}, file)
        solved = self.path('solved.exr')
        subprocess.run([PROGRAM, 'solve', self.path('capture.json'), '-o', solved, '--model', 'gloss', '-q'], check=True)
        studio = self.start(solved)
        studio.wait_ready()
        studio.key('F4')
        studio.item('edits.add')
        return studio

    def test_a_slider_takes_the_highlights_away_and_undo_brings_them_back(self):
        studio = self.glossy(1)
        before = studio.picture('shine_before')
        self.add('shine')
        height, width = before.shape[:2]
        spot = np.s_[round(.49 * height):round(.51 * height), round(.29 * width):round(.31 * width)]
        self.assertLess(np.abs(studio.picture('shine_neutral').astype(int) - before)[spot].max(), 2, 'as photographed')
        studio.drag(studio.point('parameters.amount', 1 / 3), studio.point('parameters.amount', .01))
        studio.settle()
        matte = studio.picture('shine_matte')
        studio.screenshot('shine_panel')
        self.assertGreater((before.astype(int) - matte)[spot].mean(), 20)
        _, session = self.save_as('matte')
        edit = session['edits']['edits'][0]
        self.assertEqual((edit['operation'], edit['lights']), ('shine', ['left']))
        self.assertLess(edit['amount'], .1)
        studio.key('ctrl+z')
        studio.settle()
        self.assertLess(np.abs(studio.picture('shine_undone').astype(int) - before)[spot].max(), 2)

    def test_the_viewer_shows_a_light_s_highlights(self):
        studio = self.glossy(1)
        self.show('Highlights of left', 'Highlights')
        studio.settle()
        shown = studio.picture('shine_highlights')
        studio.screenshot('shine_highlights')
        height, width = shown.shape[:2]
        self.assertGreater(shown[height // 2, round(.3 * width)].min(), 100)
        self.assertLess(shown[height // 2, round(.6 * width)].max(), 10)
        self.show('left without highlights', 'Highlights')
        studio.settle()
        self.assertLess(studio.picture('shine_diffuse')[height // 2, round(.3 * width), 2], 150)


if __name__ == '__main__':
    unittest.main()

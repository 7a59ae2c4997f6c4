"""Photographs as they should not be (overexposed, constant, not finite): every model either solves them, with finite
pixels, or refuses them in one line."""
import os

import numpy as np
import cli

MODELS = ('auto', 'single', 'lambert', 'gloss', 'transport')
THREE = [*cli.SWAPPED, [[.2, .3, .9], [.9, .2, .15]]]


def spoilt_pictures(good):
    yield 'overexposed', np.ones_like(good)
    yield 'constant', np.full_like(good, .25)
    yield 'black', np.zeros_like(good)
    yield 'negative', -good
    yield 'not a number', np.full_like(good, np.nan)
    yield 'infinite', np.full_like(good, np.inf)


class SpoiltShotsTest(cli.CliTest):
    def solve(self, name, pictures, pixel_type='float', extension='exr'):
        """Solves with each model. Gives the channels of those that did."""
        capture = cli.Capture(self.path(name), light_colors=THREE[:len(pictures)])
        for k, (shot, pixels) in enumerate(zip(capture.manifest['shots'], pictures)):
            shot['image'] = f's{k}.{extension}'
            cli.write_image(os.path.join(capture.folder, shot['image']), pixels, pixel_type)
        if extension != 'exr':
            capture.manifest['color_space'] = 'srgb'
        capture.shots = []
        capture.save()
        solved = {}
        for model in MODELS:
            output = self.path(f'{name}-{model}.exr')
            result = cli.run('solve', capture.path, '-o', output, '-q', '--model', model)
            said = f'{name}, {model}: exit {result.returncode}: {result.stderr}'
            self.assertIn(result.returncode, (0, 2), said)
            self.assertEqual(result.stderr.count('\n'), result.returncode // 2, said)
            self.assertEqual(os.path.exists(output), result.returncode == 0, said)
            if result.returncode == 0:
                solved[model] = cli.read_image(output)
                for channel, pixels in solved[model].items():
                    self.assertTrue(np.isfinite(pixels).all(), f'{channel} of {said}')
        return solved

    def test_one_spoilt_shot_of_three(self):
        good = cli.Capture(self.path('good'), light_colors=THREE, height=24, width=32)
        for name, spoilt in spoilt_pictures(good.shots[0]):
            with self.subTest(name):
                self.solve(name, [spoilt, *good.shots[1:]])

    def test_two_spoilt_shots(self):
        good = cli.Capture(self.path('good'), height=24, width=32)
        for name, spoilt in spoilt_pictures(good.shots[0]):
            with self.subTest(name):
                self.solve('both ' + name, [spoilt, spoilt])

    def test_eight_bit_pictures(self):
        for name, value in (('white', 1.), ('black', 0.), ('grey', .5)):
            with self.subTest(name):
                self.solve(name, [np.full((24, 32, 3), value)] * 2, 'uint8', 'png')

    def test_the_shots_beside_an_overexposed_one_are_used(self):
        good = cli.Capture(self.path('good'), light_colors=THREE, height=24, width=32)
        channels = self.solve('clipped', [np.ones_like(good.shots[0]), *good.shots[1:]])['auto']
        for light, truth in zip(('key', 'fill'), good.truth):
            solved = np.stack([channels[f'{light}.{c}'] for c in 'RGB'], -1)
            self.assertLess(abs(solved - truth).mean() / truth.mean(), .02, light)
        self.assertTrue((channels['quality.flags'].astype(int) & 1).all(), 'clipped in a shot is not flagged')


if __name__ == '__main__':
    cli.main()

"""What of each light is highlight: kept by a solve, in files, as layers, and changed by the edit shine"""
import json
import os
import unittest

import numpy as np
import swaplight_cli as cli

HEIGHT, WIDTH = 120, 200
NOISE = {'read': .001, 'full_well': 50000}
GLOSS = os.path.join(cli.SHARED, 'captures', 'gloss')


def plate(height, color=(.5, .15, .1)):
    """A coloured plate, striped light and dark, under two lights, each with a round white highlight in its half;
    the highlights."""
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    peaks = [height * np.exp(-((x - at) ** 2 + (y - 60) ** 2) / 60) for at in (60, 140)]
    along = [(WIDTH - x) / WIDTH, x / WIDTH]
    paint = np.array(color) * np.where((x + y) % 16 < 8, 1, .6)[..., None]
    lights = [paint * (.1 + .3 * a[..., None]) + p[..., None] for a, p in zip(along, peaks)]
    return np.array(lights, np.float32), np.array(peaks)


def photographed(truth, folder):
    """A capture of two lights with sensor noise that it tells of."""
    random = np.random.default_rng(5)
    capture = cli.Capture(folder)
    capture.truth = truth
    clean = [cli.photograph(truth, colors) for colors in cli.SWAPPED]
    capture.shots = [y + random.normal(size=y.shape) * np.sqrt(y / NOISE['full_well'] + NOISE['read'] ** 2)
                     for y in clean]
    capture.manifest['noise'] = NOISE
    capture.save()
    return capture


class HighlightsTest(cli.CliTest):
    def solved(self, truth, *options, name='solved.exr', model='gloss'):
        capture = photographed(truth, self.path('set'))
        self.succeed('solve', capture.path, '-o', self.path(name), '-q', '--model', model, *options)
        return self.path(name)

    def shone(self, solved, amount, **edit):
        edits = self.path('edits.json')
        with open(edits, 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1,
                       'edits': [{'operation': 'shine', 'amount': amount, **edit}]}, file)
        frame = self.path(f'frame{amount}.exr')
        result = self.succeed('relight', solved, '--edits', edits, '--linear', '-o', frame)
        return cli.read_rgb(frame), result.stdout + result.stderr

    def test_a_solve_keeps_them_and_changes_nothing_else(self):
        truth, peaks = plate(1)
        solved = self.solved(truth)
        channels = cli.read_image(solved)
        for name, peak in zip(('key', 'fill'), peaks):
            found, light = cli.read_rgb(solved, name + '.spec'), cli.read_rgb(solved, name)
            self.assertTrue((found >= 0).all() and (found <= light).all())
            self.assertLess(np.linalg.norm(found[..., 0] - peak) / np.linalg.norm(peak), .45)
            self.assertLess(np.maximum(found[..., 0] - peak, 0).sum(), .03 * peak.sum(), 'a lower bound')
        self.assertRegex(self.succeed('info', solved).stdout, r'highlights +of key, fill, in \d+\.\d+ % of the picture')
        without = cli.read_image(self.solved(truth, '--highlights', 'off', name='without.exr'))
        self.assertEqual(sorted(set(channels) - set(without)), sorted(f'{n}.spec.{c}' for n in ('key', 'fill') for c in 'RGB'))
        for channel, pixels in without.items():
            self.assertTrue((pixels == channels[channel]).all(), channel)

    def test_a_matte_set_has_none(self):
        for model in ('auto', 'gloss', 'transport', 'lambert'):
            solved = self.solved(plate(0)[0], model=model)
            self.assertFalse([c for c in cli.read_image(solved) if '.spec' in c], model)
        self.assertNotIn('highlights', self.succeed('info', solved).stdout)

    def test_shine(self):
        truth, peaks = plate(1)
        solved = self.solved(truth)
        plain = cli.read_rgb(solved)
        same, said = self.shone(solved, 1)
        self.assertTrue((same == self.shone(solved, 3, on=False)[0]).all(), 'neutral to the bit')
        self.assertNotIn('has no highlights', said)
        matte, more = self.shone(solved, 0)[0], self.shone(solved, 3, lights=['key'])[0]
        spec = [cli.read_rgb(solved, name + '.spec') for name in ('key', 'fill')]
        self.assertLess(abs(plain - matte - spec[0] - spec[1]).max(), 2e-3)
        self.assertLess(abs(more - plain - 2 * spec[0]).max(), 4e-3)

    def test_shine_says_where_there_are_none(self):
        frame, said = self.shone(self.solved(plate(0)[0]), 0)
        self.assertEqual(said.count('has no highlights'), 1)

    def test_they_are_layers_on_request(self):
        solved = self.solved(plate(1)[0])
        layers = self.path('layers.exr')
        self.succeed('export', solved, '-o', layers, '--light', 'key=x2', '--spec', '-q')
        self.assertLess(abs(cli.read_rgb(layers, 'key.spec') - 2 * cli.read_rgb(solved, 'key.spec')).max(), 2e-3)
        self.succeed('export', solved, '-o', layers, '-q')
        self.assertFalse([c for c in cli.read_image(layers) if '.spec' in c])
        none = self.solved(plate(0)[0], name='none.exr')
        self.assertIn('no highlights', self.succeed('export', none, '-o', layers, '--spec').stderr)

    @unittest.skipUnless(os.path.isdir(GLOSS), 'needs ../shared/captures/gloss')
    def test_matte_of_a_glossy_scene_comes_near_the_scene_without_gloss(self):
        def lights(variant):
            return np.array([cli.read_rgb(os.path.join(GLOSS, variant, f'T_{name}.exr')) for name in ('left', 'right')])
        truth, matte = lights('spec5'), lights('lambert')
        solved = self.solved(truth, model='auto')
        for name, light, best in zip(('key', 'fill'), matte, (.6, .6)):
            with_them = cli.read_rgb(solved, name)
            rest = with_them - cli.read_rgb(solved, name + '.spec')
            error = np.linalg.norm(rest - light) / np.linalg.norm(light)
            self.assertLess(error, best)
            self.assertLess(error, .3 * np.linalg.norm(with_them - light) / np.linalg.norm(light))


if __name__ == '__main__':
    cli.main()

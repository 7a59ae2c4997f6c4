"""Uneven lamps and lenses, put right by pictures of a grey card: new, solve, manifest"""
import json
import os
import shutil

import numpy as np
import cli

SIZE = {'height': 60, 'width': 80}
Y, X = np.meshgrid(np.linspace(-1, 1, 60), np.linspace(-1, 1, 80), indexing='ij')
LUMINANCE = [.2126, .7152, .0722]


def colored(*channels):
    """A drift of the colour alone: what a lamp has of light, place by place, belongs to its contribution."""
    field = np.stack(channels, -1)
    return field / (field @ LUMINANCE)[..., None]


DRIFT = {'key': colored(1 + .1 * X, 1 + 0 * X, 1 - .1 * X), 'fill': colored(1 - .1 * Y, 1 + .06 * X, 1 + .1 * Y)}
LENS = (1 / (1 + .3 * (X ** 2 + Y ** 2)) ** 2)[..., None]


class FlatFields(cli.CliTest):
    """Lamps whose colour drifts by 10 % over the field, photographed."""

    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'), **SIZE)
        self.names = ('key', 'fill')
        self.even = self.capture.truth
        uneven = np.stack([t * DRIFT[n] for n, t in zip(self.names, self.even)])
        self.capture.shots = [cli.photograph(uneven, c) * LENS for c in cli.SWAPPED]
        self.capture.save()
        for name in self.names:  # brighter at the left
            cli.write_image(self.path('cards', f'flat_{name}.exr'), DRIFT[name] * LENS * .6 * (1 - .4 * X)[..., None])
        cli.write_image(self.path('cards', 'vignetting.exr'), LENS * .7 * np.ones(3))
        self.options = ['--flat', 'key=' + self.path('cards', 'flat_key.exr'), '--flat', 'fill=' + self.path('cards', 'flat_fill.exr'),
                        '--vignetting', self.path('cards', 'vignetting.exr')]

    def error(self, *arguments, path=None):
        self.succeed('solve', path or self.capture.path, '-o', self.path('solved.exr'), '--float', '-q', *arguments)
        found = np.stack([cli.read_rgb(self.path('solved.exr'), name) for name in self.names])
        scale = [np.median(f / t, (0, 1)) for f, t in zip(found, self.even)]  # what colour a lamp has in the mean is not asked
        return max(np.abs(f / t / s - 1).max() for f, t, s in zip(found, self.even, scale))

    def test_solve_evens_lamps_and_lens(self):
        self.assertGreater(self.error(), .3)
        self.assertGreater(self.error(*self.options[4:]), .08)
        self.assertLess(self.error(*self.options), .02)

    def test_the_manifest_keeps_them_and_the_set_does_too(self):
        self.capture.manifest['flats'] = {name: f'../cards/flat_{name}.exr' for name in self.names}
        self.capture.manifest['vignetting'] = '../cards/vignetting.exr'
        self.capture.save()
        result = self.succeed('solve', self.capture.path, '-o', self.path('solved.exr'))
        self.assertNotIn('unknown key', result.stderr)
        self.assertLess(self.error(), .02)
        self.assertLess(self.error('--model', 'transport'), .02)

    def test_new_finds_them_in_the_folder(self):
        for name in os.listdir(self.path('cards')):
            shutil.copy(self.path('cards', name), self.path('set', name))
        cli.write_image(self.path('set', 'flat_moon.exr'), np.ones((60, 80, 3)))
        arguments = ['new', self.path('set'), '--lights', 'key,fill', '--colors', '.9/.2/.15,.15/.8/.25', '--force', '--exposures', '0']
        result = self.succeed_json(*arguments)
        self.assertEqual(len(result['shots']), 2)
        self.assertTrue(any('flat_moon.exr' in warning for warning in result['warnings']), result['warnings'])
        with open(self.capture.path) as file:
            made = json.load(file)
        self.assertEqual(made['flats'], {'key': 'flat_key.exr', 'fill': 'flat_fill.exr'})
        self.assertEqual(made['vignetting'], 'vignetting.exr')
        self.assertLess(self.error(), .02)
        self.succeed(*arguments, '--flat', self.options[1])
        with open(self.capture.path) as file:
            self.assertEqual(json.load(file)['flats'], {'key': '../cards/flat_key.exr', 'fill': 'flat_fill.exr'})

    def test_drift_is_found_without_cards(self):
        """Two lamps that fall off to either side, their shadows, and blobs of colour; key's red rises by 30 %."""
        random = np.random.default_rng(11)
        y, x = np.mgrid[:144, :192].astype(float)
        blobs = np.zeros((144, 192, 3))
        for _ in range(500):
            cx, cy, size = 192 * random.random(), 144 * random.random(), 1.5 + 5 * random.random()
            blobs += 3 * (random.random(3) - .4) * np.exp(-((x - cx) ** 2 + (y - cy) ** 2) / (2 * size ** 2))[..., None]
        albedo = .9 / (1 + np.exp(1.2 - blobs))
        lit = [(1 - .75 * u) * np.where(np.sin(.11 * x + tilt * y) > .75, .04, 1)
               for u, tilt in ((x / 192, .07), (1 - x / 192, -.05))]
        even = np.stack([albedo * one[..., None] for one in lit])
        drift = np.stack([1 + .15 * (x / 96 - 1), np.ones_like(x), np.ones_like(x)], -1)
        capture = cli.Capture(self.path('drifting'), height=144, width=192)
        capture.manifest['noise'] = {'read': .0005, 'full_well': 200000}

        def error(lights, *arguments):
            shots = [cli.photograph(lights, colors) for colors in cli.SWAPPED]
            capture.shots = [s + random.normal(size=s.shape) * np.sqrt(s / 200000 + .0005 ** 2) for s in shots]
            capture.save()
            said = self.succeed_json('solve', capture.path, '-o', self.path('solved.exr'), '--float',
                                     '--report', self.path('report.json'), *arguments)
            with open(self.path('report.json')) as file:
                report = json.load(file)
            found = np.stack([cli.read_rgb(self.path('solved.exr'), name) for name in self.names])
            return np.sqrt(((found - even) ** 2).mean() / (even ** 2).mean()), report, said

        drifting = even * np.stack([drift, np.ones_like(drift)])
        plain, report, _ = error(drifting)
        self.assertIn('field', report['misfit_causes']['likely'])
        evened, report, said = error(drifting, '--field')
        self.assertLess(evened, .9 * plain)  # what the lamps share stays, and noise
        self.assertEqual([field['light'] for field in report['lamp_fields']], ['key', 'fill'])
        self.assertIn('evened', json.dumps(said))
        _, report, _ = error(even, '--field')
        self.assertFalse(report.get('lamp_fields'))
        self.assertTrue(any('nothing was evened' in warning for warning in report['warnings']), report['warnings'])

    def test_what_is_wrong_is_said(self):
        out = ['-o', self.path('x.exr')]
        self.deny('solve', self.capture.path, *out, '--flat', 'moon=' + self.path('cards', 'flat_key.exr'), naming='no light "moon"')
        self.deny('solve', self.capture.path, *out, '--flat', 'key', naming='LIGHT=FILE')
        self.deny('solve', self.capture.path, *out, '--flat', 'key=gone.exr', naming='gone.exr')
        cli.write_image(self.path('black.exr'), np.zeros((60, 80, 3)))
        self.deny('solve', self.capture.path, *out, '--vignetting', self.path('black.exr'), naming=['black.exr', 'grey surface'])
        cards = self.capture.manifest['flats'] = {'key': '../cards/flat_key.exr'}
        self.capture.save()
        self.deny('solve', self.capture.path, '-o', self.path('set', cards['key']), naming='flat_key.exr')
        card = self.path('cards', 'flat_fill.exr')
        self.deny('solve', self.capture.path, '-o', card, '--flat', 'fill=' + card, naming='flat_fill.exr')
        self.assertEqual(cli.read_image(card)['R'].shape, (SIZE['height'], SIZE['width']))
        result = self.succeed('solve', self.capture.path, *out, '--vignetting', self.path('set', 'shot_01.exr'))
        self.assertIn('even grey surface', result.stderr)


if __name__ == '__main__':
    cli.main()

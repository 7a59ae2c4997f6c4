"""Numbers beyond what is usual: light of any brightness is solved alike, and nothing becomes NaN or infinite without
a word."""
import json
import os

import numpy as np
import cli


class BrightnessTest(cli.CliTest):
    def test_light_of_any_brightness_is_solved_alike(self):
        for exponent in (-25, -15, -8, -5, -3, 0, 3, 5, 6, 8, 12, 16, 20):
            with self.subTest(exponent):
                capture = cli.Capture(self.path(f'set{exponent}'), height=24, width=32)
                capture.shots = [shot * 10. ** exponent for shot in capture.shots]
                capture.save()
                solved = self.path(f'solved{exponent}.exr')
                self.succeed('solve', capture.path, '-o', solved, '-q')
                channels = cli.read_image(solved)
                for name, pixels in channels.items():
                    self.assertTrue(np.isfinite(pixels).all(), name)
                for light, truth in zip(('key', 'fill'), capture.truth):
                    layer = np.stack([channels[f'{light}.{c}'] for c in 'RGB'], -1) / 10. ** exponent
                    self.assertLess(abs(layer - truth).mean() / truth.mean(), .01, light)
                    self.assertTrue((abs(channels['beta.' + light]) <= 1).all())

    def test_values_that_are_no_light_are_refused(self):
        for factor in (1e36, 1e-36):
            capture = cli.Capture(self.path(f'set{factor}'))
            capture.shots = [shot * factor for shot in capture.shots]
            capture.save()
            self.deny('solve', capture.path, '-o', self.path('o.exr'), '-q', naming=['capture.json', 'no light'])

    def test_a_frame_that_half_cannot_hold_says_so(self):
        capture = cli.Capture(self.path('set'))
        call = ('relight', capture.path, '--light', 'key=+20st', '-o', self.path('o.exr'))
        self.assertIn('clipped', self.succeed(*call, '--type', 'half').stderr)
        self.assertNotIn('clipped', self.succeed(*call).stderr)
        self.assertGreater(cli.read_rgb(self.path('o.exr')).max(), 65504)


class NotFiniteTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '-q')

    def test_options_that_are_no_number(self):
        for text in ('nan', 'NaN', 'inf', '-inf'):
            with self.subTest(text):
                self.deny('relight', self.solved, '--ambient', text, '-o', self.path('o.exr'), naming='--ambient')
                self.deny('solve', self.capture.path, '--color-uncertainty', text, '-o', self.path('o.exr'),
                          naming='--color-uncertainty')
                self.deny('studio', '--scale', text, '--screenshot', self.path('o.png'), naming='--scale')

    def test_settings_beyond_what_float_holds(self):
        for setting in ('x3e38,+30st', 'x3e38', 'rgb:1e38/1/1,+30st', '+300st'):
            with self.subTest(setting):
                self.deny('relight', self.solved, '--light', 'key=' + setting, '-o', self.path('o.exr'), naming='key')

    def test_a_set_with_pixels_that_are_no_number(self):
        broken = self.path('broken.exr')
        self.spoil(broken, {'key.R': np.nan, 'fill.G': np.inf, 'beta.key': np.nan})
        result = self.succeed('relight', broken, '-o', self.path('o.exr'))
        self.assertIn('3 values', result.stderr)
        self.assertTrue(np.isfinite(cli.read_rgb(self.path('o.exr'))).all())
        self.succeed('export', broken, '-o', self.path('layers.exr'))
        for name, pixels in cli.read_image(self.path('layers.exr')).items():
            self.assertTrue(np.isfinite(pixels).all(), name)

    def spoil(self, path, values):
        """The solved set with one value of each of these channels replaced."""
        import OpenImageIO as oiio
        source = oiio.ImageInput.open(self.solved)
        spec, pixels = source.spec(), np.asarray(source.read_image('float'))
        for name, value in values.items():
            pixels[2, 3, spec.channelnames.index(name)] = value
        spec.set_format('float')
        spec.channelformats = ()
        out = oiio.ImageOutput.create(path)
        self.assertTrue(out.open(path, spec) and out.write_image(pixels), out.geterror())
        out.close()

    def test_a_shot_with_huge_values_leaves_no_nan(self):
        for value in (4e37, 3e38, -3e38, np.inf):
            capture = cli.Capture(self.path('huge'), height=24, width=32)
            capture.shots[1][5:9, 5:20] = value
            capture.save()
            solved = self.path('huge.exr')
            result = cli.run('solve', capture.path, '-o', solved, '-q')
            if result.returncode != 0:  # refused, because that is no light; with nothing written
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn('no light', result.stderr)
                self.assertFalse(os.path.exists(solved))
                continue
            for name, pixels in cli.read_image(solved).items():
                self.assertTrue(np.isfinite(pixels).all(), f'{name} with {value}')


if __name__ == '__main__':
    cli.main()

"""swaplight response: a camera's curve out of brackets, and captures in it."""
import json
import os

import numpy as np
import cli


def encode(y):
    """sRGB with more contrast."""
    v = np.where(y <= .0031308, 12.92 * y, 1.055 * np.maximum(y, 1e-9) ** (1 / 2.4) - .055)
    return v + .35 * (v * v * (3 - 2 * v) - v)


class Response(cli.CliTest):
    def ramp(self, name='chart', stops=(0, -1, -2, -3, 1, 2), **attributes):
        x = np.linspace(-9, .5, 200)[None, :, None] + .8 * np.sin(np.arange(120) * .05)[:, None, None]
        light = np.repeat(2 ** x, 3, 2)
        for k, one in enumerate(stops):
            stated = {'ExposureTime': 2. ** one / 50, 'FNumber': 4.0, 'Exif:ISOSpeedRatings': 100} if attributes else {}
            cli.write_image(self.path(name, f'{k}.png'), encode(np.clip(light * 2. ** one, 0, 1)), 'uint8', **stated)
        return self.path(name)

    def curve(self):
        result = self.succeed_json('response', self.ramp(), '--exposures', '0,-1,-2,-3,1,2', '-o', self.path('camera.csv'))
        return result, np.genfromtxt(self.path('camera.csv'), delimiter=',', names=True)

    def test_the_curve_is_found(self):
        result, curve = self.curve()
        light = np.linspace(0, 1, 5001)
        truth = np.interp(curve['code'], encode(light), light)
        for channel in ('red', 'green', 'blue'):
            self.assertLess(np.abs(curve[channel] - truth).max(), .01)
        self.assertGreater(result['nearest_difference'], .03)
        self.assertLess(result['method_difference'], .02)

    def test_exposures_in_a_wrong_order_are_warned_of(self):
        right, wrong = (self.succeed('response', self.ramp(), '--exposures', stops, '-o', self.path('camera.csv')).stderr
                        for stops in ('0,-1,-2,-3,1,2', '0,-3,1,-1,2,-2'))
        self.assertNotIn('warning', right)
        self.assertIn('check the exposures', wrong)

    def test_either_method_finds_it(self):
        result = self.succeed_json('response', self.ramp(), '--exposures', '0,-1,-2,-3,1,2', '--method', 'robertson', '-o', self.path('camera.csv'))
        self.assertEqual(result['method'], 'robertson')
        curve = np.genfromtxt(self.path('camera.csv'), delimiter=',', names=True)
        light = np.linspace(0, 1, 5001)
        truth = np.interp(curve['code'], encode(light), light)
        for channel in ('red', 'green', 'blue'):
            self.assertLess(np.abs(curve[channel] - truth).max(), .01)
        self.deny('response', self.path('chart'), '--method', 'guess', '-o', self.path('camera.csv'), naming=['guess', 'robertson'])

    def test_a_capture_in_it_is_solved_as_well_as_one_in_linear_light(self):
        self.curve()
        capture = cli.Capture(self.path('made'), height=60, width=80)
        for k, shot in enumerate(capture.shots):
            cli.write_image(self.path('jpeg', f'{k}.png'), encode(np.clip(shot, 0, 1)), 'uint8')
        arguments = ['new', self.path('jpeg'), '--lights', 'key,fill', '--colors', '0.9/0.2/0.15,0.15/0.8/0.25', '--force']
        errors = {}
        curve = ['--response', self.path('camera.csv')]
        for way, new, solve in (('srgb', ['--color-space', 'srgb'], []), ('solve', ['--color-space', 'srgb'], curve), ('new', curve, [])):
            self.succeed(*arguments, *new)
            self.succeed('solve', self.path('jpeg'), '-o', self.path('solved.exr'), '--float', '-q', *solve)
            found = np.stack([cli.read_rgb(self.path('solved.exr'), light) for light in ('key', 'fill')])
            errors[way] = np.sqrt(((found - capture.truth) ** 2).mean() / (capture.truth ** 2).mean())
        with open(self.path('jpeg', 'capture.json')) as file:
            self.assertEqual(json.load(file)['color_space'], '../camera.csv')
        self.assertLess(errors['new'], .03)
        self.assertAlmostEqual(errors['new'], errors['solve'], places=6)
        self.assertGreater(errors['srgb'], 3 * errors['new'], 'what the curve is there for')
        os.rename(self.path('camera.csv'), self.path('jpeg', 'response.csv'))
        self.succeed(*arguments)
        with open(self.path('jpeg', 'capture.json')) as file:
            self.assertEqual(json.load(file)['color_space'], 'response.csv', 'found in the folder, as the wizard finds it')
        self.succeed('solve', self.path('jpeg'), '-o', self.path('solved.exr'), '--float', '-q')
        # Another photograph of the set is of the same camera.
        lamps = self.succeed_json('lights', self.path('solved.exr'), self.path('jpeg', '0.png'))
        for name, color in zip(('key', 'fill'), cli.SWAPPED[0]):
            np.testing.assert_allclose(lamps['lights'][name]['color'], color, atol=.03)

    def test_pictures_are_not_replaced_by_what_is_made_of_them(self):
        self.curve()
        capture = cli.Capture(self.path('made'))
        capture.manifest['color_space'] = '../camera.csv'
        capture.save()
        self.deny('solve', capture.path, '-o', self.path('x.exr'), '--report', self.path('camera.csv'), naming='camera.csv')

    def test_what_is_missing_is_said(self):
        out = ['-o', self.path('camera.csv')]
        self.deny('response', self.ramp(), *out, naming='do not say their exposures')
        self.deny('response', self.ramp(), '--exposures', '0,-1', '-o', self.path('camera.txt'), naming='.csv')
        self.deny('response', self.ramp(), '--exposures', '0,-1,2,3', *out, naming='4 of them for 6 photographs')
        cli.write_image(self.path('light', 'a.exr'), np.ones((9, 9, 3)))
        self.deny('response', self.path('light'), '--exposures', '0', *out, naming='no codes of a camera')
        capture = cli.Capture(self.path('made'))
        capture.manifest['color_space'] = 'gone.csv'
        capture.save()
        self.deny('solve', capture.path, '--response', 'curve.txt', '-o', self.path('x.exr'), naming=['curve.txt', '.csv'])
        with open(self.path('falling.csv'), 'w') as file:
            file.write('code,light\n0,0\n.5,.4\n1,.3\n')
        self.deny('solve', capture.path, '--response', self.path('falling.csv'), '-o', self.path('x.exr'), naming=['falling.csv', 'line 4', 'rise'])
        self.deny('solve', capture.path, '-o', self.path('x.exr'), naming=['gone.csv', 'response'])


if __name__ == '__main__':
    cli.main()

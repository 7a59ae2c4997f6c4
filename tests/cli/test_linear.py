"""swaplight linear: whether photographs hold light, by themselves."""
import json

import numpy as np
import swaplight_cli as cli


def encode(y):
    """sRGB with more contrast."""
    v = np.where(y <= .0031308, 12.92 * y, 1.055 * np.maximum(y, 1e-9) ** (1 / 2.4) - .055)
    return v + .35 * (v * v * (3 - 2 * v) - v)


def srgb(y):
    return np.where(y <= .0031308, 12.92 * y, 1.055 * np.maximum(y, 1e-9) ** (1 / 2.4) - .055)


class Linear(cli.CliTest):
    def capture(self, name, coding, colors=((1, 0), (0, 1), (1, 1))):
        """Two lamps alone and together, on anything but matte surfaces."""
        random = np.random.default_rng(2)
        y, x = np.mgrid[:90, :120]
        lamps = [.4 * (.55 + .45 * np.sin(.07 * x[..., None] + 2 * i + np.arange(3)) * np.cos(.05 * y[..., None] - i)) for i in (0, 1)]
        shots = []
        for k, pair in enumerate(colors):
            light = sum(color * lamp for color, lamp in zip(pair, lamps))
            light = light + random.normal(size=light.shape) * np.sqrt(light / 40000 + 1e-6)
            cli.write_image(self.path(name, f'{k}.png'), coding(np.clip(light, 0, 1)), 'uint8')
            shots.append({'image': f'{k}.png', 'light_colors': [[color] * 3 for color in pair]})
        with open(self.path(name, 'capture.json'), 'w') as file:
            json.dump({'format': 'swaplight-capture', 'version': 1, 'name': name, 'color_space': 'srgb',
                       'lights': [{'name': 'key'}, {'name': 'fill'}], 'shots': shots}, file)
        return self.path(name)

    def test_lamps_alone_and_together_tell(self):
        yes = self.succeed_json('linear', self.capture('light', srgb))
        self.assertIs(yes['linear'], True, yes['words'])
        no = self.succeed_json('linear', self.capture('jpeg', encode))
        self.assertIs(no['linear'], False, no['words'])
        self.assertIn('power', no['words'])
        self.assertEqual(len(no['curve']), 8)
        self.assertIn('no: they do not hold light', self.succeed('linear', self.path('jpeg')).stdout)

    def test_the_measured_curve_makes_it_light(self):
        light = np.linspace(0, 1, 4001)
        codes = np.arange(256) / 255
        with open(self.path('camera.csv'), 'w') as file:
            for code, value in zip(codes, np.interp(codes, encode(light), light)):
                file.write(f'{code:.6f},{value:.7f}\n')
        yes = self.succeed_json('linear', self.capture('jpeg', encode), '--response', self.path('camera.csv'))
        self.assertIs(yes['linear'], True, yes['words'])

    def test_new_warns(self):
        folder = self.capture('jpeg', encode)
        result = self.succeed_json('new', folder, '--lights', 'key,fill', '--force', *[
            word for k, pair in enumerate(((1, 0), (0, 1), (1, 1)))
            for word in ('--shot', f'{k}.png=' + ','.join('white' if on else 'off' for on in pair))])
        self.assertIs(result['linearity']['linear'], False)
        self.assertTrue(any('do the photographs hold light? no' in warning for warning in result['warnings']), result['warnings'])

    def test_what_would_tell_is_said(self):
        result = self.succeed_json('linear', self.capture('two', srgb, ((1, 0), (0, 1))))
        self.assertIsNone(result['additivity'])
        self.assertIsNone(result['linear'], result['words'])
        self.assertIn('rackets', result['words'])


if __name__ == '__main__':
    cli.main()

"""A chroma key on a set whose lights are known: the key holds under coloured lights, and the plate is lit by them."""
import json
import os

import numpy as np

from cli import CliTest, main, read_rgb, write_image

WIDTH, HEIGHT = 192, 128
NAMES = ('key', 'left', 'right')
RIG = ['--light', 'key=rgb:1/0.1/0.1', '--light', 'left=rgb:1/0.1/0.05,+1st', '--light', 'right=rgb:0.3/0.5/1']
FACTORS = dict(zip(NAMES, ([1, .1, .1], [2, .2, .1], [.3, .5, 1])))
GREY = .4  # of the plate, in codes


def green_screen():
    """What each light gives: the key on the subject alone, the others on their half of the screen and a little of both."""
    x, y = np.meshgrid((np.arange(WIDTH) + .5) / WIDTH, (np.arange(HEIGHT) + .5) / HEIGHT)
    subject = ((x - .5) / .15) ** 2 + ((y - .5) / .35) ** 2 < 1
    albedo = np.where(subject[..., None], [.6, .42, .34], [.06, .5, .1])
    light = {'key': np.where(subject, .9, 0), 'left': np.where(subject, .1, .8 * (1 - x)),
             'right': np.where(subject, .1, .8 * x)}
    return {name: light[name][..., None] * albedo for name in NAMES}, subject


def light_of(code):
    return ((code + .055) / 1.055) ** 2.4


def codes_of(light):
    light = np.clip(light, 0, 1)
    return np.where(light < .0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - .055)


class PlateLight(CliTest):
    def setUp(self):
        super().setUp()
        pictures, self.subject = green_screen()
        shots = []
        for i, name in enumerate(NAMES):
            write_image(self.path('set', name + '.exr'), pictures[name])
            shots.append({'image': name + '.exr', 'light_colors': [[float(i == j)] * 3 for j in range(len(NAMES))]})
        with open(self.path('set', 'capture.json'), 'w') as file:
            json.dump({'format': 'swaplight-capture', 'version': 1, 'name': 'green screen', 'color_space': 'lin_rec709',
                       'lights': [{'name': name} for name in NAMES], 'shots': shots}, file)
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.path('set'), '-o', self.solved, '--model', 'transport', '--float', '-q')
        self.plate = self.path('plate.png')
        write_image(self.plate, np.full((HEIGHT, WIDTH, 3), GREY), 'uint8')

    def frame(self, name, *rig, key='', more=()):
        out = self.path(name + '.png')
        self.succeed('relight', self.solved, *rig, '--filter', f'chroma-key,plate={self.plate}{key}', *more, '-o', out,
                     '--type', 'uint16')
        return read_rgb(out)

    def test_the_key_holds_whatever_the_lights_become(self):
        white = self.frame('white', key=',show=1')
        np.testing.assert_array_equal(white[..., 0] > .5, self.subject)
        np.testing.assert_allclose(self.frame('colored', *RIG, key=',show=1'), white, atol=.04)
        as_seen = self.frame('as_seen', *RIG, key=',show=1,underWhite=off')
        self.assertGreater((np.abs(as_seen - white) > .5).mean(), .15, 'without it the screen is no longer green')

    def test_at_unit_white_nothing_changes(self):
        np.testing.assert_array_equal(self.frame('lit', key=',plateLight=1'), self.frame('plain'))

    def test_the_plate_is_lit_as_the_screen_is(self):
        plain, lit = self.frame('plain', *RIG), self.frame('lit', *RIG, key=',plateLight=1')
        np.testing.assert_array_equal(lit[self.subject], plain[self.subject])
        np.testing.assert_allclose(plain[~self.subject], GREY, atol=.03)
        across = (np.arange(WIDTH) + .5)[:, None] / WIDTH
        light = np.array(FACTORS['left']) * (1 - across) + np.array(FACTORS['right']) * across
        expected = np.broadcast_to(codes_of(light_of(GREY) * light), (HEIGHT, WIDTH, 3))
        inner = np.zeros((HEIGHT, WIDTH), bool)
        inner[8:-8, 24:-24] = True  # the mean around a place near the border is of one side
        error = np.abs(lit - expected)[inner & ~self.subject]
        self.assertLess(np.percentile(error, 95), .02)
        beside = lit[HEIGHT // 2, WIDTH // 2 + 32]  # 4 pixels beside the subject, whose key is red
        self.assertLess(np.abs(beside - expected[HEIGHT // 2, WIDTH // 2 + 32]).max(), .04)

    def test_half_of_it(self):
        whole, half = (self.frame(n, '--light', 'left=x4', '--light', 'right=x4', key=f',plateLight={a}')[4, 4, 0]
                       for n, a in (('whole', 1), ('half', .5)))
        self.assertAlmostEqual(half, codes_of(light_of(GREY) * 2.5), delta=.01)
        self.assertAlmostEqual(whole, codes_of(light_of(GREY) * 4), delta=.01)

    def test_parts_are_the_whole(self):
        np.testing.assert_array_equal(self.frame('parts', *RIG, key=',plateLight=1', more=['--tile', '64']),
                                      self.frame('whole', *RIG, key=',plateLight=1'))

    def test_layers_and_sequences_are_lit_too(self):
        whole = self.frame('whole', *RIG, key=',plateLight=1')
        out = self.path('layers.exr')
        self.succeed('export', self.solved, *RIG, '--filter', f'chroma-key,plate={self.plate},plateLight=1', '-o', out)
        np.testing.assert_allclose(codes_of(read_rgb(out, 'camera_look')), whole, atol=.003)

    def test_a_frame_alone_tells_no_lights(self):
        self.succeed('relight', self.solved, '-o', self.path('f.exr'))
        frames = []
        for i, key in enumerate(('', ',plateLight=1')):
            out = self.path(f'{i}.png')
            self.succeed('look', 'apply', self.path('f.exr'), '--filter', f'chroma-key,plate={self.plate}{key}', '-o', out)
            frames.append(read_rgb(out))
        np.testing.assert_array_equal(*frames)


if __name__ == '__main__':
    main()

"""swaplight lightmap: the light on the set without its texture"""
import json
import os
import unittest

import numpy as np
import swaplight_cli as cli

HEIGHT, WIDTH = 108, 192


def lamp(x, y, z):
    """What a bare lamp gives to an upright wall; widths of the picture from its middle."""
    rows, columns = np.mgrid[:HEIGHT, :WIDTH]
    px, py = (columns + .5) / WIDTH - .5, (.5 * HEIGHT - rows - .5) / WIDTH
    return .3 * z / ((px - x) ** 2 + (py - y) ** 2 + z ** 2) ** 1.5


KEY, FILL = lamp(-.2, .1, .6), .5 * lamp(.6, 0, 1.)


def tiles(seed):
    """Tiles of random colours."""
    colors = np.random.default_rng(seed).uniform(.15, .85, (HEIGHT // 6 + 1, WIDTH // 6 + 1, 3))
    return colors.repeat(6, 0).repeat(6, 1)[:HEIGHT, :WIDTH]


def spread(picture, truth):
    """What is wrong beyond a constant: the standard deviation of the logarithm."""
    return np.log(picture / truth).std()


class LightmapTest(cli.CliTest):
    def solved(self, seed=1, lights=(KEY, FILL)):
        colors = cli.SWAPPED if len(lights) == 2 else [[[1, 1, 1]]]
        capture = cli.Capture(self.path(f'set{seed}'), ('key', 'fill')[:len(lights)], colors)
        capture.truth = [(tiles(seed) * light[..., None]).astype(np.float32) for light in lights]
        capture.shots = [cli.photograph(capture.truth, c) for c in colors]
        capture.save()
        solved = self.path(f'solved{seed}.exr')
        self.succeed('solve', capture.path, '-o', solved, '--float', '-q')
        return solved

    def test_the_map_is_the_light_and_has_a_layer_a_light(self):
        said = self.succeed_json('lightmap', self.solved(), '-o', self.path('map.exr'), '--type', 'float')
        self.assertEqual(said['lights'], ['key', 'fill'])
        self.assertEqual((said['width'], said['height']), (WIDTH, HEIGHT))
        found = cli.read_image(self.path('map.exr'))
        for name, light in (('key', KEY), ('fill', FILL)):
            texture = (tiles(1) * light[..., None]).mean(2)
            self.assertGreater(spread(texture, light), .2)
            self.assertLess(spread(found[name + '.G'], light), .06, name)
            self.assertTrue(np.array_equal(found[name + '.R'], found[name + '.B']), 'at unit white it is grey')
        total = found['key.G'] + found['fill.G']
        self.assertLess(np.abs(found['G'] - total).max(), 1e-6 * total.max())

    def test_another_texture_gives_the_same_map(self):
        maps = []
        for seed in (2, 3):
            self.succeed('lightmap', self.solved(seed), '-o', self.path(f'map{seed}.exr'), '--type', 'float', '-q')
            maps.append(cli.read_image(self.path(f'map{seed}.exr')))
        for name in ('key', 'fill'):
            self.assertLess(spread(maps[0][name + '.G'], maps[1][name + '.G']), .08, name)

    def test_lights_have_their_colours_and_one_can_stand_alone(self):
        solved = self.solved()
        self.succeed('lightmap', solved, '--light', 'key=rgb:1/.5/.25,+1st', '--only', 'key', '-o', self.path('key.exr'),
                     '--type', 'float', '-q')
        found = cli.read_image(self.path('key.exr'))
        self.assertNotIn('fill.R', found)
        self.assertTrue(np.allclose(found['R'], 4 * found['B'], rtol=1e-5))
        self.assertLess(spread(found['R'], KEY), .06)
        self.succeed('lightmap', solved, '--light', 'fill=off', '-o', self.path('map.png'), '-q')
        picture = cli.read_rgb(self.path('map.png'))
        self.assertEqual(picture.shape, (HEIGHT, WIDTH, 3))
        self.assertLess(np.ptp(picture, axis=2).max(), .01, 'grey')
        self.assertGreater(np.ptp(picture), .2)

    def test_smoothing_evens_out_relief(self):
        relief = 1 + .2 * np.sin(.9 * np.arange(WIDTH))
        errors = {}
        for lights, smooth in ((KEY, 0), (KEY * relief, 0), (KEY * relief, .05)):
            self.succeed('lightmap', self.solved(4, (lights, FILL)), '--smooth', smooth, '-o', self.path('map.exr'), '--type',
                         'float', '-q')
            errors[lights is KEY, smooth] = spread(cli.read_image(self.path('map.exr'))['key.G'], KEY)
        def relief_in(smooth):  # beyond what is wrong without any
            return np.sqrt(max(errors[False, smooth] ** 2 - errors[True, 0] ** 2, 0))

        self.assertGreater(relief_in(0), .05, errors)
        self.assertLess(relief_in(.05), .6 * relief_in(0), errors)

    def test_one_light_alone_is_warned_of(self):
        done = self.succeed('lightmap', self.solved(5, (KEY,)), '-o', self.path('map.exr'))
        self.assertIn('warning', done.stderr)
        self.assertIn('one light', done.stderr)
        self.assertTrue(np.isfinite(cli.read_rgb(self.path('map.exr'))).all())

    def test_wrong_calls_are_one_line_and_exit_2(self):
        solved = self.solved()
        self.deny('lightmap', solved, '--only', 'rim', '-o', self.path('x.exr'), naming=['rim', 'key'])
        self.deny('lightmap', solved, '--smooth', '2', '-o', self.path('x.exr'), naming=['--smooth', '0.25'])
        self.deny('lightmap', solved, '-o', solved, naming=[solved])
        self.deny('lightmap', solved, '-o', self.path('x.gif'), naming=['x.gif'])
        self.assertFalse(os.path.exists(self.path('x.exr')))


@unittest.skipUnless(os.path.isdir(os.path.join(cli.SHARED, 'captures', 'random', 'random_9')), 'no ../shared here')
class RenderedTest(cli.CliTest):
    """Against renders: what a light gives over what an even dome gives is light without texture."""

    def test_the_map_is_nearer_to_the_light_than_the_picture_is(self):
        for name in ('random_1', 'random_2'):
            folder = os.path.join(cli.SHARED, 'captures', 'random', name)
            with open(os.path.join(folder, 'scene.json')) as file:
                lights = [light['name'] for light in json.load(file)['lights']]
            one_at_a_time = np.eye(len(lights))[..., None].repeat(3, 2).tolist()
            capture = cli.Capture(self.path(name), lights, one_at_a_time)
            capture.shots = [cli.read_rgb(os.path.join(folder, f'T_{light}.exr')) for light in lights]
            capture.save()
            self.succeed('solve', capture.path, '-o', self.path('solved.exr'), '--float', '-q', '--model', 'transport')
            self.succeed('lightmap', self.path('solved.exr'), '--smooth', '0', '-o', self.path('map.exr'), '--type', 'float',
                         '-q')
            maps = cli.read_image(self.path('map.exr'))
            dome = cli.read_rgb(os.path.join(folder, 'ambient.exr')).mean(2)
            errors = []
            for light, picture in zip(lights, capture.shots):
                picture = picture.mean(2)
                lit = (picture > .02 * np.percentile(picture, 98)) & (dome > .02 * np.percentile(dome, 98))
                truth = picture[lit] / dome[lit]
                errors.append([spread(found[lit] + 1e-6, truth) for found in (maps[light + '.G'], picture)])
            ours, untouched = np.mean(errors, 0)
            self.assertLess(ours, .85 * untouched, name)


if __name__ == '__main__':
    cli.main()

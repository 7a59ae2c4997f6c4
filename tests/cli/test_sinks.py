"""swaplight sinks: where each light's pool lies"""
import unittest

import numpy as np
import swaplight_cli as cli

HEIGHT, WIDTH = 108, 192


def lamp(x, y, z):
    """What a bare lamp gives to an upright wall; pixels, the distance in widths of the picture."""
    rows, columns = np.mgrid[:HEIGHT, :WIDTH]
    square = ((columns + .5 - x) ** 2 + (rows + .5 - y) ** 2) / WIDTH ** 2 + z ** 2
    return .05 * z / square ** 1.5


def tiles(seed):
    colors = np.random.default_rng(seed).uniform(.3, .85, (HEIGHT // 6 + 1, WIDTH // 6 + 1, 3))
    return colors.repeat(6, 0).repeat(6, 1)[:HEIGHT, :WIDTH]


class SinksTest(cli.CliTest):
    def solved(self):
        """One lamp in the picture, one to the right of it, and a light of two lamps."""
        capture = cli.Capture(self.path('set'), ('key', 'side', 'pair'))
        lights = [lamp(70, 40, .25), lamp(WIDTH + 40, 60, .25), lamp(40, 60, .08) + lamp(150, 50, .08)]
        capture.truth = [(tiles(1) * light[..., None]).astype(np.float32) for light in lights]
        capture.shots = [cli.photograph(capture.truth, c) for c in cli.rotated(3)]
        capture.save()
        self.succeed('solve', capture.path, '-o', self.path('solved.exr'), '--float', '-q')
        return self.path('solved.exr')

    def test_pools_are_where_the_lamps_are(self):
        solved = self.solved()
        said = self.succeed_json('sinks', solved)
        lights = said['lights']
        self.assertEqual({name: light['lamps'] for name, light in lights.items()}, {'key': 1, 'side': 1, 'pair': 2})
        key, side = lights['key']['sinks'][0], lights['side']['sinks'][0]
        self.assertLess(np.hypot(key['x'] - 70, key['y'] - 40), 8)
        self.assertNotIn('outside', key)
        self.assertGreater(key['sigmas'], 5)
        self.assertAlmostEqual(side['outside']['degrees'], 90, delta=25)
        self.assertGreater(side['x'], WIDTH - 6)
        self.assertEqual(sorted(abs(sink['x'] - x) < 12 for sink, x in zip(
            sorted(lights['pair']['sinks'], key=lambda sink: sink['x']), (40, 150))), [True, True])
        table = self.succeed('sinks', solved).stdout
        self.assertIn('goes on outside', table)
        self.assertEqual(len(table.splitlines()), 5)

    def test_what_is_no_set_is_one_line_and_exit_2(self):
        self.deny('sinks', self.path('none.exr'), naming=['none.exr'])


if __name__ == '__main__':
    cli.main()

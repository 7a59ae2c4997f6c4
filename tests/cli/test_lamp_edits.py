"""Lamps moved, turned and narrowed after the fact, on the command line"""
import json

import numpy as np
import swaplight_cli as cli


def wall(x0=-.1, y0=.1, z0=.7, cone=None, height=90, width=160):
    """What a lamp at (x0, y0), z0 before a checked wall gives, in widths of the picture; of a spot: the tangent of its cone."""
    x = (np.arange(width)[None] + .5) / width - .5
    y = (height / 2 - (np.arange(height)[:, None] + .5)) / width
    across = np.hypot(x - x0, y - y0)
    light = .64 * z0 / (across ** 2 + z0 ** 2) ** 1.5
    if cone:
        light = light * np.clip((1 - across / z0 / cone) / .1 + .5, 0, 1)
    rows, columns = np.mgrid[:height, :width]
    albedo = np.where((columns // 7 + rows // 7) % 2, .6, .3)
    return np.repeat((albedo * light)[..., None], 3, 2).astype(np.float32)


class LampEditsTest(cli.CliTest):
    def solved_set(self, key):
        self.capture = cli.Capture(self.path('set'))
        self.capture.truth = [key, wall(1.2, .3, 1.5)]
        self.capture.shots = [cli.photograph(self.capture.truth, c) for c in cli.SWAPPED]
        self.capture.save()
        self.succeed('solve', self.capture.path, '-o', self.path('solved.exr'), '--float', '-q')

    def frame(self, *edits):
        options = []
        if edits:
            with open(self.path('edits.json'), 'w') as file:
                json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': edits}, file)
            options = ['--edits', self.path('edits.json')]
        self.succeed('relight', self.path('solved.exr'), '--light', 'fill=off', *options, '-o', self.path('frame.exr'), '-q')
        return cli.read_rgb(self.path('frame.exr'))

    def test_a_lamp_moves_as_a_real_one_would(self):
        self.solved_set(wall())
        for numbers, truth in (({'right': .15}, wall(x0=.05)), ({'up': -.15}, wall(y0=-.05))):
            before = np.abs(self.frame() - truth).mean()
            after = np.abs(self.frame({'lights': ['key'], 'operation': 'move', **numbers}) - truth).mean()
            self.assertLess(after, .5 * before)

    def test_a_spot_narrows(self):
        self.solved_set(wall(0, 0, .8, cone=.3))
        truth = wall(0, 0, .8, cone=.2)
        before = np.abs(self.frame() - truth).mean()
        after = np.abs(self.frame({'lights': ['key'], 'operation': 'spread', 'width': 2 / 3}) - truth).mean()
        self.assertLess(after, .4 * before)

    def test_a_larger_lamp_lights_less_from_afar(self):
        self.solved_set(wall())
        small, large = (self.frame({'lights': ['key'], 'operation': 'size', 'times': times, 'diameter': .5}) for times in (.5, 3))
        before = self.frame()
        self.assertGreater(small.mean(), 1.01 * before.mean())
        self.assertLess(large.mean(), .9 * before.mean())

    def test_neutral_values_change_no_bit(self):
        self.solved_set(wall())
        before = self.frame()
        for operation in ('move', 'turn', 'spread', 'size'):
            np.testing.assert_array_equal(self.frame({'lights': ['key'], 'operation': operation}), before)

    def test_what_nobody_can_know_is_said(self):
        self.solved_set(wall(0, 0, .8, cone=.3))
        def said(**edit):
            self.frame({'lights': ['key'], **edit})
            result = self.succeed('relight', self.path('solved.exr'), '--edits', self.path('edits.json'), '-o',
                                  self.path('frame.exr'))
            return result.stdout + result.stderr
        self.assertNotIn('warning', said(operation='move', right=.01))
        far = said(operation='move', right=.3)
        self.assertRegex(far, r'edit "move": "key" is a guess on \d+ % of the picture')
        self.assertIn('its shadows stay', far)
        self.assertNotIn('its shadows stay', said(operation='turn', pan=20))
        self.assertIn('is a guess', said(operation='spread', width=1.5))
        self.assertNotIn('warning', said(operation='turn', pan=20, opacity=.1))

    def test_numbers_out_of_range_are_refused(self):
        self.solved_set(wall())
        for operation, key, value in (('move', 'distance', 0), ('turn', 'pan', 170), ('spread', 'width', -1), ('size', 'times', 0),
                                      ('size', 'times', 9), ('size', 'diameter', -1), ('size', 'diameter', 5)):
            with open(self.path('bad.json'), 'w') as file:
                json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [{'operation': operation, key: value}]}, file)
            self.deny('relight', self.path('solved.exr'), '--edits', self.path('bad.json'), '-o', self.path('x.exr'),
                      naming=['bad.json', key])


if __name__ == '__main__':
    cli.main()

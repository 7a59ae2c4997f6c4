"""Surfaces recoloured and unknown gels chosen by edits, on the command line."""
import json

import numpy as np
import swaplight_cli as cli


class RecolorTest(cli.CliTest):
    def frame(self, solved, *edits, lights=()):
        options = [part for light in lights for part in ('--light', light)]
        if edits:
            with open(self.path('edits.json'), 'w') as file:
                json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': edits}, file)
            options += ['--edits', self.path('edits.json')]
        self.succeed('relight', solved, *options, '-o', self.path('frame.exr'), '-q')
        return cli.read_rgb(self.path('frame.exr'))

    def painted(self, folder, colour):
        """A set whose right half is painted, solved."""
        capture = cli.Capture(self.path(folder), height=40, width=64)
        shade = capture.truth.mean(-1, keepdims=True)
        reflectance = np.full((40, 64, 3), .5)
        reflectance[:, 32:] = colour
        capture.truth = shade * reflectance
        capture.shots = [cli.photograph(capture.truth, c) for c in cli.SWAPPED]
        capture.save()
        self.succeed('solve', capture.path, '-o', self.path(folder + '.exr'), '--float', '-q')
        return self.path(folder + '.exr')

    def test_a_surface_is_as_if_it_had_been_painted_under_each_light(self):
        red, blue = self.painted('red', [.7, .12, .05]), self.painted('blue', [.08, .2, .6])
        edit = {'operation': 'recolor', 'kind': 'color', 'from': [.7, .12, .05], 'to': [.08, .2, .6],
                'mask': [{'shape': 'rectangle', 'x': 32, 'y': 0, 'width': 32, 'height': 40}]}
        for lights in ([], ['key=off'], ['fill=off', 'key=3200K']):
            np.testing.assert_allclose(self.frame(red, edit, lights=lights), self.frame(blue, lights=lights), atol=4e-3)

    def test_grey_stays_grey_and_hues_turn(self):
        red = self.painted('red', [.7, .12, .05])
        before = self.frame(red)
        turned = self.frame(red, {'operation': 'recolor', 'hue': 120})
        np.testing.assert_allclose(turned[:, :32], before[:, :32], rtol=2e-2, atol=1e-3)
        self.assertGreater(turned[20, 50, 1], turned[20, 50, 0], 'red turned by 120 degrees is green')
        lighter = self.frame(red, {'operation': 'recolor', 'lightness': 2})
        np.testing.assert_allclose(lighter, 2 * before, rtol=1e-3)  # frames are half float
        np.testing.assert_array_equal(self.frame(red, {'operation': 'recolor'}), before)

    def test_what_cannot_be_is_said(self):
        red = self.painted('red', [.7, .12, .05])
        for edit, naming in (({'operation': 'recolor', 'lights': ['key']}, 'acts on all of them'),
                             ({'operation': 'recolor', 'hue': 400}, 'hue'),
                             ({'operation': 'recolor', 'kind': 'paint'}, 'shift'),
                             ({'operation': 'unknown_gel'}, 'no gel of which its photographs leave')):
            with open(self.path('edits.json'), 'w') as file:
                json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [edit]}, file)
            self.deny('relight', red, '--edits', self.path('edits.json'), '-o', self.path('x.exr'), naming=naming)

    def test_an_unknown_gel_by_an_edit_is_as_if_it_had_been_solved_so(self):
        # Nowhere is one lamp alone: the solve's end of the range and the gel that was there differ.
        capture = cli.Capture(self.path('gel'), height=60, width=80)
        capture.truth = .7 * capture.truth + .3 * capture.truth[::-1]
        known, unknown = cli.SWAPPED[0]
        capture.shots = [cli.photograph(capture.truth, c) for c in cli.SWAPPED]
        capture.manifest['shots'][0]['light_colors'] = [known, '?a']
        capture.manifest['shots'][1]['light_colors'] = ['?a', known]
        capture.save()
        solve = ['solve', capture.path, '--float', '-q', '--model', 'lambert']
        self.succeed(*solve, '-o', self.path('nearest.exr'))
        for position in (.1, .3):
            self.succeed(*solve, '-o', self.path('there.exr'), '--open-color', position)
            for lights in ([], ['key=off']):
                edited = self.frame(self.path('nearest.exr'), {'operation': 'unknown_gel', 'position': position}, lights=lights)
                wanted = self.frame(self.path('there.exr'), lights=lights)
                self.assertLess(np.abs(edited - wanted).mean(), .01 * wanted.mean(), (position, lights))


if __name__ == '__main__':
    cli.main()

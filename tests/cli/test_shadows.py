"""swaplight shadows, swaplight beta, and edits on the command line"""
import json
import os
import unittest

import numpy as np
import swaplight_cli as cli


def floor(height=120, width=180):
    """A checked floor under two lights, the first hidden from a disc of it; visibility beside it."""
    y, x = np.mgrid[:height, :width]
    albedo = np.where((x // 20 + y // 20) % 2, .8, .2)
    visible = np.clip((np.hypot(x - 90, y - 60) - 25) / 6, 0, 1)
    key, fill = albedo * ((.6 + .2 * x / width) * visible + .02), albedo * .4
    return [np.repeat(t[..., None], 3, 2).astype(np.float32) for t in (key, fill)], visible


class ShadowsTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        self.capture.truth, self.visible = floor()
        self.capture.shots = [cli.photograph(self.capture.truth, c) for c in cli.SWAPPED]
        self.capture.save()
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '--float', '-q')

    def write(self, name, *edits):
        with open(self.path(name), 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': edits}, file)
        return self.path(name)

    def frame(self, *arguments):
        self.succeed('relight', self.solved, *arguments, '-o', self.path('frame.exr'), '-q')
        return cli.read_rgb(self.path('frame.exr'))

    def test_each_light_has_a_visibility_labels_and_an_outline(self):
        said = self.succeed_json('shadows', self.solved, '-o', self.path('shadows.exr'))
        found = cli.read_image(self.path('shadows.exr'))
        self.assertEqual(set(found), {f'shadow_{n}.{c}' for n in ('key', 'fill') for c in ('Y', 'label')})
        self.assertLess(np.abs(found['shadow_key.Y'] - self.visible).mean(), .04)
        label = found['shadow_key.label']
        self.assertEqual(label[60, 90], 1)
        self.assertEqual(label[5, 5], 3)
        self.assertAlmostEqual(said['lights']['key']['umbra'], (label == 1).mean(), places=4)
        self.assertEqual(cli.read_rgb(self.path('shadows.png')).shape, (120, 180, 3))

    def test_a_light_named_twice_counts_once(self):
        twice = ('--light', 'key', '--light', 'key', '-o', self.path('shadows.exr'))
        self.assertEqual(list(self.succeed_json('shadows', self.solved, *twice)['lights']), ['key'])
        self.assertEqual(set(cli.read_image(self.path('shadows.exr'))), {'shadow_key.Y', 'shadow_key.label'})

    def test_ambient_light_that_is_no_number_is_drawn_over(self):
        ambient = np.full(self.capture.shots[0].shape, .01, np.float32)
        ambient[5, 5] = np.nan
        cli.write_image(os.path.join(self.capture.folder, 'ambient.exr'), ambient)
        self.capture.manifest['ambient'] = 'ambient.exr'
        self.capture.save()
        self.succeed('shadows', self.capture.path, '-o', self.path('shadows.exr'))
        self.assertEqual(cli.read_rgb(self.path('shadows.png')).shape, (120, 180, 3))

    def test_a_light_and_a_threshold_can_be_chosen(self):
        said = self.succeed_json('shadows', self.solved, '--light', 'key', '--threshold', '0.2', '-o',
                                 self.path('shadows.exr'))
        self.assertEqual(list(said['lights']), ['key'])
        self.assertAlmostEqual(said['lights']['key']['threshold'], .2, places=4)
        self.deny('shadows', self.solved, '--light', 'rim', '-o', self.path('x.exr'), naming=['rim', 'key'])
        self.deny('shadows', self.solved, '--threshold', '7', '-o', self.path('x.exr'), naming=['--threshold'])

    def test_what_is_labelled_is_obeyed_for_the_surface_around_it(self):
        """The middle of the disc's shadow is called lit, and a lit place shadow; by option, and by a file of edits."""
        said = ['--label-lit', 'key=90,60', '--label-shadow', 'key=20,20']
        self.succeed('shadows', self.solved, *said, '-o', self.path('said.exr'), '-q')
        label = cli.read_image(self.path('said.exr'))['shadow_key.label']
        self.assertEqual((label[60, 90], label[20, 20]), (3, 1))
        self.assertGreater((label[55:66, 85:96] == 3).mean(), .95)
        self.assertEqual(label[60, 66], 1, 'not far through what is surely dark: that takes a second click')
        self.assertNotEqual(label[60, 72], 3)
        self.assertGreater((label[18:23, 18:23] != 3).mean(), .5)
        marks = {'shadow_marks': {'key': [{'is': 'lit', 'at': [90, 60]}, {'is': 'shadow', 'at': [20, 20]}]}}
        with open(self.path('marks.json'), 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [], **marks}, file)
        self.succeed('shadows', self.solved, '--edits', self.path('marks.json'), '-o', self.path('file.exr'), '-q')
        np.testing.assert_array_equal(cli.read_image(self.path('file.exr'))['shadow_key.Y'],
                                      cli.read_image(self.path('said.exr'))['shadow_key.Y'])
        # One light is chosen: labels are about it.
        self.succeed('shadows', self.solved, '--light', 'key', '--label-lit', '90,60', '-o', self.path('one.exr'), '-q')
        self.assertEqual(cli.read_image(self.path('one.exr'))['shadow_key.label'][60, 90], 3)

    def test_labels_hold_in_edits_of_shadows(self):
        remove = {'lights': ['key'], 'operation': 'shadow', 'kind': 'lighten'}
        with open(self.path('e.json'), 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [remove],
                       'shadow_marks': {'key': [{'is': 'lit', 'at': [90, 60]}]}}, file)
        before, after = self.frame('--light', 'fill=off'), self.frame('--light', 'fill=off', '--edits', self.path('e.json'))
        np.testing.assert_allclose(after[58:63, 88:93], before[58:63, 88:93], rtol=.02)  # nothing to remove here

    def test_what_is_wrong_with_labels_is_said_before_the_search(self):
        output = ['-o', self.path('x.exr')]
        self.deny('shadows', self.solved, '--label-lit', '90', *output, naming=['--label-lit 90', 'X,Y'])
        self.deny('shadows', self.solved, '--label-shadow', '90,60', *output, naming=['LIGHT=90,60', 'key', 'fill'])
        self.deny('shadows', self.solved, '--label-shadow', 'key=900,60', *output, naming=['key', '900, 60', '180 x 120'])
        self.deny('shadows', self.solved, '--label-lit', 'rim=9,6', *output, naming=['rim'])
        self.deny('shadows', self.solved, '--label-lit', 'key=9,6', '--label-shadow', 'key=9,6', *output, naming=['9,6'])

    def test_a_file_that_cannot_be_written_is_refused_before_the_search(self):
        """The source is no solved set: whoever reads it first would say so."""
        with open(self.path('broken.exr'), 'wb') as file:
            file.write(b'no picture')
        for output in ('x.png', 'x', 'x.abc'):
            self.deny('shadows', self.path('broken.exr'), '-o', self.path(output), naming=[output, 'OpenEXR', '.exr'])
        self.deny('shadows', self.path('broken.exr'), '-o', self.path('x.exr'), '--overlay', self.path('x.abc'),
                  naming=['x.abc', '.png'])

    def test_a_shadow_is_removed(self):
        edits = self.write('e.json', {'lights': ['key'], 'operation': 'shadow', 'kind': 'lighten'})
        before, after = self.frame('--light', 'fill=off'), self.frame('--light', 'fill=off', '--edits', edits)
        around = before[60, 130:140].max()
        self.assertLess(before[60, 85:95].max(), .1 * around)
        self.assertGreater(after[60, 85:95].max(), .7 * around)
        np.testing.assert_allclose(after[:10], before[:10], rtol=2e-3)

    def test_beta_maps_go_out_and_come_back(self):
        self.succeed('beta', self.solved, '-o', self.path('beta.exr'))
        maps = cli.read_image(self.path('beta.exr'))
        np.testing.assert_allclose(maps['beta.key'] + maps['beta.fill'], 1, atol=1e-4)
        back = self.write('back.json', {'lights': ['key'], 'operation': 'picture', 'file': 'beta.exr'})
        np.testing.assert_allclose(self.frame('--light', 'fill=off', '--edits', back),
                                   self.frame('--light', 'fill=off'), atol=2e-3)
        files = self.succeed_json('beta', self.solved, '-o', self.path('beta.png'))['files']
        self.assertEqual(len(files), 2)

    def test_beta_maps_replace_nothing_that_is_read(self):
        os.symlink(self.solved, self.path('beta.fill.png'))
        with open(self.solved, 'rb') as file:
            before = file.read()
        self.deny('beta', self.solved, '-o', self.path('beta.png'), naming=['beta.fill.png', 'is read here'])
        with open(self.solved, 'rb') as file:
            self.assertEqual(file.read(), before)
        self.assertFalse(os.path.exists(self.path('beta.key.png')), 'none is written before all are looked at')

    def test_light_that_is_shared_leaves_the_picture_as_it_was(self):
        edits = self.write('e.json', {'lights': ['key', 'fill'], 'operation': 'invert',
                                      'mask': [{'shape': 'ellipse', 'x': 60, 'y': 60, 'radius_x': 30, 'radius_y': 30}]})
        np.testing.assert_allclose(self.frame('--edits', edits), self.frame(), atol=1e-3)
        self.assertGreater(np.abs(self.frame('--edits', edits, '--light', 'key=off')
                                  - self.frame('--light', 'key=off')).max(), .1)

    def test_what_is_wrong_with_edits_is_said_in_one_line(self):
        output = ['-o', self.path('x.exr')]
        unknown = self.write('u.json', {'lights': ['rim'], 'operation': 'fill'})
        self.deny('relight', self.solved, '--edits', unknown, *output, naming=['u.json', 'rim', 'key'])
        self.deny('relight', self.solved, '--edits', self.capture.path, *output, naming=['capture.json', 'format'])
        self.deny('relight', self.solved, '--edits', self.path('none.json'), *output, naming=['none.json'])


SHARED = os.environ.get('SWAPLIGHT_SHARED', '')
GLOSS = os.path.join(SHARED, 'captures', 'gloss')


def grown(mask, pixels):
    for _ in range(pixels):
        padded = np.pad(mask, 1)
        mask = mask | padded[:-2, 1:-1] | padded[2:, 1:-1] | padded[1:-1, :-2] | padded[1:-1, 2:]
    return mask


@unittest.skipUnless(os.path.isdir(GLOSS), f'no ground truth: SWAPLIGHT_SHARED is "{SHARED}"')
class ShadowTruthTest(cli.CliTest):
    """A still life under two lights with hard shadows, and each light's contribution without shadows."""

    def setUp(self):
        super().setUp()
        self.truth = {n: cli.read_rgb(os.path.join(GLOSS, 'lambert', f'T_{n}.exr')) for n in ('left', 'right')}
        capture = cli.Capture(self.path('set'), names=('left', 'right'))
        capture.shots = [cli.photograph(list(self.truth.values()), c) for c in cli.SWAPPED]
        capture.save()
        self.solved = self.path('solved.exr')
        self.succeed('solve', capture.path, '-o', self.solved, '-q')

    def mean_difference(self, test, reference, where):
        """Mean CIEDE2000 over the pixels chosen, displayed as the whole picture is."""
        cli.write_image(self.path('test.exr'), np.where(where[..., None], test, reference).astype(np.float32))
        cli.write_image(self.path('reference.exr'), reference.astype(np.float32))
        said = self.succeed_json('evaluate', self.path('test.exr'), self.path('reference.exr'), '--metric', 'de2000')
        return said['de2000']['mean'] * where.size / where.sum()

    def test_umbra_and_visibility_are_near_the_truth(self):
        self.succeed('shadows', self.solved, '-o', self.path('shadows.exr'), '-q')
        found = cli.read_image(self.path('shadows.exr'))
        for light in self.truth:
            visible = cli.read_image(os.path.join(GLOSS, f'shadow_{light}.exr'))['Y']
            label = found[f'shadow_{light}.label']
            known, umbra = label > 0, visible < .02
            both, either = (label == 1) & umbra & known, ((label == 1) | umbra) & known
            self.assertGreater(both.sum() / either.sum(), .85, light)
            self.assertLess(np.abs(found[f'shadow_{light}.Y'] - visible)[known].mean(), .06, light)
            self.assertLess(1 - known.mean(), .1, light)
            self.assertLess(((label == 1) & (visible > .98)).mean(), .01, light)

    def test_a_removed_cast_shadow_shows_the_surface_below_it(self):
        for light, other in (('left', 'right'), ('right', 'left')):
            with open(self.path('edits.json'), 'w') as file:
                json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [
                    {'lights': [light], 'operation': 'shadow', 'kind': 'lighten'}]}, file)
            frame = self.path(f'{light}.exr')
            self.succeed('relight', self.solved, '--edits', self.path('edits.json'), '-o', frame, '-q')
            truth = cli.read_rgb(os.path.join(GLOSS, 'lambert', f'U_{light}.exr')) + self.truth[other]
            shadow = cli.read_image(os.path.join(GLOSS, f'shadow_{light}.exr'))
            umbra = (shadow['Y'] < .02) & (shadow['A'] > 0)
            band = grown(umbra, 6) & ~umbra & (shadow['A'] > 0)
            self.assertLess(self.mean_difference(cli.read_rgb(frame), truth, umbra), 4, light)
            self.assertLess(self.mean_difference(cli.read_rgb(frame), truth, band), 3, light)


if __name__ == '__main__':
    cli.main()

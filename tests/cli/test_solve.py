"""swaplight solve: what it writes (docs/formats.md), its options, its report."""
import glob
import json
import re

import numpy as np
import swaplight_cli as cli


class SolveTest(cli.CliTest):
    def solve(self, capture, *options):
        solved = self.path('solved.exr')
        self.succeed('solve', capture.path, '-o', solved, '-q', *options)
        return solved

    def test_finds_the_contributions_of_a_capture_without_noise(self):
        for names in (('key', 'fill'), ('key', 'fill', 'back'), ('a', 'b', 'c', 'd')):
            capture = cli.Capture(self.path(str(len(names))), names)
            solved = self.solve(capture, '--model', 'transport', '--float')
            for name, truth in zip(names, capture.truth):
                np.testing.assert_allclose(cli.read_rgb(solved, name), truth, atol=2e-5, err_msg=name)

    def test_a_file_that_cannot_be_written_is_refused_before_the_photographs_are_read(self):
        capture = cli.Capture(self.path('set'))
        shots = glob.glob(self.path('set/*.exr'))
        self.assertTrue(shots)
        for shot in shots:
            with open(shot, 'wb') as file:
                file.write(b'no picture')
        self.deny('solve', capture.path, '-o', self.path('x.png'), naming=['x.png', 'OpenEXR', 'x.exr'])

    def test_ambient_light_that_has_no_picture_is_found_from_one_more_shot(self):
        capture = cli.Capture(self.path('set'))
        self.deny('solve', capture.path, '-o', self.path('no.exr'), '--solve-ambient',
                  naming=['capture.json', 'more shots than lights'])
        three = [[[.9, .2, .15], [.15, .8, .25]], [[.15, .8, .25], [.9, .2, .15]], [[0, 0, 0], [0, 0, 0]]]
        capture = cli.Capture(self.path('three'), light_colors=three)
        room = .05 * np.ones_like(capture.truth[0])
        capture.shots = [shot + room for shot in capture.shots]
        capture.save()
        solved = self.solve(capture, '--solve-ambient', '--model', 'transport', '--float')
        np.testing.assert_allclose(cli.read_rgb(solved, 'ambient'), room, atol=1e-3)
        for name, truth in zip(('key', 'fill'), capture.truth):
            np.testing.assert_allclose(cli.read_rgb(solved, name), truth, atol=1e-3)
        # What is left out of the capture stays with the set that comes of it.
        out = 'shot_04.exr'
        capture.manifest['shots'].append({'image': out, 'light_colors': [[1, 1, 1], [1, 1, 1]]})
        capture.shots.append(np.zeros_like(room))
        capture.save()
        without = self.solve(capture, '--solve-ambient', '--model', 'transport', '--float', '--leave-out', out)
        np.testing.assert_array_equal(cli.read_rgb(without, 'key'), cli.read_rgb(solved, 'key'))
        self.assertIn(out, self.succeed('info', without).stdout)

    def test_a_tone_curve_is_looked_for_where_asked_to(self):
        capture = cli.Capture(self.path('set'))
        self.deny('solve', capture.path, '-o', self.path('no.exr'), '--tone', 'film', naming=['--tone', 'film', 'auto'])
        report = self.succeed_json('solve', capture.path, '-o', self.path('solved.exr'), '--tone', 'auto')
        self.assertNotIn('tone_correction', report, 'the photographs are as told')
        self.assertEqual(report['misfit_causes']['likely'], [])
        # What might have gone unseen is said, too, where there are pixels enough to see by.
        capture = cli.Capture(self.path('large'), height=96, width=128)
        report = self.succeed_json('solve', capture.path, '-o', self.path('solved.exr'))
        unseen = 'Might go unseen in these photographs: '
        self.assertIn('ambient', report['misfit_causes']['seen_from'])
        self.assertIn(unseen, self.succeed('solve', capture.path, '-o', self.path('solved.exr')).stdout)
        self.assertIn(unseen, self.succeed('info', self.path('solved.exr')).stdout)

    def test_a_tone_curve_that_was_not_told_is_named_and_taken_off(self):
        capture = cli.Capture(self.path('set'), height=96, width=128)
        for k, shot in enumerate(capture.shots):
            coded = shot ** (1 / 2.2)
            capture.shots[k] = (.5 * coded + .5 * (3 * coded ** 2 - 2 * coded ** 3)) ** 2.2
        capture.save()
        truth = np.stack(capture.truth)

        def solve(*options):
            report = self.succeed_json('solve', capture.path, '-o', self.path('solved.exr'), *options)
            ours = np.stack([cli.read_rgb(self.path('solved.exr'), name) for name in ('key', 'fill')])
            exposure = (ours * truth).sum() / (ours * ours).sum()  # a curve that nobody tells leaves it open
            return report, np.linalg.norm(exposure * ours - truth) / np.linalg.norm(truth)
        named, before = solve('--tone', 'declared')
        self.assertEqual(named['misfit_causes']['likely'], ['tone'])
        self.assertIn('--tone auto', named['verdict']['reasons'][0])
        corrected, after = solve('--tone', 'auto')
        self.assertGreater(corrected['tone_correction']['exponent'], 1.05, 'more contrast')
        self.assertLess(after, before / 3)
        unasked, alike = solve()
        self.assertIn('tone_correction', unasked, 'nothing else can be what is wrong')
        self.assertTrue(any('--tone declared' in warning for warning in unasked['warnings']))
        self.assertAlmostEqual(alike, after, places=6)

    def test_writes_every_channel_that_is_promised(self):
        capture = cli.Capture(self.path('set'))
        channels = cli.read_image(self.solve(capture))
        for name in ('key', 'fill'):
            self.assertIn(f'beta.{name}', channels)
            for c in 'RGB':
                self.assertIn(f'{name}.{c}', channels)
        for name in ('R', 'G', 'B', 'quality.residual', 'quality.sigma', 'quality.flags'):
            self.assertIn(name, channels)
        for name, pixels in channels.items():
            self.assertTrue(np.isfinite(pixels).all(), name)

    def test_lights_add_up_to_the_set_under_white_and_proportions_to_one(self):
        capture = cli.Capture(self.path('set'), ('key', 'fill', 'back'))
        for option in ((), ('--float',), ('--multipart',)):
            solved = self.solve(capture, *option)
            channels = cli.read_image(solved)
            beta = sum(channels['beta.' + n] for n in ('key', 'fill', 'back'))
            np.testing.assert_allclose(beta, 1, atol=1e-6)
            total = sum(cli.read_rgb(solved, n).astype(np.float64) for n in ('key', 'fill', 'back'))
            np.testing.assert_allclose(cli.read_rgb(solved), total, rtol=1e-6 if option == ('--float',) else 1e-3)

    def test_the_report_says_how_it_was_solved(self):
        capture = cli.Capture(self.path('set'))
        report = self.path('report.json')
        solved = self.path('solved.exr')
        result = self.succeed('solve', capture.path, '-o', solved, '--report', report)
        self.assertGreater(len(result.stdout.strip()), 40, 'a paragraph is expected')
        verdict, rest = result.stdout.strip().split('\n', 1)
        self.assertEqual(verdict, 'Lights told apart: good.')
        message, seconds = re.fullmatch(r'(.*) (\d+\.\d\d) s\.', rest, re.DOTALL).groups()
        self.assertLess(float(seconds), 60)
        with open(report) as file:
            self.assertEqual(json.load(file)['message'], message)
        printed = self.succeed_json('solve', capture.path, '-o', solved)
        self.assertEqual(printed['solved'], solved)
        self.assertEqual(self.succeed_json('info', solved)['report']['message'], message)

    def error_of(self, capture, *options):
        """Relative to the truth, but for what nobody can tell from wrong colours: a factor a channel, and mixing the
        lights alike in all channels."""
        solved = self.solve(capture, '--float', *options)
        found = np.stack([cli.read_rgb(solved, light['name']).reshape(-1, 3) for light in capture.manifest['lights']])
        truth = capture.truth.reshape(found.shape).astype(float)
        factors = np.ones(3)
        for _ in range(20):
            mixing = np.linalg.lstsq((truth * factors).reshape(len(truth), -1).T, found.reshape(len(found), -1).T,
                                     rcond=None)[0].T
            mixed = np.einsum('ij,jpc->ipc', mixing, truth)
            factors = (found * mixed).sum((0, 1)) / (mixed ** 2).sum((0, 1))
        return np.sqrt(((found - mixed * factors) ** 2).mean() / (truth ** 2).mean())

    def test_wrong_colors_are_not_called_good(self):
        """Gels of quite other colours: nothing of the frame looks wrong, until a light is changed."""
        capture = cli.Capture(self.path('set'), names=('key', 'fill', 'back'))
        solved = self.path('solved.exr')
        self.assertEqual(self.succeed_json('solve', capture.path, '-o', solved)['verdict'], {'word': 'good', 'reasons': []})
        verdict = self.succeed_json('solve', capture.path, '-o', solved, '--colors', '0.26/0.4/0.8,0.8/0.6/0.35,0.5/0.7/0.4')['verdict']
        self.assertNotEqual(verdict['word'], 'good')
        self.assertIn('check which light had which gel', ' '.join(verdict['reasons']))
        self.assertIn(verdict['reasons'][0], self.succeed('info', solved).stdout)

    def test_refined_colors_are_nearer_to_the_true_ones(self):
        capture = cli.Capture(self.path('set'), height=60, width=80)
        for k, shot in enumerate(capture.manifest['shots']):
            for i, color in enumerate(shot['light_colors']):
                color[:] = [value * (1 + .04 * np.sin(5 * k + 3 * i + c)) for c, value in enumerate(color)]
        capture.save()
        self.assertLess(self.error_of(capture, '--refine-colors'), .7 * self.error_of(capture))

    def test_a_color_that_is_unknown_is_estimated(self):
        capture = cli.Capture(self.path('set'), height=60, width=80)
        capture.manifest['shots'][1]['light_colors'][0] = None
        capture.save()
        self.assertLess(self.error_of(capture), .05)

    def test_a_gel_that_travels_is_one_unknown_colour(self):
        capture = cli.Capture(self.path('set'), height=60, width=80)
        gel = capture.manifest['shots'][0]['light_colors'][1]
        capture.save()
        known = '/'.join(map(str, capture.manifest['shots'][0]['light_colors'][0]))
        done = self.succeed('solve', capture.folder, '-o', self.path('solved.exr'), '--colors', f'{known},?', '--report',
                            self.path('report.json'))
        self.assertIn('two photographs leave one number of this colour open', done.stderr)
        self.assertIn('--one-lamp LIGHT=X,Y', done.stderr)
        with open(self.path('report.json')) as file:
            opened = json.load(file)['open_color']
        self.assertEqual(opened['name'], '?a (fill in shot 1, key in shot 2)')
        # On the line between both ends lies the truth: (l - m) / (l + m) in proportion to that of the ends.
        known = np.array(capture.manifest['shots'][0]['light_colors'][0])
        d = [(known - m) / (known + m) for m in map(np.array, (opened['nearest'], gel))]
        np.testing.assert_allclose(d[0] / np.linalg.norm(d[0]), d[1] / np.linalg.norm(d[1]), atol=.02)
        chosen = self.succeed('solve', capture.folder, '-o', self.path('solved.exr'), '--colors',
                              f'{"/".join(map(str, known))},?', '--open-color', '.5')
        self.assertNotIn('one number', chosen.stderr)
        self.deny('solve', capture.folder, '-o', self.path('solved.exr'), '--colors', '1/1/1',
                  naming=['1 colours for 2 lights'])
        self.deny('solve', capture.folder, '-o', self.path('solved.exr'), '--colors', f'{known[0]}/1/1,?', '--one-lamp',
                  '3,3', naming=['--one-lamp 3,3', 'LIGHT=X,Y'])

    def test_a_folder_stands_for_its_capture(self):
        capture = cli.Capture(self.path('set'))
        self.succeed('solve', capture.folder, '-o', self.path('solved.exr'))

    def test_pixels_that_are_not_numbers_are_flagged_and_the_others_solved(self):
        capture = cli.Capture(self.path('set'))
        for (y, x), value in (((2, 3), np.nan), ((4, 5), np.inf), ((6, 7), -5)):
            capture.shots[0][y, x] = value
        capture.save()
        solved = self.solve(capture, '--model', 'transport', '--float')
        channels = cli.read_image(solved)
        flags = channels['quality.flags'].astype(int)
        wrong = np.zeros(flags.shape, bool)
        for y, x in ((2, 3), (4, 5), (6, 7)):
            self.assertTrue(flags[y, x] & 8, (y, x))
            wrong[y, x] = True
        self.assertFalse((flags[~wrong] & 8).any())
        for name, truth in zip(('key', 'fill'), capture.truth):
            found = cli.read_rgb(solved, name)
            self.assertTrue(np.isfinite(found).all())
            np.testing.assert_allclose(found[~wrong], truth[~wrong], atol=2e-5)
        report = self.succeed_json('solve', capture.path, '-o', solved)
        self.assertIn('3', json.dumps({k: v for k, v in report.items() if 'finite' in k}))

    def test_a_picture_of_one_pixel_works(self):
        capture = cli.Capture(self.path('set'), height=1, width=1)
        solved = self.solve(capture, '--model', 'transport', '--float')
        np.testing.assert_allclose(cli.read_rgb(solved, 'key'), capture.truth[0], atol=2e-5)

    def test_wrong_options_are_one_line(self):
        capture = cli.Capture(self.path('set'))
        out = ('solve', capture.path, '-o', self.path('solved.exr'))
        self.deny(*out, '--model', 'magic', naming=['magic', 'lambert', 'transport'])
        self.deny(*out, '--solver', 'magic', naming='magic')
        self.deny(*out, '--denoise', 'magic', naming=['magic', 'off', 'guided'])
        self.deny(*out, '--align', 'magic', naming=['--align', 'magic', 'off', 'sure', 'on'])
        self.deny(*out, '--noise', 'read=much', naming=['--noise', 'read=much', 'full_well'])
        self.deny(*out, '--noise', 'grain=2', naming=['--noise', 'grain=2'])
        self.deny(*out, '--color-uncertainty', '2', naming='--color-uncertainty')

    def test_interrupted_it_leaves_nothing_behind(self):
        capture = cli.Capture(self.path('set'), ('a', 'b', 'c', 'd'), height=1080, width=1920)
        before = self.files()
        code, errors = self.interrupt('solve', capture.path, '-o', self.path('solved.exr'))
        self.assertEqual(code, 130, errors)
        self.assertEqual(errors, 'swaplight: stopped\n')
        self.assertEqual(self.files(), before)


if __name__ == '__main__':
    cli.main()

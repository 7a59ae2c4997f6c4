"""swaplight bench: what it measures, as tables and as JSON."""
import json
import os

import swaplight_cli as cli

SAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../samples/two_swapped/capture.json')


class BenchTest(cli.CliTest):
    def test_a_sample_is_solved_by_every_solver(self):
        rows = self.succeed_json('bench', '--no-speed', SAMPLE)['error']
        errors = {row['solver']: row for row in rows}
        for solver in ('brute-force', 'published', 'closed-form', 'maximum-likelihood', 'nnls', 'auto'):
            self.assertIn(solver, errors)
        self.assertLess(errors['auto']['rel_rmse'], errors['published']['rel_rmse'])
        self.assertGreater(errors['maximum-likelihood']['within_two_sigma'], .9)

    def test_the_hard_cases_are_a_table_and_json(self):
        suite = self.succeed_json('bench', '--hard-cases', '--quick', SAMPLE)
        cases = {case['name']: case for case in suite['cases']}
        self.assertIn('two_swapped', cases)
        for name in ('colours .01 apart', 'eight lights', '8-bit sRGB', 'clipped 10 %', 'bounced light', 'an object moved'):
            self.assertIn(name, cases)
        for case in cases.values():
            self.assertLessEqual({'lambert', 'transport', 'auto'}, set(case['models']))
            self.assertEqual(sum(model['not_finite'] for model in case['models'].values()), 0, case['name'])
        self.assertNotIn('published', cases['eight lights']['models'])
        self.assertEqual(suite, self.succeed_json('bench', '--hard-cases', '--quick', SAMPLE), 'the same every time')

    def test_speed_against_error_is_a_table_and_a_picture(self):
        picture = self.path('solvers.png')
        rows = self.succeed_json('bench', '--trade-off', '--quick', '-o', picture)['trade_off']
        self.assertEqual({row['lights'] for row in rows}, {2, 3, 4, 8})
        for row in rows:
            self.assertGreater(row['megapixels_per_second'], 0)
            self.assertGreater(row['limit_megapixels_per_second'], 0)
            self.assertGreater(row['de_mean'], 0)
        auto = {(row['lights'], row['glossy']): row for row in rows if row['solver'] == 'auto'}
        self.assertEqual(len(auto), 8)
        matte = {row['lights']: row for row in rows if row['solver'] == 'maximum-likelihood' and not row['glossy']}
        for lights in (2, 3, 4, 8):
            self.assertLess(auto[lights, False]['rel_rmse'], 1.05 * matte[lights]['rel_rmse'])
        self.assertEqual({row['lights'] for row in rows if row['solver'] == 'brute-force'}, {2})
        self.assertGreater(cli.read_rgb(picture).std(), .05)

    def test_a_capture_without_truth_is_refused(self):
        with open(SAMPLE) as file:
            manifest = json.load(file)
        del manifest['truth']
        path = self.path('capture.json')
        with open(path, 'w') as file:
            json.dump(manifest, file)
        self.deny('bench', '--no-speed', path, naming='truth')


if __name__ == '__main__':
    cli.main()

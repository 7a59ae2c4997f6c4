"""Camera looks before the frame: on the photographs that a set is solved from, and on one light's contribution."""
import os

import numpy as np

import cli

CLIPPED = 1  # of quality.flags


class LookPlaceTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        os.environ['XDG_DATA_HOME'] = self.path('data')
        self.capture = cli.Capture(self.path('set'), height=48, width=64)

    def solve(self, *arguments, out='solved.exr', code=0):
        result = cli.run('solve', self.capture.path, '-o', self.path(out), '--model', 'transport', '--float', *arguments)
        self.assertEqual(result.returncode, code, result.stderr)
        return cli.read_image(self.path(out)), result.stderr

    def light(self, image, name):
        return np.stack([image[f'{name}.{c}'] for c in 'RGB'], -1)


class Shots(LookPlaceTest):
    def test_a_filter_that_is_linear_in_light_goes_through_the_solve(self):
        """Exposure doubles every light; a blur of the photographs is the blur of every light."""
        plain, _ = self.solve(out='plain.exr')
        doubled, words = self.solve('--shot-filter', 'exposure,stops=1', out='doubled.exr')
        self.assertIn('lights add up in light alone', words)
        for name in ('key', 'fill'):
            np.testing.assert_allclose(self.light(doubled, name), 2 * self.light(plain, name), rtol=1e-3, atol=1e-5)
        blurred, _ = self.solve('--shot-filter', 'gaussian-blur,sigma=60', out='blurred.exr')
        for name in ('key', 'fill'):
            self.succeed('look', 'light', self.path('plain.exr'), '--light', name, '--filter', 'gaussian-blur,sigma=60',
                         '-o', self.path('one.exr'))
            np.testing.assert_allclose(self.light(blurred, name), self.light(cli.read_image(self.path('one.exr')), name),
                                       rtol=4e-3, atol=1e-4)

    def test_what_was_saturated_stays_so_with_what_the_look_makes_of_it(self):
        for shot in self.capture.shots:
            shot[20:24, 30:34] = 1
        for k, shot in enumerate(self.capture.manifest['shots']):
            shot['image'] = f'shot_{k}.png'
            cli.write_image(os.path.join(self.capture.folder, shot['image']), self.capture.shots[k].clip(0, 1), 'uint16')
        self.capture.shots = []
        self.capture.save()
        marked = []
        for filter in ('exposure,stops=-3', 'gaussian-blur,sigma=60'):
            image, _ = self.solve('--shot-filter', filter)
            flags = image['quality.flags'].astype(int) & CLIPPED
            self.assertTrue(flags[20:24, 30:34].all(), filter)
            marked.append(flags.sum())
        self.assertEqual(marked[0], 16)
        self.assertGreater(marked[1], 30, 'a blur spreads what is not known')
        self.assertLess(marked[1], 400)

    def test_only_filters_that_say_so_come_before_the_frame(self):
        self.deny('solve', self.capture.path, '-o', self.path('o.exr'), '--shot-filter', 'burn-in',
                  naming=['burn-in', 'not for a shot', 'WHERE'])
        self.deny('solve', self.capture.path, '-o', self.path('o.exr'), '--shot-filter', 'exposrue', naming='did you mean')
        self.deny('solve', self.capture.path, '-o', self.path('o.exr'), '--shot-look', 'nothing', naming='no camera look')

    def test_the_seeds_order_abstraction_before_the_solve(self):
        """Solves, and says what it costs: the figure stands in docs/looks.md."""
        self.solve('--shot-filter', 'abstraction', out='before.exr')
        self.solve(out='plain.exr')
        self.succeed('relight', self.path('before.exr'), '-o', self.path('before.png'))
        self.succeed('relight', self.path('plain.exr'), '--filter', 'abstraction', '-o', self.path('after.png'))
        difference = np.abs(cli.read_rgb(self.path('before.png')) - cli.read_rgb(self.path('after.png')))
        print('abstraction before against after the solve, mean of codes:', 255 * difference.mean())
        self.assertGreater(difference.mean(), 0)


class OneLight(LookPlaceTest):
    def test_only_this_light_changes_and_the_set_stays_a_set(self):
        plain, _ = self.solve()
        self.succeed('look', 'light', self.path('solved.exr'), '--light', 'key', '--filter', 'saturation,saturation=0',
                     '--filter', 'exposure,stops=1', '-o', self.path('grey.exr'))
        grey = cli.read_image(self.path('grey.exr'))
        np.testing.assert_allclose(self.light(grey, 'fill'), self.light(plain, 'fill'), rtol=1e-3)
        key = self.light(grey, 'key')
        self.assertLess(np.ptp(key, axis=-1).max(), 1e-3 * key.max())
        luminance = [.2126, .7152, .0722]
        np.testing.assert_allclose(key @ luminance, 2 * self.light(plain, 'key') @ luminance, rtol=2e-3)
        np.testing.assert_allclose(grey['beta.key'] + grey['beta.fill'], 1, atol=2e-3)
        self.succeed('relight', self.path('grey.exr'), '--light', 'key=#ff0000', '-o', self.path('o.png'))

    def test_what_is_asked_for(self):
        self.solve()
        solved, out = self.path('solved.exr'), self.path('o.exr')
        self.deny('look', 'light', solved, '--filter', 'exposure', '-o', out, naming='--light NAME')
        self.deny('look', 'light', solved, '--light', 'key', '-o', out, naming='--filter NAME')
        self.deny('look', 'light', solved, '--light', 'sun', '--filter', 'exposure', '-o', out, naming=['sun', 'key, fill'])
        self.deny('look', 'light', solved, '--light', 'key', '--filter', 'grid', '-o', out, naming='not for a light')
        self.deny('look', 'light', solved, '--light', 'key', '--filter', 'exposure', '-o', solved, naming='solved.exr')


if __name__ == '__main__':
    cli.main()

"""swaplight evaluate"""
import numpy as np
import swaplight_cli as cli


class EvaluateTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.reference = self.path('reference.exr')
        self.pixels = cli.contributions(1)[0]
        cli.write_image(self.reference, self.pixels)

    def test_a_picture_does_not_differ_from_itself(self):
        result = self.succeed_json('evaluate', self.reference, self.reference)
        self.assertEqual(result['de2000']['max'], 0)
        self.assertEqual(result['rmse']['value'], 0)

    def test_the_statistics_are_those_of_the_pixels(self):
        test = self.path('test.exr')
        random = np.random.default_rng(2)
        changed = self.pixels + random.normal(0, .01, self.pixels.shape).astype(np.float32)
        cli.write_image(test, changed)
        result = self.succeed_json('evaluate', test, self.reference, '--metric', 'absdiff,rmse', '--scale', '1')
        difference = np.abs(changed - self.pixels).mean(-1)
        for name, expected in (('mean', difference.mean()), ('median', np.median(difference)),
                               ('p95', np.percentile(difference, 95)), ('max', difference.max()),
                               ('std', difference.std())):
            self.assertAlmostEqual(result['absdiff'][name], expected, delta=1e-5, msg=name)
        self.assertAlmostEqual(result['rmse']['value'], np.sqrt(((changed - self.pixels) ** 2).mean()), delta=1e-6)
        self.assertNotIn('de2000', result)

    def test_the_plot_and_the_map_are_pictures(self):
        plot, difference_map = self.path('box.png'), self.path('map.png')
        self.succeed('evaluate', self.reference, self.reference, '--plot', plot, '--map', difference_map)
        for path in (plot, difference_map):
            self.assertGreater(cli.read_image(path)['R'].shape[1], 10)

    def test_bad_input_is_one_line(self):
        small = self.path('small.exr')
        cli.write_image(small, self.pixels[:5])
        self.fail('evaluate', self.path('nothing.exr'), self.reference, naming='nothing.exr')
        self.fail('evaluate', small, self.reference, naming=['small.exr', '5', '12'])
        self.fail('evaluate', self.reference, self.reference, '--metric', 'ssim', naming=['ssim', 'de2000'])
        self.fail('evaluate', self.reference, self.reference, '--json', '--plot', self.path('no/such/box.png'),
                  naming='box.png')


if __name__ == '__main__':
    cli.main()

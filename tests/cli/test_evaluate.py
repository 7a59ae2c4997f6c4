"""swaplight evaluate"""
import json
import os

import numpy as np
import OpenImageIO as oiio
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

    def test_the_same_light_in_other_primaries_does_not_differ(self):
        capture = cli.Capture(self.path('set'))
        self.succeed('solve', capture.path, '-o', self.path('solved.exr'), '-q')
        frames = []
        for space in ('lin_rec709', 'acescg', 'lin_rec2020'):
            frames.append(self.path(f'{space}.exr'))
            self.succeed('relight', self.path('solved.exr'), '--color-space', space, '--type', 'float', '-o', frames[-1],
                         '-q')
        self.assertLess(self.succeed_json('evaluate', frames[1], frames[0])['de2000']['max'], .01)

    def test_what_lies_outside_of_the_data_windows_does_not_count(self):
        files = []
        for name, light in (('half.exr', .5), ('one.exr', 1)):
            files.append(self.path(name))
            cli.write_image(files[-1], np.full((20, 20, 3), light), window=(30, 40, 100, 100))
        result = self.succeed_json('evaluate', *files, '--metric', 'absdiff', '--scale', '1', '--threshold', '.1')
        self.assertEqual([result['absdiff'][name] for name in ('mean', 'median', 'max')], [.5, .5, .5])

    def test_primaries_that_are_not_known_are_told_of(self):
        wide = (.684, .313, .221, .848, .0861, -.102, .3127, .329)
        spec = oiio.ImageSpec(8, 8, 3, 'float')
        spec.attribute('chromaticities', 'float[8]', wide)
        output = oiio.ImageOutput.create(self.path('wide.exr'))
        assert output.open(self.path('wide.exr'), spec) and output.write_image(np.full((8, 8, 3), .5, np.float32))
        output.close()
        result = self.succeed_json('evaluate', self.path('wide.exr'), self.path('wide.exr'))
        self.assertIn('0.684', result['warnings'][0])

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

    def test_weights_and_a_threshold_are_those_of_the_dissertation(self):
        brighter = self.path('brighter.exr')
        cli.write_image(brighter, 1.3 * self.pixels)
        plain = self.succeed_json('evaluate', brighter, self.reference, '--threshold', '5')['de2000']
        weighted = self.succeed_json('evaluate', brighter, self.reference, '--threshold', '5',
                                     '--weights', '5,1,1')['de2000']
        self.assertLess(weighted['mean'], .6 * plain['mean'])
        self.assertGreater(plain['share_above'], weighted['share_above'])
        self.assertIn('above', self.succeed('evaluate', brighter, self.reference, '--threshold', '5').stdout)
        self.assertNotIn('share_above', self.succeed_json('evaluate', brighter, self.reference)['de2000'])

    def test_beta_maps_are_compared_light_by_light_and_in_regions(self):
        solved, beta, edited = self.path('solved.exr'), self.path('beta.exr'), self.path('edited.exr')
        capture = cli.Capture(self.path('set'))
        self.succeed('solve', capture.path, '-o', solved)
        self.succeed('beta', solved, '-o', beta)
        edits = self.path('edits.json')
        with open(edits, 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [
                {'lights': ['key'], 'operation': 'fill', 'value': .95, 'meaning': 'share',
                 'mask': [{'shape': 'rectangle', 'x': 0, 'y': 0, 'width': 4, 'height': 4}]}]}, file)
        self.succeed('beta', solved, '--edits', edits, '-o', edited)
        plot = self.path('box.png')
        result = self.succeed_json('evaluate', edited, beta, '--region', 'edited=0,0,4,4', '--region', '6,4,6,4',
                                   '--threshold', '.01', '--plot', plot)
        self.assertEqual(result['encoding'], 'numbers')
        self.assertEqual(sorted(result['channels']), sorted(result['compared']))
        self.assertGreater(result['regions']['edited']['absdiff']['mean'], .01)
        self.assertLess(result['regions']['6,4,6,4']['absdiff']['max'], 1e-3)
        self.assertEqual(result['regions']['6,4,6,4']['absdiff']['share_above'], 0)
        self.assertGreater(cli.read_rgb(plot).std(), .05)
        one = self.succeed_json('evaluate', edited, beta, '--channels', 'beta.key')
        self.assertEqual(one['absdiff'], {key: value for key, value in
                                          result['channels']['beta.key']['absdiff'].items()
                                          if key != 'share_above'})

    def folders(self):
        random = np.random.default_rng(3)
        for name, noise in (('a', .002), ('b', .01), ('more/c', .03)):
            cli.write_image(self.path('reference', name + '.exr'), self.pixels)
            cli.write_image(self.path('test', name + '.exr'),
                            self.pixels + random.normal(0, noise, self.pixels.shape).astype(np.float32))
        cli.write_image(self.path('test', 'alone.exr'), self.pixels)
        return self.path('test'), self.path('reference')

    def test_folders_are_compared_picture_by_picture(self):
        test, reference = self.folders()
        plot, histogram = self.path('box.png'), self.path('histogram.png')
        result = self.succeed_json('evaluate', test, reference, '--plot', plot, '--histogram', histogram)
        self.assertEqual([picture['name'] for picture in result['pictures']], ['a', 'b', 'more/c'])
        self.assertEqual(result['unmatched'], [self.path('test', 'alone.exr')])
        alone = self.succeed_json('evaluate', self.path('test', 'b.exr'), self.path('reference', 'b.exr'))
        self.assertEqual(result['pictures'][1]['de2000'], alone['de2000'])
        means = [picture['de2000']['mean'] for picture in result['pictures']]
        self.assertEqual(means, sorted(means))
        self.assertAlmostEqual(result['mean']['de2000']['mean'], np.mean(means), places=9)
        self.assertAlmostEqual(sum(result['pictures'][0]['luminance']['test']['share']), 1, places=3)
        for path in (plot, histogram):
            self.assertGreater(cli.read_rgb(path).std(), .05)
        text = self.succeed('evaluate', test, reference).stdout
        for word in ('3 pictures', 'more/c', 'alone.exr', 'de2000', 'mean'):
            self.assertIn(word, text)

    def test_colours_and_maps_are_not_compared_in_one_table(self):
        for folder in ('test', 'reference'):
            cli.write_image(self.path(folder, 'a.exr'), self.pixels)
            cli.write_image(self.path(folder, 'b.exr'), self.pixels[..., :1], channels=['beta.key'])
        self.deny('evaluate', self.path('test'), self.path('reference'), naming=['a.exr', 'b.exr', '--channels'])
        os.remove(self.path('test', 'a.exr'))
        self.deny('evaluate', self.path('test'), self.path('reference'), '--histogram', self.path('h.png'),
                  naming=['b.exr', 'luminance'])
        self.deny('evaluate', self.path('test', 'b.exr'), self.path('reference', 'a.exr'), naming=['beta.key', 'R, G, B'])

    def test_a_region_without_a_finite_pixel_is_named(self):
        broken = self.path('broken.exr')
        pixels = self.pixels.copy()
        pixels[:4, :4] = np.nan
        cli.write_image(broken, pixels)
        self.deny('evaluate', broken, self.reference, '--region', 'corner=0,0,4,4', naming=['broken.exr', 'corner', 'finite'])

    def test_two_pictures_of_one_name_are_not_chosen_from_by_chance(self):
        for folder in ('ours', 'theirs'):
            os.makedirs(self.path(folder))
            cli.write_image(self.path(folder, 'frame.exr'), np.full((20, 20, 3), .5, np.float32))
        cli.write_image(self.path('ours', 'frame.png'), np.full((20, 20, 3), .7, np.float32), 'uint8')
        self.deny('evaluate', self.path('ours'), self.path('theirs'), naming=['frame.', 'the same name'])

    def test_folders_that_cannot_be_compared_are_said(self):
        test, reference = self.folders()
        self.deny('evaluate', test, self.path('reference', 'a.exr'), naming='two folders')
        self.deny('evaluate', self.path('test', 'more'), reference, naming='same name')
        self.deny('evaluate', test, reference, '--map', self.path('map.png'), naming='one pair')
        self.deny('evaluate', test, reference, '--plot', self.path('no/box.png'), naming='no/box.png')

    def test_bad_input_is_one_line(self):
        small = self.path('small.exr')
        cli.write_image(small, self.pixels[:5])
        self.deny('evaluate', self.path('nothing.exr'), self.reference, naming='nothing.exr')
        self.deny('evaluate', small, self.reference, naming=['small.exr', '5', '12'])
        self.deny('evaluate', self.reference, self.reference, '--metric', 'ssim', naming=['ssim', 'de2000'])
        self.deny('evaluate', self.reference, self.reference, '--weights', '5,1', naming='--weights')
        self.deny('evaluate', self.reference, self.reference, '--channels', 'Z', naming=['reference.exr', 'Z', 'R'])
        self.deny('evaluate', self.reference, self.reference, '--region', '0,0,4', naming=['--region', 'WIDTH'])
        self.deny('evaluate', self.reference, self.reference, '--region', 'a=0,0,4,4', '--region', 'a=1,0,4,4',
                  naming=['--region a', 'two'])
        self.deny('evaluate', self.reference, self.reference, '--region', '9,0,400,4', naming=['400', 'inside'])
        self.deny('evaluate', self.reference, self.reference, '--json', '--plot', self.path('no/such/box.png'),
                  naming='box.png')


if __name__ == '__main__':
    cli.main()

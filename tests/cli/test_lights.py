"""swaplight lights: what the lamps of a solved set are doing in another photograph of it"""
import json
import os
import unittest

import numpy as np
import swaplight_cli as cli

LAMPS = np.array([[.8, .5, .2], [.1, .3, .7]])


class LightsTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'), height=96, width=128)
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '--float', '-q')

    def photo(self, lamps=LAMPS, name='photo.exr', change=lambda pixels: pixels, **options):
        cli.write_image(self.path(name), change(cli.photograph(self.capture.truth, lamps)), **options)
        return self.path(name)

    def read(self, *arguments, source=None):
        return self.succeed_json('lights', source or self.solved, *arguments)

    def colors(self, said):
        return np.array([said['lights'][name]['color'] for name in ('key', 'fill')])

    def test_every_lamp_is_read_with_its_error(self):
        said = self.read(self.photo())
        np.testing.assert_allclose(self.colors(said), LAMPS, atol=2e-3)
        for name in ('key', 'fill'):
            lamp = said['lights'][name]
            self.assertTrue(lamp['on'] and lamp['known'])
            self.assertLess(max(lamp['standard_error']), .01)
            self.assertAlmostEqual(lamp['stops'], np.log2(lamp['luminance']), 5)
        self.assertEqual(said['warnings'], [])

    def test_a_set_that_was_scaled_reads_photographs_of_both_sizes(self):
        self.capture.manifest['scale'] = .5
        self.capture.save()
        half = self.path('half.exr')
        self.succeed('solve', self.capture.path, '-o', half, '--float', '-q')
        self.succeed('relight', half, '--light', 'fill=rgb:0/1/0.5', '-o', self.path('relit.exr'), '--type', 'float')
        said = self.colors(self.read(self.path('relit.exr'), source=half))
        np.testing.assert_allclose(said, [[1, 1, 1], [0, 1, .5]], atol=.01)
        np.testing.assert_allclose(self.colors(self.read(self.photo(), source=half)), LAMPS, atol=.01)
        cli.write_image(self.path('small.exr'), np.ones((10, 10, 3), np.float32))
        self.deny('lights', half, self.path('small.exr'), naming=('10 x 10', '64 x 48'))

    def test_a_set_that_was_cropped_reads_its_own_frame(self):
        self.capture.manifest['crop'] = [30, 20, 64, 48]
        self.capture.save()
        crop = self.path('crop.exr')
        self.succeed('solve', self.capture.path, '-o', crop, '--float', '-q')
        self.succeed('relight', crop, '--light', 'fill=rgb:0/1/0.5', '-o', self.path('relit.exr'), '--type', 'float')
        said = self.colors(self.read(self.path('relit.exr'), source=crop))
        np.testing.assert_allclose(said, [[1, 1, 1], [0, 1, .5]], atol=.01)
        np.testing.assert_allclose(self.colors(self.read(self.photo(), source=crop)), LAMPS, atol=.01)

    def test_the_rig_gives_the_photograph_again(self):
        photo = self.photo()
        said = self.read(photo, '--rig', self.path('rig.json'))
        with open(self.path('rig.json')) as file:
            self.assertEqual(json.load(file), said['rig'])
        self.succeed('relight', self.solved, '--rig', self.path('rig.json'), '-o', self.path('frame.exr'), '--type',
                     'float', '-q')
        np.testing.assert_allclose(cli.read_rgb(self.path('frame.exr')), cli.read_rgb(photo), atol=2e-3)

    def test_a_setting_is_what_relight_takes(self):
        said = self.read(self.photo())
        settings = [f'{name}={lamp["setting"]}' for name, lamp in said['lights'].items()]
        self.succeed('relight', self.solved, '--light', settings[0], '--light', settings[1], '-o',
                     self.path('frame.exr'), '-q')
        np.testing.assert_allclose(cli.read_rgb(self.path('frame.exr')), cli.read_rgb(self.path('photo.exr')), atol=3e-3)

    def test_a_lamp_that_is_off(self):
        said = self.read(self.photo([[.8, .5, .2], [0, 0, 0]]))
        self.assertFalse(said['lights']['fill']['on'])
        self.assertEqual(said['lights']['fill']['setting'], 'off')
        self.assertIsNone(said['lights']['fill']['stops'])
        words = self.succeed('lights', self.solved, self.path('photo.exr')).stdout
        self.assertRegex(words, r'fill .* off')
        self.assertIn('key', words)

    def test_a_coded_photograph_of_a_linear_set(self):
        def encode(pixels):
            pixels = np.clip(pixels, 0, 1)
            return np.where(pixels <= .0031308, 12.92 * pixels, 1.055 * pixels ** (1 / 2.4) - .055)
        said = self.read(self.photo(name='photo.png', change=encode, pixel_type='uint16'))
        np.testing.assert_allclose(self.colors(said), LAMPS, atol=3e-3)

    def test_exposure_and_noise_are_told(self):
        photo = self.photo(2 * LAMPS)
        said = self.read(photo, '--exposure', '1', '--noise', 'read=.001,full_well=10000')
        np.testing.assert_allclose(self.colors(said), LAMPS, atol=3e-3)
        self.assertEqual(said['noise'], {'read': .001, 'full_well': 10000})

    def test_a_nudged_tripod_is_said_and_mended(self):
        random = np.random.default_rng(3)
        capture = cli.Capture(self.path('textured'), height=160, width=200)
        texture = np.kron(random.uniform(.3, 1, (20, 25)), np.ones((8, 8)))[..., None]
        capture.truth = capture.truth * texture
        capture.shots = [cli.photograph(capture.truth, c) for c in cli.SWAPPED]
        capture.save()
        self.succeed('solve', capture.path, '-o', self.solved, '--float', '-q')
        pixels = np.roll(cli.photograph(capture.truth, LAMPS), (2, 3), (0, 1))
        cli.write_image(self.path('moved.exr'), pixels)
        moved = self.read(self.path('moved.exr'))
        self.assertTrue(any('--align' in w for w in moved['warnings']), moved['warnings'])
        np.testing.assert_allclose(moved['shift'], [3, 2], atol=.2)
        aligned = self.read(self.path('moved.exr'), '--align')
        self.assertEqual(aligned['warnings'], [])
        np.testing.assert_allclose(self.colors(aligned), LAMPS, atol=5e-3)

    def test_the_capture_itself_is_solved_first(self):
        np.testing.assert_allclose(self.colors(self.read(self.photo(), source=self.capture.path)), LAMPS, atol=5e-3)

    def test_bad_input_is_refused_in_one_line(self):
        photo = self.photo()
        self.deny('lights', self.solved, self.path('none.exr'), naming='none.exr')
        self.deny('lights', self.path('none.exr'), photo, naming='none.exr')
        self.photo(name='small.exr', change=lambda pixels: pixels[:40])
        self.deny('lights', self.solved, self.path('small.exr'), naming=['small.exr', '128 x 40', '128 x 96'])
        self.photo(name='white.png', change=lambda pixels: pixels * 0 + 1, pixel_type='uint8')
        self.deny('lights', self.solved, self.path('white.png'), naming=['white.png', 'clipped'])
        self.deny('lights', self.solved, photo, '--color-space', 'mars', naming=['mars', 'lin_rec709'])
        self.deny('lights', self.solved, photo, '--noise', 'much', naming='--noise')
        self.deny('lights', self.solved, photo, '--ambient', '.5', naming='--ambient')
        self.deny('lights', self.solved, photo, '--exposure', 'nan', naming='--exposure')
        self.deny('lights', self.solved, photo, '--rig', photo, naming='photo.exr')
        self.deny('lights', self.solved, photo, '--rig', self.path('no', 'rig.json'), naming='rig.json')

    def test_a_photograph_of_something_else_is_said(self):
        other = cli.photograph(cli.contributions(2, height=96, width=128, seed=9), LAMPS)
        said = self.read(self.photo(change=lambda pixels: other))
        self.assertTrue(any('does not look like this set' in w for w in said['warnings']), said['warnings'])


@unittest.skipUnless(os.path.isdir(os.path.join(cli.SHARED, 'captures')), 'needs $SWAPLIGHT_SHARED/captures')
class RealSwapsTest(cli.CliTest):
    """Gels that were really swapped: the four photographs that the solve has not seen."""

    def test_lamps_are_read_within_a_few_per_cent(self):
        for scene in ('lion', 'diff'):
            folder = os.path.join(cli.SHARED, 'captures', 'swapped_' + scene)
            capture = os.path.join(folder, 'capture_r_b.json')
            self.succeed('solve', capture, '-o', self.path('solved.exr'), '-q')
            with open(capture) as file:
                tests = json.load(file)['relight_tests']
            for test in tests:
                said = self.succeed_json('lights', self.path('solved.exr'), os.path.join(folder, test['image']))
                found = np.array([said['lights'][name]['color'] for name in ('left', 'right')])
                # The colours of the manifest were fitted over all photographs, to a few per cent themselves.
                np.testing.assert_allclose(found, test['light_colors'], rtol=.08, err_msg=test['image'])


if __name__ == '__main__':
    cli.main()

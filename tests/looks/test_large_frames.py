"""Frames larger than a part: the same bytes as in one go, in little memory."""
import os

import numpy as np
import OpenImageIO as oiio

import cli

SET = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../samples/three_point/capture.json')
# Ten filters: wide halos, alpha that one makes and another sees, passes over the whole frame, light and codes.
TEN = ['exposure,stops=0.5', 'halation,radius=20', 'bloom,radius=6', 'local-contrast,radius=8', 'film-grain',
       'chromatic-aberration', 'vignette', 'review,contrast=1.3,sharpness=1.5', 'gaussian-blur,sigma=6', 'auto-levels']


class LargeFrameTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        os.environ['XDG_DATA_HOME'] = self.path('data')
        self.frame = self.path('frame.exr')
        random = np.random.default_rng(3)
        pixels = random.uniform(0, 1, (150, 230, 3)) ** 3 * 2
        pixels[40:60, 100:130] = 40
        cli.write_image(self.frame, pixels)

    def apply(self, output, stages, *options):
        filters = [part for stage in stages for part in ('--filter', stage)]
        self.succeed('look', 'apply', self.frame, *filters, '-o', self.path(output), *options)
        return self.path(output)

    def assert_parts_are_the_whole(self, stages, *options, sides=(97,)):
        whole = self.apply('whole.exr', stages, *options)
        for side in sides:
            parts = self.apply('parts.exr', stages, '--tile', side, *options)
            self.assertEqual(cli.sha256(parts), cli.sha256(whole), f'{stages}, --tile {side}')


class SameBytes(LargeFrameTest):
    """Each filter by itself, with each parameter at both ends: swaplight look lint, see test_camera_looks.py."""

    def test_of_ten_filters(self):
        self.assert_parts_are_the_whole(TEN, '--type', 'float', sides=(50, 97))

    def test_of_a_matte_that_later_filters_see(self):
        cli.write_image(self.path('element.exr'), np.random.default_rng(4).uniform(0, 1, (40, 60, 4)))
        stages = ['luma-key,show=0', 'gaussian-blur,sigma=5', 'pencil',
                  f'composite,element={self.path("element.exr")}', 'gaussian-blur,sigma=9']
        self.assert_parts_are_the_whole(stages, '--type', 'float', '--alpha')

    def test_of_targets_that_are_smaller_than_the_frame(self):
        cli.write_image(self.frame, np.random.default_rng(6).uniform(0, 1, (48, 1990, 3)))
        self.assert_parts_are_the_whole(['bloom,radius=2'], '--type', 'float')

    def test_of_targets_much_smaller_than_a_wide_frame(self):
        """Highlights, so that what is missing at the end of a wide glow is more than a rounding."""
        highlights = np.random.default_rng(6).uniform(0, 1, (16, 16384, 1)) < .01
        cli.write_image(self.frame, np.where(highlights, 6e4, 0) * np.ones(3))
        self.assert_parts_are_the_whole(['bloom,radius=2,amount=1,spread=1'], '--type', 'float', sides=(613,))

    def test_of_a_wide_glow_on_a_smaller_picture(self):
        """Highlights as above."""
        highlights = np.random.default_rng(8).uniform(0, 1, (60, 400, 1)) < .005
        cli.write_image(self.frame, np.where(highlights, 6e4, 0) * np.ones(3))
        for radius in (35, 80):
            self.assert_parts_are_the_whole([f'halation,radius={radius},threshold=0,amount=1'], '--type', 'float', sides=(50, 97))

    def test_of_parts_whose_halo_is_more_than_a_texture(self):
        """A frame that a part of the usual side and its halo would make a texture wider than Mesa's 16384."""
        cli.write_image(self.frame, np.random.default_rng(7).uniform(0, 1, (8, 30000, 3)), 'half')
        self.assert_parts_are_the_whole(['lens-distortion,k1=0.5'], sides=(997,))

    def test_of_light_that_half_float_cannot_hold(self):
        cli.write_image(self.frame, np.full((150, 230, 3), 6e4))
        self.assert_parts_are_the_whole(['exposure,stops=2', 'gaussian-blur'])


class Refused(LargeFrameTest):
    def test_a_filter_that_looks_further_than_a_texture(self):
        cli.write_image(self.frame, np.full((8, 70000, 3), .5), 'half')
        self.deny('look', 'apply', self.frame, '--filter', 'lens-distortion,k1=0.5,k2=0.5', '-o', self.path('o.exr'),
                  naming=['lens-distortion: looks 35003 pixels far in the frame', '70000 x 8'])


class Memory(LargeFrameTest):
    def peak(self, *options, verb=('look', 'apply')):
        """Megabytes that the program held at most."""
        script = ('import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL);'
                  'print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)')
        stages = [part for stage in ('exposure,stops=1', 'film-grain', 'vignette') for part in ('--filter', stage)]
        out = cli.subprocess.run([cli.sys.executable, '-c', script, cli.PROGRAM, *verb, self.frame, *stages, '-o',
                                  self.path('out.exr'), *map(str, options)], capture_output=True, text=True, check=True)
        return int(out.stdout) / 1024

    def test_parts_take_little(self):
        cli.write_image(self.frame, np.random.default_rng(5).uniform(0, 1, (1500, 2250, 3)), 'half')
        whole, parts = self.peak(), self.peak('--tile', 256)
        picture = 1500 * 2250 * 12 / 2**20
        self.assertLess(parts, whole - 3 * picture)

    def test_a_set_that_is_relit_lies_beside_the_frame(self):
        """Three lights at 2400 x 1350, of a small set's copies side by side: the same bytes."""
        self.succeed('solve', SET, '-o', self.path('small.exr'))
        small = oiio.ImageInput.open(self.path('small.exr'))
        spec, pixels = oiio.ImageSpec(small.spec()), np.tile(small.read_image('half'), (5, 5, 1))
        small.close()
        spec.height, spec.width = spec.full_height, spec.full_width = pixels.shape[:2]
        large = oiio.ImageOutput.create(self.frame)
        self.assertTrue(large.open(self.frame, spec) and large.write_image(pixels))
        large.close()
        relit = ('relight', '--light', 'key=3200K,+1st')
        whole, bytes_of_whole = self.peak(verb=relit), cli.sha256(self.path('out.exr'))
        parts = self.peak('--tile', 256, verb=relit)
        self.assertEqual(cli.sha256(self.path('out.exr')), bytes_of_whole)
        contributions = 3 * 2400 * 1350 * 12 / 2**20
        self.assertLess(parts, whole - contributions)

    def test_no_file_stays(self):
        before = set(os.listdir(os.path.dirname(self.frame)))
        self.apply('out.exr', TEN, '--tile', 64)
        self.assertEqual(set(os.listdir(os.path.dirname(self.frame))) - before, {'out.exr'})


if __name__ == '__main__':
    cli.main()

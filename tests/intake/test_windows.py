"""Data windows and display windows: what an EXR holds of its picture is what is solved."""
import os

import numpy as np
import OpenImageIO as oiio
import cli


def write_window(path, pixels, x, y, display, names=('R', 'G', 'B')):
    """The pixels at x, y of a file whose display window is (x, y, width, height)."""
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], 'float')
    spec.channelnames = names
    spec.x, spec.y = x, y
    spec.full_x, spec.full_y, spec.full_width, spec.full_height = display
    output = oiio.ImageOutput.create(path)
    assert output.open(path, spec) and output.write_image(np.ascontiguousarray(pixels, np.float32)), output.geterror()
    output.close()


def windows_of(path):
    source = oiio.ImageInput.open(path)
    spec = source.spec()
    source.close()
    return ((spec.x, spec.y, spec.width, spec.height),
            (spec.full_x, spec.full_y, spec.full_width, spec.full_height))


class WindowTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.plain = cli.Capture(self.path('plain'), ('key', 'fill', 'back'), height=45, width=80)
        noise = np.random.default_rng(1)
        self.plain.shots = [shot + .003 * noise.standard_normal(shot.shape) for shot in self.plain.shots]
        self.plain.save()

    def windowed(self, *places, display=(0, 0, 200, 150), parts=None):
        """The plain capture with its shots (or `parts` of them) at places in a display window."""
        capture = cli.Capture(self.path('windowed'), ('key', 'fill', 'back'), height=45, width=80)
        for k, shot in enumerate(capture.manifest['shots']):
            pixels = self.plain.shots[k]
            if parts:
                left, top, right, bottom = parts[k % len(parts)]
                pixels = pixels[top:bottom, left:right]
            write_window(os.path.join(capture.folder, shot['image']), pixels, *places[k % len(places)], display)
        return capture

    def solve(self, capture, *options, name='solved.exr'):
        path = self.path(name)
        report = self.succeed_json('solve', capture.path, '-o', path, *options)
        for key in ('seconds', 'solved'):
            report.pop(key)
        return path, report

    def same_pixels(self, path, other):
        """Two files hold the same, wherever it lies."""
        found, expected = cli.read_image(path), cli.read_image(other)
        self.assertEqual(set(found), set(expected))
        for name, pixels in expected.items():
            np.testing.assert_array_equal(found[name], pixels, name)

    def test_only_what_the_photographs_hold_is_solved(self):
        plain, expected = self.solve(self.plain, name='plain.exr')
        capture = self.windowed((40, 30))
        solved, report = self.solve(capture)
        self.assertEqual(report, expected)
        self.assertEqual(windows_of(solved), ((40, 30, 80, 45), (0, 0, 200, 150)))
        self.same_pixels(solved, plain)
        for source in (capture.path, solved):
            self.succeed('export', source, '-o', self.path('layers.exr'), '--data-window', 'full')
            whole = cli.read_image(self.path('layers.exr'))['key.G']
            self.assertEqual(whole.shape, (150, 200))
            self.assertGreater(whole[30:75, 40:120].min(), 0)
            whole[30:75, 40:120] = 0
            self.assertFalse(whole.any())
        for k in (1, 2):
            self.succeed('lights', solved, os.path.join(capture.folder, f'shot_0{k}.exr'))

    def test_a_crop_and_a_scale_keep_the_data_window(self):
        capture = self.windowed((40, 30))
        capture.manifest['crop'] = [60, 20, 100, 40]
        capture.shots = []
        capture.save()
        solved, report = self.solve(capture)
        self.assertEqual(report['pixels'], 60 * 30)
        self.assertEqual(windows_of(solved), ((0, 10, 60, 30), (0, 0, 100, 40)))
        capture.manifest['scale'] = .3  # 30 x 12: columns 0 .. 18, rows 3 .. 12
        capture.save()
        solved, report = self.solve(capture)
        self.assertEqual(windows_of(solved), ((0, 3, 18, 9), (0, 0, 30, 12)))
        self.assertEqual(report['pixels'], 18 * 9)
        capture.manifest['crop'] = [0, 0, 30, 30]
        capture.save()
        self.deny('solve', capture.path, '-o', self.path('no.exr'), naming=['shot_01.exr', 'data window'])

    def test_of_photographs_with_different_data_windows_what_all_hold_is_solved(self):
        for shot in self.plain.shots:
            shot[:5] = shot[:, :10] = 0
        part = cli.Capture(self.path('part'), ('key', 'fill', 'back'))
        part.shots = [shot[5:, 10:] for shot in self.plain.shots]
        part.save()
        plain, expected = self.solve(part, name='plain.exr')
        capture = self.windowed((40, 30), (50, 35), parts=[(0, 0, 80, 45), (10, 5, 80, 45)])
        solved, report = self.solve(capture)
        self.assertEqual(windows_of(solved), ((50, 35, 70, 40), (0, 0, 200, 150)))
        self.same_pixels(solved, plain)
        self.assertEqual(report['pixels'], expected['pixels'])
        warnings = [warning for warning in report['warnings'] if 'data windows' in warning]
        self.assertEqual(len(warnings), 1, report['warnings'])
        self.assertIn('50,35,70,40', warnings[0])
        apart = self.windowed((0, 0), (100, 100))
        self.deny('solve', apart.path, '-o', self.path('no.exr'), naming=['shot_02.exr', 'data window'])

    def test_overscan_that_is_left_out_is_said(self):
        capture = self.windowed((-10, -5), display=(0, 0, 60, 50))
        solved, report = self.solve(capture)
        self.assertEqual(windows_of(solved), ((0, 0, 60, 40), (0, 0, 60, 50)))
        self.assertEqual(report['pixels'], 60 * 40)
        said = [warning for warning in report['warnings'] if 'overscan' in warning]
        self.assertEqual(len(said), 1, report['warnings'])
        whole, report = self.solve(self.windowed((10, 5), display=(10, 5, 80, 45)))
        self.assertEqual(windows_of(whole), ((0, 0, 80, 45), (0, 0, 80, 45)))
        self.assertNotIn('overscan', ''.join(report['warnings']))

    def test_whole_numbers_that_float_cannot_hold_are_said(self):
        path = os.path.join(self.plain.folder, 'shot_01.exr')
        for largest in (7, 0xffffffff):
            spec = oiio.ImageSpec(80, 45, 4, 'float')
            spec.channelnames = ('R', 'G', 'B', 'id')
            spec.channelformats = tuple(map(oiio.TypeDesc, ('float', 'float', 'float', 'uint')))
            ids = np.arange(45 * 80).reshape(45, 80, 1) % 2 * (largest / 0xffffffff)  # OpenImageIO scales what it is given
            output = oiio.ImageOutput.create(path)
            assert output.open(path, spec)
            assert output.write_image(np.concatenate([self.plain.shots[0], ids], -1).astype(np.float32))
            output.close()
            solved, report = self.solve(self.plain)
            np.testing.assert_array_equal(np.unique(cli.read_image(solved)['id']), np.float32([0, largest]))
            said = [warning for warning in report['warnings'] if 'whole numbers' in warning]
            self.assertEqual(len(said), int(largest > 7), report['warnings'])


if __name__ == '__main__':
    cli.main()

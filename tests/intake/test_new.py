"""swaplight new: a folder of photographs becomes a capture."""
import json
import os
import shutil
import unittest

import numpy as np
import cli

SAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../samples/film_set')
RING = '0.9/0.2/0.15,0.15/0.8/0.25,0.2/0.25/0.9'


class New(cli.CliTest):
    def photographs(self, names=('key', 'fill', 'back'), order=None, **attributes):
        """Photographs of a small set without a manifest; shot k of the file names is shot order[k] of the rotation."""
        capture = cli.Capture(self.path('made'), names=names, height=48, width=64)
        os.makedirs(self.path('plain'))
        for k, source in enumerate(order or range(len(names))):
            cli.write_image(self.path('plain', f'IMG_{k + 9}.exr'), capture.shots[source], **attributes)
        return self.path('plain')

    def manifest(self):
        with open(self.path('plain', 'capture.json')) as file:
            return json.load(file)

    def test_the_rotation_is_guessed_and_said(self):
        for order in ((0, 1, 2), (0, 2, 1)):
            folder = self.photographs(order=order)
            result = self.succeed_json('new', folder, '--lights', 'key,fill,back', '--colors', RING)
            self.assertEqual([shot['image'] for shot in result['shots']], ['IMG_9.exr', 'IMG_10.exr', 'IMG_11.exr'])
            self.assertIn('guessed, the best', result['colors'])
            truth = cli.rotated(3)
            for shot, source in zip(self.manifest()['shots'], order):
                np.testing.assert_allclose(shot['light_colors'], truth[source], atol=1e-4)
            self.assertEqual([light['role'] for light in self.manifest()['lights']], ['key', 'fill', 'back'])
            shutil.rmtree(folder)

    def test_what_it_writes_is_solved_like_the_manifest(self):
        folder = self.photographs()
        self.succeed('new', folder, '--lights', 'key,fill,back', '--colors', RING)
        self.succeed('solve', folder, '-o', self.path('a.exr'))
        self.succeed('solve', self.path('made'), '-o', self.path('b.exr'))
        for light in ('key', 'fill', 'back'):
            np.testing.assert_array_equal(cli.read_rgb(self.path('a.exr'), light), cli.read_rgb(self.path('b.exr'), light))

    def test_a_crop_and_a_scale_are_used_by_the_solve(self):
        folder = self.photographs()
        self.succeed('new', folder, '--lights', 'key,fill,back', '--colors', RING)
        self.succeed('solve', folder, '-o', self.path('all.exr'), '--float')
        result = self.succeed_json('new', folder, '--lights', 'key,fill,back', '--colors', RING, '--force',
                                   '--crop', '8,4,40,32')
        self.assertEqual((result['crop'], self.manifest()['crop']), ([8, 4, 40, 32],) * 2)
        self.succeed('solve', folder, '-o', self.path('part.exr'), '--float')
        self.assertEqual(cli.read_rgb(self.path('part.exr')).shape, (32, 40, 3))
        whole = cli.read_rgb(self.path('all.exr'))[4:36, 8:48]
        self.assertLess(np.abs(cli.read_rgb(self.path('part.exr')) - whole).mean(), 0.01)
        self.succeed('new', folder, '--lights', 'key,fill,back', '--colors', RING, '--force', '--crop', '8,4,40,32',
                     '--scale', '0.5')
        self.succeed('solve', folder, '-o', self.path('half.exr'), '--float')
        half = cli.read_rgb(self.path('half.exr'))
        self.assertEqual(half.shape, (16, 20, 3))
        mean = whole.reshape(16, 2, 20, 2, 3).mean(axis=(1, 3))
        self.assertLess(np.abs(half - mean).mean(), 0.02)
        arguments = ['new', folder, '--lights', 'key,fill,back', '--colors', RING, '--force']
        self.deny(*arguments, '--crop', '40,4,40,32', naming=['64 x 48', '40,4,40,32'])
        self.deny(*arguments, '--crop', 'much', naming='X,Y,WIDTH,HEIGHT')
        self.deny(*arguments, '--scale', '3', naming='0.5 for half')

    def test_a_photograph_that_is_left_out_changes_nothing(self):
        folder = self.photographs()
        self.succeed('new', folder, '--lights', 'key,fill,back', '--colors', RING)
        self.succeed('solve', folder, '-o', self.path('without.exr'))
        cli.write_image(os.path.join(folder, 'IMG_10b.exr'), np.full((48, 64, 3), .5))
        arguments = ['new', folder, '--lights', 'key,fill,back', '--colors', RING, '--force']
        result = self.succeed_json(*arguments, '--leave-out', 'IMG_10b.exr')
        self.assertEqual(([shot['image'] for shot in result['shots']], result['left_out']),
                         (['IMG_9.exr', 'IMG_10.exr', 'IMG_11.exr'], ['IMG_10b.exr']))
        self.assertEqual(self.manifest()['left_out'], [{'image': 'IMG_10b.exr', 'light_colors': [None] * 3}])
        self.succeed('solve', folder, '-o', self.path('new.exr'))
        self.assertIn('IMG_10b.exr', self.succeed('info', folder).stdout)
        # A capture that uses it, solved without it.
        manifest = self.manifest()
        manifest['shots'].insert(2, {'image': 'IMG_10b.exr', 'light_colors': [[1, 1, 1]] * 3})
        del manifest['left_out']
        with open(self.path('plain', 'capture.json'), 'w') as file:
            json.dump(manifest, file)
        self.succeed('solve', folder, '-o', self.path('solve.exr'), '--leave-out', 'IMG_10b.exr')
        for light in ('key', 'fill', 'back'):
            expected = cli.read_rgb(self.path('without.exr'), light)
            for name in ('new.exr', 'solve.exr'):
                np.testing.assert_array_equal(cli.read_rgb(self.path(name), light), expected)
        left_out = self.succeed_json('info', self.path('solve.exr'))['capture']['left_out']
        self.assertEqual(left_out[0]['light_colors'], [[1, 1, 1]] * 3)
        self.deny('solve', folder, '-o', self.path('x.exr'), '--leave-out', 'IMG_1.exr', naming='in use are IMG_9.exr')
        self.deny(*arguments, '--leave-out', 'IMG_9.exr,IMG_10.exr,IMG_11.exr,IMG_10b.exr', naming='leaves out all')

    def test_gels_are_known_by_their_numbers(self):
        folder = self.photographs(('key', 'fill'))
        result = self.succeed_json('new', folder, '--lights', 'key,fill', '--gels', 'L106,L124')
        self.assertEqual([shot['colors'] for shot in result['shots']], [['L106', 'L124'], ['L124', 'L106']])
        self.deny('new', folder, '--lights', 'key,fill', '--gels', 'L106,L99999', '--force', naming='L99999')

    def test_a_capture_that_is_there_is_not_replaced_unasked(self):
        folder = self.photographs()
        with open(os.path.join(folder, 'capture.json'), 'w') as file:
            file.write('precious')
        arguments = ['new', folder, '--lights', 'key,fill,back', '--colors', RING]
        self.deny(*arguments, naming=['is there already', '--force'])
        self.succeed(*arguments, '--force')
        self.assertEqual(self.manifest()['format'], 'swaplight-capture')

    def test_what_the_program_has_made_is_no_photograph(self):
        folder = self.photographs()
        first = self.succeed_json('new', folder, '--lights', 'key,fill,back', '--colors', RING)
        for name in ('frame.exr', 'frame.png', 'frame.jpg', 'frame.tif'):
            self.succeed('relight', folder, '--light', 'key=50%', '-o', self.path('plain', name))
        self.succeed('export', folder, '-o', self.path('plain', 'layers.exr'))
        again = self.succeed_json('new', folder, '--lights', 'key,fill,back', '--colors', RING, '--force')
        self.assertEqual(again['shots'], first['shots'])

    def test_a_shot_is_told_by_itself_and_an_unknown_colour_is_said(self):
        folder = self.photographs(('key', 'fill'))
        result = self.succeed_json('new', folder, '--lights', 'key,fill', '--shot', 'IMG_9.exr=0.9/0.2/0.15,unknown',
                                   '--shot', 'IMG_10.exr=0.15/0.8/0.25,0.9/0.2/0.15')
        self.assertIsNone(self.manifest()['shots'][0]['light_colors'][1])
        self.assertTrue(any('the colour of fill in IMG_9.exr is unknown' in w for w in result['warnings']), result)
        report = self.succeed_json('solve', folder, '-o', self.path('solved.exr'))
        self.assertIn('The colour of fill in shot 1 was not known: estimated', report['message'])

    def test_an_unknown_gel_that_travels_has_a_name(self):
        folder = self.photographs(('key', 'fill'))
        result = self.succeed_json('new', folder, '--lights', 'key,fill', '--colors', '0.9/0.2/0.15,?')
        self.assertEqual(self.manifest()['shots'][0]['light_colors'][1], '?a')
        self.assertEqual(self.manifest()['shots'][1]['light_colors'][0], '?a')
        self.assertTrue(any('leave one number of it open' in w for w in result['warnings']), result)

    def test_a_white_card_tells_a_lights_colours(self):
        folder = self.photographs(('key', 'fill'))
        for k, color in enumerate(([.9, .2, .15], [.15, .8, .25])):
            path = os.path.join(folder, f'IMG_{k + 9}.exr')
            pixels = cli.read_rgb(path)
            pixels[30:42, 40:52] = np.multiply(color, .9)
            cli.write_image(path, pixels)
        result = self.succeed_json('new', folder, '--lights', 'key,fill', '--card', 'key=45,36', '--colors',
                                   '0.9/0.2/0.15,0.15/0.8/0.25')
        np.testing.assert_allclose(self.manifest()['shots'][0]['light_colors'][0], np.multiply([.9, .2, .15], .9), atol=2e-3)
        np.testing.assert_allclose(self.manifest()['shots'][1]['light_colors'][1], [.9, .2, .15], atol=1e-4)
        self.assertEqual(result['lights'], ['key', 'fill'])

    def test_one_light_at_a_time(self):
        folder = self.photographs(('key', 'fill'))
        self.succeed('new', folder, '--lights', 'key,fill', '--one-at-a-time')
        self.assertEqual(self.manifest()['shots'][1]['light_colors'], [[0, 0, 0], [1, 1, 1]])

    def test_exposures_and_clipping_are_said(self):
        folder = self.photographs(('key', 'fill'))
        for k, seconds in enumerate((.02, .01)):
            path = os.path.join(folder, f'IMG_{k + 9}.exr')
            pixels = cli.read_rgb(path)
            pixels[:8, :8] = 1
            cli.write_image(path, pixels, ExposureTime=seconds, FNumber=4.0, **{'Exif:ISOSpeedRatings': 100})
        result = self.succeed_json('new', folder, '--lights', 'key,fill', '--gels', 'L106,L124')
        warnings = ' | '.join(result['warnings'])
        self.assertIn('-1.00 stops relative to IMG_9.exr', warnings)
        self.assertIn('of the picture is clipped', warnings)
        self.assertEqual(self.manifest()['shots'][1]['exposure_stops'], -1)

    def brackets(self, stops, **exposure):
        """A folder of two lightings, each at these exposures and clipped: in 16 bits, or EXR that states its exposure."""
        capture = cli.Capture(self.path('made'), height=60, width=80)
        for lighting, shot in enumerate(capture.shots):
            for k, one in enumerate(stops):
                pixels = np.clip(shot * 2.0 ** one, 0, 1)
                attributes = {'ExposureTime': 2.0 ** one / 50, 'FNumber': 4.0, 'Exif:ISOSpeedRatings': 100} if exposure else {}
                name = f'IMG_{lighting * len(stops) + k + 1}.' + ('exr' if exposure else 'tif')
                cli.write_image(self.path('plain', name), pixels, 'float' if exposure else 'uint16', **attributes)
        return self.path('plain'), capture

    def test_brackets_are_found_told_and_solved(self):
        arguments = ['--lights', 'key,fill', '--colors', '0.9/0.2/0.15,0.15/0.8/0.25', '--color-space', 'lin_rec709']
        for stated in ({}, {'exposure': True}):
            folder, made = self.brackets([0, -3, 2], **stated)
            result = self.succeed_json('new', folder, *arguments)
            self.assertEqual(result['bracket'], 3, result)
            self.assertIn('by the files and the photographs' if stated else 'by the ratios', result['exposures'])
            self.assertFalse([w for w in result['warnings'] if 'expose less' in w], result['warnings'])
            np.testing.assert_allclose([s.get('exposure_stops', 0) for s in self.manifest()['shots']], [0, -3, 2] * 2,
                                       atol=.02)
            colors = [s['light_colors'] for s in self.manifest()['shots']]
            np.testing.assert_allclose(colors, np.repeat(cli.SWAPPED, 3, axis=0), atol=1e-4)
            self.succeed('solve', folder, '-o', self.path('solved.exr'), '--float')
            for light, truth in zip(('key', 'fill'), made.truth):
                np.testing.assert_allclose(cli.read_rgb(self.path('solved.exr'), light), truth, atol=4e-3)
            shutil.rmtree(folder)

    def test_exposures_are_told(self):
        folder, _ = self.brackets([0, -2])
        arguments = ['new', folder, '--lights', 'key,fill', '--colors', '0.9/0.2/0.15,0.15/0.8/0.25', '--color-space',
                     'lin_rec709', '--force']
        result = self.succeed_json(*arguments, '--exposures', '0,-1.7')
        self.assertEqual((result['bracket'], result['exposures']), (2, 'brackets of 2: 0, -1.7 stops, as told'))
        self.assertTrue(any('is -2.00 stops, not -1.70' in w for w in result['warnings']), result)
        self.assertEqual(self.manifest()['shots'][3]['exposure_stops'], -1.7)
        self.assertEqual(self.succeed_json(*arguments, '--exposures', '0')['bracket'], 1)
        self.deny(*arguments, '--exposures', '0,-3,2', naming='3 of them for 4 photographs')
        self.deny(*arguments, '--exposures', '0,much', naming="'much' is no number of stops")

    def test_one_light_at_a_time_in_brackets(self):
        capture = cli.Capture(self.path('made'), light_colors=[[[1] * 3, [0] * 3], [[0] * 3, [1] * 3]], height=60, width=80)
        for k in range(4):
            cli.write_image(self.path('plain', f'{k}.tif'), np.clip(capture.shots[k // 2] * (1, 4)[k % 2], 0, 1), 'uint16')
        self.succeed('new', self.path('plain'), '--lights', 'key,fill', '--one-at-a-time', '--color-space', 'lin_rec709')
        self.assertEqual([s['light_colors'][0][0] for s in self.manifest()['shots']], [1, 1, 0, 0])
        np.testing.assert_allclose(self.manifest()['shots'][3]['exposure_stops'], 2, atol=.02)

    def test_a_camera_that_moved_by_half_a_pixel_is_said_and_one_that_stood_still_is_not(self):
        lights = ('key', 'fill', 'back', 'practical')
        os.makedirs(self.path('one'))
        os.makedirs(self.path('all'))
        for k, light in enumerate(lights):
            shutil.copy(os.path.join(SAMPLE, f'truth/T_{light}.exr'), self.path('one', f'IMG_{k}.exr'))
            shot = cli.read_rgb(os.path.join(SAMPLE, f'shot_0{k + 1}.exr'))
            if k == 2:  # half a pixel to the right and down, by the phases of its waves
                around = np.pad(shot, ((8, 8), (8, 8), (0, 0)), 'edge')
                fy, fx = np.fft.fftfreq(around.shape[0])[:, None], np.fft.fftfreq(around.shape[1])[None]
                turned = np.fft.fft2(around, axes=(0, 1)) * np.exp(-2j * np.pi * 0.36 * (fx + fy))[..., None]
                shot = np.fft.ifft2(turned, axes=(0, 1)).real[8:-8, 8:-8].astype(np.float32)
            cli.write_image(self.path('all', f'IMG_{k}.exr'), shot)

        def moved(*arguments):
            warnings = self.succeed_json('new', *arguments, '--lights', ','.join(lights))['warnings']
            return [w.split(':')[0] for w in warnings if 'camera moved' in w]

        self.assertEqual(moved(self.path('one'), '--one-at-a-time'), [])
        self.assertEqual(moved(self.path('all'), '--colors', RING + ',0.85/0.75/0.1', '--rotation', 'back'), ['IMG_2.exr'])

    def test_what_is_missing_is_asked_for_in_one_line(self):
        folder = self.photographs(('key', 'fill'))
        self.deny('new', folder, '--lights', 'key,fill', naming='say which colours the lights had')
        self.deny('new', folder, '--lights', 'key,fill', '--gels', 'L106', naming='1 colours for 2 lights')
        self.deny('new', folder, '--lights', 'key,9', '--gels', 'L106,L124', naming='9')
        self.deny('new', self.path('nowhere'), '--lights', 'key,fill', '--gels', 'L106,L124', naming='nowhere')

    def test_a_picture_of_another_size_is_left_out_unless_it_is_asked_for(self):
        folder = self.photographs(('key', 'fill'))
        cli.write_image(os.path.join(folder, 'IMG_11.exr'), np.zeros((10, 10, 3)))
        arguments = ['new', folder, '--lights', 'key,fill', '--gels', 'L106,L124']
        self.deny(*arguments, '--shots', 'IMG_9.exr,IMG_11.exr', naming='at one size')
        found = self.succeed_json(*arguments)
        self.assertIn('IMG_11.exr is left out: it is 10 x 10 pixels', ' '.join(found['warnings']))


@unittest.skipUnless(os.path.isdir(os.path.join(cli.SHARED, 'captures', 'swapped_lion')), 'no real photographs here')
class RealPhotographs(cli.CliTest):
    """Two lamps whose gels were swapped, as a plain folder of two photographs."""

    def setUp(self):
        super().setUp()
        self.source = os.path.join(cli.SHARED, 'captures', 'swapped_lion')
        os.makedirs(self.path('lion'))
        for name in ('photo_r_b.exr', 'photo_b_r.exr'):
            shutil.copyfile(os.path.join(self.source, name), self.path('lion', name))
        with open(os.path.join(self.source, 'capture_r_b.json')) as file:
            self.shots = json.load(file)['shots']
        # The gels of both lamps, measured, as a table of the person's own.
        self.home = {'XDG_DATA_HOME': self.path('data')}
        os.makedirs(self.path('data', 'swaplight'))
        with open(self.path('data', 'swaplight', 'gels.csv'), 'w') as file:
            file.write('brand,number,name,x,y,T\n')
            for k, shot in enumerate(self.shots):
                for i, color in enumerate(shot['light_colors']):
                    x, y, z = np.array([[.4124564, .3575761, .1804375], [.2126729, .7151522, .0721750],
                                        [.0193339, .1191920, .9503041]]) @ color
                    file.write(f'S,{10 * (i + 1) + k + 1},lamp {i + 1},{x / (x + y + z):.8f},{y / (x + y + z):.8f},{y:.8f}\n')

    def solved(self, *arguments):
        result = self.succeed_json('new', self.path('lion'), '--lights', 'left,right', '--shots',
                                   'photo_r_b.exr,photo_b_r.exr', *arguments, '--force', env=self.home)
        self.succeed('solve', self.path('lion'), '-o', self.path('solved.exr'))
        return result, [cli.read_rgb(self.path('solved.exr'), light) for light in ('left', 'right')]

    def test_the_gels_named_give_the_same_solve_as_the_manifest(self):
        self.succeed('solve', os.path.join(self.source, 'capture_r_b.json'), '-o', self.path('manifest.exr'))
        manifest = [cli.read_rgb(self.path('manifest.exr'), light) for light in ('left', 'right')]
        typed = ['--shot={}={}'.format(s['image'], ','.join('/'.join(map(str, c)) for c in s['light_colors']))
                 for s in self.shots]
        _, lights = self.solved(*typed)
        for light, wanted in zip(lights, manifest):
            np.testing.assert_array_equal(light, wanted)
        _, lights = self.solved('--shot', 'photo_r_b.exr=S11,S21', '--shot', 'photo_b_r.exr=S12,S22')
        for light, wanted in zip(lights, manifest):
            np.testing.assert_allclose(light, wanted, atol=2e-3)

    def test_two_gels_are_enough_to_be_named(self):
        result, _ = self.solved('--gels', 'S11,S12')
        self.assertEqual([shot['colors'] for shot in result['shots']], [['S11', 'S12'], ['S12', 'S11']])
        self.assertNotIn('badly', result['colors'])

    def test_an_unknown_colour_is_said(self):
        result, _ = self.solved('--shot', 'photo_r_b.exr=S11,unknown', '--shot', 'photo_b_r.exr=S12,S22')
        self.assertTrue(any('right in photo_r_b.exr is unknown' in w for w in result['warnings']))


if __name__ == '__main__':
    cli.main()

"""Captures that cannot be solved: one clear line, exit 2, nothing written."""
import json
import os
import shutil
import subprocess
import unittest

import numpy as np
import swaplight_cli as cli


class BadInputTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        self.solved = self.path('solved.exr')

    def refuse(self, *naming):
        """The capture as it is now cannot be solved."""
        self.deny('solve', self.capture.path, '-o', self.solved, naming=naming)

    def change(self, **keys):
        self.capture.manifest.update(keys)
        self.capture.save()

    def shot(self, name='shot_02.exr'):
        return os.path.join(self.capture.folder, name)

    def test_no_capture(self):
        self.deny('solve', self.path('none.json'), '-o', self.solved, naming='none.json')

    def test_missing_shot(self):
        os.remove(self.shot())
        self.refuse('shot_02.exr')

    def test_shots_of_different_size(self):
        cli.write_image(self.shot(), self.capture.shots[1][:7])
        self.refuse('shot_01.exr', 'shot_02.exr', '16', '12', '7')

    def test_one_photograph_under_two_names(self):
        shutil.copy(self.shot('shot_01.exr'), self.shot())
        self.refuse('shot_02.exr', 'the same picture as shot_01.exr')

    def test_a_card_of_another_size(self):
        cli.write_image(self.shot('lens.exr'), self.capture.shots[1][:7] * 0 + .5)
        self.change(vignetting='lens.exr')
        self.refuse('lens.exr', '7 pixels', 'at one size')

    def test_a_key_that_stands_there_twice(self):
        with open(self.capture.path) as file:
            text = file.read()
        with open(self.capture.path, 'w') as file:
            file.write(text.replace('{', '{"color_space": "srgb", ', 1))
        self.refuse('capture.json', '"color_space" twice')

    def test_a_light_with_a_long_name(self):
        self.change(lights=[{'name': 'k' * 300, 'role': 'key'}, {'name': 'fill', 'role': 'fill'}])
        self.refuse('capture.json', '300 letters', '200')

    def test_shot_that_is_no_image(self):
        with open(self.shot(), 'w') as file:
            file.write('not a picture')
        self.refuse('shot_02.exr')

    def test_shot_that_is_empty(self):
        open(self.shot(), 'w').close()
        self.refuse('shot_02.exr')

    def truncate(self, path):
        with open(path, 'r+b') as file:
            file.truncate(os.path.getsize(path) * 6 // 10)

    def test_truncated_exr(self):
        self.truncate(self.shot())
        self.refuse('shot_02.exr')

    def test_truncated_png(self):
        random = np.random.default_rng(0)  # noise does not compress: the data reaches beyond the header
        for k, shot in enumerate(self.capture.manifest['shots']):
            shot['image'] = f'shot_{k + 1:02d}.png'
            cli.write_image(self.shot(shot['image']), random.uniform(0, 1, (12, 16, 3)), 'uint16')
        with open(self.capture.path, 'w') as file:
            json.dump({**self.capture.manifest, 'color_space': 'srgb'}, file)
        self.truncate(self.shot('shot_02.png'))
        self.refuse('shot_02.png')

    def test_json_syntax_error(self):
        with open(self.capture.path, 'w') as file:
            file.write('{"format": "swaplight-capture",\n "version": 1,\n "lights": [}\n')
        self.refuse('capture.json', 'line 3', 'column 13')

    def test_no_lights(self):
        self.change(lights=[])
        self.refuse('capture.json', 'no lights')

    def test_no_shots(self):
        self.change(shots=[])
        self.refuse('capture.json', 'shots')

    def test_more_lights_than_shots_can_tell(self):
        self.change(lights=[{'name': n} for n in ('a', 'b', 'c', 'd', 'e', 'f', 'g')],
                    shots=[{'image': s['image'], 'light_colors': [[.9, .2, .1]] * 7}
                           for s in self.capture.manifest['shots']])
        self.refuse('7 lights', '2 shots')

    def test_colors_of_another_count_than_lights(self):
        self.capture.manifest['shots'][1]['light_colors'].append([1, 1, 1])
        self.capture.save()
        self.refuse('shot 2', '3', '2 lights')

    def test_two_lights_with_equal_colors_in_all_shots(self):
        for shot in self.capture.manifest['shots']:
            shot['light_colors'] = [[.5, .4, .3], [.5, .4, .3]]
        self.capture.save()
        self.refuse('key', 'fill', 'colour')

    def test_negative_color(self):
        self.capture.manifest['shots'][0]['light_colors'][0][1] = -.1
        self.capture.save()
        self.refuse('shot 1', 'key', '-0.1')

    def test_color_that_is_not_finite(self):
        for text in ('NaN', 'Infinity', '1e999'):
            with open(self.capture.path, 'w') as file:
                file.write(json.dumps(self.capture.manifest).replace('0.9', text, 1))
            self.refuse('capture.json')

    def test_unknown_color_space(self):
        self.change(color_space='technicolor')
        self.refuse('technicolor', 'lin_rec709', 'acescg')

    def test_light_name_with_a_dot(self):
        self.capture.manifest['lights'][1]['name'] = 'fill.left'
        self.capture.save()
        self.refuse('fill.left', 'fill_left')

    def test_two_lights_of_one_name(self):
        self.capture.manifest['lights'][1]['name'] = 'key'
        self.capture.save()
        self.refuse('key')

    def test_output_in_a_folder_that_is_not_there(self):
        self.deny('solve', self.capture.path, '-o', self.path('no/such/solved.exr'), naming='solved.exr')

    def test_output_that_is_a_folder(self):
        os.mkdir(self.path('solved.exr'))
        self.refuse('solved.exr')

    @unittest.skipIf(os.geteuid() == 0, 'root may write everywhere')
    def test_output_in_a_folder_that_is_read_only(self):
        os.mkdir(self.path('locked'), 0o500)
        self.deny('solve', self.capture.path, '-o', self.path('locked/solved.exr'), naming='solved.exr')

    def test_report_that_cannot_be_written(self):
        self.deny('solve', self.capture.path, '-o', self.solved, '--report', self.path('no/such/report.json'),
                  naming='report.json')

    def test_one_photograph_under_two_lightings(self):
        self.capture.manifest['shots'][1]['image'] = 'shot_01.exr'
        with open(self.capture.path, 'w') as file:
            json.dump(self.capture.manifest, file)
        self.refuse('capture.json', 'shots 1 and 2', 'shot_01.exr')
        self.capture.manifest['shots'][1]['image'] = './shot_01.exr'
        with open(self.capture.path, 'w') as file:
            json.dump(self.capture.manifest, file)
        self.refuse('capture.json', 'shots 1 and 2')

    def test_two_outputs_of_one_name(self):
        self.deny('solve', self.capture.path, '-o', self.solved, '--report', self.path('set/../solved.exr'),
                  naming=['solved.exr', 'written twice'])
        self.succeed('solve', self.capture.path, '-o', self.solved)
        frame, shot = self.path('out.exr'), self.shot('shot_01.exr')
        for arguments in (('relight', self.solved, '-o', frame, '--histogram', frame),
                          ('shadows', self.solved, '-o', frame, '--overlay', frame),
                          ('balance', shot, '--colors', '2800K,0.5/0.7/1', '-o', frame, '--map', frame),
                          ('evaluate', shot, shot, '--map', frame, '--plot', frame)):
            self.deny(*arguments, naming='out.exr')

    def test_two_outputs_of_one_name_spelt_otherwise(self):
        self.succeed('solve', self.capture.path, '-o', self.solved)
        folder = os.path.dirname(self.solved)
        self.deny('relight', 'solved.exr', '-o', 'q.png', '--histogram', './q.png', naming='q.png', cwd=folder)
        self.deny('relight', 'solved.exr', '-o', 'q.png', '--histogram', self.path('q.png'), naming='q.png', cwd=folder)

    def test_pixels_that_one_photograph_lacks_are_told_by_the_others(self):
        pixels = self.capture.shots[1].copy()
        pixels[:, :6, 0] = np.nan
        cli.write_image(self.shot(), pixels)
        told = self.succeed_json('solve', self.capture.path, '-o', self.solved)
        self.assertGreater(told['not_finite'], 60)
        self.assertEqual((told['lost'], told['verdict']['word']), (0, 'good'))

    def test_photographs_without_light_are_not_told_apart(self):
        for pixels, reason in ((np.zeros((12, 16, 3)), 'hold no light'),
                               (np.full((12, 16, 3), np.nan), 'no numbers')):
            for name in ('shot_01.exr', 'shot_02.exr'):
                cli.write_image(self.shot(name), pixels)
            told = self.succeed_json('solve', self.capture.path, '-o', self.solved)
            self.assertEqual(told['verdict']['word'], 'lights not apart')
            self.assertIn(reason, ' '.join(told['verdict']['reasons']))
            self.assertIn('not apart', self.succeed('info', self.solved).stdout)

    def test_the_wrong_file_named_as_dark(self):
        cli.write_image(self.shot('dark.exr'), 2 * self.capture.shots[0])
        self.change(dark='dark.exr')
        told = self.succeed_json('solve', self.capture.path, '-o', self.solved)
        self.assertEqual(told['verdict']['word'], 'lights not apart')
        self.assertIn('named as dark', ' '.join(told['verdict']['reasons']))

    def test_a_photograph_with_the_lights_as_dark_or_ambient(self):
        for key in ('dark', 'ambient'):
            self.change(**{key: 'shot_01.exr'})
            self.refuse(f'"{key}"', 'shot 1', 'shot_01.exr')
            del self.capture.manifest[key]

    def test_no_colour_that_is_told(self):
        for shot in self.capture.manifest['shots']:
            shot['light_colors'] = ['unknown', 'unknown']
        self.capture.save()
        self.refuse('key', 'fill', 'unknown in every shot')

    def test_a_model_that_does_not_fit_is_not_called_good(self):
        self.capture.truth[0][:, :, 1] *= np.linspace(.3, 1, self.capture.truth[0].shape[1])
        self.capture.shots = [cli.photograph(self.capture.truth, s['light_colors']) for s in self.capture.manifest['shots']]
        self.capture.save()
        told = self.succeed_json('solve', self.capture.path, '-o', self.solved, '--model', 'single')
        self.assertNotEqual(told['verdict']['word'], 'good')

    def test_what_is_written_is_called_what_it_is(self):
        self.succeed('solve', self.capture.path, '-o', self.solved, '-q')
        with open(self.path('rig.json'), 'w') as file:
            json.dump(self.succeed_json('relight', self.solved, '-o', self.path('frame.exr'))['rig'], file)
        self.deny('balance', self.path('rig.json'), '-o', self.path('rig.exr'), naming=('rig.exr', 'rig.json'))
        self.deny('report', self.solved, '-o', self.path('page.pdf'), naming=('page.pdf', 'page.html'))
        self.deny('lights', self.solved, self.path('frame.exr'), '--rig', self.path('rig.xyz'), naming=('rig.xyz', 'rig.json'))
        self.deny('lightmap', self.solved, '--type', 'uint8', '-o', self.path('map.exr'), naming=('map.exr', 'uint8'))
        self.deny('versions', self.solved, naming=('solved.exr', 'no JSON'))
        self.deny('lightmap', self.solved, '--ambient', '5', '-o', self.path('map.exr'), naming=('--ambient', 'light map'))
        self.deny('solve', self.capture.path, '--solver', 'nnls', '--model', 'gloss', '-o', self.path('x.exr'),
                  naming=('--solver nnls', '--model transport', '--model gloss'))

    def test_picture_of_no_pixels(self):
        # No library writes one: a PNG header that says 0 x 0.
        import struct
        import zlib

        def chunk(kind, data):
            return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
        self.capture.manifest['shots'][1]['image'] = 'zero.png'
        with open(self.capture.path, 'w') as file:
            json.dump(self.capture.manifest, file)
        with open(self.shot('zero.png'), 'wb') as file:
            file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', 0, 0, 8, 2, 0, 0, 0)) +
                       chunk(b'IDAT', zlib.compress(b'')) + chunk(b'IEND', b''))
        self.refuse('zero.png')


class IdleOptionTest(cli.CliTest):
    """Options that would do nothing, where a person who gives them expects something."""

    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved)
        self.out = self.path('out.png')

    def test_how_to_solve_what_is_solved(self):
        self.deny('relight', self.solved, '--model', 'lambert', '-o', self.out, naming=('--model', 'solved.exr'))
        self.deny('shadows', self.solved, '--noise', 'read=.001', '-o', self.path('s.exr'), naming=('--noise',))
        self.succeed('relight', self.solved, '--highlights', 'off', '-o', self.out)

    def test_how_to_solve_a_sequence_of_solved_sets(self):
        for frame in (1, 2):
            shutil.copy(self.solved, self.path(f'solved.{frame}.exr'))
        self.deny('relight', self.path('solved.%d.exr'), '-F', '1-2', '--model', 'lambert', '-o', self.path('f.%d.png'),
                  naming=('--model', 'solved.1.exr'))

    def test_a_picture_as_capture(self):
        photograph = os.path.join(self.capture.folder, 'shot_01.exr')
        shutil.copy(photograph, self.path('upper.EXR'))
        for picture in (self.solved, photograph, self.path('upper.EXR')):
            self.deny('linear', picture, naming=(os.path.basename(picture), 'capture.json'))
        self.deny('solve', self.solved, '-o', self.path('again.exr'), naming=('solved.exr', 'capture.json'))
        self.deny('linear', self.path('none.exr'), naming=('none.exr', 'no such file'))

    def test_highlights_leave_a_session_its_way_to_solve(self):
        session = self.path('a.swaplight')
        frames = []
        for model in ('single', 'transport'):
            with open(session, 'w') as file:
                json.dump({'format': 'swaplight-session', 'version': 1, 'source': self.capture.path,
                           'solve': {'model': model}}, file)
            frames.append(self.path(model + '.exr'))
            self.succeed('relight', session, '--highlights', 'off', '-o', frames[-1], '--light', 'key=off')
        one, other = map(cli.read_rgb, frames)
        self.assertGreater(np.abs(one - other).max(), 1e-4)

    def test_how_cues_are_played_without_cues(self):
        self.deny('relight', self.solved, '--hold', '2', '-o', self.out, naming=('--hold', '--cues'))
        self.deny('relight', self.solved, '-F', '1-2', '--cue-fps', '25', '-o', self.path('f.%04d.png'),
                  naming=('--cue-fps', '--cues'))

    def test_frames_of_a_still(self):
        for option in (('--workers', '4'), ('--cont',), ('--skip-existing',), ('--frame-index', '0'), ('--frame-count', '2')):
            self.deny('relight', self.solved, *option, '-o', self.out, naming=(option[0], '-F'))

    def test_highlights_where_nothing_looks_at_them(self):
        self.deny('shadows', self.capture.path, '--highlights', 'off', '-o', self.path('x.exr'), naming=('--highlights',))
        self.assertNotIn('--highlights', self.succeed('normals', '--help').stdout)

    def test_a_view_of_layers(self):
        self.deny('export', self.solved, '--view', 'AgX', '-o', self.path('layers.exr'), naming=('--view', '--camera-look'))

    def test_half_that_cannot_hold_the_light_is_said(self):
        layers = ('export', self.solved, '--light', 'key=+30st', '-o', self.path('layers.exr'))
        self.assertIn('--type half', self.succeed(*layers, '--type', 'half').stderr)
        self.assertNotIn('--type', self.succeed(*layers).stderr)
        lightmap = ('lightmap', self.solved, '--light', 'key=+30st', '-o', self.path('map.exr'))
        self.assertIn('--type half', self.succeed(*lightmap, '--type', 'half').stderr)
        self.assertNotIn('--type', self.succeed(*lightmap).stderr)

    def test_layers_of_a_look(self):
        for option in (('--beta',), ('--type', 'half'), ('--color-space', 'acescg')):
            self.deny('export', self.solved, *option, '-o', self.path('look.cc'), naming=(option[0], 'look.cc'))

    def test_scene_linear_primaries_of_a_picture_to_be_looked_at(self):
        self.deny('relight', self.solved, '--color-space', 'acescg', '-o', self.out, naming=('--color-space',))
        self.succeed('relight', self.solved, '--color-space', 'acescg', '-o', self.path('out.exr'))

    def test_grades_said_in_two_ways(self):
        grade = self.path('a.cc')
        self.succeed('export', self.solved, '-o', grade)
        new = ('-o', self.path('b.cc'))
        self.deny('grade', grade, '--slope', '1.1', '--gain', '1.2', *new, naming=('--gain', '--slope'))
        self.deny('grade', grade, '--on', '--off', *new, naming=('--on', '--off'))
        self.deny('grade', grade, '--from', grade, '--reset', *new, naming=('--from', '--reset'))


class DiskTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.disk = self.path('disk')
        os.mkdir(self.disk)
        if not shutil.which('mount'):
            self.skipTest('SKIPPED: there is no mount here (the package of that name)')
        mounted = subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=96k', 'none', self.disk], capture_output=True)
        if mounted.returncode:
            self.skipTest('SKIPPED: no tmpfs can be mounted here (that needs root): '
                          + mounted.stderr.decode().strip())
        self.addCleanup(subprocess.run, ['umount', self.disk])

    def test_of_a_solved_set_a_frame_and_a_plot(self):
        capture = cli.Capture(self.path('set'), height=120, width=160)
        solved = self.path('solved.exr')
        self.succeed('solve', capture.path, '-o', solved, '-q')
        full = os.path.join(self.disk, 'full')
        self.deny('solve', capture.path, '-o', full + '.exr', '-q', naming=['full.exr', 'full'], code=3)
        self.deny('relight', solved, '-o', full + '.exr', '--type', 'float', '-q', naming='full.exr', code=3)
        self.deny('relight', solved, '-o', full + '.tif', '--type', 'float', '-q', naming='full.tif', code=3)
        self.assertEqual(os.listdir(self.disk), [])

    def test_of_a_disk_that_is_read_only(self):
        subprocess.run(['mount', '-o', 'remount,ro', self.disk], check=True)
        capture = cli.Capture(self.path('set'))
        self.deny('solve', capture.path, '-o', os.path.join(self.disk, 'solved.exr'), '-q', naming='solved.exr')

    def test_leaves_the_old_file_as_it_was(self):
        capture = cli.Capture(self.path('set'), height=120, width=160)
        old = os.path.join(self.disk, 'old.exr')
        with open(old, 'w') as file:
            file.write('old')
        self.deny('solve', capture.path, '-o', old, '-q', naming='old.exr', code=3)
        with open(old) as file:
            self.assertEqual(file.read(), 'old')


if __name__ == '__main__':
    cli.main()

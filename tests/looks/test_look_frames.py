"""Camera looks where frames are made: relight, its sequences, export, and the session that keeps one."""
import json
import os

import numpy as np

import cli

BROKEN = '''/*{"INPUTS": [{"NAME": "inputImage", "TYPE": "image"}]}*/
void main() {
  gl_FragColor = amuont * IMG_THIS_PIXEL(inputImage);
}
'''
NO_OPENGL = {'__EGL_VENDOR_LIBRARY_DIRS': '/nowhere'}


class LookFrameTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        os.environ['XDG_DATA_HOME'] = self.path('data')
        capture = cli.Capture(self.path('set'), height=48, width=64)
        for light, role in zip(capture.manifest['lights'], ('key', 'fill')):
            light['role'] = role
        capture.save()
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.path('set', 'capture.json'), '-o', self.solved, '--model', 'transport', '--float', '-q')

    def write(self, name, content):
        with open(self.path(name), 'w') as file:
            file.write(content if isinstance(content, str) else json.dumps(content))
        return self.path(name)

    def look(self, *filters, name='Warm'):
        """A .swaplook file of these filters: names, or names with parameters."""
        stages = [{'filter': f} if isinstance(f, str) else {'filter': f[0], 'parameters': f[1]} for f in filters]
        return self.write('warm.swaplook', {'format': 'swaplight-look', 'version': 1, 'name': name, 'filters': stages})

    def session(self, **more):
        return self.write('a.swaplight', {'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr', **more})

    def frame(self, *arguments, out='out.exr', source=None):
        self.succeed('relight', source or self.solved, '-o', self.path(out), *arguments,
                     *(['--type', 'float'] if out.endswith('.exr') else []))
        return cli.read_rgb(self.path(out))


class Still(LookFrameTest):
    def test_relight_draws_what_look_apply_draws_on_its_frame(self):
        look = self.look(['exposure', {'stops': 1}], 'halation', 'sepia', ['film-grain', {'amount': .3}])
        self.frame(out='plain.exr')
        for out in ('a.png', 'a.exr'):
            kind = ['--type', 'float'] if out.endswith('exr') else []
            self.succeed('look', 'apply', self.path('plain.exr'), '--look', look, '-o', self.path('b' + out[1:]),
                         '--frame', 7, *kind)
            np.testing.assert_array_equal(self.frame('--camera-look', look, '--frame', 7, out=out),
                                          cli.read_rgb(self.path('b' + out[1:])))

    def test_light_stays_light_through_filters_of_light(self):
        np.testing.assert_allclose(self.frame('--filter', 'exposure,stops=2'), 4 * self.frame(), rtol=1e-6)

    def test_a_lighting_look_and_a_camera_look_are_two_things(self):
        self.frame('--look', 'golden-hour:0.5', '--camera-look', 'night vision', out='a.png')
        self.deny('relight', self.solved, '--camera-look', 'golden-hour', '-o', self.path('o.png'),
                  naming=['no camera look', 'Night vision'])

    def test_filters_for_a_display_work_in_the_view_of_the_frame(self):
        through = self.frame('--view', 'Raw', out='plain.png')
        np.testing.assert_allclose(self.frame('--view', 'Raw', '--filter', 'negative', out='a.png'), 1 - through,
                                   atol=1.01 / 255)
        np.testing.assert_allclose(self.frame('--tone', 'reinhard', '--filter', 'negative', out='b.png'),
                                   1 - self.frame('--tone', 'reinhard', out='toned.png'), atol=1.01 / 255)

    def test_a_frame_says_what_it_was_seen_through(self):
        self.frame('--camera-look', self.look('exposure'))
        import OpenImageIO as oiio
        source = oiio.ImageInput.open(self.path('out.exr'))
        self.assertEqual(json.loads(source.spec().getattribute('swaplight/cameraLook'))['name'], 'Warm')
        source.close()

    def test_what_is_typed_has_to_be_right(self):
        out = ('-o', self.path('o.png'))
        self.deny('relight', self.solved, '--filter', 'exposrue', *out, naming='did you mean exposure')
        self.deny('relight', self.solved, '--filter', self.write('bad.fs', BROKEN), *out, naming=['bad.fs:3:', 'amuont'])
        self.deny('relight', self.solved, '--filter', 'sepia', '--camera-look', 'film', *out, naming='one of them')
        look = self.look('sepia')
        self.deny('relight', self.solved, '--camera-look', look, '-o', look, naming='warm.swaplook')


class Broken(LookFrameTest):
    def test_a_broken_filter_of_a_look_is_left_out_and_named(self):
        """Does not compile; is not there; has a parameter out of range; reads a picture that is not there."""
        bad = self.write('bad.fs', BROKEN)
        doubled = self.frame('--filter', 'exposure,stops=1')
        for filter, words in ((bad, 'bad.fs:3:'), ('nothing-like-it', 'no filter "nothing-like-it"'),
                              (['exposure', {'stops': 99}], 'expected -8 to 8'),
                              (['blend', {'other': 'nowhere.png'}], 'nowhere.png')):
            look = self.look(filter, ['exposure', {'stops': 1}])
            result = cli.run('relight', self.solved, '--camera-look', look, '-o', self.path('o.exr'), '--type', 'float')
            self.assertEqual(result.returncode, 1, result.stderr)
            lines = [line for line in result.stderr.splitlines() if 'left out' in line]
            self.assertEqual(len(lines), 1, result.stderr)
            self.assertIn(words, lines[0])
            np.testing.assert_array_equal(cli.read_rgb(self.path('o.exr')), doubled)
            result = cli.run('look', 'apply', self.path('o.exr'), '--look', look, '-o', self.path('p.exr'), '--json')
            self.assertEqual(result.returncode, 1)
            self.assertEqual(len(json.loads(result.stdout)['left_out']), 1)

    def test_a_look_of_broken_filters_alone_is_refused(self):
        self.deny('relight', self.solved, '--camera-look', self.look('nothing-like-it'), '-o', self.path('o.png'),
                  naming=['no filter that can be used', 'nothing-like-it'])

    def test_without_opengl_it_is_one_line_and_code_3(self):
        self.deny('relight', self.solved, '--camera-look', self.look('sepia'), '-o', self.path('o.png'), code=3,
                  env=NO_OPENGL, naming=['Warm', 'no OpenGL', '--camera-look none'])
        self.succeed('relight', self.solved, '--camera-look', 'none', '-o', self.path('o.png'), env=NO_OPENGL)


class Sequence(LookFrameTest):
    GRAIN = ['--filter', 'exposure,stops=0.5', '--filter', 'film-grain,amount=0.5', '--filter', 'flicker']

    def sequence(self, folder, *arguments, code=0):
        os.makedirs(self.path(folder), exist_ok=True)
        result = cli.run('relight', self.solved, '-F', '5-8', '-o', self.path(folder, 'f.%04d.exr'), '--type', 'float',
                         '--key', 'key@5=-1st', '--key', 'key@8=+1st', *arguments)
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stderr

    def hashes(self, folder):
        return [cli.sha256(self.path(folder, f'f.{n:04d}.exr')) for n in range(5, 9)]

    def test_every_node_of_a_farm_makes_the_same_bytes(self):
        self.sequence('whole', *self.GRAIN)
        for task in range(2):
            self.sequence('shared', *self.GRAIN, '--frame-index', task, '--frame-count', 2, '--workers', 1)
        self.assertEqual(self.hashes('whole'), self.hashes('shared'))

    def test_grain_goes_from_frame_to_frame_and_is_that_of_a_still_with_the_number(self):
        self.sequence('whole', *self.GRAIN)
        grain = [cli.read_rgb(self.path('whole', f'f.{n:04d}.exr')) for n in range(5, 9)]
        self.assertGreater(np.abs(grain[0] - grain[1] * (grain[0].mean() / grain[1].mean())).max(), .01)
        still = self.frame('--light', 'key=-1st', *self.GRAIN, '--frame', 5)
        np.testing.assert_array_equal(still, grain[0])

    def test_a_broken_filter_is_named_once_for_all_frames(self):
        words = self.sequence('some', '--camera-look', self.look('nothing-like-it', 'sepia'), code=1)
        self.assertEqual(words.count('left out'), 1)
        self.assertEqual(len(self.hashes('some')), 4)

    def test_a_stills_number_is_not_a_sequences(self):
        self.deny('relight', self.solved, '-F', '1-2', '--frame', 3, '-o', self.path('o.%d.exr'), naming='-F')


class OfASession(LookFrameTest):
    LOOK = {'format': 'swaplight-look', 'version': 1, 'name': 'Brighter',
            'filters': [{'filter': 'exposure', 'parameters': {'stops': 1}}, {'filter': 'sepia', 'on': False}]}

    def test_relight_sees_through_the_sessions_look(self):
        session = self.session(camera_look=self.LOOK)
        plain = self.frame()
        np.testing.assert_allclose(self.frame(source=session), 2 * plain, rtol=1e-6)
        np.testing.assert_array_equal(self.frame('--camera-look', 'none', source=session), plain)
        np.testing.assert_allclose(self.frame('--filter', 'exposure,stops=2', source=session), 4 * plain, rtol=1e-6)

    def test_files_are_named_from_the_looks_own_folder(self):
        os.makedirs(self.path('looks'))
        cli.write_image(self.path('looks', 'plate.exr'), np.full((48, 64, 3), .5))
        look = {**self.LOOK, 'folder': 'looks',
                'filters': [{'filter': 'blend', 'parameters': {'other': 'plate.exr'}}]}
        self.frame(source=self.session(camera_look=look), out='o.png')

    def test_a_look_that_cannot_be_read_is_one_line(self):
        for look, words in ((3, 'camera_look'), ({**self.LOOK, 'filters': []}, 'empty')):
            self.deny('relight', self.session(camera_look=look), '-o', self.path('o.png'), naming=['a.swaplight', words])


    def test_a_look_of_a_newer_version_is_said_and_left_alone(self):
        session = self.session(camera_look={**self.LOOK, 'version': 2})
        result = self.succeed('relight', session, '-o', self.path('out.exr'), '--type', 'float')
        self.assertIn('newer', result.stderr)
        np.testing.assert_array_equal(cli.read_rgb(self.path('out.exr')), self.frame(out='plain.exr'))


class Layers(LookFrameTest):
    def test_the_picture_under_the_look_is_a_layer_beside_those_that_add_up(self):
        out = self.path('lights.exr')
        layers = self.succeed_json('export', self.solved, '--filter', 'exposure,stops=1', '--type', 'float', '-o', out)['layers']
        total = cli.read_rgb(out)
        np.testing.assert_array_equal(sum(cli.read_rgb(out, layer) for layer in layers), total)
        np.testing.assert_allclose(cli.read_rgb(out, 'camera_look'), 2 * total, rtol=1e-6)
        self.succeed('export', self.solved, '--camera-look', 'night vision', '--naming', 'blender', '-o', out)
        self.assertIn('ViewLayer.camera_look.R', cli.read_image(out))

    def test_without_a_look_there_is_no_such_layer(self):
        self.succeed('export', self.session(camera_look=OfASession.LOOK), '--camera-look', 'none', '-o', self.path('l.exr'))
        self.assertNotIn('camera_look.R', cli.read_image(self.path('l.exr')))


if __name__ == '__main__':
    cli.main()

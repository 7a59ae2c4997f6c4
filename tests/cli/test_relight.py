"""swaplight relight"""
import json
import os

import numpy as np
import OpenImageIO as oiio
import swaplight_cli as cli


def encoded(linear):
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= .0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - .055)


class RelightTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        self.key, self.fill = self.capture.truth
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '--model', 'transport', '--float', '-q')

    def frame(self, *arguments, name='frame.exr', source=None):
        frame = self.path(name)
        self.succeed('relight', source or self.solved, *arguments, '-o', frame, '-q')
        return cli.read_rgb(frame)

    def near(self, found, expected, tolerance=1e-3):
        np.testing.assert_allclose(found, expected, atol=tolerance)

    def test_without_settings_every_light_is_unit_white(self):
        self.near(self.frame(), self.key + self.fill)

    def test_a_light_is_recolored_dimmed_and_switched_off(self):
        self.near(self.frame('--light', 'key=rgb:1/0.5/0', '--light', 'fill=off'), self.key * [1, .5, 0])
        self.near(self.frame('--light', 'key=+1st,x0.25', '--light', 'fill=-1st'), .5 * (self.key + self.fill))

    def test_light_darker_than_half_can_hold_is_kept(self):
        dim = ('--light', 'key=-20st', '--light', 'fill=-20st')
        wanted = (self.key + self.fill) * 2.**-20
        np.testing.assert_allclose(self.frame(*dim), wanted, rtol=1e-4, atol=1e-12)
        self.succeed('export', self.solved, *dim, '-o', self.path('layers.exr'), '-q')
        np.testing.assert_allclose(cli.read_rgb(self.path('layers.exr')), wanted, rtol=1e-4, atol=1e-12)

    def test_no_frame_replaces_a_picture_that_the_edits_read(self):
        mask = self.path('mask.png')
        cli.write_image(mask, np.ones((12, 16, 3), np.float32), 'uint8')
        shape = {'shape': 'picture', 'file': 'mask.png', 'x': 0, 'y': 0, 'width': 16, 'height': 12}
        with open(self.path('edits.json'), 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1,
                       'edits': [{'lights': ['key'], 'operation': 'gain', 'gain': 2, 'mask': [shape]}]}, file)
        self.frame('--edits', self.path('edits.json'))
        self.deny('relight', self.solved, '--edits', self.path('edits.json'), '-o', mask, naming='mask.png')

    def test_tone_mapping_as_a_view_and_as_a_still(self):
        bright = ('--light', 'key=+4st')  # below Hable's white
        plain = self.frame(*bright, name='plain.png')
        for options in (('--view', 'Reinhard'), ('--view', 'Hable'), ('--view', 'Logarithmic'), ('--tone', 'drago'),
                        ('--tone', 'mantiuk:scale=0.8'), ('--tone', 'reinhard')):
            toned = self.frame(*bright, *options, name='toned.png')
            self.assertGreater((plain == 1).mean(), .5)
            self.assertLess((toned == 1).mean(), .5, options)
        light = (self.key * 16 + self.fill).astype(float)
        np.testing.assert_allclose(self.frame(*bright, '--view', 'Reinhard', '--type', 'uint16', name='r.png'),
                                   encoded(light / (1 + light)), atol=2e-3)
        self.deny('relight', self.solved, '--tone', 'drago', '-o', self.path('a.exr'), naming='scene-linear')
        self.deny('relight', self.solved, '--tone', 'bright', '-o', self.path('a.png'), naming='drago, mantiuk, reinhard')
        self.deny('relight', self.solved, '--tone', 'drago', '--view', 'Hable', '-o', self.path('a.png'),
                  naming='ask for one')
        self.deny('relight', self.solved, '--tone', 'drago', '-F', '1-2', '-o', self.path('a.%04d.png'),
                  naming='flicker')

    def test_a_frame_says_what_it_holds(self):
        session = self.path('a.swaplight')
        with open(session, 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': self.solved,
                       'display': {'display': 'sRGB', 'view': 'AgX'}}, file)
        for source, options, name, contents in (
                (self.solved, [], 'a.exr', 'scene-linear light'), (self.solved, [], 'a.png', 'seen through sRGB'),
                (self.solved, ['--linear'], 'a.tif', 'scene-linear light'),
                (self.solved, ['--tone', 'drago'], 'a.png', 'seen through sRGB'),
                (self.solved, ['--view', 'AgX'], 'a.exr', 'seen through sRGB \u00b7 AgX'),
                (session, [], 'a.png', 'seen through sRGB \u00b7 AgX'), (session, [], 'a.exr', 'scene-linear light'),
                (session, ['--view', 'sRGB'], 'a.png', 'seen through sRGB'),
                (session, ['-F', '1-2'], 'a.#.png', 'seen through sRGB \u00b7 AgX')):
            found = self.succeed_json('relight', source, *options, '-o', self.path(name))
            self.assertEqual(found['contents'], contents, (source, options, name))

    def test_lights_are_set_as_at_a_desk(self):
        self.near(self.frame('--command', 'key + fill @ 50'), .5 * (self.key + self.fill))
        self.near(self.frame('--light', 'key=off', '--command', '1 on @ 25', '--command', '2 out'), .25 * self.key)
        self.deny('relight', self.solved, '--command', 'kay @ 50', '-o', self.path('a.exr'),
                  naming="--command kay @ 50: 'kay' is no light and no setting")

    def test_settings_for_one_light_add_up_over_several_options(self):
        self.near(self.frame('--light', 'key=rgb:0/1/0', '--light', 'key=+1st', '--light', 'fill=off'),
                  self.key * [0, 2, 0])

    def test_files_may_be_named_from_the_folder_they_lie_in(self):
        here = {'cwd': self.folder}
        self.succeed('relight', 'solved.exr', '-o', 'frame.exr', **here)
        self.near(cli.read_rgb(self.path('frame.exr')), self.key + self.fill)
        self.assertEqual(self.succeed_json('info', 'solved.exr', **here)['capture']['name'], 'small')
        self.succeed('solve', 'capture.json', '-o', 'again.exr', cwd=self.capture.folder)
        self.succeed('info', 'capture.json', cwd=self.capture.folder)
        self.succeed('solve', '.', '-o', '../again.exr', cwd=self.capture.folder)

    def test_a_capture_is_solved_on_the_way(self):
        self.near(self.frame('--light', 'fill=off', '--model', 'transport', source=self.capture.path), self.key)

    def test_integer_formats_are_plain_srgb_and_linear_on_request(self):
        expected = self.key + self.fill
        self.near(self.frame(name='frame.png'), encoded(expected), 3e-3)
        self.near(self.frame(name='frame.tif'), encoded(expected), 1e-4)
        self.near(self.frame(name='frame.jpg'), encoded(expected), .15)
        self.near(self.frame('--linear', '--type', 'uint16', name='frame.png'), np.clip(expected, 0, 1), 1e-4)
        self.near(self.frame(name='frame.hdr'), expected, .02)

    def test_an_hdr_is_of_rec709_as_it_cannot_say_more(self):
        self.near(self.frame('--working-space', 'acescg', name='frame.hdr'), self.key + self.fill, .02)
        self.deny('relight', self.solved, '--color-space', 'acescg', '-o', self.path('x.hdr'), naming=['x.hdr', '.exr'])

    def test_a_tiff_holds_no_half(self):
        self.deny('relight', self.solved, '--type', 'half', '-o', self.path('frame.tif'),
                  naming='a TIFF holds integers or 32-bit float, not half')
        frames = cli.run('relight', self.solved, '-F', '1-2', '--type', 'half', '-o', self.path('frame.####.tif'))
        self.assertEqual(frames.returncode, 2)
        self.assertIn('not half', frames.stderr)
        self.near(self.frame('--linear', '--type', 'float', name='frame.tif'), self.key + self.fill, 1e-5)

    def test_a_view_is_applied_to_exr_too(self):
        # As sRGB without tone mapping.
        self.near(self.frame('--display', 'sRGB', '--view', 'sRGB'), encoded(self.key + self.fill), 2e-3)

    def test_an_exr_says_its_primaries_and_its_rig(self):
        frame = self.path('frame.exr')
        self.succeed('relight', self.solved, '--light', 'key=3200K', '-o', frame)
        import OpenImageIO as oiio
        source = oiio.ImageInput.open(frame)
        spec = source.spec()
        source.close()
        np.testing.assert_allclose(spec.getattribute('chromaticities'),
                                   [.64, .33, .3, .6, .15, .06, .3127, .329], atol=1e-6)
        self.assertEqual(json.loads(spec.getattribute('swaplight/rig'))['lights'][0]['color'], '3200K')

    def test_a_rig_file_holds_and_the_command_line_overrides_it(self):
        rig = self.path('rig.json')
        result = self.succeed_json('relight', self.solved, '--light', 'key=rgb:1/0/0', '--light', 'fill=off', '-o',
                                   self.path('frame.exr'))
        with open(rig, 'w') as file:
            json.dump(result['rig'], file)
        self.near(self.frame('--rig', rig), self.key * [1, 0, 0])
        self.near(self.frame('--rig', rig, '--light', 'fill=on'), self.key * [1, 0, 0] + self.fill)

    def test_a_session_applies_its_edits(self):
        height, width = self.key.shape[:2]
        edits = [{'name': 'no key at the left', 'lights': ['key'], 'meaning': 'add', 'operation': 'fill', 'value': 0,
                  'mask': [{'shape': 'rectangle', 'x': 0, 'y': 0, 'width': width // 2, 'height': height}]}]
        session, file = self.path('edited.swaplight'), self.path('edits.json')
        with open(session, 'w') as out:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr',
                       'edits': {'size': [width, height], 'edits': edits}}, out)
        with open(file, 'w') as out:
            json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': edits}, out)
        frame = self.frame(source=session)
        np.testing.assert_array_equal(frame, self.frame('--edits', file, name='other.exr'))
        left = slice(0, width // 2 - 1)
        self.near(frame[:, left], self.fill[:, left])
        self.near(frame[:, width // 2 + 1:], (self.key + self.fill)[:, width // 2 + 1:])

    def test_a_shadow_that_is_not_there_is_said_in_words(self):
        file = self.path('edits.json')
        with open(file, 'w') as out:
            json.dump({'format': 'swaplight-edits', 'version': 1,
                       'edits': [{'lights': ['key'], 'operation': 'fill', 'value': 1,
                                  'mask': [{'shape': 'shadow', 'light': 'key', 'at': [-1, -1]}]}]}, out)
        self.deny('relight', self.solved, '--edits', file, '-o', self.path('frame.exr'),
                  naming=['there is no shadow of "key" at -1, -1'])

    def test_a_session_names_the_set_and_its_rig(self):
        session = self.path('look.swaplight')
        with open(session, 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr',
                       'rig': {'lights': [{'name': 'key', 'solo': True, 'stops': 1}, {'name': 'fill'}]}}, file)
        self.near(self.frame('--session', session, source=self.solved), 2 * self.key)
        self.near(self.frame(source=session), 2 * self.key)
        frame = self.path('frame.exr')
        self.succeed('relight', '--session', session, '-o', frame)
        self.near(cli.read_rgb(frame), 2 * self.key)

    def test_ambient_light_stays_and_can_be_dimmed(self):
        ambient = np.full_like(self.key, .05)
        self.capture.manifest['ambient'] = 'ambient.exr'
        self.capture.shots = [s + ambient for s in self.capture.shots]
        self.capture.save()
        cli.write_image(os.path.join(self.capture.folder, 'ambient.exr'), ambient)
        self.succeed('solve', self.capture.path, '-o', self.solved, '--model', 'transport', '--float', '-q')
        self.near(self.frame('--light', 'key=off', '--light', 'fill=off'), ambient)
        self.near(self.frame('--light', 'fill=off', '--ambient', '0'), self.key)

    def test_json_says_what_was_made(self):
        frame = self.path('frame.exr')
        result = self.succeed_json('relight', self.solved, '--light', 'key=3200K,+1st', '-o', frame)
        self.assertEqual((result['frame'], result['width'], result['height']), (frame, 16, 12))
        self.assertEqual(result['rig']['lights'][0]['color'], '3200K')
        self.assertEqual(result['rig']['lights'][0]['stops'], 1)

    def test_an_exr_is_compressed_as_chosen(self):
        whole = self.frame()
        for name in ('none', 'zips', 'piz', 'dwaa'):
            np.testing.assert_allclose(self.frame('--compression', name), whole, rtol=.02, atol=.01)
            source = oiio.ImageInput.open(self.path('frame.exr'))
            self.assertEqual(source.spec().getattribute('compression').split(':')[0], name)
            source.close()
        self.deny('relight', self.solved, '--compression', 'zap', '-o', self.path('new.exr'), naming=['new.exr', 'zap', 'dwaa'])
        self.deny('relight', self.solved, '--compression', 'zip', '-o', self.path('new.png'), naming=['new.png', '.exr'])

    def test_options_of_sequences_are_refused_for_a_still(self):
        out = ('-o', self.path('frame.exr'))
        self.deny('relight', self.solved, '--skip-existing', *out, naming=['--skip-existing', '-F'])
        self.deny('relight', self.solved, '--key', 'key@1=-2st', *out, naming=['--key', '-F'])
        self.deny('export', self.solved, '--key', 'key@1=off', *out, naming='--key')
        self.deny('relight', self.solved, '-F', '', '-o', self.path('frame.#.exr'), naming="''")

    def test_a_still_has_its_number_in_its_name(self):
        for name in ('a.####.exr', 'a.%04d.exr'):
            self.deny('relight', self.solved, '-o', self.path(name), naming=['number', '-F', '--frame'])
            self.assertEqual(self.succeed_json('relight', self.solved, '--frame', '12', '-o', self.path(name))['frame'],
                             self.path('a.0012.exr'))
        self.near(cli.read_rgb(self.path('a.0012.exr')), self.key + self.fill)
        self.assertEqual([name for name in os.listdir(self.folder) if name.startswith('a.')], ['a.0012.exr'])

    def test_misspelt_keys_are_warned_of(self):
        with open(self.path('edits.json'), 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1, 'shadow_threshold': {'key': .1},
                       'edits': [{'lights': ['key'], 'operation': 'move', 'rigth': .1}]}, file)
        with open(self.path('rig.json'), 'w') as file:
            json.dump({'format': 'swaplight-rig', 'version': 1, 'lights': [{'name': 'key', 'stop': -3}], 'ambent': 0}, file)
        out = ('-o', self.path('frame.exr'))
        said = self.succeed('relight', self.solved, '--edits', self.path('edits.json'), '--rig', self.path('rig.json'), *out).stderr
        for key in ('shadow_threshold', 'rigth', 'stop', 'ambent'):
            self.assertIn(f'"{key}"', said)
        for file in ('edits.json: edit 1', 'rig.json: light 1 (key)'):
            self.assertIn(file, said)
        frames = ('--rig', self.path('rig.json'), '-F', '1', '-o', self.path('frame.#.exr'))
        self.assertIn('"stop"', self.succeed('relight', self.solved, *frames).stderr)
        self.assertIn('shadow_threshold', self.succeed('shadows', self.solved, '--edits', self.path('edits.json'), *out).stderr)

    def test_a_black_frame_is_mapped_to_black(self):
        frame = self.path('frame.tif')
        for tone in ('drago', 'mantiuk', 'reinhard'):
            self.succeed('relight', self.solved, '--light', 'key=off', '--light', 'fill=off', '--tone', tone, '-o', frame)
            self.assertEqual(cli.read_rgb(frame).max(), 0)

    def test_bad_input_is_one_line(self):
        out = ('-o', self.path('frame.exr'))
        for source in (self.solved, self.capture.path):
            self.deny('relight', source, '--light', 'kicker=off', *out, naming=['kicker', 'key, fill'])
            self.deny('relight', source, '--light', 'key=lots', *out, naming=['key=lots', "'lots'", '3200K'])
            self.deny('relight', source, '--light', 'key', *out, naming='NAME=SETTING')
        self.deny('relight', self.path('none.exr'), *out, naming='none.exr')
        self.deny('relight', *out, naming='solved set')
        self.deny('relight', self.solved, naming='--output')
        self.deny('relight', self.solved, '-o', self.path('frame.webm'), naming=['frame.webm', 'exr'])
        self.deny('relight', self.solved, '-o', self.path('no/such/frame.exr'), naming='frame.exr')
        self.deny('relight', self.solved, '--view', 'Film', *out, naming=['Film', 'sRGB'])
        self.deny('relight', self.solved, '--display', 'Wall', *out, naming=['Wall', 'sRGB'])
        self.deny('relight', self.solved, '--linear', '--view', 'sRGB', *out, naming='linear')
        self.deny('relight', self.solved, '--rig', self.path('none.json'), *out, naming='none.json')
        with open(self.path('rig.json'), 'w') as file:
            file.write('{"lights": [{"name": "key", "color": "lots"}]}')
        self.deny('relight', self.solved, '--rig', self.path('rig.json'), *out, naming=['rig.json', 'key', "'lots'"])
        frame = self.path('picture.exr')
        cli.write_image(frame, self.key)
        self.deny('relight', frame, *out, naming=['picture.exr', 'capture'])


if __name__ == '__main__':
    cli.main()

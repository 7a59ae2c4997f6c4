"""One line that names the file, whatever is wrong with it, and exit code 2."""
import json
import os
import shutil
import unittest

import numpy as np
import OpenImageIO as oiio
import cli

CONFIG = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../data/color')


class LinesTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '-q')

    def with_header(self, name, **texts):
        """The solved set with other texts in its header."""
        source = oiio.ImageInput.open(self.solved)
        spec, pixels = source.spec(), np.asarray(source.read_image('float'))
        for key, value in texts.items():
            spec.attribute('swaplight/' + key, value)
        spec.set_format('float')
        spec.channelformats = ()
        out = oiio.ImageOutput.create(self.path(name))
        self.assertTrue(out.open(self.path(name), spec) and out.write_image(pixels))
        out.close()
        return self.path(name)

    def test_a_report_of_another_type(self):
        for report in ('{"message": 5}', '[]', 'null', '5', '{"warnings": {}}', '{"residual_median": "a"}',
                       '{"sigma_median": []}', '{"model": 1}'):
            path = self.with_header('report.exr', report=report)
            for verb in (['info', path], ['report', path, '-o', self.path('r.html')]):
                with self.subTest(f'{verb[0]} {report}'):
                    self.deny(*verb, naming='report.exr')
        self.succeed('info', self.with_header('report.exr', report='{"residual_median": null}'))

    def test_a_capture_of_another_type(self):
        for capture in ('[]', '{}', '{"lights": 5}'):
            self.deny('info', self.with_header('header.exr', capture=capture), naming='header.exr')

    def test_paths_that_cannot_be(self):
        os.symlink('loop', self.path('loop'))
        for path in ('/'.join(['d' * 200] * 25), 'e' * 300, self.path('loop'), self.path('solved.exr/inside')):
            for verb in (['info', path], ['relight', path, '-o', self.path('o.exr')], ['solve', path, '-o', self.path('o.exr')],
                         ['new', path, '--lights', 'a,b', '--one-at-a-time'], ['evaluate', path, path]):
                with self.subTest(f'{verb[0]} {path[:40]}'):
                    self.assertNotIn('should not', self.deny(*verb))

    def test_a_solved_set_that_is_cut(self):
        for size in (4, 100, 400):
            shutil.copy(self.solved, self.path('cut.exr'))
            os.truncate(self.path('cut.exr'), size)
            said = self.deny('relight', self.path('cut.exr'), '-o', self.path('o.exr'), naming='cut.exr')
            self.assertNotIn('neither a capture', said)

    def test_a_rig_names_its_file_once(self):
        for rig in ('{"lights": [{"name": "key", "color": 5}]}', '{"lights": [{"name": "nobody"}]}', '{'):
            with open(self.path('rig.json'), 'w') as file:
                file.write(rig)
            said = self.deny('relight', self.solved, '--rig', self.path('rig.json'), '-o', self.path('o.exr'))
            self.assertEqual(said.count('rig.json'), 1, said)

    def test_a_session_is_named_by_its_file(self):
        session = {'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr'}
        curve = {'lights': ['key'], 'operation': 'curve', 'points': [[.5, 0], [.5, 1]]}
        for more in ({'edits': {'size': [16, 12], 'edits': [curve]}}, {'rig': {'lights': [{'name': 'nobody'}]}}):
            with open(self.path('a.swaplight'), 'w') as file:
                json.dump({**session, **more}, file)
            self.deny('relight', self.path('a.swaplight'), '-o', self.path('o.exr'), naming='a.swaplight')

    def test_libraries_are_silent(self):
        cli.write_image(self.path('a.png'), np.random.default_rng(0).uniform(0, 1, (30, 40, 3)), 'uint8')
        with open(self.path('a.png'), 'rb') as file:
            data = file.read()
        import struct
        import zlib
        # A picture whose data is whole, with right checksums, and is no zlib stream.
        begin = data.index(b'IDAT') - 4
        chunk = b'IDAT' + b'\xff' * 50
        with open(self.path('a.png'), 'wb') as file:
            file.write(data[:begin] + struct.pack('>I', 50) + chunk + struct.pack('>I', zlib.crc32(chunk)) + data[-12:])
        self.deny('evaluate', self.path('a.png'), self.path('a.png'), naming='a.png')

    def test_many_channels_are_not_all_printed(self):
        spec = oiio.ImageSpec(2, 2, 2000, 'half')
        spec.channelnames = tuple(f'layer{i}.R' for i in range(2000))
        out = oiio.ImageOutput.create(self.path('many.exr'))
        self.assertTrue(out.open(self.path('many.exr'), spec) and out.write_image(np.ones((2, 2, 2000), np.float32)))
        out.close()
        said = self.succeed('info', self.path('many.exr')).stdout
        self.assertIn('and 1900 more', said)
        self.assertEqual(len(self.succeed_json('info', self.path('many.exr'))['channels']), 2000)

    def test_a_long_row_of_number_signs(self):
        said = self.deny('relight', self.solved, '-F', '1-2', '-o', '#' * 100000 + '.exr', naming='longer than 255')
        self.assertLess(len(said), 3000)

    def test_folders_whose_names_are_not_utf8(self):
        folder = os.fsencode(self.path('caf')) + b'\xe9'
        os.rename(self.path('set'), folder)
        with open(folder + b'/capture.json') as file:
            manifest = json.load(file)
        manifest.pop('name')
        with open(folder + b'/capture.json', 'w') as file:
            json.dump(manifest, file)
        solved = os.fsencode(self.path('s')) + b'\xe9.exr'
        for verb in (['solve', folder, '-o', solved], ['relight', solved, '-o', self.path('o.exr')],
                     ['export', solved, '-o', self.path('l.exr')], ['info', solved], ['info', solved, '--json']):
            result = cli.subprocess.run([cli.PROGRAM, *verb], capture_output=True)
            self.assertEqual(result.returncode, 0, result.stderr)
            result.stdout.decode('utf8')

    def test_the_same_set_is_the_same_bytes(self):
        self.succeed('solve', self.capture.path, '-o', self.path('again.exr'), '-q')
        self.assertEqual(cli.sha256(self.solved), cli.sha256(self.path('again.exr')))


class ConfigTest(cli.CliTest):
    """Colour configurations that OpenColorIO does not survive."""

    def setUp(self):
        super().setUp()
        self.solved = self.path('solved.exr')
        self.succeed('solve', cli.Capture(self.path('set')).path, '-o', self.solved, '-q')
        shutil.copytree(CONFIG, self.path('ocio'))
        with open(self.path('ocio/config.ocio')) as file:
            self.text = file.read()

    def refuse(self, text, *naming):
        config = self.path('ocio/changed.ocio')
        with open(config, 'w') as file:
            file.write(text)
        self.deny('relight', self.solved, '-o', self.path('o.png'), env={'OCIO': config}, naming=['changed.ocio', *naming])

    def with_space(self, name, transform):
        return self.text.replace('colorspaces:\n', 'colorspaces:\n' + f'  - !<ColorSpace>\n    name: {name}\n'
                                 f'    from_scene_reference: {transform}\n', 1)

    def test_a_colour_space_that_names_itself(self):
        self.assertIn('colorspaces:\n', self.text)
        self.refuse(self.with_space('loop', '!<ColorSpaceTransform> {src: scene_linear, dst: loop}'), 'leads back to itself')

    def test_two_colour_spaces_that_name_each_other(self):
        text = self.with_space('one', '!<ColorSpaceTransform> {src: two, dst: scene_linear}')
        self.text = text
        self.refuse(self.with_space('two', '!<GroupTransform> {children: [!<ColorSpaceTransform> {src: one, dst: '
                                    'scene_linear}]}'), 'leads back to itself')

    def test_a_table_that_is_a_device_or_a_pipe(self):
        os.makedirs(self.path('ocio/luts'), exist_ok=True)
        os.symlink('/dev/zero', self.path('ocio/luts/zero.cube'))
        os.mkfifo(self.path('ocio/luts/pipe.cube'))
        for name in ('zero.cube', 'pipe.cube'):
            self.refuse(self.with_space('lut', f'!<FileTransform> {{src: {name}}}'), name, 'no regular file')

    def test_a_configuration_that_is_a_pipe(self):
        os.mkfifo(self.path('pipe.ocio'))
        self.deny('relight', self.solved, '-o', self.path('o.png'), env={'OCIO': self.path('pipe.ocio')}, naming='pipe.ocio')


if __name__ == '__main__':
    cli.main()

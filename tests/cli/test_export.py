"""swaplight export: layers for compositors"""
import glob
import json
import os
import shutil
import subprocess
import sys
import unittest
import zlib

import numpy as np
import OpenImageIO as oiio
import swaplight_cli as cli

HERE = os.path.dirname(os.path.abspath(__file__))
TIMECODE = oiio.TypeDesc(oiio.BASETYPE.UINT, oiio.AGGREGATE.SCALAR, oiio.VECSEMANTICS.TIMECODE, 2)


def spec_of(path, part=0):
    source = oiio.ImageInput.open(path)
    assert source, oiio.geterror()
    source.seek_subimage(part, 0)
    spec = source.spec()
    source.close()
    return spec


def shot(path, pixels):
    """A photograph as a camera department delivers it: alpha, depth, a matte, timecode, lens."""
    height, width, _ = pixels.shape
    extra = np.stack([np.linspace(0, 1, height * width).reshape(height, width),
                      np.linspace(1, 1000, height * width).reshape(height, width),
                      (np.arange(height * width).reshape(height, width) % 2)], -1)
    spec = oiio.ImageSpec(width, height, 6, 'float')
    spec.channelnames = ('R', 'G', 'B', 'A', 'Z', 'matte.hero')
    spec.attribute('PixelAspectRatio', 2.0)
    spec.attribute('smpte:TimeCode', TIMECODE, (0x01020304, 7))
    spec.attribute('ExposureTime', 0.02)
    spec.attribute('FNumber', 2.8)
    spec.attribute('studio/slate', '12A take 3')
    spec.attribute('studio/reel', 7)
    spec.attribute('DateTime', '2026:01:02 03:04:05')
    output = oiio.ImageOutput.create(path)
    assert output.open(path, spec)
    assert output.write_image(np.concatenate([pixels, extra], -1).astype(np.float32))
    output.close()
    return extra.astype(np.float32)


class ExportTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'), names=('key', 'fill', 'back'), height=24, width=33)
        self.solved = self.path('solved.exr')

    def solve(self):
        self.succeed('solve', self.capture.path, '-o', self.solved, '--model', 'transport', '--float', '-q')

    def export(self, *arguments, name='layers.exr', source=None):
        self.result = self.succeed_json('export', source or self.solved, *arguments, '-o', self.path(name))
        return cli.read_image(self.path(name))

    def summed(self, channels, color):
        total = np.zeros(1, np.float32)
        for layer in self.result['layers']:
            total = total + channels[f'{layer}.{color}']
        return total

    def test_extensions_in_capitals(self):
        self.solve()
        for name, begins in (('LOOK.CUBE', b'# The global'), ('look.Cc', b'<?xml'), ('LAYERS.EXR', b'\x76\x2f\x31\x01')):
            self.succeed('export', self.solved, '-o', self.path(name))
            with open(self.path(name), 'rb') as file:
                self.assertTrue(file.read(200).lstrip().startswith(begins), name)
        shutil.copy(self.solved, self.path('SOLVED.EXR'))
        self.succeed('relight', self.path('SOLVED.EXR'), '-o', self.path('FRAME.PNG'))
        os.rename(self.path('LOOK.CUBE'), self.path('TABLE.CUBE'))
        self.succeed('relight', self.solved, '--filter', 'lut,table=' + self.path('TABLE.CUBE'), '-o', self.path('seen.png'))

    def test_float_layers_add_up_to_the_picture_to_the_bit(self):
        self.solve()
        for more in ([], ['--multipart'], ['--compression', 'piz'], ['--light', 'key=3200K,+1.3st', '--light', 'back=#4060ff']):
            channels = self.export('--type', 'float', *more)
            for color in 'RGB':
                np.testing.assert_array_equal(self.summed(channels, color), channels[color], str(more))

    def test_half_layers_add_up_within_half_a_step(self):
        self.solve()
        channels = self.export('--light', 'key=+2st')
        for color in 'RGB':
            np.testing.assert_array_equal(self.summed(channels, color).astype(np.float16), channels[color].astype(np.float16))

    def test_layers_are_the_lights_under_the_rig(self):
        self.solve()
        channels = self.export('--type', 'float', '--light', 'key=rgb:2/1/0', '--light', 'fill=off')
        key = np.stack([channels['key.' + c] for c in 'RGB'], -1)
        np.testing.assert_allclose(key, self.capture.truth[0] * [2, 1, 0], atol=2e-5)
        self.assertFalse(channels['fill.G'].any())

    def test_what_a_compression_loses_is_said(self):
        self.solve()
        for compression, pixel_type, lossy in (('zip', 'half', 0), ('pxr24', 'half', 0), ('pxr24', 'float', 1),
                                               ('b44', 'half', 1), ('b44a', 'float', 0), ('dwaa', 'half', 1),
                                               ('dwab:45', 'float', 1)):
            said = self.succeed('export', self.solved, '--compression', compression, '--type', pixel_type, '-o',
                                self.path('a.exr')).stderr
            self.assertIn('add up to the picture', said)
            self.assertEqual('what the compression loses' in said, bool(lossy), (compression, pixel_type))

    def test_oiiotool_adds_them_up(self):
        self.solve()
        self.export('--type', 'float')
        layers = [f'{self.path("layers.exr")} --ch {light}.R,{light}.G,{light}.B' for light in self.result['layers']]
        command = f'oiiotool {layers[0]} {layers[1]} --add {layers[2]} --add {self.path("layers.exr")} --ch R,G,B ' \
                  '--fail 0 --warn 0 --diff'
        outcome = subprocess.run(command.split(), capture_output=True, text=True)
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)

    def test_types_compressions_and_beta_as_chosen(self):
        self.solve()
        for name in ('none', 'rle', 'zips', 'zip', 'piz', 'pxr24', 'b44', 'dwaa'):
            self.export('--compression', name)
            self.assertTrue(spec_of(self.path('layers.exr')).getattribute('compression').startswith(name), name)
        channels = self.export('--beta', '--quality', '--data-type', 'half')
        self.assertTrue({'beta.key', 'quality.residual', 'quality.flags'} <= set(channels))
        spec = spec_of(self.path('layers.exr'))
        self.assertEqual({str(spec.channelformat(i)) for i in range(spec.nchannels)}, {'half'})
        self.export('--multipart')
        self.assertEqual([spec_of(self.path('layers.exr'), i).getattribute('name') for i in range(4)],
                         ['rgb', 'key', 'fill', 'back'])

    def test_header_tells_where_it_comes_from(self):
        self.solve()
        self.export('--light', 'key=3200K')
        spec = spec_of(self.path('layers.exr'))
        self.assertEqual(json.loads(spec.getattribute('swaplight/capture'))['name'], 'small')
        self.assertEqual(json.loads(spec.getattribute('swaplight/rig'))['lights'][0]['color'], '3200K')
        self.assertIn('message', json.loads(spec.getattribute('swaplight/solver')))
        source = json.loads(spec.getattribute('swaplight/source'))[0]
        expected = subprocess.run(['sha256sum', self.solved], capture_output=True, text=True).stdout.split()[0]
        self.assertEqual((source['file'], source['sha256']), ('solved.exr', expected))
        np.testing.assert_allclose(spec.getattribute('chromaticities'), [.64, .33, .3, .6, .15, .06, .3127, .329], atol=1e-6)

    def carried(self, path, extra, tolerance=0):
        spec, channels = spec_of(path), cli.read_image(path)
        self.assertEqual(spec.getattribute('PixelAspectRatio'), 2)
        self.assertEqual(spec.getattribute('studio/slate'), '12A take 3')
        self.assertEqual(spec.getattribute('studio/reel'), 7)
        self.assertAlmostEqual(spec.getattribute('ExposureTime'), .02)
        self.assertAlmostEqual(spec.getattribute('FNumber'), 2.8, places=6)
        self.assertEqual(spec.getattribute('DateTime'), '2026:01:02 03:04:05')
        self.assertEqual(tuple(np.uint32(v) for v in spec.getattribute('smpte:TimeCode', TIMECODE) or ()) or
                         spec.getattribute('smpte:TimeCode'), tuple(np.uint32(v) for v in (0x01020304, 7)))
        for name, pixels in zip(('A', 'Z', 'matte.hero'), np.moveaxis(extra, -1, 0)):
            np.testing.assert_array_equal(channels[name], pixels, name)

    def test_the_time_code_goes_on_from_frame_to_frame(self):
        for s, pixels in zip(self.capture.manifest['shots'], self.capture.shots):
            shot(os.path.join(self.capture.folder, s['image']), pixels)
        self.solve()

        def time_code(frame):
            found = spec_of(self.path(f'out.{frame:04d}.exr')).getattribute('smpte:TimeCode')
            return found if isinstance(found, str) else tuple(int(v) & 0xffffffff for v in found)
        self.succeed('relight', self.solved, '-F', '1001-1025', '-o', self.path('out.####.exr'), '-q')
        first, second, last = (time_code(frame) for frame in (1001, 1002, 1025))
        self.assertNotEqual(first, second)
        if isinstance(first, str):
            self.assertEqual((first, second, last), ('01:02:03:04', '01:02:03:05', '01:02:04:04'))
        else:
            self.assertEqual([first[0], second[0], last[0]], [0x01020304, 0x01020305, 0x01020404])
        self.succeed('relight', self.solved, '-F', '1001-1025', '--frame-index', '1', '--frame-count', '5', '-o',
                     self.path('out.####.exr'), '-q')
        self.assertEqual(time_code(1025), last, 'a task of an array job counts from the whole range')
        self.succeed('relight', self.solved, '-F', '1025', '--timecode-frame', '1001', '-o', self.path('out.####.exr'), '-q')
        self.assertEqual(time_code(1025), last, 'a farm that cuts the range itself says where it begins')
        self.deny('relight', self.solved, '-o', self.path('out.exr'), '--timecode-frame', '3', naming='--timecode-frame')

    def test_a_cropped_set_keeps_the_header(self):
        self.capture.manifest['crop'] = [3, 2, 20, 16]
        self.capture.save()
        for s, pixels in zip(self.capture.manifest['shots'], self.capture.shots):
            shot(os.path.join(self.capture.folder, s['image']), pixels)
        self.solve()
        spec = spec_of(self.solved)
        self.assertEqual((spec.width, spec.full_width, spec.getattribute('PixelAspectRatio'),
                          spec.getattribute('studio/slate')), (20, 20, 2, '12A take 3'))
        self.assertNotIn('Z', spec.channelnames)

    def test_what_a_camera_look_puts_outside_of_the_data_window_is_kept(self):
        for s, pixels in zip(self.capture.manifest['shots'], self.capture.shots):
            cli.write_image(os.path.join(self.capture.folder, s['image']), pixels[:, :20], window=(10, 0, 33, 24))
        self.solve()
        for more, x, width in (((), 10, 20), (('--filter', 'mirror'), 3, 27)):
            self.succeed('export', self.solved, *more, '-o', self.path('layers.exr'), '-q')
            spec = spec_of(self.path('layers.exr'))
            self.assertEqual((spec.x, spec.width, spec.full_width), (x, width, 33), more)

    def test_a_still_of_layers_has_its_number(self):
        self.solve()
        self.succeed('export', self.solved, '--frame', '7', '-o', self.path('layers.####.exr'), '-q')
        self.assertTrue(os.path.exists(self.path('layers.0007.exr')))
        self.deny('export', self.solved, '-o', self.path('layers.####.exr'), naming='--frame')

    def test_metadata_and_unknown_channels_go_from_shot_to_solved_set_session_frame_and_layers(self):
        folder = self.capture.folder
        extra = [shot(os.path.join(folder, s['image']), pixels)
                 for s, pixels in zip(self.capture.manifest['shots'], self.capture.shots)][0]
        self.solve()
        self.carried(self.solved, extra)
        session = self.path('look.swaplight')
        with open(session, 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr'}, file)
        for verb in ('export', 'relight'):
            for source in (self.capture.path, self.solved, session):
                for more in ([], ['--multipart'], ['--compression', 'piz']) if verb == 'export' else [[]]:
                    out = self.path('out.exr')
                    self.succeed(verb, source, '-o', out, *more)
                    self.carried(out, extra)
        for verb in 'beta', 'shadows':
            self.succeed(verb, self.solved, '-o', self.path('maps.exr'))
            spec = spec_of(self.path('maps.exr'))
            self.assertEqual((spec.getattribute('PixelAspectRatio'), spec.getattribute('studio/slate')), (2, '12A take 3'))
            self.assertFalse({'A', 'Z', 'matte.hero'} & set(spec.channelnames), 'maps are no picture')

    def test_a_smaller_data_window_stays_and_can_be_chosen(self):
        for s, pixels in zip(self.capture.manifest['shots'], self.capture.shots):
            spec = oiio.ImageSpec(20, 10, 3, 'float')
            spec.x, spec.y, spec.full_width, spec.full_height = 5, 6, 33, 24
            path = os.path.join(self.capture.folder, s['image'])
            output = oiio.ImageOutput.create(path)
            assert output.open(path, spec)
            assert output.write_image(np.ascontiguousarray(pixels[6:16, 5:25].astype(np.float32)))
            output.close()
        self.solve()

        def window(path):
            spec = spec_of(path)
            return spec.x, spec.y, spec.width, spec.height, spec.full_width, spec.full_height

        for compression in ('zip', 'zips', 'piz'):
            self.export('--compression', compression)
            self.assertEqual(window(self.path('layers.exr')), (5, 6, 20, 10, 33, 24))
            self.export('--compression', compression, '--data-window', '2,3,4,5', '--type', 'float')
            self.assertEqual(window(self.path('layers.exr')), (2, 3, 4, 5, 33, 24))
        self.export('--data-window', 'full')
        self.assertEqual(window(self.path('layers.exr')), (0, 0, 33, 24, 33, 24))
        for verb in 'beta', 'shadows':
            self.succeed(verb, self.solved, '-o', self.path('maps.exr'))
            self.assertEqual(window(self.path('maps.exr')), (5, 6, 20, 10, 33, 24), verb)
        out = ('-o', self.path('no.exr'))
        self.deny('export', self.solved, '--data-window', '30,0,20,10', *out, naming='data window')
        self.deny('export', self.solved, '--data-window', 'lots', *out, naming='lots')

    def test_names_survive_nuke(self):
        capture = cli.Capture(self.path('names'), names=('depth', 'Alpha', 'key_2'))
        self.succeed('solve', capture.path, '-o', self.path('names.exr'), '-q')
        self.export(source=self.path('names.exr'))
        self.assertEqual(self.result['layers'], ['light_depth', 'light_Alpha', 'key_2'])

    def test_an_hdr_png_says_how_it_is_encoded(self):
        self.solve()
        for display, points in (('Rec.2100 PQ', b'\x09\x10\x00\x01'), ('Rec.2100 HLG', b'\x09\x12\x00\x01')):
            path = self.path('hdr.png')
            self.succeed('relight', self.solved, '--display', display, '--type', 'uint16', '-o', path)
            with open(path, 'rb') as file:
                data = file.read()
            chunks, at = {}, 8
            while at < len(data):
                size, kind = int.from_bytes(data[at:at + 4], 'big'), data[at + 4:at + 8]
                body = data[at + 8:at + 8 + size]
                self.assertEqual(zlib.crc32(kind + body), int.from_bytes(data[at + 8 + size:at + 12 + size], 'big'), kind)
                chunks.setdefault(kind, body)
                at += 12 + size
            self.assertEqual(list(chunks)[:2], [b'IHDR', b'cICP'])
            self.assertEqual(chunks[b'cICP'], points)
            self.assertNotIn(b'iCCP', chunks)
            self.assertEqual(chunks[b'IHDR'][8], 16)
            self.assertGreater(cli.read_rgb(path).mean(), .2)
        self.assertEqual([name for name in os.listdir(self.folder) if name.endswith('.tmp.png')], [])

    def test_layers_and_frames_in_other_primaries_keep_white_white_and_add_up(self):
        self.solve()
        self.succeed('export', self.solved, '--color-space', 'acescg', '--type', 'float', '-o', self.path('ap1.exr'))
        own, ap1 = (cli.read_image(path) for path in (self.solved, self.path('ap1.exr')))
        matrix = np.array([[.613097, .339523, .047380], [.070194, .916354, .013452], [.020616, .109570, .869815]])
        for light in 'key', 'fill', 'back':
            pixels = np.stack([own[f'{light}.{c}'] for c in 'RGB'], -1)
            np.testing.assert_allclose(np.stack([ap1[f'{light}.{c}'] for c in 'RGB'], -1), pixels @ matrix.T, atol=1e-3)
        for c in 'RGB':
            np.testing.assert_array_equal(ap1[c], ap1['key.' + c] + ap1['fill.' + c] + ap1['back.' + c])
        np.testing.assert_allclose(matrix.sum(1), 1, atol=1e-4)
        self.assertAlmostEqual(spec_of(self.path('ap1.exr')).getattribute('chromaticities')[0], .713, places=4)
        self.succeed('relight', self.solved, '--color-space', 'acescg', '-o', self.path('frame.exr'))
        np.testing.assert_allclose(cli.read_rgb(self.path('frame.exr')), np.stack([ap1[c] for c in 'RGB'], -1), atol=2e-3)
        self.succeed('solve', self.capture.path, '-o', self.path('solved_ap1.exr'), '--model', 'transport', '--float',
                     '--color-space', 'acescg', '-q')
        self.succeed('export', self.path('solved_ap1.exr'), '--type', 'float', '-o', self.path('again.exr'))
        again = cli.read_image(self.path('again.exr'))
        for name in ap1:
            np.testing.assert_allclose(again[name], ap1[name], atol=1e-5)
        self.succeed('relight', self.path('solved_ap1.exr'), '--type', 'uint16', '-o', self.path('a.png'))
        self.succeed('relight', self.solved, '--type', 'uint16', '-o', self.path('b.png'))
        np.testing.assert_allclose(cli.read_rgb(self.path('a.png')), cli.read_rgb(self.path('b.png')), atol=2e-4)
        self.deny('solve', self.capture.path, '--color-space', 'srgb', '-o', self.path('c.exr'), naming='acescg')
        self.deny('relight', self.solved, '--color-space', 'film', '-o', self.path('a.exr'), naming=['"film"', 'acescg'])
        self.deny('export', self.solved, '--color-space', 'film', '-o', self.path('a.exr'), naming=['"film"', 'acescg'])

    def test_codes_and_data_are_no_light(self):
        self.solve()
        for space in ('srgb', 'acescct', 'arri_logc_ei800_awg', 'raw'):
            for verb in ('relight', 'export'):
                self.deny(verb, self.solved, '--color-space', space, '-o', self.path('a.exr'),
                          naming=[f'"{space}"', 'not scene-linear light', 'acescg'])
        self.deny('relight', self.solved, '--linear', '--color-space', 'srgb', '-o', self.path('a.png'),
                  naming='not scene-linear light')

    def test_primaries_are_said_of_every_linear_space(self):
        self.solve()
        rec2020 = [.708, .292, .170, .797, .131, .046, .3127, .3290]
        for options in (['relight'], ['export'], ['export', '--multipart'], ['export', '--compression', 'piz']):
            self.succeed(*options, self.solved, '--color-space', 'lin_rec2020', '-o', self.path('a.exr'))
            said = spec_of(self.path('a.exr')).getattribute('chromaticities')
            np.testing.assert_allclose(said, rec2020, atol=2e-4)

    def test_luminance_before_and_after_as_a_plot(self):
        self.solve()
        plot = self.path('histogram.png')
        found = self.succeed_json('relight', self.solved, '--light', 'key=+10st', '-o', self.path('a.exr'),
                                  '--histogram', plot)['luminance']
        self.assertGreater(found['after']['median_stops'], found['before']['median_stops'] + 8)
        self.assertAlmostEqual(sum(found['after']['share']) + found['after']['below'] + found['after']['above'], 1, places=4)
        self.assertGreater(cli.read_rgb(plot).std(), .05)
        self.deny('relight', self.solved, '-F', '1-2', '-o', self.path('a.####.exr'), '--histogram', plot, naming='one frame')

    def test_png_tiff_and_jpeg_embed_the_displays_profile(self):
        self.solve()
        for name, arguments, word in (('a.png', [], 'sRGB'), ('a.tif', ['--display', 'P3-D65', '--view', 'P3-D65'], 'P3'),
                                      ('a.jpg', ['--display', 'Rec.709', '--view', 'ACES SDR'], '709')):
            self.succeed('relight', self.solved, *arguments, '-o', self.path(name))
            spec = spec_of(self.path(name))
            self.assertIn(word, spec.getattribute('ICCProfile:profile_description') or '', name)
        self.succeed('relight', self.solved, '--view', 'Log', '-o', self.path('log.png'))
        self.assertIsNone(spec_of(self.path('log.png')).getattribute('ICCProfile:profile_description'))

    def test_the_global_part_of_a_look_is_a_cube_or_a_correction_and_says_so(self):
        self.solve()
        lights = [f'--light={name}=rgb:0.5/1/2' for name in ('key', 'fill', 'back')]
        result = self.succeed_json('export', self.solved, *lights, '-o', self.path('look.ccc'))
        np.testing.assert_allclose(result['gain'], [.5, 1, 2], rtol=1e-5)
        self.assertAlmostEqual(result['explained'], 1, places=5)
        with open(self.path('look.ccc')) as file:
            self.assertIn('not in this file', file.read())
        result = self.succeed_json('export', self.solved, '--light', 'key=off', '-o', self.path('look.cube'), '--view', 'ACES SDR')
        self.assertLess(result['explained'], .9999)
        with open(self.path('look.cube')) as file:
            lines = file.read().splitlines()
        rows = [line for line in lines if line[0].isdigit()]
        self.assertEqual(len(rows), 33 ** 3)
        self.assertIn('not in this file', lines[0])
        # The table gives what the view gives, at its own points: ACEScct 0.5 is one of them.
        grey = 2 ** (.5 * 17.52 - 9.72)
        index = 16 + 33 * 16 + 33 * 33 * 16
        found = np.array(rows[index].split(), float)
        self.assertTrue((0 < found).all() and (found < 1).all())
        plain = self.succeed_json('export', self.solved, '-o', self.path('plain.cube'), '--display', 'sRGB', '--view', 'sRGB')
        np.testing.assert_allclose(plain['gain'], 1, rtol=1e-5)
        with open(self.path('plain.cube')) as file:
            rows = [line for line in file.read().splitlines() if line[0].isdigit()]
        encoded = 1.055 * grey ** (1 / 2.4) - .055
        np.testing.assert_allclose(np.array(rows[index].split(), float), encoded, atol=2e-5)

    def test_bad_input_is_one_line(self):
        self.solve()
        out = ('-o', self.path('x.exr'))
        self.deny('export', self.solved, '--naming', 'maya', *out, naming=['maya', 'blender'])
        self.deny('export', self.solved, '--type', 'uint8', *out, naming=['uint8', 'half'])
        self.deny('export', self.solved, '--compression', 'best', *out, naming=['best', 'zip'])
        self.deny('export', self.solved, '--naming', 'blender', '--multipart', *out, naming='multi-part')
        self.deny('export', self.solved, '-o', self.path('x.png'), naming='x.exr')
        self.deny('export', self.solved, '-o', self.path('x.cube'), '--view', 'None', naming='None')

    def test_blender_adds_its_light_groups_up(self):
        if not shutil.which('blender'):
            print('SKIPPED: blender is not installed (apt install blender)', file=sys.stderr)
            self.skipTest('blender is not installed')
        self.solve()
        self.succeed('export', self.solved, '--naming', 'blender', '--type', 'float', '--light', 'key=3200K',
                     '-o', self.path('b.exr'))
        out = subprocess.run(['blender', '--background', '--factory-startup', '--python-exit-code', '3', '--python',
                              os.path.join(HERE, 'blender_sum.py'), '--', self.path('b.exr'), self.path('out'),
                              '33', '24', 'key', 'fill', 'back'], capture_output=True, text=True, timeout=300)
        self.assertEqual(out.returncode, 0, out.stdout + out.stderr)
        expected = cli.read_image(self.path('b.exr'))
        total = cli.read_rgb(glob.glob(self.path('out', 'sum*.exr'))[0])
        difference = cli.read_rgb(glob.glob(self.path('out', 'difference*.exr'))[0])
        np.testing.assert_allclose(total, np.stack([expected[f'ViewLayer.Combined.{c}'] for c in 'RGB'], -1), atol=1e-6)
        self.assertLess(np.abs(difference).max(), 1e-6)


if __name__ == '__main__':
    cli.main()

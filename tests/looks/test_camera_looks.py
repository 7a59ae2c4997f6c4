"""swaplight look: camera shaders from the command line."""
import json
import os

import numpy as np
import OpenImageIO as oiio

from cli import CliTest, main, read_image, read_rgb, write_image

SOFT = '''/*{"INPUTS": [{"NAME": "inputImage", "TYPE": "image"}, {"NAME": "amount", "TYPE": "float", "DEFAULT": 1}]}*/
void main() {
  gl_FragColor = amount * IMG_THIS_PIXEL(inputImage);
}
'''


def ramp(height=36, width=64, highest=4):
    x = np.linspace(0, highest, width)[None, :, None]
    y = np.linspace(.2, 1, height)[:, None, None]
    return (x * y * np.array([1, .8, .6])).astype(np.float32)


def srgb_codes(light):
    light = np.maximum(light, 0)
    return np.where(light <= .0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - .055)


class CameraLookTest(CliTest):
    def setUp(self):
        super().setUp()
        os.environ['XDG_DATA_HOME'] = self.path('data')
        self.frame = self.path('frame.exr')
        write_image(self.frame, ramp())

    def write(self, name, text):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), 'w') as file:
            file.write(text)
        return self.path(name)

    def apply(self, *filters, output='out.exr', frame=None, options=()):
        arguments = [part for filter in filters for part in ('--filter', filter)]
        self.succeed('look', 'apply', frame or self.frame, *arguments, '-o', self.path(output), *options)
        return read_rgb(self.path(output))


class Library(CameraLookTest):
    def test_at_least_sixty_filters_say_what_they_do(self):
        filters = self.succeed_json('look', 'list')['filters']
        built_in = [f for f in filters if f['built_in']]
        self.assertGreaterEqual(len(built_in), 60)
        for filter in built_in:
            self.assertGreater(len(filter['description']), 10, filter['name'])
            self.assertTrue(filter['categories'], filter['name'])

    def test_every_filter_compiles_draws_what_is_finite_and_looks_no_further_than_its_halo(self):
        """On dark to 65504, negative, infinite and missing values; whole against parts."""
        folder = os.path.dirname(os.path.dirname(self.succeed_json('look', 'show', 'exposure')['file']))
        result = self.succeed_json('look', 'lint', folder)
        self.assertGreaterEqual(result['fine'], 60)
        self.assertEqual(result['broken'], 0)

    def test_endings_in_capitals(self):
        self.write('data/swaplight/filters/SOFTER.FS', SOFT)
        self.assertTrue(self.succeed_json('look', 'show', 'softer')['file'].endswith('SOFTER.FS'))
        self.assertTrue(self.succeed_json('look', 'show', self.write('MINE.FS', SOFT))['file'].endswith('MINE.FS'))
        self.write('data/swaplight/filters/MY-SEPIA.FS', SOFT)
        self.assertEqual(self.succeed_json('look', 'keep', 'sepia,amount=0.9')['filter'], 'my-sepia-2')
        broken = self.write('data/swaplight/filters/TORN.FS', 'no header')
        self.deny('look', 'show', 'torn', naming=broken)

    def test_a_persons_own_filter_is_found_and_hides_one_of_its_name(self):
        self.write('data/swaplight/filters/Exposure.fs', SOFT)
        self.assertEqual(self.succeed_json('look', 'show', 'exposure')['file'],
                         self.path('data/swaplight/filters/Exposure.fs'))
        self.write('data/ISF/My Soft.fs', SOFT)
        self.assertEqual(self.succeed_json('look', 'list', 'my-soft')['filters'][0]['name'], 'My Soft')

    def test_a_changed_filter_is_kept_in_the_library(self):
        made = self.succeed_json('look', 'keep', 'split-tone,amount=0.9,shadows=0:0:1')
        self.assertEqual(made['filter'], 'my-split-tone')
        kept = {p['name']: p for p in self.succeed_json('look', 'show', 'my-split-tone')['parameters']}
        self.assertAlmostEqual(kept['amount']['default'], .9, delta=1e-6)
        self.assertEqual(kept['shadows']['default'], [0, 0, 1, 1])
        own = {p['name']: p for p in self.succeed_json('look', 'show', 'split-tone')['parameters']}
        self.assertEqual(kept['amount']['max'], own['amount']['max'])
        self.assertEqual(own['amount']['default'], .5)
        np.testing.assert_array_equal(self.apply('my-split-tone'), self.apply('split-tone,amount=0.9,shadows=0:0:1'))
        self.assertEqual(self.succeed_json('look', 'keep', 'my-split-tone,amount=0')['filter'], 'my-split-tone-2')
        self.deny('look', 'keep', 'sepia', '--name', 'my-split-tone', naming='already')
        self.deny('look', 'keep', 'sepia', '--name', '../x', naming='name of a file')
        self.deny('look', 'keep', 'sepia,amount=7', naming='expected 0 to 1')

    def test_a_broken_file_is_skipped_and_named(self):
        broken = self.write('data/swaplight/filters/Broken.fs', '/*{ "INPUTS": [ }*/')
        result = self.succeed('look', 'list')
        self.assertIn(broken + ': the header: line 1, column ', result.stderr)
        self.assertIn('exposure', result.stdout)

    def test_three_hundred_filters(self):
        for i in range(300):
            self.write(f'data/ISF/many {i}.fs', SOFT)
        self.assertGreaterEqual(len(self.succeed_json('look', 'list')['filters']), 360)


class Apply(CameraLookTest):
    def test_light_goes_through_scene_linear_filters_as_light(self):
        out = self.apply('exposure,stops=2', options=['--type', 'float'])
        np.testing.assert_allclose(out, ramp() * 4, rtol=1e-6)

    def test_codes_are_filtered_behind_the_view(self):
        linear = ramp(highest=1)
        write_image(self.frame, linear)
        out = self.apply('negative', output='out.png')
        codes = np.where(linear <= .0031308, linear * 12.92, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - .055)
        np.testing.assert_allclose(out, 1 - codes, atol=1 / 255)

    def test_the_order_counts(self):
        first = self.apply('negative', 'threshold,level=0.6', output='a.png')
        second = self.apply('threshold,level=0.6', 'negative', output='b.png')
        self.assertGreater(np.abs(first - second).max(), .9)

    def test_blur_before_edges_changes_the_edges(self):
        """The dissertation's figure 4.3: one filter's sigma changes what those after it show."""
        random = np.random.default_rng(1)
        write_image(self.frame, random.uniform(0, 1, (72, 128, 3)))
        edges = [self.apply('grayscale', f'gaussian-blur,sigma={sigma}', 'sobel', 'threshold,level=0.1',
                            output='e.png').mean() for sigma in (1, 40)]
        self.assertGreater(edges[0], .2)
        self.assertLess(edges[1], edges[0] / 4)

    def test_parts_give_the_same_picture(self):
        write_image(self.frame, np.random.default_rng(2).uniform(0, 2, (160, 240, 3)))
        chain = ['exposure,stops=0.5', 'halation', 'film-grain', 'local-contrast,radius=10', 'sobel', 'negative']
        whole = self.apply(*chain, output='a.exr', options=['--type', 'float'])
        parts = self.apply(*chain, output='b.exr', options=['--type', 'float', '--tile', '64'])
        np.testing.assert_allclose(parts, whole, atol=1e-3)

    def test_bloom_and_halation_add_no_light(self):
        pixels = np.full((90, 160, 3), .05, np.float32)
        pixels[40:50, 75:85] = 50
        write_image(self.frame, pixels)
        for filter in ('bloom', 'halation', 'glare', 'diffusion', 'gaussian-blur', 'lens-blur,radius=20'):
            out = self.apply(filter, options=['--type', 'float'])
            self.assertGreater(np.abs(out - pixels).max(), .1, filter)
            np.testing.assert_allclose(out.mean(), pixels.mean(), rtol=.01, err_msg=filter)

    def test_grain_follows_from_the_frame_number_alone(self):
        options = ['--type', 'float', '--frame']
        first = self.apply('film-grain,amount=0.5', options=[*options, '7'])
        np.testing.assert_array_equal(self.apply('film-grain,amount=0.5', options=[*options, '7']), first)
        self.assertGreater(np.abs(self.apply('film-grain,amount=0.5', options=[*options, '8']) - first).max(), .01)
        write_image(self.frame, np.full((360, 640, 3), .18))
        grain = self.apply('film-grain,amount=0.25', options=[*options, '1'])
        self.assertAlmostEqual(grain.mean() / .18, 1, delta=.01)

    def test_chroma_key_puts_the_plate_behind_and_gives_the_matte(self):
        front = np.full((40, 60, 3), [.1, .7, .2], np.float32)
        front[:, 30:] = [.6, .4, .35]
        write_image(self.path('front.png'), front, 'uint8')
        write_image(self.path('plate.png'), np.full((40, 60, 3), .5), 'uint8')
        out = self.apply(f'chroma-key,plate={self.path("plate.png")}', frame=self.path('front.png'), output='k.png')
        np.testing.assert_allclose(out[:, :29], .5, atol=.01)
        np.testing.assert_allclose(out[:, 31:], front[:, 31:], atol=.01)
        matte = self.apply('chroma-key,show=1', frame=self.path('front.png'), output='m.png')
        np.testing.assert_array_equal(matte[0, [5, 50], 0], [0, 1])
        self.apply('chroma-key,show=2', frame=self.path('front.png'), output='a.png', options=['--alpha'])
        np.testing.assert_array_equal(read_image(self.path('a.png'))['A'][0, [5, 50]], [0, 1])

    def test_an_exr_has_its_alpha_multiplied_in_and_is_read_so(self):
        """PNG has not."""
        x = np.linspace(0, 1, 60)[None, :, None]
        front = ((1 - x) * [.1, .7, .2] + x * [.6, .4, .35]) * np.ones((40, 1, 1))
        write_image(self.path('front.exr'), front)
        key = 'chroma-key,key=#59dc7c,spill=0,show=2'
        exr = self.apply(key, frame=self.path('front.exr'), options=['--alpha', '--type', 'float'])
        alpha = read_image(self.path('out.exr'))['A'][..., None]
        self.assertEqual((alpha.min(), alpha.max()), (0, 1))
        self.assertTrue(((0 < alpha) & (alpha < 1)).any())
        np.testing.assert_allclose(exr, front * alpha, atol=1e-5)
        self.apply('exposure,stops=1', frame=self.path('out.exr'), output='twice.exr', options=['--alpha', '--type', 'float'])
        np.testing.assert_allclose(read_rgb(self.path('twice.exr')), 2 * front * alpha, atol=1e-5)
        png = self.apply(key, frame=self.path('front.exr'), output='a.png', options=['--alpha', '--type', 'uint16'])
        np.testing.assert_allclose(png, srgb_codes(front), atol=1e-3)

    def test_what_else_a_frame_holds_goes_along(self):
        pixels = np.concatenate([ramp()[6:16, 5:25], np.full((10, 20, 1), .5), np.full((10, 20, 1), 7)], -1)
        spec = oiio.ImageSpec(20, 10, 5, 'float')
        spec.channelnames = ('R', 'G', 'B', 'A', 'id')
        spec.x, spec.y, spec.full_width, spec.full_height = 5, 6, 64, 36
        spec.attribute('PixelAspectRatio', 2.0)
        spec.attribute('studio/slate', '12A take 3')
        output = oiio.ImageOutput.create(self.frame)
        assert output.open(self.frame, spec) and output.write_image(np.ascontiguousarray(pixels, np.float32))
        output.close()
        for options in ((), ('--alpha',)):
            out = self.apply('exposure,stops=1', options=[*options, '--type', 'float'])
            np.testing.assert_allclose(out, 2 * pixels[..., :3], rtol=1e-5)
            source = oiio.ImageInput.open(self.path('out.exr'))
            found = source.spec()
            source.close()
            self.assertEqual((found.x, found.y, found.width, found.height, found.full_width, found.full_height),
                             (5, 6, 20, 10, 64, 36))
            self.assertEqual((found.getattribute('PixelAspectRatio'), found.getattribute('studio/slate')), (2, '12A take 3'))
            channels = read_image(self.path('out.exr'))
            self.assertEqual((channels['A'].min(), channels['A'].max(), channels['id'].max()), (.5, .5, 7))

    def test_what_a_filter_puts_outside_of_the_data_window_is_kept(self):
        pixels = ramp()[:10, 1:21]
        write_image(self.frame, pixels, window=(40, 6, 64, 36))
        for name, x, width in (('mirror', 4, 56), ('exposure,stops=0', 40, 20)):
            self.apply(name, options=['--type', 'float'])
            source = oiio.ImageInput.open(self.path('out.exr'))
            spec = source.spec()
            source.close()
            self.assertEqual((spec.x, spec.width, spec.y, spec.height, spec.full_width), (x, width, 6, 10, 64), name)
        mirrored = self.apply('mirror', options=['--type', 'float'])
        np.testing.assert_allclose(mirrored[:, :20], pixels[:, ::-1], rtol=1e-5)
        write_image(self.frame, pixels, window=(-5, 6, 64, 36))
        result = self.succeed('look', 'apply', self.frame, '--filter', 'mirror', '-o', self.path('out.exr'))
        self.assertIn('overscan', result.stderr)

    def test_alpha_that_a_tiff_has_multiplied_in_is_divided_out(self):
        straight = np.concatenate([np.full((8, 8, 3), .8), np.full((8, 8, 1), .25)], -1)
        associated = straight * [.25, .25, .25, 1]
        found = []
        for name, pixels, unassociated in (('straight.tif', straight, 1), ('associated.tif', associated, 0)):
            write_image(self.path(name), pixels, 'uint16', **{'oiio:UnassociatedAlpha': unassociated})
            found.append(self.apply('exposure,stops=0', frame=self.path(name), options=['--alpha', '--type', 'float']))
        np.testing.assert_allclose(found[1], found[0], atol=1e-3)
        self.assertAlmostEqual(srgb_codes(found[0] / .25).max(), .8, delta=1e-3)

    def test_light_without_alpha_is_told_of(self):
        glow = np.concatenate([ramp(), np.zeros((36, 64, 1))], -1)
        write_image(self.frame, glow)
        arguments = ('look', 'apply', self.frame, '--filter', 'exposure,stops=1', '-o', self.path('out.exr'))
        self.assertIn('glows', self.succeed(*arguments, '--alpha').stderr)
        self.assertNotIn('warning', self.succeed(*arguments, '--type', 'float').stderr)
        np.testing.assert_allclose(read_rgb(self.path('out.exr')), 2 * glow[..., :3], rtol=1e-5)

    def test_the_frames_number_stands_in_the_name(self):
        self.succeed('look', 'apply', self.frame, '--filter', 'exposure,stops=1', '--frame', '12', '-o', self.path('n.####.exr'))
        self.assertTrue(os.path.exists(self.path('n.0012.exr')))
        self.deny('look', 'apply', self.frame, '--filter', 'exposure,stops=1', '-o', self.path('n.####.exr'), naming='--frame')

    def test_a_picture_is_placed_in_the_frames_primaries(self):
        ap1 = (.713, .293, .165, .83, .128, .044, .32168, .33767)
        element = np.full((36, 64, 3), [.8, .3, .1], np.float32)
        write_image(self.path('element.exr'), element)
        spec = oiio.ImageSpec(64, 36, 3, 'float')
        spec.attribute('chromaticities', 'float[8]', ap1)
        output = oiio.ImageOutput.create(self.frame)
        assert output.open(self.frame, spec) and output.write_image(np.zeros_like(element))
        output.close()
        out = self.apply(f'composite,element={self.path("element.exr")}', options=['--type', 'float'])
        np.testing.assert_allclose(out[18, 32], [.597, .332, .136], atol=2e-3)

    def test_a_colour_table_that_swaps_red_and_blue(self):
        lines = [f'{b} {g} {r}' for b in (0, 1) for g in (0, 1) for r in (0, 1)]
        self.write('swap.cube', 'TITLE "swap"\nLUT_3D_SIZE 2\n' + '\n'.join(lines) + '\n')
        write_image(self.path('in.png'), ramp(highest=1), 'uint8')
        out = self.apply(f'lut,table={self.path("swap.cube")}', frame=self.path('in.png'), output='o.png')
        np.testing.assert_allclose(out, read_rgb(self.path('in.png'))[..., ::-1], atol=2 / 255)

    def test_a_colour_table_of_another_range_is_refused(self):
        rows = '\n'.join(f'{r} {g} {b}' for b in (0, 1) for g in (0, 1) for r in (0, 1)) + '\n'
        for keyword in ('DOMAIN_MAX 4 4 4', 'DOMAIN_MIN -1 0 0', 'LUT_3D_INPUT_RANGE 0 16', 'LUT_1D_SIZE 2'):
            self.write('t.cube', f'LUT_3D_SIZE 2\n{keyword}\n{rows}')
            self.deny('look', 'apply', self.frame, '--filter', f'lut,table={self.path("t.cube")}', '-o', self.path('o.exr'),
                      naming=['t.cube:2', keyword.split()[0]])
        self.write('t.cube', f'LUT_3D_SIZE 2\nDOMAIN_MIN 0 0 0\nDOMAIN_MAX 1.0 1 1\nLUT_3D_INPUT_RANGE 0.0 1.0\n{rows}')
        self.apply(f'lut,table={self.path("t.cube")}')

    def test_vectors_and_matrices_by_name(self):
        x, as_float = ramp(), ['--type', 'float']
        cdl = self.apply('cdl,slopes=1.5:1:0.5,offsets=0.1:0:0.2,powers=1:2:0.5', options=as_float)
        np.testing.assert_allclose(cdl, (x * [1.5, 1, .5] + [.1, 0, .2]) ** [1, 2, .5], rtol=1e-4, atol=1e-6)
        mixed = self.apply('channel-mixer,matrix=0:1:0/0.5:0:0.5/1:-1:0', options=as_float)
        np.testing.assert_allclose(mixed, x @ np.array([[0, 1, 0], [.5, 0, .5], [1, -1, 0]]).T, rtol=1e-5, atol=1e-6)
        self.deny('look', 'apply', self.frame, '--filter', 'cdl,slopes=1:2', '-o', 'o.png', naming=['as 1:1:1'])

    def test_curves_go_through_their_points(self):
        """And are constant beyond them, never overshoot, and act one after the other."""
        codes = np.tile(np.arange(256)[None, :, None] / 255, (4, 1, 3))
        write_image(self.path('codes.png'), codes, 'uint8')
        out = self.apply('curves,tone=0.2:0.1/0.6:0.8/0.8:0.9,green=0:1/1:0', frame=self.path('codes.png'),
                         output='curved.exr', options=['--type', 'float'])[0]
        red, green = srgb_codes(out[:, 0]), srgb_codes(out[:, 1])
        for x, y in ((0, .1), (51, .1), (153, .8), (204, .9), (255, .9)):
            self.assertAlmostEqual(red[x], y, delta=2e-3)
        self.assertGreaterEqual(np.diff(red).min(), -1e-6)
        np.testing.assert_allclose(green, 1 - red, atol=2e-3)

    def test_looks_with_former_parameters_are_drawn_as_before(self):
        self.write('old.swaplook', json.dumps({'format': 'swaplight-look', 'version': 1, 'name': 'Old', 'filters': [
            {'filter': 'cdl', 'parameters': {'slope': [.8, .5, .3, 1], 'offset': [.6, .5, .5, 1], 'power': [.4, .5, .6, 1]}},
            {'filter': 'channel-mixer', 'parameters': {'red': [0, 1, 0, 1]}}]}))
        self.succeed('look', 'apply', self.frame, '--look', self.path('old.swaplook'), '-o', self.path('old.exr'), '--type', 'float')
        graded = (ramp() * [.8, .5, .3] + [.1, 0, 0]) ** [.8, 1, 1.2]
        np.testing.assert_allclose(read_rgb(self.path('old.exr')), graded[..., [1, 1, 2]], rtol=1e-4, atol=1e-6)

    def test_a_look_is_saved_and_used_again(self):
        first = self.apply('exposure,stops=1', 'sepia', output='a.png', options=['--save', self.path('warm.swaplook')])
        with open(self.path('warm.swaplook')) as file:
            look = json.load(file)
        self.assertEqual(look['name'], 'warm')
        self.assertEqual(look['filters'][0], {'filter': 'exposure', 'on': True, 'parameters': {'stops': 1.0}})
        self.succeed('look', 'apply', self.frame, '--look', self.path('warm.swaplook'), '-o', self.path('b.png'))
        np.testing.assert_array_equal(read_rgb(self.path('b.png')), first)
        look['filters'][1]['on'] = False
        self.write('warm.swaplook', json.dumps(look))
        self.succeed('look', 'apply', self.frame, '--look', self.path('warm.swaplook'), '-o', self.path('c.exr'),
                     '--type', 'float')
        np.testing.assert_allclose(read_rgb(self.path('c.exr')), ramp() * 2, rtol=1e-6)
        self.assertIn('warm', self.succeed('look', 'show', self.path('warm.swaplook')).stdout)

    def test_a_look_of_this_folder_is_saved_again_with_its_pictures(self):
        write_image(self.path('plate.exr'), ramp())
        self.write('a.swaplook', json.dumps({'format': 'swaplight-look', 'version': 1, 'name': 'A', 'filters': [
            {'filter': 'blend', 'parameters': {'other': 'plate.exr'}}]}))
        os.makedirs(self.path('data'))
        self.succeed('look', 'apply', 'frame.exr', '--look', 'a.swaplook', '-o', 'o.png', '--save', 'data/b.swaplook',
                     cwd=self.folder)
        with open(self.path('data', 'b.swaplook')) as file:
            self.assertEqual(json.load(file)['filters'][0]['parameters'], {'other': self.path('plate.exr')})

    def test_looks_that_come_along_can_be_named(self):
        for name in self.succeed_json('look', 'list')['camera_looks']:
            self.succeed('look', 'apply', self.frame, '--look', name, '-o', self.path('o.png'))

    def test_a_picture_after_every_filter_of_a_look(self):
        out = self.path('stages')
        self.succeed('look', 'thumbnails', self.frame, 'Pencil edges', '--stages', '-o', out, '--width', 64)
        names = ['1 grayscale', '2 sobel', '3 negative']
        self.assertEqual(sorted(os.listdir(out)), sorted([f'look Pencil edges {n}.png' for n in names] + ['look Pencil edges.png']))
        pictures = [read_rgb(os.path.join(out, f'look Pencil edges {n}.png')) for n in names]
        self.assertLess(np.ptp(pictures[0], axis=-1).max(), 2 / 255)
        np.testing.assert_allclose(pictures[2], 1 - pictures[1], atol=1.01 / 255)
        np.testing.assert_array_equal(read_rgb(os.path.join(out, 'look Pencil edges.png')), pictures[2])

    def test_isf_of_several_passes_with_a_vertex_shader(self):
        self.write('two.fs', '''/*{"INPUTS": [{"NAME": "inputImage", "TYPE": "image"}],
          "PASSES": [{"TARGET": "small", "WIDTH": "$WIDTH / 4", "HEIGHT": "max(1, floor($HEIGHT / 4.0))"}, {}]}*/
          varying vec2 left;
          void main() {
            if (PASSINDEX == 0) gl_FragColor = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord);
            else gl_FragColor = vec4(IMG_SIZE(small) / 100.0, left.x, 1.0);
          }''')
        self.write('two.vs', 'varying vec2 left;\nvoid main() { isf_vertShaderInit(); left = isf_FragNormCoord; }')
        out = self.apply(self.path('two.fs'), output='o.png')
        np.testing.assert_allclose(out[0, :, :2], np.tile([.16, .09], (64, 1)), atol=1 / 255)
        np.testing.assert_allclose(out[0, :, 2], (np.arange(64) + .5) / 64, atol=1 / 255)

    def test_isf_that_indexes_an_array_by_its_pass(self):
        """Within it where it is run; as a constant, the last pass would lie beyond it."""
        passes = self.write('passes.fs', '''/*{"INPUTS": [{"NAME": "inputImage", "TYPE": "image"}],
          "PASSES": [{"TARGET": "a"}, {"TARGET": "b"}, {}]}*/
          void main() {
            float level[2];
            level[0] = 0.2;
            level[1] = 0.4;
            if (PASSINDEX < 2) gl_FragColor = vec4(vec3(level[PASSINDEX]), 1.0);
            else gl_FragColor = IMG_THIS_PIXEL(a) + IMG_THIS_PIXEL(b);
          }''')
        np.testing.assert_allclose(self.apply(passes, output='o.png'), .6, atol=1 / 255)


class Refused(CameraLookTest):
    def refuse(self, *filters, naming, options=()):
        arguments = [part for filter in filters for part in ('--filter', filter)]
        self.deny('look', 'apply', self.frame, *arguments, '-o', self.path('o.exr'), *options, naming=naming)

    def test_what_is_asked_for(self):
        self.deny('look', 'paint', naming='expected list, show, star, unstar, lint, apply')
        self.deny('look', 'show', naming='name one filter')
        self.deny('look', 'apply', self.frame, '-o', self.path('o.exr'), naming='--look NAME')
        self.deny('look', 'apply', self.frame, '--filter', 'exposure', naming='-o FRAME')
        self.deny('look', 'apply', self.frame, '--filter', 'exposure', '-o', self.frame, naming='frame.exr')
        self.deny('look', 'apply', self.frame, '--look', 'nothing', '-o', self.path('o.exr'), naming='no camera look')

    def test_filters_and_parameters(self):
        self.refuse('exposrue', naming='did you mean exposure')
        self.refuse('exposure,stosp=1', naming='it has stops')
        self.refuse('exposure,stops=99', naming='expected -8 to 8 stops')
        self.refuse('exposure,stops=bright', naming='expected a number')
        self.refuse('sepia,amount', naming='NAME,parameter=value')
        self.refuse('split-tone,shadows=1:2', naming='1:0.5:0')
        self.refuse('blend,other=nowhere.png', naming='nowhere.png')
        self.refuse('lut,table=' + self.write('short.cube', 'LUT_3D_SIZE 2\n0 0 0\n'), naming='not complete')

    def test_a_syntax_error_is_at_the_line_of_the_persons_file(self):
        bad = self.write('bad.fs', SOFT.replace('amount *', 'amuont *'))
        self.refuse(bad, naming=[bad + ':3:', 'amuont'])
        result = self.deny_lint(bad)
        self.assertIn(bad + ':3:', result)

    def deny_lint(self, *files):
        from cli import run
        result = run('look', 'lint', *files)
        self.assertEqual(result.returncode, 2)
        return result.stdout

    def test_a_loop_without_an_end_ends(self):
        endless = self.write('endless.fs', SOFT.replace('gl_FragColor', 'float x = 0.0; while (x >= 0.0) x += 1e-9;\n'
                                                                        '  gl_FragColor'))
        out = self.apply(endless, output='o.png')
        np.testing.assert_allclose(out, self.apply(self.write('soft.fs', SOFT), output='p.png'))

    def test_a_filter_that_takes_too_long_is_stopped_and_named(self):
        write_image(self.frame, ramp(480, 640))
        slow = self.write('slow.fs', SOFT.replace('gl_FragColor', 'float x = amount;\n  while (x > 0.0) x += sin(x) * 1e-6;\n'
                                                                  '  gl_FragColor = x *').replace('* =', '* '))
        self.refuse(slow, naming=['slow.fs', 'takes longer than 0.1 s'], options=['--seconds', '0.1'])

    def test_lint_finds_what_computes_no_number(self):
        root = self.write('root.fs', '''/*{"INPUTS": [{"NAME": "inputImage", "TYPE": "image"},
          {"NAME": "power", "TYPE": "float", "DEFAULT": 1, "MIN": 0.5, "MAX": 2}],
          "SWAPLIGHT": {"SPACE": "scene_linear", "HALO": 0}}*/
          void main() { vec4 c = IMG_THIS_PIXEL(inputImage);
            gl_FragColor = vec4(power < 0.6 ? sqrt(c.rgb) : c.rgb, c.a); }''')
        self.assertIn('gives no finite number where the light is -1, with power=0.5', self.deny_lint(root))

    def test_lint_finds_a_halo_that_is_too_small(self):
        short = self.write('short.fs', '''/*{"INPUTS": [{"NAME": "inputImage", "TYPE": "image"}], "SWAPLIGHT": {"HALO": 1}}*/
          void main() { gl_FragColor = IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(9.0, 0.0)); }''')
        self.assertIn('looks further than its HALO', self.deny_lint(short))


if __name__ == '__main__':
    main()

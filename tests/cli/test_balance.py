"""swaplight balance: of photographs, and of rigs"""
import json

import numpy as np
import OpenImageIO as oiio
import swaplight_cli as cli

WEIGHTS = np.array([.2126, .7152, .0722])
LAMPS = np.array([[.70, .23, .13], [.10, .25, .88]])
WHITE = (LAMPS @ WEIGHTS)[:, None] * np.ones((2, 3))


class BalanceTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'), height=96, width=128)
        self.truth = cli.photograph(self.capture.truth, WHITE)
        self.photo = self.path('photo.exr')
        cli.write_image(self.photo, cli.photograph(self.capture.truth, LAMPS))

    def test_what_else_the_photograph_holds_goes_along(self):
        cli.write_image(self.photo, cli.photograph(self.capture.truth, LAMPS)[:40, :50], window=(20, 10, 128, 96),
                        PixelAspectRatio=2., slate='12A')
        self.solved()
        for how in (('--beta', self.path('solved.exr')), ('--method', 'grey-world')):
            self.succeed('balance', self.photo, *how, '-o', self.path('balanced.exr'))
            source = oiio.ImageInput.open(self.path('balanced.exr'))
            spec = source.spec()
            source.close()
            self.assertEqual((spec.x, spec.y, spec.width, spec.full_width), (20, 10, 50, 128), how)
            self.assertEqual((spec.getattribute('PixelAspectRatio'), spec.getattribute('slate')), (2, '12A'), how)

    def solved(self):
        self.succeed('solve', self.capture.path, '-o', self.path('solved.exr'), '--float', '-q')
        return self.path('solved.exr')

    def balance(self, *arguments, name='out.exr'):
        self.said = self.succeed_json('balance', self.photo, *arguments, '-o', self.path(name))
        return cli.read_rgb(self.path(name))

    def error(self, picture, truth=None):
        truth = self.truth if truth is None else truth
        return np.sqrt(((picture - truth) ** 2).mean() / (truth ** 2).mean())

    def test_a_solved_set_says_which_lamp_lights_what(self):
        solved = self.solved()
        self.assertLess(self.error(self.balance('--beta', solved)), .005)
        np.testing.assert_allclose(self.said['lights']['key']['color'], LAMPS[0], atol=3e-3)
        given = ','.join('/'.join(map(str, lamp)) for lamp in LAMPS)
        self.assertLess(self.error(self.balance('--beta', solved, '--colors', given)), .005)
        nothing = self.error(cli.read_rgb(self.photo))
        self.assertGreater(nothing, .3)

    def test_only_some_lamps_and_another_white(self):
        solved = self.solved()
        only = cli.photograph(self.capture.truth, [WHITE[0], LAMPS[1]])
        self.assertLess(self.error(self.balance('--beta', solved, '--lights', 'key'), only), .005)
        self.assertLess(self.error(self.balance('--beta', solved, '--lights', 'all-but:fill'), only), .005)
        warm = self.balance('--beta', solved, '--white', 'A')
        ratio = (warm / np.maximum(self.truth, 1e-4)).reshape(-1, 3).mean(0)
        self.assertAlmostEqual(ratio @ WEIGHTS, 1, 2)
        self.assertGreater(ratio[0] / ratio[2], 4)  # illuminant A: 1.81 / .38 in Rec.709
        self.assertEqual(self.said['white'], 'A')

    def test_someone_in_the_picture_is_balanced_too(self):
        actor = np.array([.5, 1.2, 1.6])
        pixels, truth = cli.photograph(self.capture.truth, LAMPS), self.truth.copy()
        pixels[30:70, 40:70] *= actor
        truth[30:70, 40:70] *= actor
        cli.write_image(self.photo, pixels)
        self.assertLess(self.error(self.balance('--beta', self.solved(), '--noise', 'read=.0001,full_well=1e9'), truth), .01)

    def test_two_colors_without_a_set(self):
        grey = self.capture.truth.mean(-1, keepdims=True) * np.ones(3)
        cli.write_image(self.photo, cli.photograph(grey, LAMPS))
        given = ','.join('/'.join(map(str, lamp)) for lamp in LAMPS)
        out = self.balance('--colors', given, '--map', self.path('beta.exr'))
        self.assertLess(self.error(out, cli.photograph(grey, WHITE)), .002)
        self.assertEqual(cli.read_image(self.path('beta.exr'))['Y'].shape, (96, 128))

    def test_a_grey_card_becomes_neutral(self):
        pixels = cli.photograph(self.capture.truth, LAMPS)
        pixels[10:30, 20:40] = np.array([.3, .4, .2])
        cli.write_image(self.photo, pixels)
        out = self.balance('--grey', '30,20,11')
        np.testing.assert_allclose(out[20, 30], np.array([.3, .4, .2]) @ WEIGHTS, rtol=1e-3)
        self.balance('--method', 'grey-world', '--grey', '30,20')

    def test_a_cameras_matrix_keeps_pixels_finite_at_every_white(self):
        camera = self.path('camera.json')
        with open(camera, 'w') as file:
            json.dump({'format': 'swaplight-camera', 'version': 1, 'from': 'lin_rec709', 'to': 'lin_rec709',
                       'camera_matrix': [[.9, .1, 0], [.1, .8, .1], [0, .2, .8]]}, file)
        how = ['--grey', '30,20', '--camera', camera]
        for white in ('2000K', 'A', 'D50', 'D65', '25000K'):
            self.assertTrue(np.isfinite(self.balance(*how, '--white', white)).all(), white)
        self.deny('balance', self.photo, *how, '--white', '1500K', '-o', self.path('x.exr'), naming=['1500K', '--white'])
        colors = ['--colors', '.7/.2/.1,.1/.2/.9', '--camera', camera, '--map', camera]
        self.deny('balance', self.photo, *colors, '-o', self.path('x.exr'), naming='camera.json')

    def test_every_method_is_there(self):
        for method in ('grey-world', 'max-rgb', 'shades-of-grey', 'grey-edge', 'grey-edge-2', 'ebner', 'xphoto-simple',
                       'xphoto-grey-world', 'xphoto-learning'):
            self.assertTrue(np.isfinite(self.balance('--method', method)).all(), method)
            self.assertEqual(self.said['method'], method)

    def test_a_picture_for_the_eye(self):
        self.balance('--beta', self.solved(), name='out.png')
        self.assertLessEqual(cli.read_rgb(self.path('out.png')).max(), 1)

    def rig(self, *lights):
        with open(self.path('rig.json'), 'w') as file:
            json.dump({'format': 'swaplight-rig', 'version': 1,
                       'lights': [{'name': name, 'color': color} for name, color in lights]}, file)
        return self.path('rig.json')

    def test_a_rigs_lights_become_white_at_their_luminance(self):
        solved, out = self.solved(), self.path('frame.exr')
        rig = self.rig(('key', 'rgb:.7/.23/.13'), ('fill', 'rgb:.1/.25/.88'))
        self.succeed('balance', rig, '-o', self.path('white.json'), '-q')
        self.succeed('relight', solved, '--rig', self.path('white.json'), '-o', out, '-q')
        self.assertLess(self.error(cli.read_rgb(out)), .005)
        said = self.succeed_json('balance', rig, '--lights', 'all-but:fill', '--white', 'A', '-o', self.path('some.json'))
        lights = {light['name']: light for light in said['rig']['lights']}
        self.assertEqual(lights['key']['color'], '2856K')
        self.assertEqual(lights['fill']['color'], 'rgb:0.1/0.25/0.88')
        self.deny('balance', rig, '--lights', 'rim', '-o', self.path('x.json'), naming=['--lights', 'rim', 'key'])
        self.deny('balance', rig, '--white', 'E', '-o', self.path('x.json'), naming='D65')
        self.deny('balance', rig, '--method', 'ebner', '-o', self.path('x.json'), naming='is a rig')
        self.deny('balance', rig, '-o', rig, naming='rig.json')

    def test_bad_input_is_refused_in_one_line(self):
        out = ['-o', self.path('x.exr')]
        self.deny('balance', self.photo, *out, naming='--beta')
        self.deny('balance', self.photo, '--method', 'magic', *out, naming=['magic', 'grey-world'])
        self.deny('balance', self.photo, '--method', 'ebner', '--colors', '1/1/1,1/0/0', *out, naming='one of')
        self.deny('balance', self.photo, '--colors', '1/1/1', *out, naming='--colors')
        self.deny('balance', self.photo, '--colors', '1/.5/.2,.5/.25/.1', *out, naming='same colour')
        self.deny('balance', self.photo, '--colors', '1/.5/.2,unknown', *out, naming='unknown')
        self.deny('balance', self.photo, '--grey', '5', *out, naming='--grey')
        self.deny('balance', self.photo, '--grey', '500,5', *out, naming='500')
        self.deny('balance', self.photo, '--method', 'ebner', '--white', 'D99', *out, naming='D99')
        self.deny('balance', self.photo, '--method', 'ebner', '--lights', 'key', *out, naming='--beta')
        self.deny('balance', self.photo, '--method', 'ebner', '-o', self.photo, naming='photo.exr')
        self.deny('balance', self.path('none.exr'), '--method', 'ebner', *out, naming='none.exr')


if __name__ == '__main__':
    cli.main()

"""$OCIO, the session's colour configuration, the built-in one; and what is said where one cannot be used"""
import json
import os
import shutil

import numpy as np
import OpenImageIO as oiio
import swaplight_cli as cli

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../data/color')
CONFIG = os.path.join(DATA, 'config.ocio')


class ColorConfigTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '--model', 'transport', '-q')

    def session(self, **values):
        path = self.path('a.swaplight')
        with open(path, 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr', **values}, file)
        return path

    def frame(self, *arguments, config='', name='frame.png'):
        self.succeed('relight', *arguments, '-o', self.path(name), '-q', env={'OCIO': config} if config else {})
        return cli.read_rgb(self.path(name))

    def test_the_environment_goes_before_the_session_and_that_before_the_built_in(self):
        film = self.frame(self.solved, '--display', 'Monitor', '--view', 'Film', config=CONFIG)
        self.assertGreater(np.abs(film - self.frame(self.solved)).mean(), .02)
        shutil.copytree(DATA, self.path('show'))
        session = self.session(color_config='show/config.ocio', display={'display': 'Monitor', 'view': 'Film'})
        np.testing.assert_array_equal(self.frame(session), film)
        with open(CONFIG) as file:
            other = file.read().replace('log_side_slope: 0.247190', 'log_side_slope: 0.2')
        shutil.copytree(DATA, self.path('other'))
        with open(self.path('other', 'config.ocio'), 'w') as file:
            file.write(other)
        changed = self.frame(session, config=self.path('other', 'config.ocio'))
        self.assertGreater(np.abs(changed - film).mean(), .01)
        found = self.succeed('info', session).stdout
        self.assertIn(self.path('show', 'config.ocio'), found)

    def test_what_cannot_be_used_is_said_in_one_line_with_what_to_do(self):
        broken, undefined = self.path('broken.ocio'), self.path('undefined.ocio')
        with open(broken, 'w') as file:
            file.write('ocio_profile_version: 2\nroles: [\n')
        with open(CONFIG) as file:
            text = file.read()
        with open(undefined, 'w') as file:
            file.write(text.replace('{name: Print, colorspace: print}', '{name: Print, colorspace: gone}'))
        for config in ('/nowhere/none.ocio', broken, undefined):
            self.deny('relight', self.solved, '-o', self.path('a.png'), env={'OCIO': config},
                      naming=[config, '$OCIO', 'unset it'])
        self.deny('relight', self.session(color_config='none.ocio'), '-o', self.path('a.png'),
                  naming=[self.path('none.ocio'), 'color_config'])

    def test_a_view_that_the_configuration_lacks_is_said_with_those_that_it_has(self):
        self.deny('relight', self.solved, '--view', 'Nope', '-o', self.path('a.png'), env={'OCIO': CONFIG},
                  naming=["'Nope'", CONFIG, 'Film'])
        self.deny('relight', self.solved, '--display', 'Old monitor', '-o', self.path('a.png'), env={'OCIO': CONFIG},
                  naming=["'Old monitor'", CONFIG, 'Projector, Monitor'])

    def test_a_look_takes_the_place_of_the_views_own(self):
        view = ['--display', 'Monitor', '--view']
        film = self.frame(self.solved, *view, 'Film', config=CONFIG)
        warm = self.frame(self.solved, *view, 'Warm film', config=CONFIG)
        self.assertGreater(np.abs(warm - film).mean(), .005)
        for arguments, expected in (([*view, 'Film', '--view-look', 'warm'], warm),
                                    ([*view, 'Warm film', '--view-look', 'none'], film),
                                    ([*view, 'Film', '--view-look=-warm,+warm,+warm'], warm)):
            np.testing.assert_allclose(self.frame(self.solved, *arguments, config=CONFIG), expected, atol=1.1 / 255)
        shutil.copytree(DATA, self.path('show'))
        session = self.session(color_config='show/config.ocio',
                               display={'display': 'Monitor', 'view': 'Warm film', 'look': 'bleach'})
        bleached = self.frame(session)
        self.assertGreater(np.abs(bleached - warm).mean(), .005)
        self.assertIn('bleach', self.succeed('info', session).stdout)
        np.testing.assert_array_equal(self.frame(session, '--view-look', 'none'), film)
        np.testing.assert_array_equal(self.frame(session, *view, 'Warm film'), warm)
        for name, look in (('a.cube', 'bleach'), ('b.cube', 'none')):
            self.succeed('export', session, '--view-look', look, '-o', self.path(name), '-q')
        with open(self.path('a.cube')) as a, open(self.path('b.cube')) as b:
            bleached, plain = a.read(), b.read()
        self.assertIn('Warm film · bleach', bleached)
        self.assertNotEqual(bleached.splitlines()[9:], plain.splitlines()[9:])

    def test_a_look_that_the_configuration_lacks_is_said_with_those_that_it_has(self):
        for verb, file in (('relight', 'a.png'), ('export', 'a.cube'), ('report', 'a.html')):
            self.deny(verb, self.solved, '--view-look', 'warm,cold', '-o', self.path(file), env={'OCIO': CONFIG},
                      naming=["'cold'", CONFIG, 'warm, bleach'])
        self.deny('relight', self.session(display={'display': 'sRGB', 'view': 'ACES SDR', 'look': 'cold'}),
                  '-o', self.path('a.png'), naming=["'cold'", 'Gamut compression'])
        self.deny('relight', self.solved, '--view-look', 'Gamut compression', '-o', self.path('a.exr'),
                  naming=['a.exr', 'name a view'])

    def test_a_working_space_is_where_lights_are_multiplied(self):
        def frame(source, *arguments):
            self.succeed('relight', source, *arguments, '--type', 'uint16', '-o', self.path('a.png'), '-q')
            return cli.read_rgb(self.path('a.png'))

        neon = ['--light', 'key=rgb:0.1/1/0.1', '--light', 'fill=rgb:0.2/0.1/1']
        wide = ['--working-space', 'acescg']
        np.testing.assert_allclose(frame(self.solved, *wide), frame(self.solved), atol=3e-4)
        own = frame(self.solved, *neon)
        worked = frame(self.solved, *neon, *wide)
        self.assertGreater(np.abs(worked - own).max(), .02)
        self.succeed('solve', self.capture.path, '-o', self.path('wide.exr'), '--model', 'transport', '--float', '-q',
                     '--color-space', 'acescg')
        np.testing.assert_allclose(worked, frame(self.path('wide.exr'), *neon), atol=1e-3)
        session = self.session(working_space='acescg')
        np.testing.assert_array_equal(frame(session, *neon), worked)
        np.testing.assert_array_equal(frame(session, *neon, '--working-space', 'lin_rec709'), own)
        self.assertIn('ACEScg', self.succeed('info', session).stdout)
        self.succeed('relight', session, '-o', self.path('a.exr'), '-q')
        self.succeed('export', session, '-o', self.path('layers.exr'), '-q')
        for name in ('a.exr', 'layers.exr'):
            header = self.succeed('info', self.path(name)).stdout
            self.assertIn('acescg', header)
        self.deny('relight', self.solved, '--working-space', 'srgb', '-o', self.path('a.png'), naming=['srgb', 'acescg'])
        self.deny('relight', self.session(working_space='film'), '-o', self.path('a.png'),
                  naming=['working_space', 'film', 'acescg'])

    def test_file_rules_say_what_a_capture_does_not(self):
        del self.capture.manifest['color_space']
        self.capture.save()
        plain = self.succeed('solve', self.capture.path, '-o', self.path('b.exr')).stderr
        self.assertIn('lin_rec709 assumed', plain)
        with open(self.capture.path) as file:
            manifest = json.load(file)
        for shot in manifest['shots']:
            os.rename(os.path.join(self.capture.folder, shot['image']),
                      os.path.join(self.capture.folder, 'plate_' + shot['image']))
            shot['image'] = 'plate_' + shot['image']
        with open(self.capture.path, 'w') as file:
            json.dump(manifest, file)
        ruled = self.succeed('solve', self.capture.path, '-o', self.path('c.exr'), env={'OCIO': CONFIG}).stderr
        self.assertIn('log_camera assumed', ruled)

    def test_displays_that_the_house_makes_active_are_its_configurations_own(self):
        self.succeed('relight', self.solved, '-o', self.path('house.png'), '-q',
                     env={'OCIO_ACTIVE_DISPLAYS': 'projector of the house'})

    def test_a_colour_space_is_the_same_however_it_is_called(self):
        frames = []
        for name in ('acescg', 'ACEScg'):
            self.capture.manifest['color_space'] = name
            self.capture.save()
            self.succeed('solve', self.capture.path, '-o', self.path(f'{name}1.exr'), '-q')
            self.assertEqual(self.succeed_json('info', self.path(f'{name}1.exr'))['color_space'], 'acescg')
            self.succeed('relight', self.path(f'{name}1.exr'), '-o', self.path(f'{name}2.exr'), '-q')
            frames.append(cli.read_rgb(self.path(f'{name}2.exr')))
        np.testing.assert_array_equal(frames[0], frames[1])

    def test_colours_that_a_file_states_are_taken_or_said(self):
        rec2020 = (.708, .292, .170, .797, .131, .046, .3127, .3290)
        camera = (.684, .313, .221, .848, .0861, -.102, .3127, .3290)
        for name, xy in (('rec2020', rec2020), ('camera', camera)):
            spec = oiio.ImageSpec(self.capture.shots[0].shape[1], self.capture.shots[0].shape[0], 3, 'float')
            spec.attribute('chromaticities', oiio.TypeDesc('float[8]'), xy)
            os.makedirs(self.path(name))
            for k, pixels in enumerate(self.capture.shots):
                output = oiio.ImageOutput.create(self.path(name, f'{k}.exr'))
                self.assertTrue(output.open(self.path(name, f'{k}.exr'), spec))
                output.write_image(np.ascontiguousarray(pixels, np.float32))
                output.close()
        told = ('--colors', '#ff3322,#2244ff')
        made = self.succeed('new', self.path('rec2020'), '--lights', 'key,fill', *told)
        with open(self.path('rec2020', 'capture.json')) as file:
            self.assertEqual(json.load(file)['color_space'], 'lin_rec2020')
        self.assertNotIn('says that its colours', made.stdout + made.stderr)
        made = self.succeed('new', self.path('camera'), '--lights', 'key,fill', *told)
        self.assertIn('says that its colours are primaries 0.684', made.stdout + made.stderr)
        with open(self.path('rec2020', 'capture.json')) as file:
            manifest = json.load(file)
        manifest['color_space'] = 'acescg'
        with open(self.path('rec2020', 'capture.json'), 'w') as file:
            json.dump(manifest, file)
        solved = self.succeed('solve', self.path('rec2020'), '-o', self.path('d.exr'))
        self.assertIn('says that its colours are lin_rec2020; they are taken as acescg', solved.stderr)


if __name__ == '__main__':
    cli.main()

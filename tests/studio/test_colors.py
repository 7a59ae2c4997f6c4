"""The studio's colour configuration: $OCIO, the session's own, and what happens where one cannot be used."""
import json
import os
import shutil
import subprocess
import unittest

import numpy as np
import OpenImageIO as oiio

from studio_session import HERE, PROGRAM, SAMPLES, StudioTest

DATA = os.path.join(HERE, '../data/color')


class Colors(StudioTest):
    def test_a_wrong_environment_is_said_and_the_built_in_configuration_shown(self):
        studio = self.open_sample(environment={'OCIO': '/nowhere/none.ocio'})
        self.assertEqual(studio.state('colors'), 'built-in')
        studio.item('status.colors_trouble')
        self.assertGreater(studio.picture('colors_wrong').std(), 10)
        self.assertTrue(studio.quit())

    def test_the_environment_gives_displays_and_views(self):
        studio = self.open_sample(environment={'OCIO': os.path.join(DATA, 'config.ocio')})
        self.assertEqual(studio.state('colors'), 'hand-made')
        studio.item('status.colors')
        studio.click('bar.view')
        studio.click('display.Monitor')
        before = studio.picture('colors_film')
        studio.click('bar.view')
        self.assertFalse(studio.has('view.Monitor.Put away'))
        studio.screenshot('colors_menu')
        studio.click('view.Monitor.Warm film')
        studio.move(640, 705)
        self.assertGreater(np.abs(studio.picture('colors_warm') - before).mean(), 1)

    def test_a_look_is_chosen_and_undone_and_saved_and_exported(self):
        environment = {'OCIO': os.path.join(DATA, 'config.ocio')}
        studio = self.open_sample(environment=environment)

        def choose(item):
            studio.click('bar.view')
            studio.click(item)
            studio.move(640, 705)
            return studio.picture('look')

        choose('display.Monitor')
        warm = choose('view.Monitor.Warm film')
        film = choose('look.none')
        self.assertGreater(np.abs(film - warm).mean(), 1)
        self.assertLess(np.abs(choose('view.Monitor.Film') - film).max(), 2)
        self.assertLess(np.abs(choose('look.warm') - warm).max(), 2)
        bleached = choose('look.bleach')
        self.assertGreater(np.abs(bleached - warm).mean(), 1)
        studio.click('bar.view')
        studio.screenshot('look_menu')
        studio.click('bar.view')
        studio.key('ctrl+z')
        studio.move(640, 705)
        self.assertLess(np.abs(studio.picture('look_undone') - warm).max(), 2)
        studio.key('ctrl+shift+z')
        _, session = self.save_as('look')
        self.assertEqual(session['display'], {'display': 'Monitor', 'view': 'Film', 'look': 'bleach'})

    def shown_view(self, name):
        """The view as a session of this name keeps it."""
        return self.save_as(name)[1]['display']

    def test_sets_open_in_a_rolled_off_view_and_then_in_the_one_chosen_last(self):
        studio = self.open_sample(plain_view=False)
        self.assertEqual(self.shown_view('rolled_off'), {'display': 'sRGB', 'view': 'AgX'})
        rolled_off = studio.picture('view_agx')
        studio.click('bar.view')
        studio.screenshot('view_menu')
        studio.click('view.sRGB.ACES SDR')
        studio.move(640, 705)
        self.assertGreater(np.abs(studio.picture('view_aces') - rolled_off).mean(), 3)
        studio.key('ctrl+z')  # what is saved is on show again; the choice stays the last one
        self.assertTrue(studio.quit())
        # What was saved keeps its own view, another set has the one chosen last.
        studio = self.start(self.path('rolled_off.swaplight'), plain_view=False)
        studio.wait_ready()
        self.assertLess(np.abs(studio.picture('view_of_session') - rolled_off).max(), 2)
        self.assertTrue(studio.quit())
        studio = self.open_sample('two_swapped', plain_view=False)
        self.assertEqual(self.shown_view('aces'), {'display': 'sRGB', 'view': 'ACES SDR'})
        self.assertTrue(studio.quit())

    def test_an_exported_frame_says_its_view_and_has_the_pixels_of_relight(self):
        studio = self.open_sample(plain_view=False)
        frame = self.export_frame('frame.png')
        self.assertTrue(studio.has('message.0'))
        studio.screenshot('view_exported')
        session, _ = self.save_as('shown')
        capture = os.path.join(SAMPLES, 'three_point', 'capture.json')
        for name, source, options, same in (('session.png', session, [], True),
                                            ('agx.png', capture, ['--view', 'AgX'], True),
                                            ('plain.png', capture, [], False)):
            # Each has a name of its own: OpenImageIO keeps what it has read of a file changed within the second.
            path = self.path(name)
            said = subprocess.run([PROGRAM, 'relight', source, *options, '-o', path], check=True,
                                  capture_output=True, text=True).stderr
            self.assertIn('seen through sRGB \u00b7 AgX' if same else 'seen through sRGB\n', said)
            a, b = (oiio.ImageBuf(file).get_pixels(oiio.UINT8) for file in (frame, path))
            self.assertEqual(np.array_equal(a, b), same)

    def test_the_built_in_looks_are_in_sight_in_a_small_window(self):
        studio = self.open_sample()
        studio.click('bar.view')
        for name in ('own', 'none', 'Gamut compression', 'Blue light fix'):
            self.assertLess(studio.item('look.' + name)[3], 720)
        studio.move(*studio.point('look.Gamut compression'))
        studio.screenshot('look_menu_builtin')

    def test_a_working_space_is_chosen_undone_saved_and_exported(self):
        def session(name, color):
            rig = {'format': 'swaplight-rig', 'version': 1,
                   'lights': [{'name': light, 'color': color} for light in ('key', 'fill', 'back')]}
            with open(self.path(name), 'w') as file:
                json.dump({'format': 'swaplight-session', 'version': 1, 'rig': rig,
                           'source': os.path.join(SAMPLES, 'three_point', 'capture.json')}, file)
            return self.path(name)

        studio = self.start(session('white.swaplight', '#ffffff'))
        studio.wait_ready()

        def work_in(space):
            studio.click('bar.view')
            studio.click('working_space')
            studio.screenshot('working_space_menu')
            studio.click('menu.working_space.' + space)
            studio.wait(lambda layout: layout.get('working_space') == space and layout['status'] == 'ready', space)
            studio.move(640, 705)
            return studio.picture('working_space_' + space)

        white = studio.picture('working_space_before')
        self.assertEqual(studio.state('working_space'), 'lin_rec709')
        self.assertLess(np.abs(work_in('acescg') - white).max(), 3, 'white light looks the same')
        studio.key('ctrl+z')
        studio.wait(lambda layout: layout.get('working_space') == 'lin_rec709', 'the photographs\' own')
        self.assertTrue(studio.quit())
        studio = self.start(session('neon.swaplight', 'rgb:0.1/0.2/1'))
        studio.wait_ready()
        own = studio.picture('working_space_own')
        wide = work_in('acescg')
        self.assertGreater(np.abs(wide - own).max(), 12)
        studio.key('ctrl+z')
        studio.wait(lambda layout: layout.get('working_space') == 'lin_rec709', 'the photographs\' own')
        self.assertLess(np.abs(studio.picture('working_space_undone') - own).max(), 2)
        studio.key('ctrl+shift+z')
        studio.wait(lambda layout: layout.get('working_space') == 'acescg', 'ACEScg again')
        path, saved = self.save_as('wide')
        self.assertEqual(saved['working_space'], 'acescg')
        self.assertTrue(studio.quit())
        studio = self.start(path)
        studio.wait_ready()
        self.assertEqual(studio.state('working_space'), 'acescg')
        self.assertLess(np.abs(studio.picture('working_space_opened') - wide).max(), 2)
        script = self.path('export.txt')
        with open(script, 'w') as file:
            file.write('\n'.join([f'open {session("neon.swaplight", "rgb:0.1/0.2/1")}', 'wait',
                                  'action working_space.acescg', 'wait', f'save {path}', 'wait',
                                  f'export {self.path("a.exr")}', 'wait', 'sleep 1', 'frames 3', 'quit']))
        subprocess.run([PROGRAM, 'studio', '--screenshot', self.path('x.png'), '--script', script, '--size', '640x480'],
                       check=True, env={**os.environ, 'HOME': self.folder}, capture_output=True)
        subprocess.run([PROGRAM, 'relight', path, '-o', self.path('b.exr')], check=True, capture_output=True)
        a, b = (oiio.ImageBuf(self.path(name)) for name in ('a.exr', 'b.exr'))
        np.testing.assert_array_equal(a.get_pixels(oiio.FLOAT), b.get_pixels(oiio.FLOAT))
        self.assertAlmostEqual(a.spec().getattribute('chromaticities')[0], .713, places=4)

    def test_a_session_brings_its_own_and_undo_takes_it_away(self):
        shutil.copytree(DATA, self.path('show'))
        with open(self.path('a.swaplight'), 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'color_config': 'show/config.ocio',
                       'display': {'display': 'Monitor', 'view': 'Print'},
                       'source': os.path.join(SAMPLES, 'three_point', 'capture.json')}, file)
        studio = self.start(self.path('a.swaplight'))
        studio.wait_ready()
        self.assertEqual(studio.state('colors'), 'hand-made')
        print_view = studio.picture('colors_session')
        studio.click('bar.view')
        studio.click('menu.view.builtin_colors')
        studio.wait(lambda layout: layout.get('colors') == 'built-in', 'the built-in configuration')
        self.assertGreater(np.abs(studio.picture('colors_builtin') - print_view).mean(), 3)
        studio.key('ctrl+z')
        studio.wait(lambda layout: layout.get('colors') == 'hand-made', 'the session\'s configuration again')
        self.assertLess(np.abs(studio.picture('colors_undone') - print_view).max(), 2)

    def test_a_view_whose_table_is_missing_is_said_and_not_taken(self):
        shutil.copytree(DATA, self.path('show'))
        os.remove(self.path('show/luts/film.spi1d'))
        studio = self.open_sample(environment={'OCIO': self.path('show/config.ocio')})
        self.assertEqual(studio.state('colors'), 'hand-made')
        before = studio.picture('colors_before')
        studio.click('bar.view')
        studio.click('display.Monitor')
        studio.item('message.0')
        studio.move(640, 705)
        shown = studio.picture('colors_no_table')
        rows = before.shape[0] * 2 // 3  # above the message
        self.assertLess(np.abs(shown[:rows] - before[:rows]).max(), 2)
        studio.click('bar.view')
        studio.item('view.Projector.Film')

    def test_a_session_whose_configuration_is_gone_is_shown_through_the_built_in(self):
        with open(self.path('a.swaplight'), 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'color_config': 'gone.ocio',
                       'source': os.path.join(SAMPLES, 'three_point', 'capture.json')}, file)
        studio = self.start(self.path('a.swaplight'))
        studio.wait_ready()
        studio.item('status.colors_trouble')
        studio.screenshot('colors_gone')


if __name__ == '__main__':
    unittest.main()

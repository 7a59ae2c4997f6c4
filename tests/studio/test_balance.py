"""White balance of the lights, and lamps read from a photograph, in a real window."""
import json
import os
import subprocess
import unittest

import numpy as np

from studio_session import PROGRAM, SAMPLES, StudioTest

WEIGHTS = np.array([.2126, .7152, .0722])


class Balance(StudioTest):
    def menu(self, *items):
        self.studio.click('menu.Lights')
        for item in items:
            self.studio.item(item)
            self.studio.settle()
            self.studio.click(item)

    def lights(self, name):
        return {light['name']: light for light in self.save_as(name)[1]['rig']['lights']}

    def setting(self, light, text):
        self.studio.click(f'mixer.{light}.chip')
        self.studio.click('light.hex')
        self.studio.key('ctrl+a')
        self.studio.type(text)
        self.studio.key('Return')

    def test_lights_are_neutralized_and_stay_as_bright(self):
        self.open_sample('two_swapped')
        names = [item.split('.')[1] for item in self.studio.layout()['items'] if item.endswith('.chip')]
        self.setting(names[0], 'rgb:0.9/0.2/0.15')
        self.setting(names[1], 'rgb:0.15/0.3/0.8')
        self.studio.screenshot('balance_before')
        self.studio.click('menu.Lights')
        self.studio.item('menu.mixer.neutralize_all')
        self.studio.screenshot('balance_menu')
        self.studio.click('menu.mixer.neutralize_all')
        self.studio.screenshot('balance_after')
        lights = self.lights('neutral')
        for name, color in zip(names, ([.9, .2, .15], [.15, .3, .8])):
            self.assertEqual(lights[name]['color'], 'white')
            self.assertAlmostEqual(lights[name]['stops'], np.log2(np.dot(WEIGHTS, color)), 3)
        self.studio.key('ctrl+z')
        self.assertIn('rgb', self.lights('coloured')[names[0]]['color'])

    def test_a_white_point_is_chosen_and_others_stay(self):
        self.open_sample('two_swapped')
        names = [item.split('.')[1] for item in self.studio.layout()['items'] if item.endswith('.chip')]
        self.setting(names[1], 'rgb:0.15/0.3/0.8')
        self.setting(names[0], 'rgb:0.9/0.2/0.15')  # the one that is chosen now
        self.menu('menu.white_point')
        self.studio.screenshot('balance_white_points')
        self.studio.click('menu.white.D50')
        self.menu('menu.mixer.neutralize_others')
        lights = self.lights('others')
        self.assertIn('0.9', lights[names[0]]['color'])
        self.assertEqual(lights[names[1]]['color'], '5003K')

    def test_lamps_are_read_from_a_photograph_and_undone(self):
        solved, photo = self.path('solved.exr'), self.path('photo.exr')
        subprocess.run([PROGRAM, 'solve', os.path.join(SAMPLES, 'two_swapped/capture.json'), '-o', solved, '-q'], check=True)
        with open(os.path.join(SAMPLES, 'two_swapped/capture.json')) as file:
            names = [light['name'] for light in json.load(file)['lights']]
        subprocess.run([PROGRAM, 'relight', solved, '--light', f'{names[0]}=rgb:.8/.4/.2', '--light', f'{names[1]}=off',
                        '-o', photo, '-q'], check=True)
        self.start(solved)
        self.studio.wait_ready()
        before = self.lights('before')
        self.menu('menu.mixer.read_photograph')
        self.studio.item('chooser.name')
        self.studio.screenshot('balance_chooser')
        self.studio.key('ctrl+a')
        self.studio.type(photo)
        self.studio.key('Return')
        self.studio.wait(lambda layout: 'message.0' in layout['items'], 'the lamps are read')
        self.studio.settle()
        self.studio.screenshot('balance_read')
        self.studio.click('message.0')
        lights = self.lights('read')
        self.assertFalse(lights[names[1]]['on'])
        self.assertAlmostEqual(lights[names[0]]['stops'], np.log2(np.dot(WEIGHTS, [.8, .4, .2])), 2)
        self.studio.key('ctrl+z')
        self.assertEqual(self.lights('undone'), before)


if __name__ == '__main__':
    unittest.main()

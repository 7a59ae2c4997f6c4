"""Files dropped onto the window, and the window on the whole monitor."""
import os
import shutil
import unittest

import numpy as np

from drop_files import drop_files
from studio_session import SAMPLES, StudioTest


class Drop(StudioTest):
    def drop(self, *paths):
        drop_files(self.display.name, 'Swaplight', paths, 500, 300)

    def test_one_photograph_brings_in_its_folder(self):
        studio = self.start()
        studio.item('welcome.open')
        folder = self.path('set')
        shutil.copytree(os.path.join(SAMPLES, 'two_swapped'), folder)
        os.remove(os.path.join(folder, 'capture.json'))
        self.drop(os.path.join(folder, 'shot_01.exr'))
        studio.item('wizard.solve')
        studio.item('message.0')
        studio.screenshot('drop_photograph')

    def test_a_folder_and_a_session_open_where_they_are_dropped(self):
        studio = self.start()
        studio.item('welcome.open')
        self.drop(os.path.join(SAMPLES, 'two_swapped'))
        studio.wait_ready()
        self.assertIn('two_swapped', studio.state('title'))
        studio.click('mixer.' + self.first_light() + '.mute')
        studio.key('ctrl+s')
        studio.item('chooser.name')
        studio.key('ctrl+a')
        studio.type(self.path('dropped.swaplight'))
        studio.key('Return')
        studio.wait(lambda layout: layout.get('title', '').startswith('dropped'), 'the session has a name')
        studio.move(640, 705)
        muted = studio.picture('drop_saved')
        self.drop(os.path.join(SAMPLES, 'three_point', 'capture.json'))
        studio.wait(lambda layout: 'three_point' in layout.get('title', '') and layout['status'] == 'ready', 'the other set')
        self.drop(self.path('dropped.swaplight'))
        studio.wait(lambda layout: layout.get('title', '').startswith('dropped') and layout['status'] == 'ready',
                    'the session')
        self.assertLess(np.abs(studio.picture('drop_session') - muted).max(), 2)

    def first_light(self):
        return [name for name in self.studio.layout()['items'] if name.endswith('.chip')][0].split('.')[1]

    def test_unsaved_work_is_asked_about_first(self):
        studio = self.open_sample()
        studio.click('mixer.key.mute')
        self.drop(os.path.join(SAMPLES, 'two_swapped'))
        studio.item('unsaved.discard')
        studio.screenshot('drop_unsaved')
        studio.click('unsaved.discard')
        studio.wait(lambda layout: 'two_swapped' in layout.get('title', ''), 'the dropped set')

    def test_what_is_no_set_is_said(self):
        with open(self.path('notes.txt'), 'w') as file:
            file.write('lunch at one')
        studio = self.open_sample()
        self.drop(self.path('notes.txt'))
        studio.item('message.0')
        studio.screenshot('drop_notes')
        self.assertIn('three_point', studio.state('title'))


class FullScreen(StudioTest):
    def test_the_window_takes_the_monitor_and_gives_it_back(self):
        self.size = (1000, 640)
        studio = self.open_sample()
        window = lambda: studio.item('menu.File')[0:2] + [studio.item('mixer.menu')[2]]
        before = window()
        studio.key('F11')
        studio.wait(lambda layout: layout['items'].get('mixer.menu', [0] * 4)[2] > before[2] + 200, 'the whole monitor')
        studio.screenshot('full_screen')
        studio.key('F11')
        studio.wait(lambda layout: layout['items'].get('mixer.menu', [0] * 4)[2] == before[2], 'the window again')


if __name__ == '__main__':
    unittest.main()

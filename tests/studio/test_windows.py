"""Keys, command palette, history, About, and panels, in a real window."""
import os
import unittest

import numpy as np

from studio_session import StudioTest


class Windows(StudioTest):
    def test_an_action_is_found_and_run_by_a_few_letters(self):
        studio = self.open_sample()
        studio.key('ctrl+shift+p')
        studio.item('palette.filter')
        studio.type('all off')
        studio.screenshot('windows_palette')
        studio.key('Return')
        self.assertLess(studio.picture('windows_all_off').mean(), 2)

    def test_keys_are_changed_and_kept_as_text(self):
        studio = self.open_sample()
        studio.type('?')
        studio.item('keys.filter')
        studio.type('zebra')
        studio.screenshot('windows_keys')
        studio.click('keys.view.zebra')
        studio.key('ctrl+j')
        path = os.path.join(self.folder, '.config', 'swaplight', 'keys.txt')
        with open(path) as file:
            self.assertIn('view.zebra Ctrl+J', file.read())
        studio.key('Escape')
        studio.move(640, 705)
        before = studio.picture('windows_no_zebra')
        studio.key('z')
        self.assertLess(np.abs(studio.picture('windows_old_key') - before).max(), 2, 'the old key does nothing')
        self.assertTrue(studio.quit())
        studio = self.open_sample()
        studio.key('ctrl+j')
        studio.move(640, 705)
        self.assertGreater(np.abs(studio.picture('windows_zebra') - before).max(), 20, 'the new key was remembered')

    def test_the_history_goes_back_to_any_step(self):
        studio = self.open_sample()
        before = studio.picture('windows_history_before')
        for light in ('key', 'fill', 'back'):
            studio.click(f'mixer.{light}.mute')
        dark = studio.picture('windows_history_dark')
        self.assertLess(dark.mean(), 2)
        studio.key('ctrl+h')
        studio.screenshot('windows_history')
        studio.click('history.0')
        studio.key('ctrl+h')
        studio.move(640, 705)
        self.assertLess(np.abs(studio.picture('windows_history_first') - before).max(), 2)
        studio.key('ctrl+shift+z', 'ctrl+shift+z', 'ctrl+shift+z')
        self.assertLess(np.abs(studio.picture('windows_history_last') - dark).max(), 2)

    def test_about_names_the_engine(self):
        studio = self.open_sample()
        studio.click('menu.Help')
        studio.click('menu.help.about')
        studio.item('about')
        studio.screenshot('windows_about')

    def test_panels_hide_and_come_back(self):
        studio = self.open_sample()
        width = lambda: studio.item('viewer')[2] - studio.item('viewer')[0]
        before = width()
        studio.key('Tab')
        studio.settle()
        self.assertEqual(width(), self.size[0])
        studio.key('Tab')
        studio.settle()
        self.assertEqual(width(), before)
        studio.key('F5')
        studio.settle()
        self.assertGreater(width(), before + 300)
        self.assertTrue(studio.quit())
        studio = self.open_sample()
        self.assertGreater(width(), before + 300, 'what was hidden stays hidden')


if __name__ == '__main__':
    unittest.main()

"""Keys, command palette, history, About, and panels, in a real window."""
import os
import unittest

import numpy as np

from studio_session import StudioTest

TOOLS = ('file.open', 'file.save', 'file.export', 'edit.undo', 'edit.redo', 'edit.history', 'view.fit', 'view.one_to_one',
         'brush.take', 'light.neutral', 'view.probe', 'compare.wipe', 'view.photograph', 'view.scopes', 'view.gallery', 'help.keys')


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


class Scale(StudioTest):
    """At larger scales of the interface nothing leaves the window for good."""

    def seen(self):
        """The names of what lies within the window."""
        self.studio.settle()
        return {name for name, (x0, y0, x1, y1) in self.studio.layout()['items'].items()
                if x0 >= 0 and y0 >= 0 and x1 <= self.size[0] and y1 <= self.size[1]}

    def toolbar(self, scale):
        """Those of its buttons that are seen; other panels have some of them, too."""
        items, seen = self.studio.layout()['items'], self.seen()
        return [tool for tool in TOOLS if 'button.' + tool in seen and items['button.' + tool][2] < 46 * float(scale)]

    def test_what_has_no_room_beside_the_picture_is_left_out_and_comes_back(self):
        studio = self.open_sample()
        for keys in ('F4', 'F10', 'shift+F10', 'shift+F8'):
            studio.key(keys)
        studio.settle()
        studio.screenshot('windows_no_room')
        self.assertTrue(studio.has('button.cues.record') and studio.has('button.file.open'))
        self.assertFalse(studio.has('edits.add'), 'there is no room for what was opened first')
        x, _, width, _ = studio.item('viewer.picture')
        self.assertGreater(width, 100)
        studio.key('shift+F8', 'shift+F10')
        studio.settle()
        self.assertTrue(studio.has('edits.add') and studio.has('splitter.mixer'))

    def test_every_tool_of_the_toolbar_is_in_it_or_in_its_list(self):
        for scale in ('1', '1.25', '1.5', '2'):
            with self.subTest(scale):
                studio = self.open_sample(scale=scale)
                shown = self.toolbar(scale)
                self.assertEqual(shown, list(TOOLS[:len(shown)]))
                studio.screenshot('scale_toolbar_' + scale)
                if scale == '1':
                    self.assertEqual(len(shown), len(TOOLS))
                    self.assertFalse(studio.has('button.more_tools'))
                else:
                    self.assertIn('button.more_tools', self.seen())
                    studio.click('button.more_tools')
                    studio.item('menu.help.keys')
                    listed = self.seen()
                    for tool in TOOLS[len(shown):]:
                        self.assertIn('menu.' + tool, listed)
                    studio.screenshot('scale_toolbar_list_' + scale)
                    studio.click('menu.view.probe' if 'view.probe' not in shown else 'menu.view.gallery')
                    studio.settle()
                    self.assertFalse(studio.has('menu.help.keys'), 'the list closes')
                self.assertTrue(studio.quit())


if __name__ == '__main__':
    unittest.main()

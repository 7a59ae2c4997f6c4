"""The window comes back as it stood, and files are chosen where they were chosen last."""
import json
import os
import unittest

from studio_session import Studio, StudioTest


class WindowMemory(StudioTest):
    size = (1920, 1080)

    def begin(self, **options):
        self.studio = Studio(self.display, self.folder, **{'size': None, **options})
        self.studio.item('welcome.open')
        self.studio.settle()
        return self.studio

    def window(self):
        with open(os.path.join(self.folder, '.local/state/swaplight/window.json')) as file:
            return json.load(file)

    def right_end(self):
        """Of what is at the right end of the status bar."""
        return max(x1 for _, _, x1, _ in self.studio.layout()['items'].values())

    def test_the_size_is_kept(self):
        self.begin()
        before = self.right_end()
        self.studio.resize(1200, 800)
        smaller = self.right_end()
        self.assertLess(smaller, before - 300)
        self.assertTrue(self.studio.quit())
        self.assertEqual((self.window()['width'], self.window()['height']), (1200, 800))
        self.begin()
        self.assertEqual(self.right_end(), smaller)
        self.assertTrue(self.studio.quit())

    def test_a_size_that_was_asked_for_once_is_not_kept(self):
        self.begin()
        self.studio.resize(1200, 800)
        self.assertTrue(self.studio.quit())
        self.begin(size='1700x1000')
        self.assertTrue(self.studio.quit())
        self.assertEqual(self.window()['width'], 1200)

    def test_a_session_is_saved_into_a_folder_made_for_it(self):
        self.open_sample()
        self.studio.key('ctrl+shift+s')
        self.studio.item('chooser.name')
        self.studio.key('ctrl+a')
        self.studio.type(self.folder)
        self.studio.key('Return')
        self.studio.settle()
        self.studio.click('chooser.new_folder')
        self.studio.item('chooser.new_folder_name')
        self.studio.type('day/two')
        self.studio.key('Return')
        self.studio.item('chooser.new_folder_error')
        self.studio.key('ctrl+a')
        self.studio.type('day two')
        self.studio.screenshot('window_memory_new_folder')
        self.studio.key('Return')
        self.studio.wait(lambda layout: os.path.isdir(self.path('day two')), 'the folder is made')
        self.studio.settle()
        self.studio.key('ctrl+a')
        self.studio.type('scene 4')
        self.studio.key('Return')
        self.studio.wait(lambda layout: os.path.exists(self.path('day two/scene 4.swaplight')), 'the session is in it')

    def test_files_are_chosen_where_they_were_last(self):
        os.makedirs(self.path('sets/night'))
        self.begin()
        self.studio.click('welcome.open')
        self.studio.item('chooser.name')
        self.studio.type(self.path('sets/night'))
        self.studio.key('Return')
        self.studio.settle()
        self.studio.screenshot('window_memory_chooser')
        self.studio.key('Escape')
        self.studio.settle()
        self.assertTrue(self.studio.quit())
        self.assertEqual(self.window()['folder'], self.path('sets/night'))
        self.begin()
        self.studio.click('welcome.open')
        self.studio.item('chooser.name')
        self.studio.key('Escape')
        self.assertTrue(self.studio.quit())
        self.assertEqual(self.window()['folder'], self.path('sets/night'))

    def test_a_memory_that_cannot_be_read_does_not_matter(self):
        folder = os.path.join(self.folder, '.local/state/swaplight')
        os.makedirs(folder)
        for text in ('{', '{"width": -5, "height": 1e9, "maximized": 7, "folder": 3}', '[]'):
            with open(os.path.join(folder, 'window.json'), 'w') as file:
                file.write(text)
            self.begin()
            self.assertTrue(self.studio.quit(), text)


if __name__ == '__main__':
    unittest.main()

"""The page that the studio starts with: samples and what was open last, as pictures."""
import os
import unittest

import numpy as np

from studio_session import StudioTest


class StartPage(StudioTest):
    def card(self, studio, name, shot):
        """The pixels of a card's picture; its words stand below."""
        x0, y0, x1, y1 = map(int, studio.item(name))
        return studio.screenshot(shot)[y0 + 8:y0 + (x1 - x0) * 9 // 16 - 8, x0 + 8:x1 - 8]

    def has_picture(self, studio, name, shot):
        """Until there is one, the card is flat but for a few words."""
        pixels = self.card(studio, name, shot)
        return np.median(abs(pixels - np.median(pixels))) > 5

    def test_samples_are_pictures(self):
        studio = self.start()
        for sample in ('film_set', 'three_point', 'two_swapped'):
            studio.wait(lambda _: self.has_picture(studio, 'welcome.sample.' + sample, 'start'), 'the picture of ' + sample)
        studio.screenshot('start_page')

    def test_what_was_open_comes_back_as_it_was_seen_last(self):
        studio = self.open_sample('two_swapped')
        studio.wait(lambda _: self.kept() == 1, 'the picture is kept')
        studio.key('ctrl+w')
        studio.item('welcome.recent.0')
        studio.wait(lambda _: self.has_picture(studio, 'welcome.recent.0', 'start_recent'), 'its picture')
        white = self.card(studio, 'welcome.recent.0', 'start_recent').mean()
        studio.click('welcome.recent.0')
        studio.wait_ready()
        studio.click('mixer.left.mute')
        self.save_as('dark')
        studio.settle()
        studio.wait(lambda _: self.kept() == 2, 'the picture is kept')
        studio.key('ctrl+w')
        studio.item('welcome.recent.1')
        studio.wait(lambda _: self.has_picture(studio, 'welcome.recent.0', 'start_dark'), 'the picture of the session')
        self.assertLess(self.card(studio, 'welcome.recent.0', 'start_dark').mean(), .8 * white)
        studio.screenshot('start_page_recent')

    def test_the_tour_points_at_what_it_is_about(self):
        studio = self.start()
        studio.click('welcome.tour')
        studio.wait_ready()
        for step, item in enumerate(('mixer.key.stops', 'light.disc', 'viewer.picture', 'button.brush.take', 'menu.File'), 1):
            studio.wait(lambda _: studio.state('tour') == str(step), f'step {step}')
            studio.settle()
            shot = studio.screenshot(f'tour_{step}').astype(int)
            x0, y0, x1, y1 = map(int, studio.item(item))
            rim = shot[y1 + 2, x0 + 8:x1 - 8]
            self.assertGreater((rim[:, 2] - rim[:, 0]).mean(), 40, f'{item} has a blue frame')
            studio.click('tour.next')
        studio.wait(lambda _: studio.state('tour') == '', 'the end')
        # It does not hold up what it points at.
        studio.click('menu.Help')
        studio.click('menu.help.tour')
        studio.wait(lambda _: studio.state('tour') == '1', 'again')
        studio.click('mixer.key.mute')
        self.assertTrue(self.save_as('toured')[1]['rig']['lights'][0]['mute'])
        studio.key('Escape')
        studio.wait(lambda _: studio.state('tour') == '', 'Escape ends it')

    def kept(self):
        return sum(name.endswith('.png') and not name.startswith('.') for folder, _, names in os.walk(self.folder)
                   if os.path.basename(folder) == 'pictures' for name in names)


if __name__ == '__main__':
    unittest.main()

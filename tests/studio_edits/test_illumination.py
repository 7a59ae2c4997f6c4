"""The light on the set without its texture, in a real window: chosen by mouse, followed by the lights and by edits."""
import unittest

import numpy as np

from studio import StudioTest


class Illumination(StudioTest):
    def light_on_the_set(self, words, name):
        self.show(words, 'Illumination')
        self.studio.settle()
        self.studio.wait(lambda _: self.studio.picture(name).mean() > 8, 'the light on the set is found')
        return self.studio.picture(name)

    def test_the_light_is_shown_without_texture_in_the_colours_of_the_lights(self):
        studio = self.open_sample()
        relit = studio.picture('illumination_relit')
        whole = self.light_on_the_set('Illumination by all lights', 'illumination_all')
        self.assertGreater(np.abs(whole.astype(int) - relit).mean(), 3)
        self.assertGreater(np.ptp(relit.astype(int), axis=-1)[60:-120].max(), 20, 'things have colours')
        self.assertLess(np.ptp(whole.astype(int), axis=-1)[60:-120].max(), 3, 'under white light it is grey')
        studio.click('mixer.key.chip')
        studio.click('light.hex')
        studio.key('ctrl+a')
        studio.type('#ff4000')
        studio.key('Return')
        studio.move(640, 705)
        warm = studio.picture('illumination_warm')
        self.assertGreater((warm[..., 0].astype(int) - warm[..., 2])[60:-120].mean(), 15, 'the key is orange now')
        key = self.light_on_the_set('Illumination by key', 'illumination_key')
        self.assertLess(np.ptp(key.astype(int), axis=-1)[60:-120].max(), 3, 'one light is shown at unit white')
        self.assertGreater(np.abs(key - whole).mean(), 5)

    def test_it_follows_light_edits(self):
        studio = self.open_edits()
        before = self.light_on_the_set('Illumination by key', 'illumination_before_edit')
        self.add('gain')
        x0, y0, x1, y1 = studio.item('parameters.gain')
        studio.drag((round(x0 + .25 * (x1 - x0)), (y0 + y1) // 2), (x0 + 4, (y0 + y1) // 2))
        studio.move(640, 705)
        studio.wait(lambda _: np.abs(studio.picture('illumination_after_edit') - before).mean() > 8,
                    'the light without the edit is replaced')

    def test_pools_are_shown_over_the_picture(self):
        studio = self.open_sample()
        before = studio.picture('pools_before')
        studio.click('menu.View')
        studio.click('menu.view.pools')
        studio.move(640, 705)
        studio.wait(lambda layout: 'key 1' in (layout.get('viewer.pools') or ''), 'the pools are found')
        studio.settle()
        x0, y0, x1, y1 = studio.item('viewer.picture')
        left, top, right, bottom = studio.item('pools.key')
        self.assertTrue(x0 - 5 <= (left + right) / 2 <= x1 + 5 and y0 - 5 <= (top + bottom) / 2 <= y1 + 5)
        self.assertGreater(np.abs(studio.picture('pools').astype(int) - before).max(), 60)
        self.assertTrue(self.save_as('pools')[1]['studio']['pools'])

    def test_the_choice_is_saved_with_the_session(self):
        studio = self.open_sample()
        self.light_on_the_set('Illumination by key', 'illumination_saved')
        view = self.save_as('light')[1]['studio']
        self.assertEqual((view['subject'], view['subject_index']), ('illumination', 0))


if __name__ == '__main__':
    unittest.main()

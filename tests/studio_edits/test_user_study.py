"""The tasks that the dissertation gave its first users (user study 1): a light's intensity, its colour, its dispersion, its
location, and "a cool morning". By mouse alone, as one who knows no key finds them."""
import time
import unittest

import numpy as np

from studio import StudioTest

MOST_SECONDS = 20  # of all processors, a task


class UserStudy(StudioTest):
    def begin(self):
        """The sample with its key light chosen."""
        studio = self.open_sample()
        studio.click('mixer.key.chip')
        studio.settle()
        self.begun = time.time(), studio.processor_seconds()
        return studio

    def done(self, name):
        """The picture after the task, and how long it took."""
        self.studio.settle()
        seconds, work = (now - then for now, then in zip((time.time(), self.studio.processor_seconds()), self.begun))
        print(f'{name}: {seconds:.1f} s, {work:.1f} s of the processors', flush=True)
        self.assertLess(work, MOST_SECONDS)
        return self.seen('study_' + name)

    def seen(self, name):
        self.studio.move(*self.studio.point('status.colors'))  # no tooltip over the picture
        return self.studio.picture(name).astype(float)

    def undo(self, before):
        self.studio.click('button.edit.undo')
        self.assertLess(np.abs(self.seen('study_undone') - before).mean(), .5, 'one undo takes it back')

    def add_edit(self, kind):
        """By the menus; the picture with the edit as it comes, which is as it was."""
        self.studio.click('menu.Window')
        self.studio.click('menu.view.edits')
        self.studio.item('edits.add')
        self.add(kind)
        return self.seen(f'study_{kind}_before')

    def slide(self, item, start, end):
        self.studio.drag(self.studio.point(item, start), self.studio.point(item, end))

    def test_intensity(self):
        studio = self.begin()
        before = self.seen('study_intensity_before')
        self.slide('mixer.key.stops', .5, .35)
        after = self.done('intensity')
        self.assertLess(after.mean(), before.mean() - 5)
        self.assertTrue((after <= before + 3).all(), 'nothing gets brighter')
        self.undo(before)

    def test_color(self):
        studio = self.begin()
        before = self.seen('study_color_before')
        studio.drag(studio.point('light.disc'), studio.point('light.disc', .5, .12))
        change = (self.done('color') - before).reshape(-1, 3).mean(0)
        self.assertGreater(np.ptp(change), 5, 'the picture has another colour')
        self.undo(before)

    def test_dispersion(self):
        studio = self.begin()
        before = self.add_edit('spread')
        self.slide('parameters.width', .25, .05)
        change = (self.done('dispersion') - before).mean(-1)
        x0, y0, _, _ = studio.item('viewer.picture')
        x, y = studio.point('lamp.middle')
        row, column = round(y - y0), round(x - x0)
        middle = change[max(row - 40, 0):row + 40, max(column - 40, 0):column + 40].mean()
        borders = np.concatenate([change[:30].ravel(), change[:, :30].ravel(), change[:, -30:].ravel()]).mean()
        self.assertLess(borders, middle - 2, 'a narrower beam loses its borders')
        self.undo(before)

    def test_location(self):
        self.begin()
        before = self.add_edit('move')
        self.slide('parameters.right', .5, .75)
        change = (self.done('location') - before).mean(-1)
        half = change.shape[1] // 2
        self.assertGreater(change[:, half:].mean(), change[:, :half].mean() + 2, 'the light goes to the right')
        self.undo(before)

    def test_a_cool_morning(self):
        studio = self.begin()
        studio.click('button.view.three_point')
        studio.item('three_point.look.Cool_morning')
        before = self.seen('study_cool_morning_before')
        studio.click('three_point.look.Cool_morning')
        after = self.done('cool_morning')
        blue_over_red = lambda picture: picture[..., 2].mean() / picture[..., 0].mean()
        self.assertGreater(blue_over_red(after), 1.15 * blue_over_red(before), 'it is cooler')
        self.undo(before)


if __name__ == '__main__':
    unittest.main()

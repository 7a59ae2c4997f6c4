"""The mixer in a real window: gels, neutral pixels, several lights at once, groups, names, resets."""
import json
import unittest

import numpy as np

from studio_session import StudioTest


def mean(pixels):
    return pixels.reshape(-1, 3).mean(0)


class Mixer(StudioTest):
    def save(self, name='mixed'):
        """The session's lights by name, as a file has them."""
        rig = self.save_as(name)[1]['rig']
        return rig, {light['name']: light for light in rig['lights']}

    def test_a_gel_is_found_by_typing_and_colours_the_light(self):
        studio = self.open_sample()
        before = mean(studio.picture('mixer_gel_before'))
        studio.click('light.gel')
        studio.item('gel.filter')
        studio.type('L201')
        studio.screenshot('mixer_gel_list')
        studio.key('Return')
        after = mean(studio.picture('mixer_gel'))
        self.assertGreater(after[2] / after[0], 1.05 * before[2] / before[0], 'a blue gel makes it bluer')
        _, lights = self.save()
        self.assertIn('L201', lights['key']['color'])

    def test_a_gel_is_found_as_people_write_it_and_an_empty_list_says_so(self):
        studio = self.open_sample()
        studio.click('light.gel')
        studio.item('gel.filter')
        studio.type('full ctb')
        studio.item('gel.L201')
        self.assertFalse(studio.has('gel.none'))
        studio.type(' nowhere')
        studio.item('gel.none')
        studio.screenshot('mixer_gel_none')

    def test_no_gel_is_in_sight_where_the_list_opens(self):
        studio = self.open_sample()
        studio.click('light.gel')
        studio.item('gel.filter')
        studio.type('L201')
        studio.key('Return')
        studio.settle()
        studio.click('light.gel')
        studio.settle()
        for place in (studio.item('gel.filter'), studio.item('gel.remove')):
            self.assertGreater(place[3] - place[1], 10, 'in sight')
        self.assertLess(studio.item('gel.filter')[1], studio.item('gel.remove')[1])
        studio.screenshot('mixer_gel_opened')
        studio.click('gel.remove')
        studio.settle()
        self.assertNotIn('L201', json.dumps(self.save()[1]['key'].get('color', '')))

    def test_the_number_of_a_level_ends_where_the_switches_end(self):
        studio = self.open_sample()
        for light in ('key', 'fill'):
            self.assertAlmostEqual(studio.item(f'mixer.{light}.number')[2], studio.item(f'mixer.{light}.on')[2], delta=1)

    def test_four_lights_are_in_sight_in_a_low_window(self):
        studio = self.open_sample('film_set')
        lights = ['key', 'fill', 'back', 'practical']
        rows = [studio.item('mixer.' + light) for light in lights]
        self.assertLess(rows[-1][3], studio.item('light.disc')[1] - 16, 'above the colours, not cut off by them')
        for row, light in zip(rows, lights):
            for part in ('chip', 'number_of_light', 'live', 'mute', 'solo', 'on', 'stops', 'number'):
                x0, y0, x1, y1 = studio.item(f'mixer.{light}.{part}')
                self.assertTrue(row[0] <= x0 and row[1] <= y0 and x1 <= row[2] and y1 <= row[3], f'{light}.{part}')
            self.assertLess(studio.item(f'mixer.{light}.live')[2], studio.item(f'mixer.{light}.mute')[0])
            self.assertLess(studio.item(f'mixer.{light}.on')[3], studio.item(f'mixer.{light}.number')[1] + 1)
        studio.click('mixer.practical.mute')
        self.assertEqual(studio.state('mixer.practical.live'), 'muted')
        studio.double_click(*studio.point('mixer.fill.number_of_light'))
        studio.item('mixer.fill.name_field')
        studio.key('ctrl+a')
        studio.type('a window with a name too long')
        studio.key('Return')
        studio.screenshot('mixer_four_lights')
        studio.settle()
        shown = studio.state('mixer.fill.title')
        self.assertTrue(shown.startswith('a window') and shown.endswith('\u2026'), shown)
        self.assertLess(studio.item('mixer.fill.live')[2], studio.item('mixer.fill.mute')[0], 'the level is in sight')

    def test_three_lights_have_wide_rows_in_the_same_window(self):
        studio = self.open_sample()
        _, top, _, bottom = studio.item('mixer.key')
        self.assertGreater(bottom - top, 75)
        self.assertGreater(studio.item('mixer.key.live')[1], studio.item('mixer.key.number_of_light')[1] + 10)

    def test_a_pixel_becomes_neutral_by_one_click(self):
        studio = self.open_sample('two_swapped')
        light = [name for name in studio.layout()['items'] if name.endswith('.chip')][0]
        studio.click(light)
        studio.click('light.neutral') if studio.has('light.neutral') else studio.click('button.light.neutral')
        x, y = studio.point('viewer.picture', 0.5, 0.5)
        before = studio.screenshot('mixer_neutral_before')[y, x]
        studio.click_at(x, y)
        after = studio.screenshot('mixer_neutral')[y, x]
        self.assertLess(np.ptp(after), max(5, np.ptp(before) / 2), f'{before} -> {after}')

    def test_what_is_touched_on_one_of_several_lights_changes_on_all(self):
        studio = self.open_sample()
        studio.click('mixer.key.chip')
        studio.xdotool('keydown', 'ctrl')
        studio.click('mixer.back.chip')
        studio.xdotool('keyup', 'ctrl')
        x0, y0, x1, y1 = studio.item('mixer.key.stops')
        studio.drag(((x0 + x1) // 2, (y0 + y1) // 2), (round(x0 + 0.6 * (x1 - x0)), (y0 + y1) // 2))
        studio.screenshot('mixer_several')
        _, lights = self.save()
        self.assertGreater(lights['key']['stops'], 0.5)
        self.assertEqual(lights['key']['stops'], lights['back']['stops'])
        self.assertEqual(lights['fill'].get('stops', 0), 0)

    def test_a_light_is_copied_onto_another(self):
        studio = self.open_sample()
        studio.click('mixer.key.chip')
        studio.click('light.hex')
        studio.key('ctrl+a')
        studio.type('3200K,+1st')
        studio.key('Return')
        studio.key('ctrl+c')
        studio.click('mixer.fill.chip')
        studio.key('ctrl+v')
        _, lights = self.save()
        self.assertEqual(lights['fill']['color'], lights['key']['color'])
        self.assertEqual(lights['fill']['stops'], 1)

    def test_all_off_is_black_and_the_dot_resets_everything(self):
        studio = self.open_sample()
        before = studio.picture('mixer_reset_before')
        studio.click('menu.Lights')
        studio.click('menu.mixer.all_off')
        self.assertLess(studio.picture('mixer_all_off').mean(), 2)
        studio.click('mixer.reset_all')
        self.assertLess(np.abs(studio.picture('mixer_reset') - before).max(), 2)

    def test_as_captured_shows_the_colours_of_the_first_shot(self):
        studio = self.open_sample()
        before = studio.picture('mixer_captured_before')
        studio.click('menu.Lights')
        studio.click('menu.mixer.as_captured')
        after = studio.picture('mixer_captured')
        self.assertGreater(np.abs(after - before).mean(), 8)
        _, lights = self.save()
        self.assertTrue(all(light['color'].startswith('rgb:') for light in lights.values()), lights)

    def test_a_light_is_renamed_in_place(self):
        studio = self.open_sample()
        studio.click('mixer.key.chip')
        studio.key('F2')
        studio.item('mixer.key.name_field')
        studio.key('ctrl+a')
        studio.type('Big one')
        studio.key('Return')
        studio.screenshot('mixer_renamed')
        _, lights = self.save()
        self.assertEqual(lights['key']['label'], 'Big one')

    def test_the_menu_of_a_light_turns_it_off_and_on(self):
        studio = self.open_sample()
        before = studio.picture('mixer_menu_on')
        for off, name in ((True, 'off'), (False, 'on')):
            studio.click('mixer.back.chip', button=3)
            studio.screenshot('mixer_light_menu')
            studio.click('light_menu.off')
            studio.move(*studio.point('viewer.picture', .5, .02))
            self.assertEqual(np.abs(studio.picture('mixer_menu_' + name) - before).max() > 10, off)
            self.assertEqual(self.save(name)[1]['back'].get('on', True), not off)

    def test_a_group_has_a_fader(self):
        studio = self.open_sample()
        studio.click('mixer.key.chip', button=3)
        studio.click('light_menu.group')
        studio.click('light_menu.new_group')
        studio.type('front')
        studio.key('Return')
        before = mean(studio.picture('mixer_group_before'))
        x0, y0, x1, y1 = studio.item('mixer.group.front.stops')
        studio.drag(((x0 + x1) // 2, (y0 + y1) // 2), (round(x0 + 0.3 * (x1 - x0)), (y0 + y1) // 2))
        self.assertTrue((mean(studio.picture('mixer_group')) < before - 3).all())
        rig, lights = self.save()
        self.assertEqual(lights['key']['group'], 'front')
        self.assertLess(rig['groups'][0]['stops'], -1)


if __name__ == '__main__':
    unittest.main()

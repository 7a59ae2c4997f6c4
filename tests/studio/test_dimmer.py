"""The dimmer of a light by mouse, wheel and keyboard: words for levels, fine steps, nothing beyond the slider unasked."""
import unittest

from studio_session import StudioTest


class Dimmer(StudioTest):
    size = (1600, 900)

    def lights(self, name):
        return {light['name']: light for light in self.save_as(name)[1]['rig']['lights']}

    def stops(self, name, light='key'):
        return self.lights(name)[light].get('stops', 0)

    def type_level(self, text, light='key', key='Return'):
        self.studio.double_click(*self.studio.point(f'mixer.{light}.number'))
        self.studio.settle()
        self.studio.key('ctrl+a')
        self.studio.type(text)
        self.studio.key(key)
        self.studio.settle()

    def test_levels_are_typed_in_words(self):
        self.open_sample()
        for n, (text, stops) in enumerate((('50%', -1), ('x2', 1), ('-1.5st', -1.5), ('at25', None), ('full', 0), ('@25', -2),
                                           ('1', 1))):
            self.type_level(text)
            if stops is None:
                self.studio.item('mixer.level_note')
                self.studio.screenshot('dimmer_wrong')
                self.studio.key('Escape')
                self.studio.settle()
                self.assertFalse(self.studio.has('mixer.level_note'))
                stops = -1.5
            self.assertAlmostEqual(self.stops(f'words{n}'), stops, 5, text)

    def test_beyond_the_slider_only_by_a_second_enter(self):
        self.open_sample()
        self.type_level('+12st')
        self.studio.item('mixer.level_note')  # it asks: nothing is taken yet
        self.studio.screenshot('dimmer_beyond')
        self.studio.key('Return')
        self.studio.settle()
        self.assertFalse(self.studio.has('mixer.level_note'))
        self.assertAlmostEqual(self.stops('beyond'), 12, 5)

    def test_tab_types_the_next_light(self):
        self.open_sample()
        self.type_level('50%', key='Tab')
        self.studio.type('25%')
        self.studio.key('Return')
        self.studio.settle()
        lights = self.lights('tabbed')
        self.assertAlmostEqual(lights['key']['stops'], -1, 5)
        self.assertAlmostEqual(lights['fill']['stops'], -2, 5)

    def test_several_lights_all_go_to_the_level(self):
        studio = self.open_sample()
        self.type_level('-3st')
        studio.click('mixer.key.chip')
        studio.xdotool('keydown', 'ctrl')
        studio.click('mixer.back.chip')
        studio.xdotool('keyup', 'ctrl')
        self.type_level('50%')
        lights = self.lights('several')
        self.assertEqual([lights[name].get('stops', 0) for name in ('key', 'back', 'fill')], [-1, -1, 0])

    def test_wheel_and_arrows_step_and_are_undone_at_once(self):
        studio = self.open_sample()
        x, y = studio.point('mixer.key.stops')
        studio.move(x, y)
        studio.xdotool('click', '--repeat', 3, '--delay', 60, 4)
        studio.settle()
        self.assertAlmostEqual(self.stops('wheel'), 0.3, 4)
        studio.move(x, y)
        studio.xdotool('key', 'Left')
        studio.xdotool('keydown', 'shift', 'key', 'Left', 'keyup', 'shift')
        studio.settle()
        self.assertAlmostEqual(self.stops('arrows'), 0.19, 4)
        studio.move(x, y)
        studio.xdotool('key', 'Right', 'key', 'Right', 'key', 'Right', 'key', 'ctrl+z')
        studio.settle()
        self.assertAlmostEqual(self.stops('undone'), 0.19, 4, 'three steps are one')

    def test_shift_drags_finely(self):
        studio = self.open_sample()
        x0, y0, x1, y1 = studio.item('mixer.key.stops')
        middle, y = (x0 + x1) // 2, (y0 + y1) // 2
        place = .1 * 2 * 40 / (x1 - x0 - 10)  # a tenth of the way; around 0 a stop is two and a half times as wide
        expected = 10 * place * (.4 + .6 * place ** 2)
        studio.move(middle, y)
        studio.xdotool('keydown', 'shift')
        studio.drag((middle, y), (middle + 40, y))
        studio.xdotool('keyup', 'shift')
        studio.settle()
        self.assertAlmostEqual(self.stops('fine'), expected, delta=0.02)
        studio.screenshot('dimmer')

    def live(self):
        self.studio.settle()
        return [self.studio.state(f'mixer.{light}.live') for light in ('key', 'fill', 'back')]

    def row_ink(self, shot, light):
        """How bright the brightest of the light's title and slider is."""
        x0, y0, x1, y1 = map(int, self.studio.item(f'mixer.{light}.stops'))
        return shot[y0:y1, x0:x1].max()

    def test_rows_say_what_comes_out_and_grey_where_nothing_does(self):
        studio = self.open_sample()
        studio.move(*studio.point('viewer.picture', 0.5, 0.05))
        self.assertEqual(self.live(), ['100 %'] * 3)
        bright = self.row_ink(studio.screenshot('rows_all'), 'fill')
        studio.click('mixer.key.solo')
        studio.move(*studio.point('viewer.picture', 0.5, 0.05))
        self.assertEqual(self.live(), ['100 %', 'not in solo', 'not in solo'])
        solo = studio.screenshot('rows_solo')
        self.assertLess(self.row_ink(solo, 'fill'), bright - 40)
        self.assertGreaterEqual(self.row_ink(solo, 'key'), bright)
        studio.click('mixer.key.mute')
        self.assertEqual(self.live(), ['muted', 'not in solo', 'not in solo'])
        studio.click('mixer.key.solo')
        studio.click('mixer.back.on')
        self.type_level('25%', light='fill')
        studio.move(*studio.point('viewer.picture', 0.5, 0.05))
        self.assertEqual(self.live(), ['muted', '25 %', 'off'])
        shot = studio.screenshot('rows_muted')
        self.assertLess(self.row_ink(shot, 'key'), bright - 40)
        self.assertGreaterEqual(self.row_ink(shot, 'fill'), bright)
        self.type_level('50%', light='key')  # what gives nothing can be set all the same
        self.assertEqual(self.live(), ['muted', '25 %', 'off'])
        self.assertAlmostEqual(self.stops('muted', 'key'), -1, 5)


if __name__ == '__main__':
    unittest.main()

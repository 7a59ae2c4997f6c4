"""The command line of the studio by keyboard: lights by number and name, completion, history, what is wrong."""
import json
import os
import time
import unittest

from studio_session import StudioTest


class CommandLine(StudioTest):
    size = (1600, 900)

    def open_line(self):
        studio = self.open_sample()
        studio.move(*studio.point('viewer.picture', 0.5, 0.05))
        studio.key('ctrl+l')
        studio.item('desk.line')
        studio.settle()
        return studio

    def run_line(self, text):
        self.studio.type(text)
        self.studio.key('Return')
        self.studio.settle()

    def lights(self, name):
        return {light['name']: light for light in self.save_as(name)[1]['rig']['lights']}

    def answer(self):
        return self.studio.state('desk.answer_words')

    def test_lights_are_set_by_number_and_name(self):
        studio = self.open_line()
        studio.screenshot('command_line_empty')
        self.run_line('1 thru 3 @ 50')
        self.assertEqual([studio.state(f'mixer.{light}.live') for light in ('key', 'fill', 'back')], ['50 %'] * 3)
        self.run_line('key gel L201 3200K')
        self.run_line('all - key mute')
        studio.screenshot('command_line_used')
        self.assertEqual(self.answer(), 'fill, back')
        self.run_line('@ 25')  # those that were named last
        self.run_line('undo')
        studio.key('Escape')
        lights = self.lights('desk')
        self.assertEqual(lights['key']['color'], '3200K,gel:L201')
        self.assertEqual([lights[name].get('stops', 0) for name in ('key', 'fill', 'back')], [-1, -1, -1])
        self.assertEqual([lights[name].get('mute', False) for name in ('key', 'fill', 'back')], [False, True, True])

    def test_what_is_wrong_is_said_and_can_be_put_right(self):
        studio = self.open_line()
        self.run_line('kay @ 50')
        self.assertIn("'kay' is no light and no setting: lights are 1 key, 2 fill, 3 back", self.answer())
        studio.screenshot('command_line_wrong')
        studio.key('Home', 'Right', 'Delete')
        studio.type('e')
        studio.key('Return')
        studio.settle()
        self.assertEqual(studio.state('mixer.key.live'), '50 %')

    def test_tab_completes_and_up_brings_lines_back(self):
        studio = self.open_line()
        studio.type('fi')
        studio.key('Tab')
        studio.type('gel l20')
        studio.settle()
        self.assertIn('L201', self.answer())
        studio.screenshot('command_line_ends')
        studio.type('1')
        studio.key('Return')
        studio.settle()
        self.run_line('back off')
        self.assertEqual(studio.state('mixer.back.live'), 'off')
        self.run_line('back on')
        studio.key('Up', 'Up', 'Return')
        studio.settle()
        self.assertEqual(studio.state('mixer.back.live'), 'off')
        studio.key('Escape')
        self.assertEqual(self.lights('completed')['fill']['color'], 'gel:L201')

    def test_looks_and_actions_are_commands_too(self):
        studio = self.open_line()
        self.run_line('look moonlight')
        self.assertEqual(self.answer(), 'Moonlight')
        self.run_line('view.scopes')
        self.assertEqual(self.answer(), 'Scopes')
        self.run_line('look 7')
        self.assertIn('there is no look 7', self.answer())

    def test_go_fades_from_look_to_look(self):
        studio = self.open_line()
        studio.key('Escape')
        studio.key('shift+k')  # look 1: as photographed
        studio.key('ctrl+l')
        studio.settle()
        self.run_line('key @ 25')
        studio.key('Escape')
        studio.key('shift+k')  # look 2: a dim key
        studio.key('ctrl+l')
        studio.settle()
        self.run_line('go 1 in 0')
        self.assertEqual(studio.state('mixer.key.live'), '100 %')
        studio.type('go in 4')
        studio.key('Return')
        levels = set()
        end = time.time() + 60
        while studio.state('desk.fading') == 'yes' and time.time() < end:
            levels.add(studio.state('mixer.key.live'))
        self.assertGreater(len(levels - {'100 %', '25 %'}), 1, 'levels between the looks')
        self.assertEqual(studio.state('mixer.key.live'), '25 %')
        self.assertEqual(self.answer(), '2 Look 2 in 4 s')
        studio.screenshot('command_line_go')
        self.run_line('go back in 0')
        self.assertEqual(studio.state('mixer.key.live'), '100 %')
        self.run_line('go')
        self.run_line('go')
        self.assertEqual(self.answer(), 'Look 2 is the last look of the gallery')
        studio.key('Escape')
        studio.click('button.cues.back')
        studio.settle()
        self.assertEqual(studio.state('mixer.key.live'), '100 %')
        studio.key('ctrl+z')  # a fade is one step
        studio.settle()
        self.assertEqual(studio.state('mixer.key.live'), '25 %')

    def test_the_line_stays_open_for_the_next_start(self):
        studio = self.open_line()
        studio.key('Escape')
        self.assertTrue(studio.quit())
        with open(os.path.join(self.folder, '.local/state/swaplight/panels.json')) as file:
            self.assertTrue(json.load(file)['command_line'])


if __name__ == '__main__':
    unittest.main()

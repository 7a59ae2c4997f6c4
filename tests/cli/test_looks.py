"""swaplight relight --look"""
import json

import numpy as np
import swaplight_cli as cli


class Looks(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        for light in self.capture.manifest['lights']:
            light['role'] = light['name']
        self.capture.save()
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '--float', '-q')

    def frame(self, *arguments, source=None):
        frame = self.path('frame.exr')
        return self.succeed_json('relight', source or self.solved, *arguments, '-o', frame), cli.read_rgb(frame)

    def test_a_look_lights_by_role_and_in_part(self):
        _, white = self.frame()
        result, whole = self.frame('--look', 'golden-hour')
        lights = {light['name']: light for light in result['rig']['lights']}
        self.assertEqual(lights['key']['color'], '2700K')
        self.assertEqual(lights['fill']['color'], '9500K')
        _, part = self.frame('--look', 'Golden Hour:0.25')
        np.testing.assert_allclose(part, .75 * white + .25 * whole, rtol=2e-3, atol=1e-3)
        _, none = self.frame('--look', 'golden_hour:0')
        np.testing.assert_array_equal(none, white)

    def test_what_light_says_holds_over_the_look(self):
        result, _ = self.frame('--look', 'neon', '--light', 'key=5600K')
        lights = {light['name']: light for light in result['rig']['lights']}
        self.assertEqual(lights['key']['color'], '5600K')
        self.assertIn('hsv', lights['fill']['color'])

    def test_a_session_has_looks_of_its_own(self):
        session = self.path('mine.swaplight')
        rig = {'lights': [{'name': 'key', 'color': '#ff0000'}, {'name': 'fill', 'on': False}]}
        with open(session, 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr',
                       'looks': [{'name': 'Red alert', 'note': 'scene 12', 'rig': rig}]}, file)
        result, _ = self.frame('--look', 'red-alert', source=session)
        lights = {light['name']: light for light in result['rig']['lights']}
        self.assertEqual((lights['key']['color'], lights['fill']['on']), ('#ff0000', False))
        self.deny('relight', session, '--look', 'Nite', '-o', self.path('x.exr'), naming='there are: Red alert, High key')

    def test_what_cannot_be_is_said_in_one_line(self):
        frame = self.path('x.exr')
        self.deny('relight', self.solved, '--look', 'noir', '-o', frame, naming='there are: High key')
        self.deny('relight', self.solved, '--look', 'neon:3', '-o', frame, naming='from 0 to 1')


if __name__ == '__main__':
    cli.main()

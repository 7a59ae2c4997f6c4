"""swaplight relight --cues and swaplight cues: a show played as a sequence, and as keys of its lights."""
import json
import os

import numpy as np
import swaplight_cli as cli

FPS = 8


def light(name, stops=0, **more):
    return {'name': name, 'color': 'white', 'stops': stops, **more}


def rig(key, fill):
    return {'lights': [light('key', key), light('fill', fill)]}


def gain(factor, opacity=1):
    return {'name': 'Gain', 'opacity': opacity, 'lights': ['key'], 'meaning': 'add', 'operation': 'gain', 'gain': factor}


def edits(*all_of_them):
    return {'format': 'swaplight-edits', 'version': 1, 'edits': list(all_of_them)}


class CuesTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        capture = cli.Capture(self.path('set'))
        self.solved = self.path('solved.exr')
        self.succeed('solve', capture.path, '-o', self.solved, '--model', 'transport', '--float', '-q')
        channels = cli.read_image(self.solved)
        self.lights = [np.stack([channels[f'{name}.{c}'] for c in 'RGB'], -1) for name in ('key', 'fill')]

    def session(self, looks, cues, name='show.swaplight', **more):
        path = self.path(name)
        with open(path, 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr', 'rig': rig(0, 0),
                       'looks': looks, 'cues': cues, **more}, file)
        return path

    def day_and_night(self):
        return self.session([{'name': 'Day', 'rig': rig(0, 0)}, {'name': 'Night', 'rig': rig(-3, 1)}],
                            [{'id': 1, 'look': 'Day', 'follow': 0.5}, {'id': 2, 'look': 'Night', 'fade': 2}])

    def play(self, source, *arguments, out='cue.####.exr'):
        result = cli.run('relight', source, '-o', self.path(out), '--type', 'float', '--json', *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def frame(self, number, name='cue'):
        return cli.read_rgb(self.path(f'{name}.{number:04d}.exr'))

    def test_a_show_is_played_and_fades_evenly_in_linear_light(self):
        frames = self.play(self.day_and_night(), '--cues', '--cue-fps', FPS, '--hold', 0.25)['frames']
        self.assertEqual(len(frames), 1 + 4 + 16 + 2)
        day = self.lights[0] + self.lights[1]
        night = self.lights[0] / 8 + self.lights[1] * 2
        for number in range(1, 24):
            amount = np.clip((number - 5) / 16, 0, 1)
            np.testing.assert_allclose(self.frame(number), (1 - amount) * day + amount * night, rtol=2e-6, atol=1e-7)

    def test_its_keys_make_the_same_frames_to_the_bit(self):
        show = self.day_and_night()
        self.play(show, '--cues', '--cue-fps', FPS)
        keys = self.path('keys.json')
        result = cli.run('cues', show, '--cue-fps', FPS, '--keys', keys, '--json')
        self.assertEqual(result.returncode, 0, result.stderr)
        listed = json.loads(result.stdout)
        self.assertEqual([(cue['id'], cue['first_whole_frame'], cue['last_frame']) for cue in listed['cues']],
                         [(1, 1, 5), (2, 21, 29)])
        self.play(self.solved, '--rig', keys, '-F', '1-29', out='key.####.exr')
        with open(keys) as file:
            animation = json.load(file)['animation']['lights']
        arguments = [word for name, all_keys in animation.items() for key in all_keys
                     for word in ('--key', f'{name}@{key["frame"]}={key["setting"]}')]
        self.play(self.solved, '-F', '1-29', *arguments, out='typed.####.exr')
        for number in range(1, 30):
            for name in ('key', 'typed'):
                self.assertTrue(np.array_equal(self.frame(number), self.frame(number, name)), (name, number))

    def test_a_part_of_it_is_the_same(self):
        show = self.day_and_night()
        self.play(show, '--cues', '--cue-fps', FPS)
        self.play(show, '--cues', '--cue-fps', FPS, '-F', '11-13', '--frame-index', 1, '--frame-count', 3, out='part.####.exr')
        self.assertTrue(np.array_equal(self.frame(12), self.frame(12, 'part')))
        self.assertFalse(os.path.exists(self.path('part.0011.exr')))

    def test_edits_fade_by_their_opacity(self):
        size = [self.lights[0].shape[1], self.lights[0].shape[0]]
        scene = {'edits': {**edits(gain(0.5)), 'size': size}}
        show = self.session([{'name': 'Plain', 'rig': rig(0, 0), 'scene': {}},
                             {'name': 'Half', 'rig': rig(0, 0), 'scene': scene}],
                            [{'id': 1, 'look': 'Plain'}, {'id': 2, 'look': 'Half', 'fade': 1}])
        self.play(show, '--cues', '--cue-fps', FPS, '--hold', 0)
        for number, opacity in ((1, 0), (3, 0.25), (5, 0.5), (9, 1)):
            path = self.path('edits.json')
            with open(path, 'w') as file:
                json.dump(edits(gain(0.5, opacity)), file)
            still = self.path('still.exr')
            self.succeed('relight', self.solved, *(['--edits', path] if opacity else []), '-o', still, '--type', 'float', '-q')
            self.assertTrue(np.array_equal(cli.read_rgb(still), self.frame(number)), number)
        self.assertGreater(np.abs(self.frame(1) - self.frame(9)).max(), 0.01)
        warned = self.succeed('cues', show, '--keys', self.path('keys.json'))
        self.assertIn('light edits change from cue to cue', warned.stderr)

    def test_a_version_is_a_look_of_the_command_line(self):
        size = [self.lights[0].shape[1], self.lights[0].shape[0]]
        scene = {'edits': {**edits(gain(0.5)), 'size': size}}
        show = self.session([{'name': 'Half', 'rig': rig(-1, 0), 'scene': scene}], [])
        frame = self.path('frame.exr')
        self.succeed('relight', show, '--look', 'Half', '-o', frame, '--type', 'float', '-q')
        path = self.path('edits.json')
        with open(path, 'w') as file:
            json.dump(edits(gain(0.5)), file)
        again = self.path('again.exr')
        self.succeed('relight', self.solved, '--edits', path, '--light', 'key=-1st', '-o', again, '--type', 'float', '-q')
        self.assertTrue(np.array_equal(cli.read_rgb(frame), cli.read_rgb(again)))

    def test_cues_are_changed_by_lines(self):
        show = self.day_and_night()
        self.succeed('cues', show, '--cue', '2 time 4 follow 1', '--cue', '1.5 look Night')
        with open(show) as file:
            cues = json.load(file)['cues']
        self.assertEqual([(cue['id'], cue['look'], cue['fade']) for cue in cues],
                         [(1, 'Day', 3), (1.5, 'Night', 3), (2, 'Night', 4)])
        self.assertEqual(cues[2]['follow'], 1)
        self.succeed('cues', show, '--cue', '1.5 remove', '-o', self.path('other.swaplight'))
        with open(show) as file:
            self.assertEqual(len(json.load(file)['cues']), 3, 'the other file was written')

    def test_what_is_wrong_is_said(self):
        show = self.day_and_night()
        out = self.path('out.####.exr')
        self.deny('relight', show, '--cues', '--light', 'key=off', '-o', out, naming='--light')
        self.deny('relight', self.solved, '--cues', '-o', out, naming='session')
        self.deny('relight', show, '--cues', '-o', self.path('out.exr'), naming='%04d')
        self.deny('relight', show, '--cues', '--cue-fps', 0, '-o', out, naming='frames a second')
        empty = self.session([{'name': 'Day', 'rig': rig(0, 0)}], [], 'empty.swaplight')
        refused = cli.run('relight', empty, '--cues', '-o', out)
        self.assertEqual((refused.returncode, refused.stdout), (2, ''))
        self.assertIn('the cue list is empty', refused.stderr.splitlines()[-1])
        lost = self.session([], [{'id': 1, 'look': 'Day'}], 'lost.swaplight')
        refused = cli.run('relight', lost, '--cues', '-o', out)
        self.assertEqual((refused.returncode, refused.stdout), (2, ''))
        self.assertIn('cue 1: the gallery has no look "Day"', refused.stderr.splitlines()[-1])
        self.deny('cues', show, '--cue', '7 time 4', naming='no cue 7')
        self.deny('cues', self.session([], [{'id': 'x', 'look': 'Day'}], 'bad.swaplight'), naming='id')


if __name__ == '__main__':
    cli.main()

"""Versions and cues by mouse and keyboard: a show of five cues on the film set, played, undone, exported, and equal to the
frames of relight --key."""
import json
import os
import subprocess
import time
import unittest

import numpy as np
import OpenImageIO as oiio

from studio_session import PROGRAM, SAMPLES, StudioTest

LOOKS = ['all @ full', 'key @ 25', 'key 3200K @ 50', 'all - key @ 10', 'key out']  # one over the other
FPS, HOLD = 4, 0.25


def pixels(path):
    source = oiio.ImageInput.open(path)
    assert source, oiio.geterror()
    values = np.asarray(source.read_image('float'))
    source.close()
    return values


class Cues(StudioTest):
    size = (1920, 1080)

    def run_line(self, text):
        self.studio.type(text)
        self.studio.key('Return')
        self.studio.settle()

    def answer(self):
        return self.studio.state('desk.answer_words')

    def program(self, *arguments):
        subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True)

    def open_line(self, *path):
        studio = self.start(*path) if path else self.open_sample()
        studio.wait_ready()
        studio.move(*studio.point('viewer.picture', 0.5, 0.05))
        studio.key('shift+F8', 'ctrl+l')
        studio.item('desk.line')
        studio.item('button.cues.record')
        studio.settle()
        return studio

    def wait_still(self):
        self.studio.wait(lambda layout: layout.get('desk.fading') == 'no', 'the fade has ended')

    def test_a_show_of_five_cues(self):
        solved = self.path('film.exr')
        self.program('solve', os.path.join(SAMPLES, 'film_set'), '-o', solved, '-q')
        studio = self.open_line(solved)
        self.assertEqual(studio.state('cues.words'), 'No cues yet: light the set, then Record.')
        for number, line in enumerate(LOOKS, 1):
            self.run_line(line)
            if number == 1:
                studio.click('button.cues.record')
                studio.click('desk.line')
            else:
                self.run_line('record')
        self.assertEqual(self.answer(), 'Recorded cue 5')
        self.run_line('cue 2 thru 5 time 0.5')
        self.run_line('cue 3 follow 0.25')
        studio.screenshot('cues_recorded')

        # Played: GO by the line, by keys, by the button; cue 4 follows cue 3 by itself.
        self.run_line('go 1 in 0')
        self.wait_still()
        self.assertEqual(studio.state('mixer.key.live'), '100 %')
        self.assertEqual(studio.state('cue.1.state'), 'stands')
        self.assertEqual(studio.state('cue.2.state'), 'next')
        self.run_line('cue 2 time 4')
        studio.key('Escape', 'ctrl+Return')
        levels, end = set(), time.time() + 60
        while studio.state('desk.fading') == 'yes' and time.time() < end:
            levels.add(studio.state('mixer.key.live'))
        self.assertGreater(len(levels - {'100 %', '25 %'}), 1, 'levels between the cues')
        self.assertEqual(studio.state('mixer.key.live'), '25 %')
        studio.key('ctrl+l')
        self.run_line('cue 2 time 0.5')
        studio.click('button.cues.go')
        studio.wait(lambda layout: layout.get('cue.4.state') == 'stands' and layout.get('desk.fading') == 'no',
                    'cue 4 has followed cue 3')
        self.assertEqual(studio.state('mixer.fill.live'), '10 %')
        studio.screenshot('cues_followed')
        studio.click('button.cues.back')
        studio.wait(lambda layout: layout.get('cue.3.state') == 'stands', 'back to cue 3')
        studio.click('cue.5')  # cue 4 is left out
        studio.click('button.cues.go')
        studio.wait(lambda layout: layout.get('cue.5.state') == 'stands', 'cue 5, which was loaded')
        self.wait_still()
        self.assertEqual(studio.state('mixer.key.live'), 'level 0')

        # Every fade is one step.
        studio.key('Escape', 'ctrl+z')
        studio.settle()
        self.assertNotEqual(studio.state('mixer.key.live'), 'level 0')
        studio.key('ctrl+shift+z')
        studio.settle()
        self.assertEqual(studio.state('mixer.key.live'), 'level 0')

        session, saved = self.save_as('show')
        self.assertEqual([(cue['id'], cue['look'], cue['fade'], cue.get('follow')) for cue in saved['cues']],
                         [(1, 'Cue 1', 3, None), (2, 'Cue 2', 0.5, None), (3, 'Cue 3', 0.5, 0.25), (4, 'Cue 4', 0.5, None),
                          (5, 'Cue 5', 0.5, None)])
        self.same_frames(session, solved)

    def same_frames(self, session, solved):
        """What the export dialog writes of the show, and what relight makes of its keys."""
        studio = self.studio
        keys = self.path('keys.json')
        self.program('cues', session, '--cue-fps', FPS, '--hold', HOLD, '--keys', keys)
        studio.key('ctrl+e')
        studio.click('export.kind.sequence')
        studio.click('export.format.exr')
        for field, value in (('export.fps', FPS), ('export.hold', HOLD)):
            studio.click(field)
            studio.key('ctrl+a')
            studio.type(str(value))
            studio.key('Tab')
        studio.click('export.file')
        studio.key('ctrl+a')
        studio.type(self.path('studio.####.exr'))
        studio.screenshot('cues_export')
        studio.click('export.accept')
        # Each cue stands for the hold or its follow, a frame; a fade takes two.
        last = 2 + 4 * 3
        studio.wait(lambda _: os.path.exists(self.path(f'studio.{last:04d}.exr')), 'the last frame', 300)
        self.program('relight', solved, '--rig', keys, '-F', f'1-{last}', '-o', self.path('keyed.####.exr'), '-q')
        for frame in range(1, last + 1):
            made, keyed = (pixels(self.path(f'{name}.{frame:04d}.exr')) for name in ('studio', 'keyed'))
            self.assertTrue(np.array_equal(made, keyed), frame)
        self.assertGreater(np.abs(pixels(self.path('studio.0001.exr')) - made).max(), 0.1)

    def stands(self, number, why='the cue that stands'):
        self.studio.wait(lambda layout: layout.get('desk.current') == number, why)

    def test_the_cue_that_stands_follows_undo_and_new_numbers(self):
        studio = self.open_line()
        for line in ('record', 'key @ 50', 'record 2', 'key @ 10', 'record 3', 'go 1 in 0', 'go in 0'):
            self.run_line(line)
        self.stands('2')
        studio.key('ctrl+z')
        studio.settle()
        self.stands('1', 'the line of commands lets Ctrl+Z through')
        studio.key('ctrl+Return')
        self.wait_still()
        self.stands('2', 'no cue is left out')
        studio.key('ctrl+z')
        studio.key('ctrl+shift+z')
        studio.settle()
        self.stands('2')
        self.run_line('cue 2 number 2.5')
        self.stands('2.5')
        self.run_line('go 3 in 60')
        studio.key('ctrl+z')
        studio.settle()
        self.stands('2.5')

    def test_times_are_typed_into_the_list_and_undone(self):
        studio = self.open_line()
        self.run_line('record')
        self.run_line('record')
        studio.key('Escape')
        studio.click('cue.2.time')
        studio.key('ctrl+a')
        studio.type('4.5')
        studio.key('Return')
        studio.click('cue.2.follow')
        studio.type('2')
        studio.click('cue.1.time')  # what was typed counts when the field is left, too
        studio.key('ctrl+a')
        studio.type('soon')
        studio.key('Return')
        studio.item('message.0')
        studio.settle()
        _, saved = self.save_as('times')
        self.assertEqual([(cue['fade'], cue.get('follow')) for cue in saved['cues']], [(3, None), (4.5, 2)])
        studio.click('cue.1.menu')
        studio.click('cue.1.remove')
        studio.settle()
        self.assertFalse(studio.has('cue.1'))
        studio.key('ctrl+z', 'ctrl+z')
        studio.settle()
        self.assertTrue(studio.has('cue.1'))
        _, saved = self.save_as('undone')
        self.assertNotIn('follow', saved['cues'][1])

    def times(self, name):
        return [(cue['fade'], cue.get('follow')) for cue in self.save_as(name)[1]['cues']]

    def pull(self, key, seconds, shift=False):
        """Drags a key of the line of time by so many seconds."""
        studio = self.studio
        x, y = studio.point(key)
        if shift:
            studio.xdotool('keydown', 'shift')
        studio.drag((x, y), (max(1, x + round(seconds * self.pixels_a_second())), y))
        if shift:
            studio.xdotool('keyup', 'shift')
        studio.move(*studio.point('viewer.picture'))

    def pixels_a_second(self):
        """Cue 2 begins where cue 1 ends and stands after its fade."""
        fade = self.shown_fade
        return (self.studio.point('cue.2.stand')[0] - self.studio.point('cue.2.begin')[0]) / fade

    def test_keys_of_the_line_of_time_are_dragged_and_undone(self):
        studio = self.open_line()
        for _ in range(3):
            self.run_line('record')
        self.run_line('cue 2 thru 3 time 4')
        self.run_line('cue 1 follow 2')
        studio.key('Escape')
        self.shown_fade = 4
        studio.screenshot('cue_track')
        self.pull('cue.2.stand', 2)
        (_, _), (fade, _), (other, _) = self.times('faded')
        self.assertAlmostEqual(fade, 6, delta=.15)
        self.assertAlmostEqual(fade * 10, round(fade * 10), places=3, msg='to a tenth of a second')
        self.assertEqual(other, 4, 'what comes later moves along')
        self.shown_fade = fade
        self.pull('cue.2.begin', -1)
        (_, follow), (same, _), _ = self.times('begun')
        self.assertAlmostEqual(follow, 1, delta=.15)
        self.assertEqual(same, fade)
        self.pull('cue.3.begin', 2)  # cue 2 waited for GO
        self.assertAlmostEqual(self.times('follows')[1][1], 3, delta=.15)
        studio.key('ctrl+z')
        self.assertIsNone(self.times('waits_again')[1][1])
        studio.key('ctrl+z', 'ctrl+z')
        self.assertEqual(self.times('undone_all'), [(3, 2), (4, None), (4, None)])
        studio.key('ctrl+shift+z')
        self.assertEqual(self.times('redone')[1][0], fade)
        self.shown_fade = fade
        self.pull('cue.2.stand', .5, shift=True)
        fine = self.times('fine')[1][0]
        self.assertAlmostEqual(fine, fade + .5, delta=.06)
        self.pull('cue.2.begin', -50)
        self.assertEqual(self.times('least')[0][1], 0)

    def test_a_version_brings_its_edits_back(self):
        studio = self.open_edits()
        self.add('gain')
        studio.key('shift+v')
        studio.item('gallery.0')
        _, saved = self.save_as('kept')
        self.assertEqual(saved['looks'][0]['name'], 'Version 1')
        self.assertEqual(len(saved['looks'][0]['scene']['edits']['edits']), 1)
        studio.click('edits.0', x=0.6, y=0.5)
        studio.key('Delete')
        studio.settle()
        studio.click('gallery.0')
        studio.settle()
        studio.screenshot('version_recalled')
        _, saved = self.save_as('recalled')
        self.assertEqual(len(saved['edits']['edits']), 1)


if __name__ == '__main__':
    unittest.main()

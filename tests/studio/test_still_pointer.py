"""A person acts and then holds still, or is quicker than the studio draws: nothing is lost, and nothing waits for the
next twitch of the mouse."""
import json
import os
import shutil
import time
import unittest

from studio_session import SAMPLES, StudioTest

PATIENCE = 10  # seconds, on a busy machine: what waits for a twitch of the mouse never comes
WATCHED = 2  # seconds
MOST_AT_REST = 0.1  # of one processor, for the timers; drawing all the time takes all of one and more
SLOW = {'SWAPLIGHT_FRAME_SECONDS': '0.2'}  # five frames a second


class StillPointer(StudioTest):
    """No input but what is said, not even the tests' own key: between two of them the window may sleep."""

    def still(self, *words):
        """Does it all at once, then keeps its hands off."""
        self.studio.xdotool(*words)

    def photographs(self):
        folder = self.path('shots')
        os.makedirs(folder)
        with open(os.path.join(SAMPLES, 'two_swapped', 'capture.json')) as file:
            shots = [shot['image'] for shot in json.load(file)['shots']]
        for shot in shots:
            shutil.copy(os.path.join(SAMPLES, 'two_swapped', shot), folder)
        return folder

    def test_a_tooltip_comes_though_nothing_moves(self):
        studio = self.open_sample()
        studio.settle()
        for button in ('button.brush.take', 'bar.exposure', 'mixer.key.on'):
            x, y = studio.point(button)
            studio.move(640, 400)
            self.assertIsNone(studio.layout()['items'].get('tooltip'), button)
            self.still('mousemove', x, y)
            studio.wait(lambda layout: 'tooltip' in layout['items'], 'the tooltip of ' + button, PATIENCE)
        studio.screenshot('still_tooltip')

    def test_a_dialog_follows_a_dialog(self):
        studio = self.open_sample()
        studio.click('mixer.key.on')
        studio.key('ctrl+n')
        x, y = studio.point('unsaved.discard')
        self.still('mousemove', x, y, 'mousedown', 1, 'mouseup', 1)
        studio.wait(lambda layout: 'chooser.name' in layout['items'], 'the folder chooser after the question', PATIENCE)
        # What is typed without looking goes into it.
        folder = self.photographs()
        self.still('type', '--delay', '0', folder)
        self.still('key', 'Return')
        studio.wait(lambda layout: 'wizard.cell.0.0' in layout['items'], 'the wizard of that folder')

    def test_a_search_shows_what_was_typed(self):
        studio = self.open_sample()
        studio.key('ctrl+shift+p')
        studio.item('palette.filter')
        self.still('type', '--delay', '0', 'zebra')
        studio.wait(lambda layout: any(name.startswith('palette.view.zebra') for name in layout['items'])
                    and sum(name.startswith('palette.') for name in layout['items']) < 5, 'only what is called so', PATIENCE)
        self.still('key', 'ctrl+a', 'type', '--delay', '0', 'export')
        studio.wait(lambda layout: not any(name == 'palette.view.zebra' for name in layout['items'])
                    and any(name.startswith('palette.file.export') for name in layout['items']), 'the new words', PATIENCE)


class AtRest(StudioTest):
    """What stands on the screen and does not change is not drawn again and again."""

    def rests(self, what):
        studio = self.studio
        studio.settle()
        before = studio.processor_seconds()
        time.sleep(WATCHED)
        used = studio.processor_seconds() - before
        self.assertLess(used, MOST_AT_REST * WATCHED, what)

    def test_nothing_is_drawn_while_nothing_changes(self):
        studio = self.open_sample()
        self.rests('the set')
        for what, key, item in (('export', 'ctrl+e', 'export.file'), ('the search of actions', 'ctrl+shift+p', 'palette.filter'),
                                ('keys', 'F1', 'keys.filter'), ('the choice of a file', 'ctrl+o', 'chooser.name')):
            with self.subTest(what):
                studio.key(key)
                studio.item(item)
                self.rests(what)
                studio.key('Escape')
                studio.wait(lambda layout: item not in layout['items'], what + ' is closed')
        studio.click('menu.Help')
        self.rests('a menu')
        studio.click('menu.help.about')
        studio.item('about')
        self.rests('about')
        studio.key('Escape', 'ctrl+l')
        studio.item('desk.line')
        self.rests('the command line')


class SlowFrames(StillPointer):
    """The same, and a few things more, at five frames a second."""

    def start(self, *arguments, **options):
        return super().start(*arguments, environment=SLOW, **options)

    def test_a_name_that_is_typed_ahead_is_the_files_name(self):
        studio = self.open_sample()
        path = self.path('ahead.swaplight')
        self.still('key', 'ctrl+shift+s', 'type', '--delay', '0', path)  # before the dialog is there
        self.still('key', 'Return')
        studio.wait(lambda layout: layout.get('title', '').startswith('ahead'), 'the session has its name', 10)
        self.assertTrue(os.path.exists(path))

    def test_fields_are_filled_with_tab_as_quickly_as_one_types(self):
        folder = self.photographs()
        studio = self.start(folder)
        studio.item('wizard.cell.0.0')
        studio.click('wizard.light.0')
        words = ('kino', 'lantern')
        self.still('key', 'ctrl+a', 'type', '--delay', '0', words[0])
        self.still('key', 'Tab', 'type', '--delay', '0', words[1])
        self.still('key', 'Tab')
        colors = ['white', 'off', 'L201', '#4060ff']
        for text in colors:
            self.still('type', '--delay', '0', text)
            self.still('key', 'Tab')
        studio.rest()
        studio.screenshot('slow_tab')
        self.assertEqual([studio.state(f'wizard.cell.{k}.{i}.text') for k in range(2) for i in range(2)], colors)
        studio.click('wizard.solve')
        studio.wait(lambda layout: os.path.exists(os.path.join(folder, 'capture.json')), 'the description')
        with open(os.path.join(folder, 'capture.json')) as file:
            self.assertEqual([light['name'] for light in json.load(file)['lights']], list(words))

    def test_every_click_counts(self):
        studio = self.open_sample()
        x, y = studio.point('mixer.key.mute')
        for presses in range(1, 4):
            self.still('mousemove', x, y, 'mousedown', 1, 'mouseup', 1, 'sleep', 0.35)
        studio.rest()
        path, session = self.save_as('muted')
        lights = {light['name']: light for light in session['rig']['lights']}
        self.assertTrue(lights['key'].get('mute'), 'three clicks leave it muted')

    def test_a_double_click_is_one_however_slow_the_frames(self):
        studio = self.open_sample()
        x, y = studio.point('mixer.key.number')
        self.still('mousemove', x, y, 'sleep', 0.5, 'click', '--repeat', 2, '--delay', 150, 1)
        self.still('key', 'ctrl+a', 'type', '--delay', '0', '1.5')
        self.still('key', 'Return')
        studio.rest()
        path, session = self.save_as('dimmed')
        lights = {light['name']: light for light in session['rig']['lights']}
        self.assertAlmostEqual(lights['key']['stops'], 1.5)

    def test_a_drag_ends_where_the_hand_ended(self):
        studio = self.open_sample()
        start, end = studio.point('mixer.key.stops', 0.5), studio.point('mixer.key.stops', 0.75)
        self.still('mousemove', *start, 'mousedown', 1, 'mousemove', *end, 'mouseup', 1, 'mousemove', 640, 400)
        studio.rest()
        path, session = self.save_as('dragged')
        lights = {light['name']: light for light in session['rig']['lights']}
        x0, _, x1, _ = studio.item('mixer.key.stops')
        place = 2 * (end[0] - x0 - 5) / (x1 - x0 - 10) - 1  # -1 .. 1 between the insets; finer around 0
        self.assertAlmostEqual(lights['key']['stops'], 10 * place * (.4 + .6 * place ** 2), delta=.15)


if __name__ == '__main__':
    unittest.main()

"""The manners of every dialog, menu and list: Escape closes what is on top and nothing else, Enter takes the marked
button or what Tab and the arrows have come to, Tab goes round through all of it, everything says what it does, and the
keyboard is where it was before. What was found is printed as a table, and kept as manners.md among the artefacts."""
import json
import os
import shutil
import sys
import unittest

import numpy as np
import OpenImageIO as oiio

from studio_session import ARTEFACTS, HERE, SAMPLES, StudioTest

sys.path.append(os.path.join(HERE, '../intake'))
from made_chart import photograph as chart_photograph

PATIENCE = 30  # seconds
MOST_STOPS = 80
WORDS = ['menu.' + name for name in ('File', 'Edit', 'Lights', 'View', 'Compare', 'Window', 'Help')]  # say all there is to say


class Manners(StudioTest):
    size = (1600, 900)

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.rows = []

    @classmethod
    def tearDownClass(cls):
        super().tearDownClass()
        lines = ['| what | Escape | Enter | Tab or arrows | tooltips |', '|---|---|---|---|---|']
        lines += ['| ' + ' | '.join(row) + ' |' for row in cls.rows]
        print('\n' + '\n'.join(lines))
        os.makedirs(ARTEFACTS, exist_ok=True)
        with open(os.path.join(ARTEFACTS, 'manners.md'), 'w') as file:
            file.write('\n'.join(lines) + '\n')

    def row(self, *cells):
        """One line of the table: what was seen, not what was hoped for."""
        self.rows.append([str(cell) for cell in cells])

    def popups(self, count):
        self.studio.wait(lambda layout: layout.get('popups') == str(count), f'{count} lists are open', PATIENCE)

    def gone(self, item):
        self.studio.wait(lambda layout: item not in layout['items'], item + ' is closed', PATIENCE)

    def told(self, beginning):
        """That all of what is named so, and can be pressed, says what it does."""
        self.studio.rest()
        untold = [name for name in self.studio.layout()['untold'] if name.startswith(beginning) and name not in WORDS]
        self.assertEqual(untold, [], 'these do not say what they do')
        return 'all'

    def escape_closes(self, item):
        self.studio.item(item)
        self.studio.rest()
        before = self.studio.state('title')
        self.studio.key('Escape')
        self.gone(item)
        self.assertEqual(self.studio.state('title'), before)

    def tab_round(self):
        """The named things that Tab comes to, in order, until it is back at the first of them."""
        seen = []
        for _ in range(MOST_STOPS):
            self.studio.key('Tab')
            focus = self.studio.state('focus')
            if focus and seen and focus == seen[0]:
                return seen
            if focus:
                seen.append(focus)
        self.fail(f'Tab does not come round: {seen}')

    def find_action(self, words):
        self.studio.key('ctrl+shift+p')
        self.studio.item('palette.filter')
        self.studio.type(words)

    def run_action(self, words):
        self.find_action(words)
        self.studio.key('Return')

    # Menus and lists

    def to_line(self, line):
        for presses in range(1, 40):
            self.studio.key('Down')
            if self.studio.state('focus') == line:
                return presses
        self.fail(f'the arrows do not come to {line}')

    def menu(self, name, line, proof, back):
        """Escape closes it; the arrows lead to a line, and Enter takes it."""
        studio = self.studio
        studio.click('menu.' + name)
        self.popups(1)
        told = self.told('menu.')
        studio.key('Escape')
        self.popups(0)
        studio.click('menu.' + name)
        self.popups(1)
        presses = self.to_line('menu.' + line)
        studio.key('Return')
        studio.wait(proof, f'Enter takes {line}', PATIENCE)
        studio.key(back)
        self.row('menu ' + name, 'closes it', 'takes ' + line, f'{presses} down', told)

    def test_menus(self):
        studio = self.open_sample()
        place = studio.item('viewer.picture')
        there = lambda item: lambda layout: item in layout['items']
        for name, line, proof, back in (
                ('File', 'file.open', there('chooser.name'), 'Escape'),
                ('Edit', 'edit.history', there('history'), 'Escape'),
                ('Lights', 'light.mute', lambda layout: '(edited)' in layout['title'], 'ctrl+z'),
                ('View', 'view.one_to_one', lambda layout: layout['items']['viewer.picture'] != place, 'f'),
                ('Compare', 'compare.wipe', there('viewer.wipe'), 'w'),
                ('Window', 'view.hide_panels', lambda layout: 'menu.Window' not in layout['items'], 'Tab'),
                ('Help', 'help.keys', there('keys.filter'), 'Escape')):
            with self.subTest(name):
                self.menu(name, line, proof, back)
        studio.click('menu.Help')
        self.popups(1)
        studio.key('Down', 'Down')
        studio.screenshot('manners_menu')
        studio.key('Escape')

    def list_manners(self, name, opener, takes):
        self.popups(0)
        opener()
        self.popups(1)
        self.studio.key('Escape')
        self.popups(0)
        if not takes:
            return self.row(name, 'closes it', '', '', '')
        opener()
        self.popups(1)
        self.studio.key('Down')
        self.studio.key('Return')
        self.studio.wait(lambda layout: layout.get('popups') in ('0', '2'), 'Enter takes the line', PATIENCE)
        opened = self.studio.state('popups') == '2'
        for level in (1, 0) if opened else ():
            self.studio.key('Escape')
            self.popups(level)
        return self.row(name, 'closes it', 'opens the list of the line' if opened else 'takes the line', '1 down', '')

    def test_lists(self):
        studio = self.open_sample()
        studio.key('F4')
        studio.item('edits.add')
        for name, opener, button, takes in (
                ('list of pictures', 'bar.subject', 1, True), ('list of comparisons', 'bar.compare', 1, True),
                ('list of channels', 'bar.channel', 1, True), ('list of views', 'bar.view', 1, True),
                ('list of gels', 'light.gel', 1, False), ('list of white points', 'light.kelvin.presets', 1, True),
                ('all lights', 'mixer.menu', 1, True), ('levels of the zebra', 'button.view.zebra', 3, False),
                ('list of edits to add', 'edits.add', 1, True), ('a light', 'mixer.key', 3, True)):
            with self.subTest(name):
                self.list_manners(name, lambda: studio.click(opener, 0.3 if button == 3 else 0.5, button=button), takes)
        studio.key('Escape')  # the light's name, which was the line taken last
        # With a word in its search Escape closes it, too, and what is typed next does not go there.
        studio.click('light.gel')
        studio.item('gel.filter')
        studio.type('amber')
        studio.key('Escape')
        self.popups(0)

    # Windows

    def test_windows(self):
        studio = self.open_sample()
        for name, opener, item in (('Find an action', lambda: studio.key('ctrl+shift+p'), 'palette.filter'),
                                   ('Keyboard shortcuts', lambda: studio.key('F1'), 'keys.filter'),
                                   ('About', lambda: self.run_action('about'), 'about'),
                                   ('History', lambda: studio.key('ctrl+h'), 'history')):
            with self.subTest(name):
                opener()
                self.escape_closes(item)
                self.row(name, 'closes it', '', '', '')
        self.find_action('expor')
        self.escape_closes('palette.filter')
        self.find_action('wipe')
        studio.key('Down', 'Up', 'Return')
        self.gone('palette.filter')
        studio.item('viewer.wipe')
        self.row('Find an action, typed into', 'closes it', 'runs the line', 'up and down', '')

    def test_escape_gives_up_the_tool_after_all_that_is_open(self):
        studio = self.open_sample()
        studio.key('shift+b')
        studio.item('brush.size')
        studio.click('menu.View')
        self.popups(1)
        studio.key('Escape')
        self.popups(0)
        self.assertTrue(studio.has('brush.size'), 'the menu was on top')
        studio.key('Escape')
        self.gone('brush.size')
        self.row('a tool', 'gives it up', '', '', '')

    def test_the_key_of_a_tool_takes_it_and_its_button_puts_it_away(self):
        studio = self.open_sample()
        studio.key('shift+b')
        studio.item('brush.size')
        studio.key('shift+b')
        studio.settle()
        self.assertTrue(studio.has('brush.size'), 'the key pressed again keeps the brush in the hand')
        studio.click('button.brush.take')
        self.gone('brush.size')

    def test_tab_hides_the_panels_and_types_into_none(self):
        studio = self.open_sample()
        studio.click('mixer.key.chip')
        studio.key('Tab')
        self.gone('mixer.key')
        studio.key('Tab')
        studio.item('mixer.key')
        studio.key('m')  # an action's key, where nothing is being typed into
        studio.wait(lambda layout: '(edited)' in layout['title'], 'the key light is muted', PATIENCE)

    # Dialogs

    def dialog(self, name, opener, item, stops):
        opener()
        self.studio.item(item)
        told = self.told(tuple(stops - {'chooser.truth'}))  # which is a file's name
        seen = self.tab_round()
        self.assertLessEqual(stops, set(seen), f'{name}: Tab comes to {seen}')
        self.studio.key('shift+Tab')
        self.assertEqual(self.studio.state('focus'), seen[-1], 'Shift+Tab goes back')
        self.studio.screenshot('manners_' + name.split()[0].lower())
        self.escape_closes(item)
        return [name, 'cancels', '', f'{len(seen)} stops, round', told]

    def test_a_press_of_enter_answers_one_dialog(self):
        studio = self.open_sample()
        path, _ = self.save_as('kept')
        with open(path, 'rb') as file:
            kept = file.read()
        studio.click('mixer.fill.on')
        studio.key('ctrl+o')
        studio.item('chooser.name')
        studio.key('ctrl+a')
        studio.type(os.path.join(SAMPLES, 'two_swapped', 'capture.json'))
        studio.key('Return')
        studio.item('unsaved.discard')
        studio.settle()
        with open(path, 'rb') as file:
            self.assertEqual(file.read(), kept)
        studio.click('unsaved.cancel')

    def test_dialogs(self):
        studio = self.open_sample()
        studio.click('mixer.fill.on')
        chooser = {'chooser.home', 'chooser.computer', 'chooser.up', 'chooser.name', 'chooser.accept', 'chooser.truth'}
        row = self.dialog('Save as', lambda: studio.key('ctrl+shift+s'), 'chooser.name', chooser)
        row[2] = 'saves: see Unsaved work'
        self.row(*row)
        row = self.dialog('Export', lambda: studio.key('ctrl+e'), 'export.file',
                          {'export.kind.frame', 'export.kind.report', 'export.format.exr', 'export.space', 'export.float',
                           'export.file', 'export.choose', 'export.accept', 'export.cancel'})
        row[2] = 'exports: see below'
        self.row(*row)
        row = self.dialog('Unsaved work', lambda: studio.key('ctrl+n'), 'unsaved.save',
                          {'unsaved.save', 'unsaved.discard', 'unsaved.cancel'})
        # Enter presses what Tab has come to, else the marked button.
        studio.key('ctrl+n')
        studio.item('unsaved.save')
        studio.key('Tab', 'Tab', 'Tab')
        self.assertEqual(studio.state('focus'), 'unsaved.cancel')
        studio.key('Return')
        self.gone('unsaved.save')
        self.assertFalse(studio.has('chooser.name'))
        studio.key('ctrl+n')
        studio.item('unsaved.save')
        studio.key('Return')
        self.gone('unsaved.save')
        studio.item('chooser.name')
        studio.key('ctrl+a')
        studio.type(self.path('kept'))
        studio.key('Return')
        studio.wait(lambda layout: layout.get('title', '').startswith('kept'), 'saved')
        self.assertTrue(os.path.exists(self.path('kept.swaplight')))
        row[2] = 'saves, goes on'
        self.row(*row)
        studio.item('chooser.name')  # and goes on: which photographs?
        studio.type(self.photographs())
        studio.key('Return')
        studio.item('wizard.cell.0.0')
        self.wizard()

    def photographs(self):
        folder = self.path('shots')
        os.makedirs(folder)
        with open(os.path.join(SAMPLES, 'two_swapped', 'capture.json')) as file:
            for shot in json.load(file)['shots']:
                shutil.copy(os.path.join(SAMPLES, 'two_swapped', shot['image']), folder)
        return folder

    def wizard(self):
        """What is typed into it is there again after Escape."""
        studio = self.studio
        told = self.told(('wizard.cell', 'wizard.light', 'wizard.solve', 'wizard.cancel', 'wizard.more', 'wizard.fewer',
                          'wizard.field', 'wizard.align', 'wizard.guess', 'wizard.scale'))  # photographs need no words
        studio.click('wizard.cell.0.0', 0.3)
        studio.type('L106')
        studio.key('Return')
        studio.rest()
        self.assertTrue(studio.has('wizard.cell.0.0'), 'Enter does not solve what cannot be solved')
        studio.key('Tab')
        self.assertEqual(studio.state('focus'), 'wizard.cell.0.1', 'from colour to colour')
        studio.type('L201')
        seen = self.tab_round()
        self.assertLessEqual({'wizard.more', 'wizard.field', 'wizard.align', 'wizard.light.0', 'wizard.cell.1.1', 'wizard.guess',
                              'wizard.scale', 'wizard.cancel'}, set(seen))
        studio.screenshot('manners_wizard')
        studio.key('Escape')
        self.gone('wizard.cell.0.0')
        studio.key('ctrl+n')
        studio.item('chooser.name')
        studio.key('ctrl+a')
        studio.type(self.path('shots'))
        studio.key('Return')
        studio.item('wizard.cell.0.0')
        studio.wait(lambda layout: layout.get('wizard.cell.0.0.text') == 'L106', 'what was typed is there again')
        self.assertEqual(studio.state('wizard.cell.0.1.text'), 'L201')
        self.row('New capture', 'cancels, keeps what was typed', 'solves; not what cannot be solved',
                 f'{len(seen)} stops, round', told)

    def test_the_chart_dialog(self):
        studio = self.open_sample()
        chart = self.path('chart.exr')
        pixels = np.ascontiguousarray(chart_photograph(np.array([.8, .7, .6])), np.float32)
        out = oiio.ImageBuf(oiio.ImageSpec(*pixels.shape[1::-1], 3, 'float'))
        out.set_pixels(oiio.ROI(), pixels)
        out.write(chart)

        def opener():
            self.run_action('colour chart')
            studio.item('chooser.name')
            studio.key('ctrl+a')
            studio.type(chart)
            studio.key('Return')
        row = self.dialog('Colour chart', opener, 'chart.picture', {'chart.save', 'chart.gel.without', 'chart.close'})
        self.row(*row)

    def test_a_list_in_a_dialog_closes_before_the_dialog(self):
        studio = self.open_sample()
        studio.key('ctrl+e')
        studio.click('export.kind.layers')
        studio.click('export.compression')
        studio.item('export.compression.piz')
        studio.key('Escape')
        self.gone('export.compression.piz')
        self.assertTrue(studio.has('export.file'))
        self.escape_closes('export.file')
        self.row('list in a dialog', 'closes it, not the dialog', '', '', '')

    def test_a_wrong_name_can_be_typed_again_at_once(self):
        studio = self.open_sample()
        studio.key('ctrl+e')
        studio.item('export.file')
        studio.key('ctrl+a')
        studio.type('/nowhere/frame.exr')
        studio.key('Return')
        studio.item('export.file')
        studio.key('ctrl+a')
        studio.type(self.path('frame.exr'))
        studio.key('Return')
        studio.wait(lambda _: os.path.exists(self.path('frame.exr')), 'the frame')
        self.row('Export, a wrong name', '', 'keeps the field, then exports', '', '')

    def test_the_list_of_files_by_the_keyboard(self):
        os.makedirs(self.path('list/a_folder/inside'))
        studio = self.open_sample()
        studio.key('ctrl+o')
        studio.item('chooser.name')
        studio.type(self.path('list'))
        studio.key('Return')
        studio.item('chooser.a_folder')
        studio.key('Up')
        self.assertEqual(studio.state('focus'), 'chooser.a_folder')
        studio.key('Return')
        studio.item('chooser.inside')
        self.assertEqual(studio.state('focus'), 'chooser.name', 'a name can be typed at once')
        self.escape_closes('chooser.name')


if __name__ == '__main__':
    unittest.main()

"""The export dialog in a real window: every kind is written as the command line does, and choices are remembered."""
import json
import os
import shutil
import subprocess
import unittest

import numpy as np
import OpenImageIO as oiio

from studio_session import PROGRAM, SAMPLES, StudioTest

SAMPLE = os.path.join(SAMPLES, 'three_point')


def read(path):
    source = oiio.ImageInput.open(path)
    assert source, oiio.geterror()
    pixels = np.asarray(source.read_image('float'))
    names = source.spec().channelnames
    source.close()
    return names, pixels


class ExportDialog(StudioTest):
    def ask(self, name, *clicks):
        """Opens the dialog, clicks, names the file and exports; gives the file once it is there."""
        path = self.path(name)
        self.studio.key('ctrl+e')
        self.studio.item('export.file')
        for click in clicks:
            self.studio.click(click)
        self.studio.screenshot('export_' + os.path.splitext(name)[0])
        self.studio.click('export.file')
        self.studio.key('ctrl+a')
        self.studio.type(path)
        self.studio.click('export.accept')
        self.studio.wait(lambda _: os.path.exists(path), name)
        self.assertFalse(self.studio.has('export.file'))
        return path

    def same(self, path, *arguments):
        again = self.path('again' + os.path.splitext(path)[1])
        subprocess.run([PROGRAM, *arguments, '-o', again], check=True, capture_output=True)
        for a, b in zip(read(path), read(again)):
            self.assertTrue(np.array_equal(a, b), path)

    def test_no_file_of_the_set_is_replaced(self):
        shutil.copytree(SAMPLE, self.path('set'))
        solved = self.path('set/solved.exr')
        subprocess.run([PROGRAM, 'solve', self.path('set'), '-o', solved, '-q'], check=True)
        with open(solved, 'rb') as file:
            before = file.read()
        studio = self.start(solved)
        studio.wait_ready()
        studio.key('ctrl+e')
        studio.item('export.file')
        studio.key('Return')
        made = self.path('set/solved_frame.exr')
        studio.wait(lambda _: os.path.exists(made), 'a name of its own')
        studio.key('ctrl+e')
        studio.click('export.file')
        studio.key('ctrl+a')
        studio.type(solved)
        studio.settle()
        studio.screenshot('export_source')
        studio.click('export.accept')
        studio.settle()
        self.assertTrue(studio.has('export.file'), 'it asks for another name')
        with open(solved, 'rb') as file:
            self.assertEqual(file.read(), before)

    def test_beta_maps_as_png_replace_no_file_of_the_set_under_any_lights_name(self):
        shutil.copytree(SAMPLE, self.path('set'))
        solved = self.path('set/solved.exr')
        subprocess.run([PROGRAM, 'solve', self.path('set'), '-o', solved, '-q'], check=True)
        os.symlink(solved, self.path('maps.fill.png'))
        with open(solved, 'rb') as file:
            before = file.read()
        studio = self.start(solved)
        studio.wait_ready()
        studio.key('ctrl+e')
        studio.click('export.kind.beta')
        studio.click('export.format.png')
        studio.click('export.file')
        studio.key('ctrl+a')
        studio.type(self.path('maps.png'))
        studio.click('export.accept')
        studio.settle()
        self.assertTrue(studio.has('export.file'), 'it asks for another name')
        with open(solved, 'rb') as file:
            self.assertEqual(file.read(), before)

    def test_every_kind_is_what_the_command_line_writes(self):
        self.open_sample()
        self.same(self.ask('frame.exr', 'export.kind.frame', 'export.format.exr'), 'relight', SAMPLE)
        self.same(self.ask('frame.png', 'export.format.png', 'export.sixteen'), 'relight', SAMPLE, '--type', 'uint16')
        self.same(self.ask('layers.exr', 'export.kind.layers', 'export.float_layers', 'export.beta'), 'export', SAMPLE,
                  '--type', 'float', '--beta')
        self.same(self.ask('blender.exr', 'export.kind.layers', 'export.naming', 'export.naming.blender'), 'export', SAMPLE,
                  '--type', 'float', '--beta', '--naming', 'blender')
        self.same(self.ask('beta.exr', 'export.kind.beta'), 'beta', SAMPLE)
        with open(self.ask('look.ccc', 'export.kind.look', 'export.format.ccc')) as file:
            self.assertIn('<Slope>', file.read())
        with open(self.ask('page.html', 'export.kind.report')) as file:
            self.assertIn('three_point', file.read())

    def parts(self, path):
        """What every part of an EXR says of itself, and its pixels."""
        found, source = [], oiio.ImageInput.open(path)
        assert source, oiio.geterror()
        while source.seek_subimage(len(found), 0):
            spec = source.spec()
            found.append({'name': spec.getattribute('name'), 'channels': spec.channelnames,
                          'compression': spec.getattribute('compression'), 'type': str(spec.format),
                          'primaries': spec.getattribute('chromaticities'),
                          'pixels': np.asarray(source.read_image('float'))})
        source.close()
        return found

    def test_a_part_a_light_in_other_primaries(self):
        self.open_sample()
        path = self.ask('parts.exr', 'export.kind.layers', 'export.naming', 'export.naming.multi', 'export.compression',
                        'export.compression.piz', 'export.space', 'export.space.acescg')
        again = self.path('again.exr')
        subprocess.run([PROGRAM, 'export', SAMPLE, '--multipart', '--compression', 'piz', '--color-space', 'acescg', '-o',
                        again], check=True, capture_output=True)
        ours, line = self.parts(path), self.parts(again)
        self.assertEqual([part['name'] for part in ours], [part['name'] for part in line])
        self.assertLessEqual({'key', 'fill', 'back'}, {part['name'] for part in ours})
        for a, b in zip(ours, line):
            self.assertEqual((a['channels'], a['compression'], a['type']), (b['channels'], 'piz', 'half'))
            np.testing.assert_allclose(a['primaries'][:6], (.713, .293, .165, .83, .128, .044), atol=1e-4)
            np.testing.assert_array_equal(a['pixels'], b['pixels'])
        frame = self.ask('aces.exr', 'export.kind.frame', 'export.format.exr', 'export.space',
                         'export.space.aces2065_1', 'export.float')
        self.same(frame, 'relight', SAMPLE, '--color-space', 'aces2065_1', '--type', 'float')
        np.testing.assert_allclose(self.parts(frame)[0]['primaries'][:6], (.7347, .2653, 0, 1, .0001, -.077), atol=1e-4)

    def test_every_tone_mapping_is_what_the_command_line_writes(self):
        self.open_sample()
        plain = read(self.ask('plain.png', 'export.kind.frame', 'export.format.png'))[1]
        for tone in ('drago', 'mantiuk', 'reinhard'):
            path = self.ask(tone + '.png', 'export.tone', 'export.tone.' + tone)
            self.same(path, 'relight', SAMPLE, '--tone', tone)
            self.assertGreater(np.abs(read(path)[1] - plain).mean(), 0.01)

    def test_tabs_stay_below_the_pointer(self):
        studio = self.open_sample()
        studio.key('ctrl+e')
        studio.item('export.file')
        studio.settle()
        kinds = ('frame', 'layers', 'beta', 'look', 'report', 'sequence', 'sheet')
        places = {kind: studio.item('export.kind.' + kind) for kind in kinds}
        for kind in kinds:
            studio.click('export.kind.' + kind)
            studio.settle()
            self.assertEqual({other: studio.item('export.kind.' + other) for other in kinds}, places, kind)
            self.assertLess(studio.item('export.accept')[3], 715, 'in the window')
            studio.screenshot('export_kind_' + kind)

    def test_the_versions_are_the_contact_sheet_of_the_command_line(self):
        studio = self.open_sample()
        studio.key('ctrl+e')
        studio.click('export.kind.sheet')
        studio.key('Return')
        studio.settle()
        self.assertTrue(studio.has('export.file'), 'there is nothing in the gallery yet')
        studio.screenshot('export_versions_empty')
        studio.key('Escape')
        studio.key('shift+k')
        studio.key('ctrl+l')
        studio.settle()
        studio.type('key @ 25')
        studio.key('Return')
        studio.key('Escape')
        studio.key('shift+v')
        studio.settle()
        session, written = self.save_as('show')
        self.assertEqual([look['name'] for look in written['looks']], ['Look 1', 'Version 1'])
        sheet = self.ask('sheet.png', 'export.kind.sheet', 'export.format.png')
        again = self.path('again.png')
        named = shutil.copy(session, self.path('three_point.swaplight'))  # its name is the sheet's title
        subprocess.run([PROGRAM, 'versions', named, '-o', again], check=True, capture_output=True)
        np.testing.assert_array_equal(read(sheet)[1], read(again)[1])
        self.assertGreater(read(sheet)[1].std(), .05, 'with pictures')

    def test_choices_are_remembered_and_mistakes_said_before(self):
        self.open_sample()
        self.ask('frame.tif', 'export.kind.frame', 'export.format.tif', 'export.sixteen')
        self.assertTrue(self.studio.quit())
        with open(self.path('.local/state/swaplight/export.json')) as file:
            remembered = json.load(file)
        self.assertEqual((remembered['kind'], remembered['formats']['frame'], remembered['sixteen_bits']), ('frame', '.tif', True))
        studio = self.open_sample()
        studio.key('ctrl+e')
        studio.item('export.sixteen')
        studio.key('Return')
        studio.wait(lambda _: os.path.exists(self.path('three_point.tif')), 'the frame beside the last one')
        studio.key('ctrl+e')
        studio.item('export.file')
        studio.key('ctrl+a')
        studio.type('/nowhere/frame.exr')
        studio.key('Return')
        studio.item('export.file')
        studio.screenshot('export_mistake')
        studio.click('export.cancel')
        studio.wait(lambda layout: 'export.file' not in layout['items'], 'the end of the dialog')


if __name__ == '__main__':
    unittest.main()

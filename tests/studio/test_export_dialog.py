"""The export dialog in a real window: every kind is written as the command line does, and choices are remembered."""
import json
import os
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

"""Edits of any size take what the picture takes: feathers, texts and stencils far larger than it."""
import json
import os
import time

import numpy as np
import cli


class LargeShapesTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.solved = self.path('solved.exr')
        self.succeed('solve', cli.Capture(self.path('set'), height=24, width=32).path, '-o', self.solved, '-q')

    def edits(self, shape, size=None):
        path = self.path('edits.json')
        with open(path, 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [
                {'lights': ['key'], 'meaning': 'add', 'operation': 'fill', 'value': 1, 'mask': [shape]}]}, file)
        return path

    def masked(self, shape):
        """How much light the edit adds, picture by picture; within seconds and a gigabyte."""
        begun = time.time()
        limit = lambda: cli.limit_memory(2)
        self.succeed('relight', self.solved, '--edits', self.edits(shape), '--light', 'fill=off', '-o',
                     self.path('o.exr'), '-q', preexec_fn=limit)
        self.assertLess(time.time() - begun, 60)
        return cli.read_rgb(self.path('o.exr'))

    def test_a_feather_far_beyond_the_picture(self):
        triangle = [[4, 2], [28, 3], [15, 22]]
        small = self.masked({'shape': 'polygon', 'points': triangle, 'feather': 30})
        self.assertTrue(np.isfinite(small).all())
        for feather in (8000, 1e6):
            large = self.masked({'shape': 'polygon', 'points': triangle, 'feather': feather})
            self.assertTrue(np.isfinite(large).all())
        for shape in ({'shape': 'rectangle', 'x': 3, 'y': 3, 'width': 9, 'height': 9},
                      {'shape': 'ellipse', 'x': 3, 'y': 3, 'radius_x': 9, 'radius_y': 9},
                      {'shape': 'text', 'text': 'Light', 'x': 2, 'y': 20, 'height': 12},
                      {'shape': 'selection', 'parts': [{'shape': 'polygon', 'points': triangle}]}):
            self.assertTrue(np.isfinite(self.masked({**shape, 'feather': 1e6})).all(), shape)

    def test_a_wide_feather_is_as_soft_as_a_gaussian(self):
        # Half of a wide picture: the edge falls as the error function of sigma = feather / 4.
        from math import erf
        solved = self.path('wide.exr')
        self.succeed('solve', cli.Capture(self.path('wide'), height=40, width=600).path, '-o', solved, '-q')
        self.solved = solved
        half = {'shape': 'polygon', 'points': [[-2000, -2000], [300, -2000], [300, 2000], [-2000, 2000]]}
        sharp, soft = self.masked({**half, 'feather': 0}), self.masked({**half, 'feather': 200})
        nothing = self.masked({'shape': 'rectangle', 'x': -900, 'y': -900, 'width': 1, 'height': 1})
        full = self.masked({'shape': 'rectangle', 'x': -900, 'y': -900, 'width': 9000, 'height': 9000})
        share = (soft - nothing)[20, :, 1] / (full - nothing)[20, :, 1]
        expected = np.array([.5 - .5 * erf((x + .5 - 300) / (50 * 2 ** .5)) for x in range(600)])
        self.assertLess(abs(share - expected).max(), .02)
        edge = (sharp - nothing)[20, :, 1] / (full - nothing)[20, :, 1]
        # OpenCV draws the outline a pixel wide, with soft sides.
        self.assertLess(abs(edge[:298] - 1).max(), 2e-3)
        self.assertLess(abs(edge[302:]).max(), 2e-3)

    def test_a_key_of_lights_that_are_not_there(self):
        key = {'shape': 'key', 'lights': {'fill': [1, 1, 1], 'backk': [1, 1, 1]}}
        for shape in (key, {'shape': 'selection', 'parts': [key]}):
            self.deny('relight', self.solved, '--edits', self.edits(shape), '-o', self.path('o.exr'),
                      naming='edit "fill": the key of its mask: there is no light "backk"; the lights are key, fill')

    def test_text_larger_than_the_picture(self):
        for height in (1e6, 41):
            self.deny('relight', self.solved, '--edits', self.edits({'shape': 'text', 'text': 'L', 'x': 0, 'y': 9, 'height': height}),
                      '-o', self.path('o.exr'), naming=['edits.json', 'height', 'at most 40'])
        for x, y in ((-30, 20), (0, 2), (25, 40), (-1e6, 1e6), (31, 0)):
            frame = self.masked({'shape': 'text', 'text': 'LIGHT', 'x': x, 'y': y, 'height': 38})
            self.assertTrue(np.isfinite(frame).all())

    def test_a_stencil_stretched_beyond_the_picture(self):
        stencil = np.zeros((2, 2, 3), np.float32)
        stencil[:, 1] = 1
        cli.write_image(self.path('stencil.exr'), stencil)
        shape = {'shape': 'picture', 'file': 'stencil.exr'}
        frame = self.masked({**shape, 'x': 0, 'y': 0, 'width': 65536, 'height': 65536})
        self.assertLess(abs(frame - self.masked({**shape, 'x': -9999, 'y': 0})).max(), 1e-6, 'its left part is black')
        ramp = self.masked({**shape, 'x': 0, 'y': 0, 'width': 32, 'height': 24})
        self.assertGreater(ramp[12, 30, 1], ramp[12, 1, 1])

    def test_a_session_that_paints_more_than_any_set(self):
        path = self.path('a.swaplight')
        painted = {'shape': 'painted', 'strokes': [{'radius': 1e5, 'points': [[30000, 30000]]}]}
        with open(path, 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr', 'edits': {
                'size': [65536, 65536], 'edits': [{'lights': ['key'], 'operation': 'fill', 'mask': [painted]}]}}, file)
        self.deny('info', path, naming=['a.swaplight', 'size'], preexec_fn=lambda: cli.limit_memory(2))


class SmallFilesTest(cli.CliTest):
    """Pictures of kilobytes that ask for gigabytes."""

    def test_a_display_window_far_beyond_its_data(self):
        capture = cli.Capture(self.path('set'), height=24, width=32)
        with open(self.path('set/shot_01.exr'), 'rb') as file:
            data = bytearray(file.read())
        at = data.index(b'displayWindow\0box2i\0') + 24
        data[at:at + 16] = np.array([0, 0, 27999, 27999], '<i4').tobytes()
        with open(self.path('set/shot_01.exr'), 'wb') as file:
            file.write(data)
        limit = lambda: cli.limit_memory(2)
        self.deny('solve', capture.path, '-o', self.path('o.exr'), naming=['shot_01.exr', 'display window'], preexec_fn=limit)
        self.deny('evaluate', self.path('set/shot_01.exr'), self.path('set/shot_02.exr'), naming='shot_01.exr', preexec_fn=limit)

    def test_an_attribute_that_lies_about_its_length(self):
        path = self.path('a.exr')
        cli.write_image(path, np.ones((4, 4, 3)), Artist='somebody')
        with open(path, 'rb') as file:
            data = bytearray(file.read())
        at = data.index(b'string\0', data.index(b'rtist')) + 7
        for size in (2 ** 31 - 1, 2 ** 32 - 1, len(data)):
            data[at:at + 4] = size.to_bytes(4, 'little')
            with open(path, 'wb') as file:
                file.write(data)
            self.deny('info', path, naming='a.exr', preexec_fn=lambda: cli.limit_memory(1))

    def test_files_with_a_long_tail_of_nothing(self):
        for name in ('a.png', 'a.jpg'):
            cli.write_image(self.path(name), cli.contributions(1)[0], 'uint8')
            size = os.path.getsize(self.path(name))
            with open(self.path(name), 'r+b') as file:
                file.truncate(size - 12)
                file.truncate(2 << 30)  # sparse: takes no disk
            self.deny('info', self.path(name), naming=name, preexec_fn=lambda: cli.limit_memory(1))

    def test_a_picture_that_libjpeg_would_end_the_process_for(self):
        import OpenImageIO as oiio
        capture = cli.Capture(self.path('tall'), height=66000, width=1)
        solved = self.path('solved.exr')
        self.succeed('solve', capture.path, '-o', solved, '-q')
        self.deny('relight', solved, '-o', self.path('tall.jpg'), naming=['tall.jpg', '65500'])
        self.succeed('report', solved, '-o', self.path('report.html'), '-q')
        self.assertTrue(oiio.ImageInput.open(solved))


if __name__ == '__main__':
    cli.main()

"""Every filter that comes along, drawn: against pictures that were looked at, on bright light, with its parameters.

usage, after a filter was added or its picture changed on purpose: test_filter_pictures.py --write, then look at
tests/data/filters/filters.png: it is right if a person says so."""
import json
import math
import os
import sys

import numpy as np
import OpenImageIO as oiio

import cli

SHEET = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../data/filters/filters.png')
WIDTH, HEIGHT = 96, 64  # of a picture on the sheet
DRAWN = 3  # times as large, so that pixels of 1920 are seen
COLUMNS = 10
# Where the defaults leave a picture as it is, or change too little of a small one.
SHOWN = {
    'blend': {'other': 'element.exr'},
    'cdl': {'slope': [.8, .5, .3, 1], 'power': [.4, .5, .6, 1], 'saturation': 1.5},
    'channel-mixer': {'red': [0, 1, 0, 1], 'green': [1, 0, 0, 1]},
    'chroma-key': {'plate': 'element.exr', 'plateBlur': 10},
    'composite': {'element': 'element.exr', 'scale': .5},
    'depth-haze': {'depth': 'depth.png'},
    'exposure': {'stops': 1},
    'film-grain': {'amount': 1, 'size': 8},
    'flicker': {'amount': .8},
    'gate-weave': {'amount': 10},
    'kuwahara': {'radius': 24},
    'lut': {'table': 'swap.cube'},
    'review': {'brightness': 1.2, 'contrast': 1.4, 'saturation': 1.6, 'sharpness': 2},
    'unsharp-mask': {'amount': 4, 'radius': 20},
    'white-balance': {'kelvin': 3600, 'green': .3},
}
# Those whose purpose is to bring light into a range, or to draw over it.
MEANT_TO_END_LIGHT = {'tone-map', 'range-check', 'false-colour', 'day-for-night'}


def scene(width, height):
    """Scene-linear light with what filters work on: a ramp, flat colours, a green screen, lamps of 30, fine lines,
    round shading, darkness."""
    x, y = np.meshgrid((np.arange(width) + .5) / width, (np.arange(height) + .5) / height)
    light = (.06 + .5 * x * (1 - .6 * y))[..., None] * np.array([1, .92, .8])
    light[y > .72] = (.12 + .1 * (np.floor(18 * x) + np.floor(12 * y))[y > .72, None] % .2) * np.array([.9, .6, .4])
    light[(x > .66) & (y < .6)] = [.07, .5, .12]
    for cx, cy, radius, colour in ((.28, .45, .3, [.75, .3, .2]), (.8, .55, .2, [.25, .35, .8])):
        dx, dy = (x - cx) * width / height / radius, (y - cy) / radius
        inside = dx * dx + dy * dy < 1
        shade = np.maximum(0, (-.5 * dx - .5 * dy + .7 * np.sqrt(np.maximum(0, 1 - dx * dx - dy * dy))))
        light[inside] = (.02 + shade[..., None] * np.array(colour))[inside]
    for cx, cy in ((.1, .12), (.52, .2)):
        light[(x - cx) ** 2 * (width / height) ** 2 + (y - cy) ** 2 < .0012] = [30, 26, 18]
    light[(np.floor(x * width / 3) % 2 == 0) & (abs(x - .5) < .06) & (abs(y - .45) < .12)] = .01
    return light.astype(np.float32)


class PictureTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        os.environ['XDG_DATA_HOME'] = self.path('data')
        self.filters = {f['name']: f for f in self.succeed_json('look', 'list')['filters'] if f['built_in']}
        self.light = scene(WIDTH * DRAWN, HEIGHT * DRAWN)
        cli.write_image(self.path('frame.exr'), self.light)
        y, x = np.mgrid[0:40, 0:60]
        element = np.stack([x / 60, .5 + 0 * x, y / 40, ((x - 30) ** 2 + (y - 20) ** 2 < 350)], -1)
        element[..., :3] *= element[..., 3:]
        cli.write_image(self.path('element.exr'), element)
        cli.write_image(self.path('depth.png'), np.repeat((x / 59)[..., None], 3, -1), 'uint8')
        with open(self.path('swap.cube'), 'w') as file:
            file.write('LUT_3D_SIZE 2\n' + ''.join(f'{b} {g} {r}\n' for b in (0, 1) for g in (0, 1) for r in (0, 1)))

    def write_look(self, name, stages):
        path = self.path(name + '.swaplook')
        with open(path, 'w') as file:
            json.dump({'format': 'swaplight-look', 'version': 1, 'name': name,
                       'filters': [{'filter': f, 'parameters': p} for f, p in stages]}, file)
        return path


class Golden(PictureTest):
    def drawn(self):
        """name -> codes 0..1, as large as they were drawn"""
        looks = [self.write_look(name, [(name, SHOWN.get(name, {}))]) for name in sorted(self.filters)]
        result = self.succeed('look', 'thumbnails', self.path('frame.exr'), *looks, '-o', self.path('out'),
                              '--width', WIDTH * DRAWN, '--frame', 5)
        self.assertNotIn('warning', result.stderr)
        return {name: cli.read_rgb(self.path('out', f'look {name}.png')) for name in sorted(self.filters)}

    def small(self, picture):
        return picture.reshape(HEIGHT, DRAWN, WIDTH, DRAWN, 3).mean((1, 3))

    def place(self, index):
        return (slice(index // COLUMNS * HEIGHT, (index // COLUMNS + 1) * HEIGHT),
                slice(index % COLUMNS * WIDTH, (index % COLUMNS + 1) * WIDTH))

    def write_sheet(self, pictures, path):
        rows = math.ceil(len(pictures) / COLUMNS)
        sheet = np.zeros((rows * HEIGHT, COLUMNS * WIDTH, 3), np.float32)
        for index, name in enumerate(pictures):
            sheet[self.place(index)] = self.small(pictures[name])
        cli.write_image(path, sheet, 'uint8', ImageDescription=' '.join(pictures))

    def test_every_filter_draws_its_picture(self):
        """To 2 codes in the mean and 12 anywhere, of means over 3 x 3 pixels: less than is seen. What differs further
        is a filter that was changed; drivers differ in the last bits of sines and powers."""
        pictures = self.drawn()
        if '--write' in sys.argv:
            return self.write_sheet(pictures, SHEET)
        source = oiio.ImageInput.open(SHEET)
        names = source.spec().getattribute('ImageDescription').split()
        source.close()
        self.assertEqual(names, list(pictures), 'filters came or went: write the sheet again (see above) and look at it')
        sheet = cli.read_rgb(SHEET)
        for index, name in enumerate(names):
            with self.subTest(name):
                difference = 255 * np.abs(self.small(pictures[name]) - sheet[self.place(index)])
                self.assertLess(difference.mean(), 2)
                self.assertLess(np.quantile(difference, .995), 12)

    def test_every_filter_changes_the_picture(self):
        pictures = self.drawn()
        plain = np.where(self.light <= .0031308, self.light * 12.92, 1.055 * self.light ** (1 / 2.4) - .055)
        plain = np.rint(255 * plain.clip(0, 1))
        for name, picture in pictures.items():
            with self.subTest(name):
                self.assertGreater(np.abs(255 * picture - plain).mean(), .05)


class Grid(PictureTest):
    def lines(self, width, height, show):
        """rows and columns that are drawn over from edge to edge"""
        grey = self.path('grey.exr')
        cli.write_image(grey, np.full((height, width, 3), .2, np.float32))
        self.succeed('look', 'apply', grey, '--filter', f'grid,show={show}', '-o', self.path('grid.exr'))
        over = cli.read_rgb(self.path('grid.exr'))[..., 0] > .4
        return np.flatnonzero(over.mean(1) > .9).tolist(), np.flatnonzero(over.mean(0) > .9).tolist()

    def test_lines_are_whole_pixels_alike_from_both_sides(self):
        """A third of 180 rows lies between two of them, where a card's rounding is not to choose: a card drew one row
        of the lower line and llvmpipe the two beside it."""
        self.assertEqual(self.lines(320, 180, 0), ([60, 119], [106, 213]))
        self.assertEqual(self.lines(1920, 1080, 0), ([359, 360, 719, 720], [639, 640, 1279, 1280]))
        self.assertEqual(self.lines(1920, 1080, 2), ([539, 540], [959, 960]))


class Light(PictureTest):
    def test_filters_of_light_keep_what_is_brighter_than_white(self):
        """A lamp of 1000, a hundred pixels of it: no filter of light may bring it down to white."""
        frame = np.full((90, 160, 3), .18, np.float32)
        frame[30:60, 60:100] = 1000
        cli.write_image(self.path('lamp.exr'), frame)
        for name, filter in self.filters.items():
            if filter['space'] == 'display' or name in MEANT_TO_END_LIGHT:
                continue
            out = self.path('out.exr')
            parameters = ''.join(f',{key}={self.path(value) if isinstance(value, str) else value}'
                                 for key, value in SHOWN.get(name, {}).items() if not isinstance(value, list))
            with self.subTest(name):
                self.succeed('look', 'apply', self.path('lamp.exr'), '--filter', name + parameters, '-o', out, '--type', 'float')
                self.assertGreater(cli.read_rgb(out).max(), 50)


class Parameters(PictureTest):
    def other(self, parameter):
        """A value that is not the default."""
        standard, kind = parameter['default'], parameter['type']
        if kind == 'bool':
            return not standard
        if kind == 'long':
            return next(v for v in parameter['values'] if v != standard)
        if kind == 'float':
            middle = round(.3 * parameter['min'] + .7 * parameter['max'], 3)
            return middle if middle != standard else parameter['min']
        if kind == 'color':
            return [.25, .5, .75, 1]
        if kind == 'point2D':
            return [.25, .75]
        if kind == 'vector':
            return [round(.3 * parameter['min'] + .7 * parameter['max'] + .01 * i, 3) for i in range(len(standard))]
        if kind == 'matrix':
            return [[round(.1 * (3 * y + x) - .2, 3) for x in range(len(standard))] for y in range(len(standard))]
        if kind == 'curve':
            return [[0, .1], [.3, .7], [1, .9]]
        return self.path('swap.cube' if 'cube' in parameter['tooltip'] else 'element.exr')

    def test_every_parameter_of_every_filter_comes_back_from_a_file(self):
        stages = [(name, {p['name']: self.other(p) for p in filter['parameters']})
                  for name, filter in sorted(self.filters.items())]
        look = self.write_look('all', stages)
        saved = self.path('again.swaplook')
        cli.write_image(self.path('small.exr'), np.full((9, 16, 3), .2))
        self.succeed('look', 'apply', self.path('small.exr'), '--look', look, '-o', self.path('o.png'), '--save', saved)
        again = self.succeed_json('look', 'show', saved)['filters']
        for (name, parameters), stage in zip(stages, again, strict=True):
            self.assertEqual(stage['filter'], name)
            self.assertEqual(set(stage.get('parameters', {})), set(parameters), name)
            for key, value in parameters.items():
                if isinstance(value, (float, list)):
                    np.testing.assert_allclose(stage['parameters'][key], value, rtol=1e-6, err_msg=f'{name} {key}')
                else:
                    self.assertEqual(stage['parameters'][key], value, f'{name} {key}')


if __name__ == '__main__':
    if '--write' in sys.argv:
        test = Golden('test_every_filter_draws_its_picture')
        test.debug()
    else:
        cli.main()

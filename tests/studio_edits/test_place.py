"""Lamps that are placed by how the surfaces of a set are turned, in a real window."""
import json
import subprocess
import unittest

import numpy as np
import OpenImageIO as oiio

from studio import PROGRAM, StudioTest, read_float

HEIGHT, WIDTH = 288, 480
RADIUS = .2  # of the ball, widths of the picture
LAMPS = {'left': (-60, 25), 'right': (50, 15), 'top': (0, 60), 'low': (-20, -10)}
COLORS = [[.9, .2, .15], [.15, .8, .25], [.2, .25, .9], [.85, .75, .1]]


def direction(azimuth, elevation):
    a, e = np.radians([azimuth, elevation])
    return np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])


def ball():
    """Normals of a ball before a wall."""
    rows, columns = np.mgrid[:HEIGHT, :WIDTH]
    x, y = (columns + .5) / WIDTH - .5, (.5 * HEIGHT - rows - .5) / WIDTH
    square = RADIUS ** 2 - x ** 2 - y ** 2
    inside = np.stack([x, y, np.sqrt(np.maximum(square, 0))], -1) / RADIUS
    return np.where((square > 0)[..., None], inside, [0, 0, 1.])


class Place(StudioTest):
    size = (1920, 1080)

    def solved(self):
        """The ball under four lamps, each with its own paint of noise."""
        truth = [np.maximum(ball() @ direction(*place), 0)[..., None] * np.array([.15, .12, .1]) for place in LAMPS.values()]
        shots = []
        for k in range(len(LAMPS)):
            colors = [COLORS[(i + k) % 4] for i in range(4)]
            pixels = sum(light * np.array(color) for light, color in zip(truth, colors))
            spec = oiio.ImageSpec(WIDTH, HEIGHT, 3, 'float')
            out = oiio.ImageOutput.create(self.path(f'shot_{k}.exr'))
            assert out.open(self.path(f'shot_{k}.exr'), spec) and out.write_image(np.ascontiguousarray(pixels, np.float32))
            out.close()
            shots.append({'image': f'shot_{k}.exr', 'light_colors': colors})
        with open(self.path('capture.json'), 'w') as file:
            json.dump({'format': 'swaplight-capture', 'version': 1, 'color_space': 'lin_rec709',
                       'lights': [{'name': name} for name in LAMPS], 'shots': shots}, file)
        subprocess.run([PROGRAM, 'solve', self.path('capture.json'), '-o', self.path('solved.exr'), '-q'], check=True)
        return self.path('solved.exr')

    def open_ball(self):
        studio = self.start(self.solved())
        studio.wait_ready()
        studio.key('F4')
        studio.item('edits.add')
        return studio

    def seen(self, name):
        self.studio.move(*self.studio.point('status.colors'))  # no tooltip over the picture
        return self.studio.picture(name).astype(float)

    def new_lamp(self):
        self.studio.click('edits.add')
        self.studio.item('add.new_lamp')
        self.studio.settle()
        self.studio.click('add.new_lamp')
        self.studio.settle()

    def tell(self, light):
        """By mouse, to a few degrees."""
        azimuth, elevation = LAMPS[light]
        studio = self.studio
        studio.click('places.lamp')
        studio.click(f'places.lamp.{light}')
        studio.settle()
        studio.click('places.known')
        studio.settle()
        for slider, start, value, most in (('side', -45, azimuth, 180), ('height', 30, elevation, 90)):
            at = lambda degrees: studio.point(f'places.{slider}', .5 + .97 * degrees / (2 * most))
            studio.drag(at(start), at(value))
            studio.settle()

    def sides(self, picture):
        """The mean of the ball on the left and on the right, where nothing is drawn over it."""
        height, width = picture.shape[:2]
        across = lambda low, high: picture[round(.55 * height):round(.6 * height), round(low * width):round(high * width)].mean()
        return across(.4, .44), across(.56, .6)

    def test_a_new_lamp_lights_the_ball_once_three_places_are_told(self):
        studio = self.open_ball()
        before = self.seen('place_before')
        self.new_lamp()
        studio.item('places.missing')
        self.tell('left')
        self.tell('right')
        studio.item('places.missing')
        self.assertLess(np.abs(self.seen('place_two') - before).mean(), .5, 'two lamps tell nothing')
        self.tell('top')
        studio.wait(lambda layout: 'places.missing' not in layout['items'] and 'places.finding' not in layout['items']
                    and 'lamp.handle' in layout['items'], 'the surfaces', 60)
        lit = self.seen('place_lit')
        studio.screenshot('place_panel')
        gain = np.subtract(self.sides(lit), self.sides(before))
        self.assertGreater(gain[0], gain[1] + 3, 'a new lamp comes from the left')
        studio.drag(studio.point('lamp.handle'), studio.point('viewer.picture', .62, .45))
        studio.settle()
        right = self.seen('place_right')
        gain = np.subtract(self.sides(right), self.sides(before))
        self.assertGreater(gain[1], gain[0] + 3, 'and where it is dragged to, from the right')
        path, session = self.save_as('placed')
        self.assertEqual(session['edits']['new_lights'], ['lamp'])
        self.assertEqual(sorted(session['edits']['lamp_places']), ['left', 'right', 'top'])
        self.assertAlmostEqual(session['edits']['lamp_places']['left']['azimuth'], LAMPS['left'][0], delta=6)
        self.assertGreater(session['edits']['edits'][0]['azimuth'], 10)
        frame = self.path('cli.exr')
        subprocess.run([PROGRAM, 'relight', self.path('solved.exr'), '--session', path, '-o', frame, '-q'], check=True)
        np.testing.assert_array_equal(read_float(self.export_frame('frame.exr'))[0], read_float(frame)[0])
        studio.key('ctrl+z')
        studio.settle()
        self.assertLess(np.abs(self.seen('place_undone') - lit).mean(), .5, 'one undo takes the drag back')

    def test_a_light_that_was_photographed_is_turned_round_the_set(self):
        studio = self.open_ball()
        places = {name: {'azimuth': a, 'elevation': e, 'stops': 0} for name, (a, e) in LAMPS.items()}
        path, session = self.save_as('told')
        session['edits'] = {'size': [WIDTH, HEIGHT], 'new_lights': [], 'edits': [], 'lamp_places': places}
        with open(path, 'w') as file:
            json.dump(session, file)
        studio.quit()
        studio = self.start(path)
        studio.wait_ready()
        studio.click('mixer.right.chip')
        if not studio.has('edits.add'):
            studio.key('F4')
        studio.item('edits.add')
        before = self.seen('place_right_before')
        self.add('place')
        studio.item('lamp.handle')
        same = np.subtract(self.sides(self.seen('place_neutral')), self.sides(before))
        self.assertLess(np.abs(same).max(), .1, 'it stands where it stood')
        x0, y0 = studio.point('lamp.handle')
        x1, _ = studio.point('viewer.picture', .5)
        studio.drag((x0, y0), (2 * x1 - x0, y0))
        studio.settle()
        change = np.subtract(self.sides(self.seen('place_mirrored')), self.sides(before))
        self.assertGreater(change[0], 3)
        self.assertLess(change[1], -3)
        studio.key('ctrl+z')
        studio.settle()
        back = np.subtract(self.sides(self.seen('place_back')), self.sides(before))
        self.assertLess(np.abs(back).max(), .1)


if __name__ == '__main__':
    unittest.main()

"""swaplight normals: how surfaces are turned, from lamps whose places are told"""
import json
import unittest

import numpy as np
import swaplight_cli as cli

SIZE = 96
RADIUS = .45
LAMPS = {'left': (-60, 25), 'right': (50, 15), 'top': (0, 60), 'low': (-20, -10)}


def direction(azimuth, elevation):
    a, e = np.radians([azimuth, elevation])
    return np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])


def ball():
    """Its normals before a wall: x to the right, y up, z towards the camera."""
    rows, columns = np.mgrid[:SIZE, :SIZE]
    x, y = (columns + .5) / SIZE - .5, .5 - (rows + .5) / SIZE
    square = RADIUS ** 2 - x ** 2 - y ** 2
    inside = np.stack([x, y, np.sqrt(np.maximum(square, 0))], -1) / RADIUS
    return np.where((square > 0)[..., None], inside, [0, 0, 1.])


class NormalsTest(cli.CliTest):
    def solved(self):
        capture = cli.Capture(self.path('set'), tuple(LAMPS))
        paint = np.array([.6, .5, .4])
        capture.truth = [(np.maximum(ball() @ direction(*place), 0)[..., None] * paint).astype(np.float32)
                         for place in LAMPS.values()]
        capture.shots = [cli.photograph(capture.truth, c) for c in cli.rotated(4)]
        capture.save()
        self.succeed('solve', capture.path, '-o', self.path('solved.exr'), '--float', '-q')
        return self.path('solved.exr')

    @staticmethod
    def lamps(distance='far', stops=',0', wrong=0):
        return [text for name, (azimuth, elevation) in LAMPS.items()
                for text in ('--lamp', f'{name}={azimuth + wrong},{elevation},{distance}{stops}')]

    def error(self, file):
        found = cli.read_image(file)
        normals = np.stack([found['normal.' + c] for c in 'XYZ'], -1)
        known = np.linalg.norm(normals, axis=-1) > .5
        angle = np.degrees(np.arccos(np.clip((normals * ball()).sum(-1), -1, 1)))
        return angle[known].mean(), 1 - known.mean()

    def test_normals_of_a_ball_and_its_relief(self):
        out = self.path('normals.exr')
        said = self.succeed_json('normals', self.solved(), *self.lamps(), '-o', out)
        error, refused = self.error(out)
        self.assertLess(error, 3)
        self.assertLess(refused, .3)
        self.assertAlmostEqual(said['refused'], refused, delta=.001)
        depth = cli.read_image(out)['depth.Z']
        self.assertLess(depth[48, 48], depth[48, 76], 'the middle of the ball is nearer')
        self.assertLess(depth[48, 48], depth[20, 48])
        paint = np.stack([cli.read_image(out)['reflectance.' + c] for c in 'RGB'], -1)[48, 48]
        np.testing.assert_allclose(paint, [.6, .5, .4], rtol=.03)
        self.assertIn('refused', self.succeed('normals', self.path('solved.exr'), *self.lamps(), '-o', out).stdout)

    def test_places_told_ten_degrees_off_serve(self):
        out = self.path('normals.exr')
        self.succeed('normals', self.solved(), *self.lamps(stops='', wrong=10), '-o', out)
        self.assertLess(self.error(out)[0], 15)

    def test_three_lamps_are_said_not_to_be_checked(self):
        said = self.succeed('normals', self.solved(), *self.lamps()[:6], '-o', self.path('normals.exr'))
        self.assertIn('which nothing checks', said.stdout + said.stderr)

    def test_near_lamps_are_left_out_or_refused(self):
        solved, out = self.solved(), self.path('normals.exr')
        lamps = self.lamps()
        said = self.succeed('normals', solved, *lamps[:7], 'low=-20,-10,.8,0', '-o', out)
        self.assertIn('low', said.stdout + said.stderr)
        self.deny('normals', solved, *self.lamps(distance='1.2'), '-o', out, naming=['nearer than 2 widths', 'left'])

    def edits(self, light, place, told=tuple(LAMPS), **more):
        """A file of one edit that places a lamp."""
        places = {name: {'azimuth': LAMPS[name][0], 'elevation': LAMPS[name][1], 'stops': 0} for name in told}
        edit = {'name': 'placed', 'lights': [light], 'operation': 'place', 'azimuth': place[0], 'elevation': place[1]}
        file = {'format': 'swaplight-edits', 'version': 1, 'lamp_places': places, 'edits': [edit], **more}
        path = self.path('place.json')
        with open(path, 'w') as out:
            json.dump(file, out)
        return path

    def alone(self, light, edits):
        """The picture lit by one light, edited."""
        dark = [text for name in LAMPS if name != light for text in ('--light', f'{name}=off')]
        self.succeed('relight', self.path('solved.exr'), '--edits', edits, *dark, '-o', self.path('frame.exr'))
        return np.stack([cli.read_image(self.path('frame.exr'))[c] for c in 'RGB'], -1)

    def misfit(self, frame, place):
        """Of what four lamps light: the rest is a guess."""
        seen = np.min([ball() @ direction(*lamp) for lamp in LAMPS.values()], 0) > .1
        truth = np.maximum(ball() @ direction(*place), 0)[..., None] * np.array([.6, .5, .4])
        return np.sqrt(((frame - truth)[seen] ** 2).mean() / (truth[seen] ** 2).mean())

    def test_a_lamp_is_placed_elsewhere_and_a_new_one_lights_the_ball(self):
        self.solved()
        place = (-20, 50)
        self.assertGreater(self.misfit(self.alone('right', self.edits('right', LAMPS['right'])), place), .2)
        self.assertLess(self.misfit(self.alone('right', self.edits('right', place)), place), .03)
        new = self.edits('sun', place, new_lights=['sun'])
        self.assertLess(self.misfit(self.alone('sun', new), place), .03)

    def test_what_is_missing_for_a_placed_lamp_is_said(self):
        solved, out = self.solved(), self.path('frame.png')
        say = lambda edits: self.deny('relight', solved, '--edits', edits, '-o', out, naming=['place.json', *self.naming])
        self.naming = ['right', 'where its lamp stood']
        say(self.edits('right', (0, 0), told=('left', 'top', 'low')))
        self.naming = ['2 of 3 are known']
        say(self.edits('right', (0, 0), told=('left', 'right')))
        self.naming = ['lamp_places', 'azimuth']
        say(self.edits('right', (0, 0), lamp_places={'left': {'azimuth': 700, 'elevation': 0}}))
        self.naming = ['azimuth']
        say(self.edits('right', (400, 0)))

    def test_bad_places_are_one_line_and_exit_2(self):
        solved, out = self.solved(), self.path('normals.exr')
        for place in ('left', 'left=1,2', 'left=1,2,3,4,5', 'left=x,2,far', 'left=181,0,far', 'left=0,91,far',
                      'left=0,0,-1', 'left=0,0,near', 'left=0,0,nan'):
            self.deny('normals', solved, *self.lamps()[2:], '--lamp', place, '-o', out, naming=['--lamp', place])
        self.deny('normals', solved, *self.lamps()[:4], '-o', out, naming=['3 lamps', '2 given'])
        self.deny('normals', solved, *self.lamps(), *self.lamps()[:2], '-o', out, naming=['left', 'already'])
        self.deny('normals', solved, *self.lamps()[2:], '--lamp', 'left=0,0,far', '-o', out, naming=['stops'])
        self.deny('normals', solved, *self.lamps(), '-o', self.path('normals.png'), naming=['normals.png', 'OpenEXR'])
        self.deny('normals', solved, *self.lamps()[2:], '--lamp', 'sun=0,0,far,0', '-o', out, naming=['sun', 'left'])
        self.deny('normals', solved, *self.lamps(), '-o', out, '--edits', 'edits.json', naming=['--edits'])
        self.deny('normals', self.path('none.exr'), *self.lamps(), '-o', out, naming=['none.exr'])


if __name__ == '__main__':
    cli.main()

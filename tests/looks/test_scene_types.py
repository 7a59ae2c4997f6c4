"""The scene types that come along: each changes a picture as its name promises; favourites are kept."""
import json
import os

import numpy as np

from cli import CliTest, main, read_rgb, write_image

HEIGHT, WIDTH = 216, 384
LUMA = np.array([.2126, .7152, .0722])
LAMP = (slice(90, 102), slice(300, 312))


def scene():
    """Surfaces of six colours and six greys under white light, and a lamp as bright as 20 white surfaces."""
    colours = [[.4, .08, .06], [.08, .35, .09], [.06, .1, .4], [.45, .38, .06], [.35, .2, .14], [.1, .3, .35]]
    greys = [[g] * 3 for g in (.03, .06, .12, .2, .4, .8)]
    picture = np.zeros((HEIGHT, WIDTH, 3), np.float32)
    for row, patches in enumerate((colours, greys)):
        for column, patch in enumerate(patches):
            picture[row * 108:(row + 1) * 108, column * 64:(column + 1) * 64] = patch
    picture[LAMP] = 20
    return picture


def linear(codes):
    return np.where(codes <= .04045, codes / 12.92, ((codes + .055) / 1.055) ** 2.4)


class Seen:
    """What one would say of a picture, from its light."""

    def __init__(self, light):
        self.light = light
        mean = np.median(light.reshape(2, 108, 6, 64, 3)[:, 20:-20, :, 10:-10], axis=(1, 3))  # of each patch
        self.colours, self.greys = mean
        y = self.greys @ LUMA
        self.brightness = np.exp(np.log(np.maximum(y, 1e-6)).mean())
        self.warmth = (self.greys[:, 0] / np.maximum(self.greys[:, 2], 1e-6))[1:5].mean()  # red to blue of greys
        self.contrast = y[4] / max(y[0], 1e-6)
        spread = self.colours.max(-1) - self.colours.min(-1)
        self.saturation = (spread / np.maximum(self.colours.max(-1), 1e-6)).mean()
        ring = light[LAMP[0].start - 8:LAMP[0].start - 3, LAMP[1]].mean((0, 1)) @ LUMA
        self.glow = ring / max(self.greys[4] @ LUMA, 1e-6)  # the light beside the lamp, to that of a bright grey
        self.corners = light[-6:, :6].mean() / max(light[-6:, 28:36].mean(), 1e-6)


class SceneTypes(CliTest):
    def setUp(self):
        super().setUp()
        os.environ['XDG_DATA_HOME'] = self.path('data')

    def see(self, look):
        frame = self.path('frame.exr')
        if not os.path.exists(frame):
            write_image(frame, scene())
        self.succeed('look', 'apply', frame, '--look', look, '-o', self.path('seen.png'), '--type', 'uint16')
        return Seen(linear(read_rgb(self.path('seen.png'))))

    def plain(self):
        write_image(self.path('plain.exr'), scene())
        self.succeed('look', 'apply', self.path('plain.exr'), '--filter', 'exposure,stops=0', '-o',
                     self.path('plain.png'), '--type', 'uint16')
        return Seen(linear(read_rgb(self.path('plain.png'))))

    def test_each_changes_the_picture_as_its_name_promises(self):
        plain = self.plain()
        self.assertAlmostEqual(plain.warmth, 1, delta=.01)
        promises = {  # of what is seen to the plain picture: least and most
            'Snow': {'brightness': (1.2, 2.5), 'warmth': (.6, .97), 'saturation': (.3, .9), 'glow': (1.05, 99)},
            'Indoor': {'brightness': (1.02, 1.6), 'warmth': (1.1, 2), 'contrast': (1.05, 2)},
            'Twilight': {'brightness': (.25, .7), 'warmth': (.3, .85), 'corners': (0, .95)},
            'Beach': {'brightness': (1.1, 1.7), 'warmth': (1.05, 2), 'saturation': (1.02, 2), 'glow': (1.05, 99)},
            'Fireworks': {'brightness': (.3, .8), 'saturation': (1.02, 2), 'glow': (1.3, 99)},
            'Night': {'brightness': (.05, .4), 'warmth': (.2, .7), 'saturation': (.2, 1), 'corners': (0, .9)},
            'Magic hour': {'brightness': (.95, 1.6), 'warmth': (1.3, 3), 'glow': (1.05, 99)},
            'Overcast': {'brightness': (.8, 1.4), 'warmth': (.8, .99), 'contrast': (.3, .9), 'saturation': (.3, .9)},
            'Tungsten': {'brightness': (.4, .9), 'warmth': (1.4, 4), 'contrast': (1.1, 3), 'corners': (0, .95)},
            'Noir': {'saturation': (0, .02), 'contrast': (1.5, 50), 'corners': (0, .9)},
        }
        self.assertEqual(sorted(promises), sorted(self.succeed_json('look', 'list')['favourites']))
        for look, expected in promises.items():
            seen = self.see(look)
            for what, (least, most) in expected.items():
                ratio = getattr(seen, what) / getattr(plain, what)
                self.assertTrue(least <= ratio <= most, f'{look}: {what} is {ratio:.3f} of the plain picture\'s, '
                                                        f'expected {least} to {most}')
            self.assertTrue(np.isfinite(seen.light).all(), look)

    def test_they_are_told_apart_at_a_glance(self):
        seen = {look: self.see(look) for look in self.succeed_json('look', 'list')['favourites']}
        for one in seen:
            for other in seen:
                if one < other:
                    difference = np.abs(seen[one].light ** (1 / 2.2) - seen[other].light ** (1 / 2.2)).mean()
                    self.assertGreater(difference, .02, f'{one} and {other}')


class Favourites(CliTest):
    def setUp(self):
        super().setUp()
        os.environ['XDG_DATA_HOME'] = self.path('data')

    def favourites(self):
        return self.succeed_json('look', 'list')['favourites']

    def test_a_persons_own_look_is_starred_and_kept(self):
        first = self.favourites()
        self.assertEqual(first[:5], ['Snow', 'Indoor', 'Twilight', 'Beach', 'Fireworks'])
        os.makedirs(self.path('data/swaplight/camera-looks'))
        with open(self.path('data/swaplight/camera-looks/mine.swaplook'), 'w') as file:
            json.dump({'format': 'swaplight-look', 'version': 1, 'name': 'My grey', 'filters': [{'filter': 'grayscale'}]}, file)
        self.assertEqual(self.succeed_json('look', 'star', 'my-grey')['favourites'], ['My grey', *first])
        self.assertEqual(self.favourites(), ['My grey', *first])
        listed = self.succeed('look', 'list').stdout.splitlines()
        self.assertTrue(any(line.startswith('My grey') and 'camera look *' in line for line in listed))
        self.assertFalse(any(line.startswith('Cartoon') and '*' in line for line in listed))
        self.succeed('look', 'unstar', 'Snow', 'magic_hour')
        self.assertEqual(self.favourites(), ['My grey'] + [n for n in first if n not in ('Snow', 'Magic hour')])
        self.assertIn('grayscale', self.succeed('look', 'show', 'my grey').stdout)

    def test_what_cannot_be_starred_is_said(self):
        self.deny('look', 'star', naming='name a camera look')
        self.deny('look', 'star', 'No such look', naming='no camera look')
        self.deny('look', 'unstar', 'Cartoon', naming='no favourite')
        self.deny('look', 'star', 'mine.swaplook', naming='library')
        os.makedirs(self.path('data/swaplight'))
        file = self.path('data/swaplight/favourite-looks.json')
        with open(file, 'w') as f:
            f.write('{"format": "something"}')
        self.deny('look', 'star', 'Twilight', naming=[file, 'remove the file'])
        with open(file) as f:
            self.assertEqual(f.read(), '{"format": "something"}', 'left as it is')


if __name__ == '__main__':
    main()

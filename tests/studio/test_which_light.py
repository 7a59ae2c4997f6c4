"""Which light is this? With Q held, the lights' shares of the pixel under the mouse, and a click that selects."""
import os
import unittest

import numpy as np
import OpenImageIO as oiio

from studio_session import SAMPLES, StudioTest


def truth(light):
    """What the light gives to every pixel of three_point: height x width, luminance."""
    source = oiio.ImageInput.open(os.path.join(SAMPLES, 'three_point', 'truth', f'T_{light}.exr'))
    pixels = np.asarray(source.read_image('float')).reshape(source.spec().height, source.spec().width, -1)[..., :3]
    source.close()
    return pixels @ [0.2126, 0.7152, 0.0722]


class WhichLight(StudioTest):
    size = (1600, 900)

    def test_the_shares_are_shown_and_a_click_selects(self):
        studio = self.open_sample()
        names = sorted(name[6:-5] for name in studio.layout()['items'] if name.startswith('mixer.') and name.endswith('.chip'))
        given = {name: truth(name) for name in names}
        total = sum(given.values())
        lit = total > np.quantile(total, 0.3)
        height, width = total.shape
        places = {}
        for name in names:
            share = np.where(lit, given[name] / np.maximum(total, 1e-6), 0)
            share[share > 0.9] = 0  # another click has another light to take
            y, x = np.unravel_index(np.argmax(share), share.shape)
            if share[y, x] > 0.75:
                places[name] = ((x + 0.5) / width, (y + 0.5) / height)
        self.assertGreaterEqual(len(places), 2, 'places at which it is plain which light it is')
        self.assertFalse(studio.has('viewer.which_light'))
        studio.xdotool('keydown', 'q')
        for name, (x, y) in places.items():
            studio.move(*studio.point('viewer.picture', x, y))
            studio.item('viewer.which_light')
            self.assertEqual(studio.state('viewer.which_light'), name)
        studio.screenshot('which_light')
        studio.click_at(*studio.point('viewer.picture', *places[name]))
        studio.wait(lambda layout: layout.get('viewer.which_light', name) != name, 'another click takes the next one', 15)
        studio.xdotool('keyup', 'q')
        studio.rest()
        self.assertFalse(studio.has('viewer.which_light'))
        place = studio.item('viewer.picture')
        studio.key('m')  # mutes the light that was selected
        lights = {light['name']: light for light in self.save_as('asked')[1]['rig']['lights']}
        self.assertEqual([light for light in names if lights[light].get('mute')], [name])
        self.assertEqual(studio.item('viewer.picture'), place, 'the picture has not moved')


if __name__ == '__main__':
    unittest.main()

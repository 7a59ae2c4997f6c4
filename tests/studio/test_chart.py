"""A colour chart in a photograph, in a real window: found or shown by its corners, its light, the camera's matrix, a gel."""
import json
import os
import subprocess
import sys
import unittest

import numpy as np
import OpenImageIO as oiio

from drop_files import drop_files
from studio_session import HERE, PROGRAM, StudioTest

sys.path.append(os.path.join(HERE, '../intake'))
from made_chart import CORNERS, photograph

WHITE, GEL = np.array([.8, .7, .6]), np.array([.7, .25, .1])
CAMERA = np.array([[.78, .17, .05], [.12, .8, .08], [.03, .22, .75]])


def write_picture(path, pixels):
    pixels = np.ascontiguousarray(pixels, np.float32)
    out = oiio.ImageBuf(oiio.ImageSpec(*pixels.shape[1::-1], 3, 'float'))
    out.set_pixels(oiio.ROI(), pixels)
    out.write(path)
    return path


def behind_an_arm():
    """An arm lies across the chart: nobody finds it but a person."""
    pixels = photograph(WHITE)
    pixels[200:262] = .15, .1, .08
    return pixels


class Chart(StudioTest):
    def choose(self, path):
        self.studio.item('chooser.name')
        self.studio.settle()
        self.studio.key('ctrl+a')
        self.studio.type(path)
        self.studio.key('Return')

    def open_chart(self, path):
        self.studio.click('menu.Lights')
        self.studio.click('menu.file.chart')
        self.choose(path)
        self.studio.item('chart.picture')
        self.studio.settle()

    def light(self):
        return [float(part) for part in self.studio.state('chart.light.text').split('/')]

    def on_screen(self, x, y):
        left, top, right, bottom = self.studio.item('chart.picture')
        return left + (right - left) * (x + .5) / 680, top + (bottom - top) * (y + .5) / 480

    def test_the_light_the_camera_and_a_gel(self):
        white = write_picture(self.path('white.exr'), photograph(WHITE, CAMERA))
        gelled = write_picture(self.path('gelled.exr'), photograph(WHITE * GEL))
        studio = self.start()
        studio.item('welcome.open')
        self.open_chart(white)
        self.assertEqual(studio.state('chart.read'), 'yes')
        np.testing.assert_allclose(self.light(), WHITE, rtol=.02)
        studio.move(*self.on_screen(150, 120))
        studio.screenshot('chart_read')
        studio.click('chart.save')
        self.choose(self.path('camera.json'))
        studio.wait(lambda layout: os.path.exists(self.path('camera.json')), 'the matrix is saved')
        with open(self.path('camera.json')) as file:
            matrix = np.array(json.load(file)['camera_matrix'])
        np.testing.assert_allclose(matrix, np.linalg.inv(CAMERA), atol=.05)
        subprocess.run([PROGRAM, 'balance', white, '--grey', '300,345', '--camera', self.path('camera.json'), '-o',
                        self.path('right.exr'), '-q'], check=True)
        studio.click('chart.close')
        studio.wait(lambda layout: layout.get('popups') == '0', 'it is closed')

        # The camera's colours are Rec.709 from here on.
        write_picture(white, photograph(WHITE))
        self.open_chart(gelled)
        studio.click('chart.gel.without')
        self.choose(white)
        studio.item('chart.gel.brand')
        studio.settle()
        passed = 100 * np.dot(GEL, [.2126, .7152, .0722])
        words = studio.state('chart.gel.words').split()
        self.assertAlmostEqual(float(words[1]), passed, delta=1)
        for name, text in (('brand', 'House'), ('number', '77'), ('name', 'Brick')):
            studio.click('chart.gel.' + name)
            studio.type(text)
        studio.screenshot('chart_gel')
        studio.click('chart.gel.add')
        studio.wait(lambda layout: 'message.0' in layout['items'], 'the gel is known')
        with open(os.path.join(studio.home, '.local/share/swaplight/gels/measured.csv')) as file:
            self.assertIn('House,77,Brick', file.read())
        studio.key('Escape')
        studio.wait(lambda layout: layout.get('popups') == '0', 'Escape closes it')

    def test_corners_are_put_where_no_chart_is_found(self):
        path = write_picture(self.path('arm.exr'), behind_an_arm())
        studio = self.start()
        studio.item('welcome.open')
        self.open_chart(path)
        self.assertEqual(studio.state('chart.read'), 'no')
        self.assertIn('No chart was found', studio.state('chart.wrong'))
        studio.screenshot('chart_not_found')
        for corner, (x, y) in enumerate(CORNERS):
            left, top, right, bottom = studio.item(f'chart.corner.{corner}')
            studio.drag(((left + right) / 2, (top + bottom) / 2), self.on_screen(x + 3, y - 3))
            studio.settle()
        studio.wait(lambda layout: layout.get('chart.read') == 'yes', 'the chart is read')
        np.testing.assert_allclose(self.light(), WHITE, rtol=.05)
        studio.screenshot('chart_corners')

    def test_the_wizard_takes_a_light_from_a_chart(self):
        shots = self.path('shots')
        os.makedirs(shots)
        for k in range(2):
            write_picture(os.path.join(shots, f'{k}.exr'), photograph(WHITE * (1 if k else GEL), noise=.01))
        chart = write_picture(self.path('arm.exr'), photograph(WHITE * GEL))
        studio = self.start()
        studio.item('welcome.open')
        drop_files(self.display.name, 'Swaplight', [shots], 500, 300)
        studio.item('wizard.cell.0.0')
        studio.settle()
        studio.click('wizard.cell.0.1.list')
        studio.click('wizard.choose.chart')
        self.choose(chart)
        studio.item('chart.picture')
        studio.settle()
        studio.screenshot('chart_for_wizard')
        studio.click('chart.use')
        told = studio.wait(lambda layout: '/' in layout.get('wizard.cell.0.1.text', ''), 'the colour is told')
        color = [float(part) for part in told['wizard.cell.0.1.text'].split('/')]
        np.testing.assert_allclose(color, WHITE * GEL, rtol=.02)
        studio.screenshot('chart_used')


if __name__ == '__main__':
    unittest.main()

"""Bringing in a folder of photographs in a real window: dropped or chosen, colours typed, picked, guessed, unknown."""
import itertools
import json
import os
import shutil
import subprocess
import sys
import unittest

import numpy as np
import OpenImageIO as oiio

from drop_files import drop_files
from studio_session import HERE, PROGRAM, SAMPLES, StudioTest

sys.path.append(os.path.join(HERE, '../intake'))
from camera_raw import write_dng
from made_chart import photograph as chart_photograph


class Wizard(StudioTest):
    def setUp(self):
        super().setUp()
        self.shots = self.path('shots')
        os.makedirs(self.shots)

    def photographs(self, sample):
        with open(os.path.join(SAMPLES, sample, 'capture.json')) as file:
            manifest = json.load(file)
        for shot in manifest['shots']:
            shutil.copy(os.path.join(SAMPLES, sample, shot['image']), self.shots)
        return manifest

    def drop(self):
        drop_files(self.display.name, 'Swaplight', [self.shots], 500, 300)
        self.studio.item('wizard.cell.0.0')
        self.studio.settle()

    def fill_in(self, shot, *texts):
        for light, text in enumerate(texts):
            self.studio.click(f'wizard.cell.{shot}.{light}', 0.3)
            self.studio.key('ctrl+a')
            self.studio.type(text)

    def written(self):
        with open(os.path.join(self.shots, 'capture.json')) as file:
            return json.load(file)

    def test_dropped_photographs_become_a_solved_picture(self):
        manifest = self.photographs('three_point')
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        studio.screenshot('wizard_dropped')
        self.fill_in(0, *('/'.join(map(str, color)) for color in manifest['shots'][0]['light_colors']))
        studio.click('wizard.guess')
        studio.wait(lambda layout: 'guessed, the best' in layout.get('wizard.guess_words', ''), 'the guess')
        studio.screenshot('wizard_guessed')
        studio.click('wizard.solve')
        studio.wait_ready()
        self.assertEqual([shot['light_colors'] for shot in self.written()['shots']],
                         [shot['light_colors'] for shot in manifest['shots']])
        studio.move(640, 15)
        picture = studio.picture('wizard_solved')
        studio.quit()
        self.open_sample()
        self.studio.move(640, 15)
        self.assertLess(np.abs(self.studio.picture('wizard_sample') - picture).mean(), 0.5)

    def test_at_larger_scales_its_first_line_does_not_lie_over_itself(self):
        self.photographs('three_point')
        for scale in ('1', '1.25', '1.5'):
            with self.subTest(scale):
                studio = self.start(scale=scale)
                studio.item('welcome.open')
                self.drop()
                items = studio.layout()['items']
                studio.screenshot('wizard_scale_' + scale)
                _, top, right, bottom = items['wizard.color_hint']
                for other in ('wizard.more', 'wizard.field', 'wizard.align'):
                    x0, y0, x1, y1 = items[other]
                    self.assertTrue(right <= x0 or x1 <= items['wizard.color_hint'][0] or bottom <= y0 or y1 <= top, other)
                self.assertLessEqual(right, items['wizard.align'][2] + 30, 'it stays in the dialog')
                studio.kill()

    def test_the_photographs_are_asked_whether_they_hold_light(self):
        """Each lamp alone and both together, as light and through a camera's contrast."""
        random = np.random.default_rng(2)
        y, x = np.mgrid[:90, :120]
        lamps = [.4 * (.55 + .45 * np.sin(.07 * x[..., None] + 2 * i + np.arange(3)) * np.cos(.05 * y[..., None] - i)) for i in (0, 1)]
        for k, pair in enumerate(((1, 0), (0, 1), (1, 1))):
            light = sum(on * lamp for on, lamp in zip(pair, lamps))
            light = np.clip(light + random.normal(size=light.shape) * np.sqrt(light / 40000 + 1e-6), 1e-9, 1)
            v = np.where(light <= .0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - .055)
            v = v + .35 * (v * v * (3 - 2 * v) - v)
            out = oiio.ImageBuf(oiio.ImageSpec(120, 90, 3, 'uint8'))
            out.set_pixels(oiio.ROI(), np.round(255 * v).astype(np.uint8))
            out.write(os.path.join(self.shots, f'{k}.png'))
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        studio.click('wizard.fewer', 0.3)  # as many as photographs
        for k, pair in enumerate((('white', 'off'), ('off', 'white'), ('white', 'white'))):
            self.fill_in(k, *pair)
        studio.click('wizard.linear')
        studio.wait(lambda layout: layout.get('wizard.linear.words', '').startswith('no'), 'the answer')
        studio.screenshot('wizard_linear')
        self.fill_in(2, 'off')
        studio.wait(lambda layout: layout.get('wizard.linear.words', 'x') == '', 'the answer was of other colours')
        self.fill_in(2, 'white')
        studio.click('wizard.tone')
        studio.click('wizard.solve')
        studio.wait_ready()
        self.assertIs(self.save_as('toned')[1]['solve']['correct_tone'], True)

    def test_colours_are_taken_from_charts(self):
        """Charts beside the photographs, each under one lamp, are offered with their light."""
        manifest = self.photographs('two_swapped')
        colors = manifest['shots'][0]['light_colors']
        for name, color in zip(('red', 'green'), colors):
            pixels = np.ascontiguousarray(chart_photograph(np.array(color)), np.float32)
            out = oiio.ImageBuf(oiio.ImageSpec(*pixels.shape[1::-1], 3, 'float'))
            out.set_pixels(oiio.ROI(), pixels)
            out.write(os.path.join(self.shots, f'chart_{name}.exr'))
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        for light, name in enumerate(('red', 'green')):
            studio.click(f'wizard.cell.0.{light}.list')
            studio.item(f'wizard.choose.chart_{name}.exr')
            studio.screenshot('wizard_charts')
            studio.click(f'wizard.choose.chart_{name}.exr')
            told = [float(x) for x in studio.state(f'wizard.cell.0.{light}.text').split('/')]
            np.testing.assert_allclose(told, colors[light], rtol=.05, atol=.01)

    def test_a_chart_that_cannot_be_read_is_said_whichever_photographs_are_used(self):
        self.photographs('three_point')
        wall = oiio.ImageBuf(oiio.ImageSpec(400, 300, 3, 'float'))
        oiio.ImageBufAlgo.fill(wall, (.3, .3, .3))
        wall.write(os.path.join(self.shots, 'chart_wall.exr'))
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        self.assertIn('chart_wall.exr', studio.state('wizard.warnings.text'))
        studio.click('wizard.use.1', 0.05)
        studio.wait(lambda layout: layout.get('wizard.use.1.on') == 'no', 'it is left out')
        studio.settle()
        self.assertIn('chart_wall.exr', studio.state('wizard.warnings.text'))
        studio.screenshot('wizard_no_chart')

    def test_a_chosen_folder_with_an_unknown_colour(self):
        manifest = self.photographs('two_swapped')
        studio = self.start()
        studio.item('welcome.new')
        studio.key('ctrl+n')
        studio.item('chooser.name')
        studio.type(self.shots + '_')
        studio.key('Return')
        studio.item('chooser.words')
        self.assertEqual(studio.state('chooser.words'), f'There is no folder {self.shots}_.')
        self.assertFalse(studio.has('wizard.cancel'), 'the folder that is listed was not meant')
        studio.key('End', 'BackSpace')
        studio.settle()
        self.assertFalse(studio.has('chooser.words'))
        studio.screenshot('wizard_chooser')
        studio.key('Return')
        studio.item('wizard.cell.0.0')
        studio.settle()
        before = int(studio.state('wizard.warnings'))
        colors = [['/'.join(map(str, color)) for color in shot['light_colors']] for shot in manifest['shots']]
        self.fill_in(0, colors[0][0])
        studio.click('wizard.cell.0.1.list')
        studio.click('wizard.choose.unknown')
        self.fill_in(1, *colors[1])
        studio.click('wizard.align', 0.1)
        studio.item('wizard.field')
        studio.click('wizard.light.0')
        studio.key('ctrl+a')
        studio.type('lamp')
        studio.wait(lambda layout: int(layout.get('wizard.warnings', 0)) > before, 'what is assumed is said')
        studio.screenshot('wizard_unknown')
        studio.click('wizard.solve')
        studio.wait_ready()
        capture = self.written()
        self.assertEqual([light['name'] for light in capture['lights']], ['lamp', 'fill'])
        self.assertIsNone(capture['shots'][0]['light_colors'][1])
        self.assertGreater(studio.picture('wizard_unknown_solved').std(), 15)
        studio.key('ctrl+s')
        studio.item('chooser.name')
        studio.settle()
        studio.key('ctrl+a')
        studio.type(self.path('brought.swaplight'))
        studio.key('Return')
        studio.wait(lambda layout: layout.get('title', '').startswith('brought'), 'the session has a name')
        with open(self.path('brought.swaplight')) as file:
            self.assertTrue(json.load(file)['solve']['align'])

    def test_lamps_one_by_one_by_a_button(self):
        manifest = self.photographs('three_point')
        count = len(manifest['shots'])
        subprocess.run([PROGRAM, 'relight', os.path.join(SAMPLES, 'three_point'), '-o', os.path.join(self.shots, 'mine.png')],
                       check=True, capture_output=True)
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        self.assertTrue(studio.has(f'wizard.picture.{count - 1}'))
        self.assertFalse(studio.has(f'wizard.picture.{count}'), 'what it has exported is no photograph')
        texts = lambda: [[studio.state(f'wizard.cell.{k}.{i}.text') for i in range(count)] for k in range(count)]
        for button, alone, others in (('wizard.one_lamp', 'white', 'off'), ('wizard.one_off', 'off', 'white')):
            studio.click(button)
            studio.settle()
            self.assertEqual(texts(), [[alone if i == k else others for i in range(count)] for k in range(count)])
        studio.screenshot('wizard_one_off')

    def test_a_photograph_is_left_out_and_stays_so(self):
        manifest = self.photographs('two_swapped')
        first, second = (os.path.join(self.shots, shot['image']) for shot in manifest['shots'])
        shutil.copy(first, os.path.join(self.shots, 'shot_01b.exr'))  # once more, by mistake
        colors = [['/'.join(map(str, color)) for color in shot['light_colors']] for shot in manifest['shots']]
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        self.assertEqual(os.path.basename(second), 'shot_02.exr')
        studio.click('wizard.fewer')
        self.fill_in(0, *colors[0])
        self.fill_in(1, 'L201')
        studio.click('wizard.use.1', 0.05)
        studio.wait(lambda layout: layout.get('wizard.use.1.on') == 'no', 'it is left out')
        studio.settle()
        studio.click('wizard.guess')
        studio.wait(lambda layout: 'guessed' in layout.get('wizard.guess_words', ''), 'the guess')
        self.assertEqual([studio.state(f'wizard.cell.2.{i}.text') for i in range(2)], colors[1])
        studio.screenshot('wizard_left_out')
        studio.click('wizard.solve')
        studio.wait_ready()
        written = self.written()
        self.assertEqual([shot['image'] for shot in written['shots']], ['shot_01.exr', 'shot_02.exr'])
        self.assertEqual([shot['light_colors'] for shot in written['shots']],
                         [shot['light_colors'] for shot in manifest['shots']])
        left_out, = written['left_out']
        self.assertEqual(left_out['image'], 'shot_01b.exr')
        self.assertIsNone(left_out['light_colors'][1])
        studio.quit()
        # Another day: the folder's capture.json says it all.
        studio = self.start()
        studio.item('welcome.new')
        studio.key('ctrl+n')
        studio.item('chooser.name')
        studio.type(self.shots)
        studio.key('Return')
        studio.item('wizard.cell.2.1')
        studio.settle()
        self.assertEqual([studio.state(f'wizard.use.{k}.on') for k in range(3)], ['yes', 'no', 'yes'])
        self.assertEqual([[studio.state(f'wizard.cell.{k}.{i}.text') for i in range(2)] for k in (0, 2)], colors)
        self.assertEqual(studio.state('wizard.cell.1.1.text'), '')
        studio.screenshot('wizard_read_back')
        studio.click('wizard.replace', 0.05)
        studio.click('wizard.solve')
        studio.wait_ready()
        self.assertEqual(self.written(), written)

    def brackets(self, *gains):
        """The sample's photographs, each as exposures that are these times as long."""
        with open(os.path.join(SAMPLES, 'two_swapped', 'capture.json')) as file:
            manifest = json.load(file)
        names = itertools.count(1)
        for shot, times in zip(manifest['shots'], gains):
            source = oiio.ImageInput.open(os.path.join(SAMPLES, 'two_swapped', shot['image']))
            pixels = np.asarray(source.read_image('float'))[..., :3]
            source.close()
            for gain in times:
                path = os.path.join(self.shots, f'IMG_{next(names)}.exr')
                output = oiio.ImageOutput.create(path)
                spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, 'half')
                self.assertTrue(output.open(path, spec) and output.write_image(np.minimum(gain * pixels, 1)))
                output.close()
        return manifest

    def test_a_photograph_more_hides_no_brackets_once_it_is_left_out(self):
        manifest = self.brackets((2, 1, .125, 4), (1, .125, 4))
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        self.assertIn('a lighting of its own', studio.state('wizard.brackets'))
        studio.click('wizard.use.0', 0.05)
        studio.wait(lambda layout: '6 photographs are 2 lightings of 3 exposures: found' in layout.get('wizard.brackets', ''),
                    'the brackets are found')
        self.assertEqual([studio.state(f'wizard.use.{k}.on') for k in range(3)], ['no', 'yes', 'yes'])
        self.fill_in(1, *('/'.join(map(str, color)) for color in manifest['shots'][0]['light_colors']))
        studio.screenshot('wizard_brackets_left_out')
        studio.click('wizard.use.0', 0.05)
        studio.wait(lambda layout: 'a lighting of its own' in layout.get('wizard.brackets', ''), 'it is used again')

    def test_a_gel_from_the_list_and_a_colour_from_a_white_card(self):
        rng = np.random.default_rng(5)
        for k, color in enumerate(([.8, .3, .1], [.1, .3, .8])):
            pixels = rng.uniform(.02, .2, (90, 160, 3)).astype(np.float32)
            pixels[30:60, 60:100] = color
            spec = oiio.ImageSpec(160, 90, 3, 'float')
            output = oiio.ImageOutput.create(os.path.join(self.shots, f'{k + 1}.exr'))
            self.assertTrue(output.open(os.path.join(self.shots, f'{k + 1}.exr'), spec) and output.write_image(pixels))
            output.close()
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        for k in range(2):
            studio.click(f'wizard.cell.{k}.0.pick')
            studio.click(f'wizard.picture.{k}')
        studio.click('wizard.cell.0.1.list')
        studio.type('L201')
        studio.click('gel.L201')
        studio.screenshot('wizard_picked')
        line = studio.item('wizard.footer')
        self.fill_in(1, '0.1/0.3/0.8', 'L9999')
        studio.click('wizard.solve')
        studio.screenshot('wizard_wrong_gel')
        self.assertFalse(os.path.exists(os.path.join(self.shots, 'capture.json')), 'a gel that is not there')
        lines = studio.item('wizard.footer')  # every gel that there is: read to its end
        self.assertGreater(lines[3] - lines[1], 1.5 * (line[3] - line[1]), 'more lines than one')
        self.assertLess(lines[2], studio.item('wizard.solve')[0])
        self.assertLess(lines[3], 695, 'in the window')
        self.fill_in(1, '0.1/0.3/0.8', 'L106')
        studio.click('wizard.solve')
        studio.wait_ready()
        colors = [shot['light_colors'] for shot in self.written()['shots']]
        np.testing.assert_allclose(colors[0][0], [.8, .3, .1], atol=1e-3)
        self.assertGreater(colors[0][1][2], colors[0][1][0], 'L201 is blue')

    def test_camera_raw_is_shown_and_solved(self):
        """The same photographs as raw files of a camera give the same picture."""
        self.photographs('three_point')
        with open(os.path.join(SAMPLES, 'three_point', 'capture.json')) as file:
            manifest = json.load(file)
        for k, shot in enumerate(manifest['shots']):
            path = os.path.join(self.shots, shot['image'])
            source = oiio.ImageInput.open(path)
            pixels = np.asarray(source.read_image('float'))[..., :3]
            source.close()
            os.remove(path)
            write_dng(os.path.join(self.shots, f'P{k}.dng'), np.maximum(pixels, 0), f'2026:11:21 10:00:0{k}')
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        shown = studio.screenshot('wizard_raw')
        for k in range(len(manifest['shots'])):
            x0, y0, x1, y1 = map(int, studio.item(f'wizard.picture.{k}'))
            self.assertGreater(shown[y0:y1, x0:x1].std(), 10, 'a photograph is to be seen')
        self.fill_in(0, *('/'.join(map(str, color)) for color in manifest['shots'][0]['light_colors']))
        studio.click('wizard.guess')
        studio.wait(lambda layout: 'guessed, the best' in layout.get('wizard.guess_words', ''), 'the guess')
        studio.click('wizard.solve')
        studio.wait_ready()
        self.assertEqual([shot['image'] for shot in self.written()['shots']], ['P0.dng', 'P1.dng', 'P2.dng'])
        studio.move(640, 15)
        picture = studio.picture('wizard_raw_solved')
        studio.quit()
        self.open_sample()
        self.studio.move(640, 15)
        self.assertLess(np.abs(self.studio.picture('wizard_raw_sample') - picture).mean(), 3.5,
                        'but for the mosaic, which no lens softens here')

    def test_brackets_are_shown_as_one_lighting_each(self):
        manifest = self.brackets((1, .125, 4), (1, .125, 4))
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        self.assertIn('6 photographs are 2 lightings of 3 exposures: found', studio.state('wizard.brackets'))
        self.assertFalse(studio.has('wizard.cell.2.0'))
        studio.screenshot('wizard_brackets')
        found = studio.state('wizard.exposures.text')
        for text, words in (('0,-3', '6 photographs are 3 lightings of 2 exposures'), ('', 'a lighting of its own'),
                            (found, '6 photographs are 2 lightings of 3 exposures')):
            studio.click('wizard.exposures')
            studio.key('ctrl+a')
            studio.type(text) if text else studio.key('BackSpace')
            studio.wait(lambda layout: words in layout.get('wizard.brackets', ''), words)
        self.fill_in(0, *('/'.join(map(str, color)) for color in manifest['shots'][0]['light_colors']))
        studio.click('wizard.guess')
        studio.wait(lambda layout: 'guessed' in layout.get('wizard.guess_words', ''), 'the guess')
        studio.screenshot('wizard_brackets_guessed')
        studio.click('wizard.solve')
        studio.wait_ready()
        written = self.written()['shots']
        self.assertEqual([shot['light_colors'] for shot in written],
                         [manifest['shots'][k // 3]['light_colors'] for k in range(6)])
        np.testing.assert_allclose([shot.get('exposure_stops', 0) for shot in written], [0, -3, 2] * 2, atol=.03)
        self.assertGreater(studio.picture('wizard_brackets_solved').std(), 15)

    def test_what_has_no_photographs_is_said(self):
        studio = self.start()
        studio.item('welcome.open')
        drop_files(self.display.name, 'Swaplight', [self.shots], 500, 300)
        studio.item('message.0')
        studio.screenshot('wizard_nothing')
        self.assertFalse(studio.has('wizard.cell.0.0'))


    def test_the_photographs_are_cropped_by_a_drag_and_made_smaller(self):
        manifest = self.photographs('three_point')
        studio = self.start()
        studio.item('welcome.open')
        self.drop()
        for shot, description in enumerate(manifest['shots']):
            self.fill_in(shot, *('/'.join(map(str, color)) for color in description['light_colors']))
        studio.drag(studio.point('wizard.picture.0', 0.25, 0.1), studio.point('wizard.picture.0', 0.75, 0.9))
        studio.item('wizard.crop')
        x, y = studio.point('wizard.scale')
        studio.click_at(x, y)
        studio.click_at(x, y + 56)  # half size
        studio.screenshot('wizard_cropped')
        studio.click('wizard.solve')
        studio.wait_ready()
        x, y, width, height = self.written()['crop']
        self.assertAlmostEqual(x, 120, delta=6)
        self.assertAlmostEqual(width, 240, delta=8)
        self.assertAlmostEqual(height, 216, delta=8)
        scale = self.written().get('scale', 1)
        x0, y0, x1, y1 = studio.item('viewer.picture')
        self.assertAlmostEqual((x1 - x0) / (y1 - y0), width / height, delta=0.03)
        self.assertEqual(scale, 0.5)


if __name__ == '__main__':
    unittest.main()

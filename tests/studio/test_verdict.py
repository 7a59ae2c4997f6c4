"""The word after a solve in a real window: good for the sample, and not for colours that were told wrongly."""
import json
import os
import shutil
import unittest

from studio_session import SAMPLES, StudioTest


class Verdict(StudioTest):
    def test_the_word_of_the_status_bar_opens_the_report(self):
        studio = self.open_sample()
        self.assertEqual(studio.state('status.solve_word'), 'good')
        self.assertFalse(studio.has('message.0'))
        studio.click('status.solve')
        studio.item('status.report')
        studio.screenshot('verdict_report')
        studio.key('Escape')
        studio.settle()
        self.assertFalse(studio.has('status.report'))

    def test_wrong_colours_are_said(self):
        folder = self.path('wrong')
        shutil.copytree(os.path.join(SAMPLES, 'three_point'), folder)
        path = os.path.join(folder, 'capture.json')
        with open(path) as file:
            capture = json.load(file)
        for k, shot in enumerate(capture['shots']):
            gels = [[.26, .4, .8], [.8, .6, .35], [.5, .7, .4]]
            shot['light_colors'] = [gels[(i + k) % 3] for i in range(3)]
        with open(path, 'w') as file:
            json.dump(capture, file)
        studio = self.start(path)
        studio.wait_ready()
        studio.settle()
        self.assertEqual(studio.state('status.solve_word'), 'lights not apart')
        studio.item('message.0')
        studio.click('status.solve')
        studio.item('status.report')
        studio.screenshot('verdict_wrong_colours')


if __name__ == '__main__':
    unittest.main()

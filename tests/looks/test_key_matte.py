"""A key filter's matte as the mask of an edit: the same as what the filter shows."""
import json
import os

import numpy as np

from cli import CliTest, main, read_rgb

SET = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../samples/three_point/truth.json')
LIGHTS = ['--model', 'transport', '--light', 'key=+1st', '--light', 'fill=-1st', '--light', 'back=+0st']
FACTORS = {'key': [2, 2, 2], 'fill': [.5, .5, .5]}  # what is not named: 1


class KeyMatte(CliTest):
    def matte_of_filter(self, filter):
        frame = self.path('frame.exr')
        if not os.path.exists(frame):
            self.succeed('relight', SET, *LIGHTS, '-o', frame, '--type', 'float')
        self.succeed('look', 'apply', frame, '--filter', filter + ',show=1', '-o', self.path('matte.png'), '--type', 'uint16')
        return read_rgb(self.path('matte.png'))[..., 0]

    def matte_of_mask(self, lights=FACTORS, **shape):
        """From a frame whose light is taken away where the mask is: frame (1 - matte)."""
        edits = {'format': 'swaplight-edits', 'version': 1, 'edits': [
            {'operation': 'gain', 'gain': 0, 'meaning': 'add', 'mask': [{'shape': 'key', 'lights': lights, **shape}]}]}
        with open(self.path('edits.json'), 'w') as file:
            json.dump(edits, file)
        self.succeed('relight', SET, *LIGHTS, '--edits', self.path('edits.json'), '-o', self.path('edited.exr'), '--type', 'float')
        frame, edited = read_rgb(self.path('frame.exr')).sum(-1), read_rgb(self.path('edited.exr')).sum(-1)
        return 1 - edited / np.maximum(frame, 1e-6), frame > .003

    def compare(self, seen, mask, lit):
        self.assertGreater(lit.mean(), .9)
        self.assertGreater(seen[lit].std(), .2, 'some of both')
        self.assertGreater(((seen > .1) & (seen < .9)).mean(), .01, 'and of the ramp')
        np.testing.assert_allclose(mask[lit], seen[lit], atol=.004)

    def test_a_chroma_key(self):
        seen = self.matte_of_filter('chroma-key,key=0.85:0.6:0.5,inner=0.05,outer=0.12')
        self.compare(seen, *self.matte_of_mask(color=[.85, .6, .5], **{'from': .05, 'to': .12}))

    def test_a_chroma_key_as_under_white(self):
        """In a frame of a set the key is pulled as if the lights were at unit white."""
        key = 'chroma-key,key=0.85:0.6:0.5,inner=0.05,outer=0.12,show=1'
        self.succeed('relight', SET, *LIGHTS, '-o', self.path('frame.exr'), '--type', 'float')
        self.succeed('relight', SET, *LIGHTS, '--filter', key, '-o', self.path('matte.png'), '--type', 'uint16')
        self.compare(read_rgb(self.path('matte.png'))[..., 0],
                     *self.matte_of_mask(lights={}, color=[.85, .6, .5], **{'from': .05, 'to': .12}))

    def test_a_luma_key(self):
        seen = self.matte_of_filter('luma-key,low=0.2,high=0.6')
        self.compare(seen, *self.matte_of_mask(by='luma', **{'from': .2, 'to': .6}))

    def test_it_stays_where_it_is_when_the_lights_change(self):
        self.matte_of_filter('luma-key')
        first, lit = self.matte_of_mask(by='luma', **{'from': .2, 'to': .6})
        self.succeed('relight', SET, '--model', 'transport', '--light', 'key=-2st', '-o', self.path('frame.exr'), '--type', 'float')
        self.succeed('relight', SET, '--model', 'transport', '--light', 'key=-2st', '--edits', self.path('edits.json'), '-o',
                     self.path('edited.exr'), '--type', 'float')
        frame, edited = read_rgb(self.path('frame.exr')).sum(-1), read_rgb(self.path('edited.exr')).sum(-1)
        np.testing.assert_allclose((1 - edited / np.maximum(frame, 1e-6))[lit], first[lit], atol=.002)

    def test_bad_keys_are_said(self):
        with open(self.path('edits.json'), 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [
                {'operation': 'fill', 'value': 0, 'mask': [{'shape': 'key', 'color': [0, 700, 0]}]}]}, file)
        self.deny('relight', SET, '--edits', self.path('edits.json'), '-o', self.path('o.png'),
                  naming=['edits.json', 'color', 'from 0 to 1'])


if __name__ == '__main__':
    main()

"""Photographs through crossed polarisers: a solve takes from them what of each light is highlight, on white things too."""
import copy
import json
import os
import unittest

import numpy as np

import cli

HEIGHT, WIDTH = 144, 240
NOISE = {'read': .001, 'full_well': 50000}
PASS = np.array([.45, .43, .40])
GLOSS = os.path.join(cli.SHARED, 'captures', 'gloss')


def scene():
    """Matte light of a striped wall, its left half orange, its right half grey, under two lights; and the highlights
    of four knobs, two in each half. Both: lights x height x width x 3."""
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    paint = np.where((x < WIDTH / 2)[..., None], [.5, .2, .1], [.4, .4, .4]) * np.where((x + y) % 16 < 8, 1, .6)[..., None]
    matte = np.array([paint * (.1 + .3 * a[..., None]) for a in ((WIDTH - x) / WIDTH, x / WIDTH)])
    shine = np.array([sum(.6 * np.exp(-((x - u) ** 2 + (y - v) ** 2) / 50) for u, v in places)
                      for places in (((50, 40), (160, 50)), ((80, 100), (200, 90)))])[..., None]
    return matte, np.repeat(shine, 3, -1)


def error(found, truth):
    return np.linalg.norm(found - truth) / np.linalg.norm(truth)


def saturate(capture):
    """Its shots as 16-bit pictures that end at full scale."""
    for shot, pixels in zip(capture.manifest['shots'], capture.shots):
        shot['image'] = shot['image'].replace('.exr', '.tif')
        cli.write_image(os.path.join(capture.folder, shot['image']), np.clip(pixels, 0, 1), 'uint16')
    with open(capture.path, 'w') as file:
        json.dump(capture.manifest, file)


class PolarisersTest(cli.CliTest):
    def shots(self, kinds, matte=None, shine=None, ambient=0, tell=True, name='set', coding=cli.SWAPPED, level=1, seed=1):
        """A capture with a shot a kind: (lighting, whether it is crossed). `tell`: of the ambient light, by a picture.
        `level`: all light is so much."""
        random = np.random.default_rng(seed)
        if matte is None:
            matte, shine = scene()
        capture = cli.Capture(self.path(name))
        if level == 1:
            capture.manifest['noise'] = NOISE
        capture.shots, capture.manifest['shots'] = [], []
        for k, (lighting, crossed) in enumerate(kinds):
            colors = copy.deepcopy(coding[lighting])
            clean = cli.photograph(matte, colors) + ambient
            clean = clean * PASS if crossed else clean + cli.photograph(shine, colors)
            capture.shots.append(level * (clean + random.normal(size=clean.shape) * np.sqrt(clean / NOISE['full_well'] + NOISE['read'] ** 2)))
            shot = {'image': f'shot_{k}.exr', 'light_colors': colors}
            if crossed:
                shot['polarisation'] = 'cross'
            capture.manifest['shots'].append(shot)
        if tell and np.any(ambient):
            capture.manifest['ambient'] = 'ambient.exr'
            cli.write_image(self.path(name, 'ambient.exr'), np.full((*matte.shape[1:3], 3), ambient))
        capture.save()
        return capture

    def solved(self, capture, *options, name='solved.exr'):
        said = self.succeed_json('solve', capture.path, '-o', self.path(name), '-q', *options)
        lights = np.array([cli.read_rgb(self.path(name), light) for light in ('key', 'fill')])
        return lights, said

    def highlights(self, name='solved.exr'):
        return np.array([cli.read_rgb(self.path(name), light + '.spec') for light in ('key', 'fill')])

    def test_each_lamp_has_its_highlights_on_white_things_too(self):
        matte, shine = scene()
        lights, said = self.solved(self.shots([(0, False), (1, False), (0, True), (1, True)]))
        found = self.highlights()
        self.assertLess(error(found, shine), .05)
        self.assertLess(error(found[:, :, WIDTH // 2:], shine[:, :, WIDTH // 2:]), .05, 'on grey')
        self.assertTrue((found >= 0).all() and (found <= lights).all())
        nothing = shine.max(0) < 1e-4
        self.assertLess(np.abs(found[:, nothing]).mean(), 1e-5, 'none where there is none')
        self.assertLess(abs(said['highlights'] - (shine[..., 0].max(0) > .01).mean()), .03)
        self.assertIn('crossed polarisers, which pass 43 %', said['message'])
        truth = matte + shine
        open_only, _ = self.solved(self.shots([(0, False), (1, False)], name='open'), name='open.exr')
        self.assertLess(error(lights, truth), .8 * error(open_only, truth))
        self.assertLess(error(lights, truth), .02)

    def test_a_single_open_photograph_shows_whose_they_are(self):
        matte, shine = scene()
        lights, _ = self.solved(self.shots([(0, True), (1, True), (1, False)]))
        self.assertLess(error(self.highlights(), shine), .07)
        self.assertLess(error(lights, matte + shine), .03)

    def test_ambient_light_loses_as_much(self):
        matte, shine = scene()
        kinds = [(0, False), (1, False), (0, True), (1, True)]
        lights, said = self.solved(self.shots(kinds, ambient=.1))
        self.assertIn('which pass 43 % of matte light', said['message'])
        self.assertLess(error(self.highlights(), shine), .06)
        self.assertLess(error(lights, matte + shine), .03)
        # The filter's tint is in the ambient light, too.
        for channel in range(3):
            found, truth = (np.median((x.sum(0) - shine.sum(0))[..., channel]) for x in (lights, matte + shine))
            self.assertLess(abs(found / truth - 1), .015)

    def test_ambient_light_that_is_solved_for_is_no_highlight(self):
        matte, shine = scene()
        y, x = np.mgrid[:HEIGHT, :WIDTH]
        ambient = (.03 + .02 * np.sin(y / 20) * np.cos(x / 30))[..., None] * matte.sum(0) / matte.sum(0).mean()
        thrice = [*cli.SWAPPED, [[.6, .5, .2], [.3, .4, .9]]]
        kinds = [(k, crossed) for crossed in (False, True) for k in range(3)]
        lights, _ = self.solved(self.shots(kinds, ambient=ambient, tell=False, coding=thrice), '--solve-ambient')
        self.assertLess(error(self.highlights(), shine), .2)
        self.assertLess(error(lights, matte + shine), .1)

    def test_light_of_any_strength(self):
        _, shine = scene()
        for level in (1e-7, 1e6):
            self.solved(self.shots([(0, False), (1, False), (0, True), (1, True)], level=level), '--float')
            self.assertLess(error(self.highlights() / level, shine), .08, level)

    def test_lamps_of_nearly_one_colour(self):
        _, shine = scene()
        alike = [[[1, .8, .6], [.6, .8, 1]], [[.6, .8, 1], [1, .8, .6]]]
        self.solved(self.shots([(0, False), (1, False), (0, True), (1, True)], coding=alike))
        self.assertLess(error(self.highlights(), shine), .15)

    def test_a_matte_set_has_none(self):
        matte, shine = scene()
        _, said = self.solved(self.shots([(0, False), (1, False), (0, True), (1, True)], matte, 0 * shine))
        self.assertIn('No highlights, by crossed polarisers', said['message'])
        self.assertFalse([c for c in cli.read_image(self.path('solved.exr')) if '.spec' in c])

    def test_crossed_photographs_alone_are_a_matte_set(self):
        matte, _ = scene()
        lights, _ = self.solved(self.shots([(0, True), (1, True)]))
        self.assertFalse([c for c in cli.read_image(self.path('solved.exr')) if '.spec' in c])
        self.assertLess(error(lights, matte * PASS), .05)

    def test_they_need_not_be_kept(self):
        capture = self.shots([(0, False), (1, False), (0, True), (1, True)])
        kept, _ = self.solved(capture)
        left, _ = self.solved(capture, '--highlights', 'off', name='without.exr')
        self.assertTrue((kept == left).all())
        self.assertFalse([c for c in cli.read_image(self.path('without.exr')) if '.spec' in c])

    def test_saturated_highlights_stay_with_their_lamp(self):
        matte, shine = scene()
        capture = self.shots([(0, False), (1, False), (0, True), (1, True)], matte, 3 * shine)
        saturate(capture)
        lights, said = self.solved(capture)
        self.assertGreater(said['clipped'], 0)
        found = self.highlights()
        self.assertTrue(np.isfinite(lights).all())
        for own, places in zip((0, 1), (((50, 40), (160, 50)), ((80, 100), (200, 90)))):
            for x, y in places:
                self.assertGreater(found[own, y, x, 0], .7)
                self.assertLess(found[1 - own, y, x, 0], .3 * found[own, y, x, 0])

    def test_saturated_highlights_of_lamps_one_at_a_time(self):
        matte, shine = scene()
        single = [[[1, 1, 1], [0, 0, 0]], [[0, 0, 0], [1, 1, 1]]]
        capture = self.shots([(0, False), (1, False), (0, True), (1, True)], matte, 3 * shine, coding=single)
        saturate(capture)
        lights, _ = self.solved(capture)
        # What is saturated is as bright as the photograph, no brighter.
        self.assertLess(abs(lights[0, 40, 50].max() - 1), .05)
        self.assertLess(error((lights - self.highlights()), matte), .05)

    def test_marks_the_wrong_way_round_are_noticed(self):
        capture = self.shots([(0, False), (1, False), (0, True), (1, True)])
        for shot in capture.manifest['shots']:
            shot['polarisation'] = 'open' if 'polarisation' in shot else 'cross'
        capture.save()
        _, said = self.solved(capture)
        self.assertIn('they seem to be the ones with the highlights', ' '.join(said['warnings']))

    def test_what_cannot_be_solved_is_said(self):
        output = self.path('solved.exr')

        def refuse(capture, *naming):
            capture.save()
            self.deny('solve', capture.path, '-o', output, '-q', naming=naming)
        wrong = self.shots([(0, False), (1, False)])
        wrong.manifest['shots'][1]['polarisation'] = 'crossed'
        refuse(wrong, 'shot 2', '"polarisation" is "crossed", expected "cross" (crossed polarisers) or "open"')
        unknown = self.shots([(0, False), (1, False), (0, True), (1, True)])
        unknown.manifest['shots'][0]['light_colors'][1] = None
        refuse(unknown, "a light's colour is unknown", 'crossed')
        few = self.shots([(0, False), (1, False)])
        few.manifest['shots'].append({'image': 'again.exr', 'polarisation': 'cross', 'light_colors': [[1, 1, 1], [1, 1, 1]]})
        few.shots.append(few.shots[0])
        refuse(few, 'its crossed photographs must tell the lights apart by themselves')
        alike = self.shots([(0, True), (1, True)])
        alike.manifest['shots'].append({'image': 'shot_2.exr', 'light_colors': [[1, 1, 1], [1, 1, 1]]})
        alike.shots.append(cli.photograph(scene()[0], [[1, 1, 1], [1, 1, 1]]))
        refuse(alike, 'cannot be told', 'crossed')

    def test_new_marks_them_and_a_new_description_keeps_the_marks(self):
        capture = self.shots([(0, False), (1, False), (0, True), (1, True)])
        told = ['--gels', 'L106,L119', '--rotation', 'forward', '--lights', 'key,fill', '--force', capture.folder]
        os.remove(capture.path)
        crossed = ['shot_2.exr', 'shot_3.exr']
        said = self.succeed_json('new', '--crossed', ','.join(crossed), *told)
        self.assertEqual([s['image'] for s in said['shots'] if s.get('polarisation') == 'cross'], crossed)
        self.succeed('new', *told)
        with open(capture.path) as file:
            self.assertEqual([s['image'] for s in json.load(file)['shots'] if s.get('polarisation') == 'cross'], crossed)
        self.deny('new', '--crossed', 'shot_9.exr', *told, naming='--crossed shot_9.exr: there is no such shot')
        self.assertNotIn('polarisation', json.dumps(self.succeed_json('new', '--crossed', 'none', *told)))
        with open(capture.path) as file:
            self.assertNotIn('polarisation', file.read())

    def test_new_gives_both_filters_the_same_colours(self):
        for kinds in ([(0, False), (0, True), (1, False), (1, True)], [(0, False), (1, False), (0, True), (1, True)]):
            for how in ('guess', 'forward'):
                capture = self.shots(kinds)
                os.remove(capture.path)
                crossed = ','.join(f'shot_{k}.exr' for k, kind in enumerate(kinds) if kind[1])
                said = self.succeed_json('new', capture.folder, '--lights', 'key,fill', '--crossed', crossed, '--rotation', how,
                                         '--colors', '.9/.2/.15,.15/.8/.25', '--force')
                with open(capture.path) as file:
                    colors = [shot['light_colors'] for shot in json.load(file)['shots']]
                np.testing.assert_allclose(colors, [cli.SWAPPED[lighting] for lighting, _ in kinds], atol=1e-6)
                self.assertNotIn('do not hold light', ' '.join(said['warnings']))
        capture = self.shots([(0, False), (0, True), (1, False), (1, True)])
        self.succeed('new', capture.folder, '--lights', 'key,fill', '--crossed', 'shot_1.exr,shot_3.exr', '--one-at-a-time',
                     '--force')
        with open(capture.path) as file:
            on = [[sum(color) > 0 for color in shot['light_colors']] for shot in json.load(file)['shots']]
        self.assertEqual(on, [[True, False], [True, False], [False, True], [False, True]])

    def test_the_mark_travels_with_the_set(self):
        self.solved(self.shots([(0, False), (1, False), (0, True), (1, True)]))
        described = json.dumps(self.succeed_json('info', self.path('solved.exr')))
        self.assertEqual(described.count('"polarisation": "cross"'), 2)

    @unittest.skipUnless(os.path.isdir(GLOSS), 'needs ../shared/captures/gloss')
    def test_a_rendered_glossy_scene(self):
        matte, glossy = (np.array([cli.read_rgb(os.path.join(GLOSS, variant, f'T_{name}.exr')) for name in ('left', 'right')])
                         for variant in ('lambert', 'spec3'))
        shine = np.maximum(glossy - matte, 0)
        self.solved(self.shots([(0, False), (1, False), (0, True), (1, True)], matte, shine))
        self.assertLess(error(self.highlights(), shine), .03)


if __name__ == '__main__':
    cli.main()

#!/usr/bin/python3
"""How well lamps are moved, turned and spread after the fact: a table over every rendered set whose lamps were really moved.

usage: light_move_table.py SWAPLIGHT SHARED [--sets random/random_1,...] [--keep FOLDER] [--quick]

A row a truth T_<light>@<edit>.exr: the mean CIEDE2000 between the picture lit by that lamp alone, after the edit, and the
truth (box-averaged by two; the truth's 99.5th percentile at .9).

nothing   the light as it was
warped    its contribution displaced by the best of many shifts, and its best level
rule      our edit, its numbers from the real lamp's by the rule below: nobody has looked
dragged   our edit, its numbers moved until it looks right (pattern search on the error), as a person with sliders would
fader     the same, dragging the light's own fader along
said      with the rule's numbers: what the program warns of

The rule: lengths are divided by the picture's width at the depth that the lamp's axis meets. A move's part along the axis is
`distance`, the rest is `right` and `up` as the camera sees them. A turn's angle is that between the axes; it goes where the
lamp's point of aim goes in the picture. Lamps that were enlarged are left out: light_size_table.py measures them.
"""
import argparse
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

CHOSEN_ON = ('random_1', 'random_2', 'random_6')  # the first constants were; the cone's edge was looked at on all of them


def read(path):
    pixels = oiio.ImageBuf(path).get_pixels(oiio.FLOAT)[..., :3].astype(np.float64)
    height, width = pixels.shape[0] // 2 * 2, pixels.shape[1] // 2 * 2
    return pixels[:height, :width].reshape(height // 2, 2, width // 2, 2, 3).mean((1, 3))


def score(picture, truth):
    from score import de2000, lab  # of SHARED/tools
    scale = .9 / np.percentile(truth, 99.5)
    return de2000(lab(picture * scale), lab(truth * scale)).mean()


def best_level(picture, truth):
    return min(score(picture * level, truth) for level in np.exp2(np.linspace(-.6, .6, 13)))


def numbers_of(scene, edit):
    """What the edit of the real lamp is in the terms of ours: the operation and its numbers."""
    before, after = edit['before'][0], edit['after'][0]
    kind, values = edit['edit'].split('=')
    values = np.array([float(v) for v in values.split(',')])
    camera = scene['camera']
    forward = np.array(camera['forward'])
    right = np.cross(forward, [0, 0, 1])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    place = np.array(before['position'])
    hit = np.array(before.get('axis_hit', before['target']))
    axis, reach = (hit - place) / np.linalg.norm(hit - place), np.linalg.norm(hit - place)
    width = (hit - np.array(camera['position'])) @ forward * camera['sensor_width_mm'] / camera['lens_mm']
    if kind == 'move':
        along = values @ axis
        rest = values - along * axis
        return 'move', dict(right=rest @ right / width, up=rest @ up / width, distance=(reach - along) / reach)
    if kind == 'turn':
        angle = np.degrees(np.arccos(np.clip(np.dot(before['direction'], after['direction']), -1, 1)))
        way = np.subtract(after['target_pixel'], before['target_pixel']) * [1, -1]
        way = angle * way / max(np.hypot(*way), 1e-9)
        return 'turn', dict(pan=way[0], tilt=way[1])
    return 'spread', dict(width=values[0])


STEPS = dict(right=.08, up=.08, distance=.15, pan=8, tilt=8, width=.3)
LEAST = dict(distance=.3, width=.25)


class Light:
    """One light of a solved set, seen through an edit."""

    def __init__(self, program, solved, lights, light, folder):
        self.program, self.solved, self.light, self.folder = program, solved, light, folder
        self.others = [a for other in lights if other != light for a in ('--light', f'{other}=off')]

    def picture(self, operation=None, numbers=None):
        frame = os.path.join(self.folder, 'frame.exr')
        command = [self.program, 'relight', self.solved, *self.others, '-q', '-o', frame]
        if operation:
            name = os.path.join(self.folder, 'edits.json')
            with open(name, 'w') as file:
                json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [
                    {'lights': [self.light], 'meaning': 'add', 'operation': operation, **numbers}]}, file)
            command += ['--edits', name]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return read_fresh(frame)

    def limits(self):
        """What the program says that the last edit cannot know: the guessed part of the picture, how far the light goes."""
        said = subprocess.run([self.program, 'relight', self.solved, '--edits', os.path.join(self.folder, 'edits.json'), '-o',
                               os.path.join(self.folder, 'said.exr')], check=True, capture_output=True, text=True)
        found = re.findall(r'(a guess on|moves by) (\d+ %)', said.stdout + said.stderr)
        return ', '.join(('guess ' if kind == 'a guess on' else 'moves ') + part for kind, part in found)


def read_fresh(frame):
    oiio.ImageCache().invalidate(frame)
    return read(frame)


def dragged(light, truth, operation, numbers, rounds, score=score):
    """Pattern search from the numbers, and from none: what looks best by the score, and how good it is."""
    neutral = {key: 1. if key in ('distance', 'width') else 0. for key in numbers}
    starts = [(score(light.picture(operation, n), truth), n) for n in (numbers, neutral)]
    best, at = min(starts, key=lambda found: found[0])
    step = 1.
    for _ in range(rounds):
        better = False
        for key in at:
            for sign in (1, -1):
                tried = dict(at, **{key: max(at[key] + sign * step * STEPS[key], LEAST.get(key, -90))})
                error = score(light.picture(operation, tried), truth)
                if error < best:
                    best, at, better = error, tried, True
                    break
        if not better:
            step /= 2
    return best, at


def warped(before, truth):
    """The contribution itself displaced, as well as can be."""
    reach = [-30, -16, -8, -4, 0, 4, 8, 16, 30]
    tried = [np.roll(before, (y, x), (0, 1)) for x in reach for y in reach if abs(y) <= 16]
    errors = [score(picture, truth) for picture in tried]
    return best_level(tried[int(np.argmin(errors))], truth)


def rows(a, name, folder):
    source = os.path.join(a.shared, 'captures', name)
    with open(os.path.join(source, 'scene.json')) as file:
        scene = json.load(file)
    solved = os.path.join(folder, 'solved.exr')
    if not os.path.exists(solved):
        subprocess.run([os.path.join(a.shared, 'tools/compose.py'), source, folder, '--bits', 'float'], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([a.swaplight, 'solve', os.path.join(folder, 'capture.json'), '-q', '-o', solved], check=True,
                       stdout=subprocess.DEVNULL)
    for edit in scene['edits']:
        if edit['edit'].startswith('size'):
            continue
        light = Light(a.swaplight, solved, [entry['name'] for entry in scene['lights']], edit['light'], folder)
        truth = read(os.path.join(source, edit['image']))
        operation, numbers = numbers_of(scene, edit)
        before = light.picture()
        by_rule = light.picture(operation, numbers)
        limits = light.limits()
        best, at = dragged(light, truth, operation, numbers, 1 if a.quick else 5)
        yield dict(set=name, light=edit['light'], edit=edit['edit'], nothing=score(before, truth),
                   level=best_level(before, truth), warped=warped(before, truth), rule=score(by_rule, truth), limits=limits,
                   dragged=best, fader=min(best, dragged(light, truth, operation, at, 1 if a.quick else 4, best_level)[0]),
                   at=', '.join(f'{key} {value:.2f}' for key, value in at.items()))


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('swaplight')
    arguments.add_argument('shared')
    arguments.add_argument('--sets')
    arguments.add_argument('--keep')
    arguments.add_argument('--quick', action='store_true', help='hardly dragged')
    a = arguments.parse_args()
    sys.path.insert(0, os.path.join(a.shared, 'tools'))
    captures = os.path.join(a.shared, 'captures')
    found = sorted({os.path.relpath(os.path.dirname(f), captures) for f in glob.glob(captures + '/**/T_*@*.exr', recursive=True)})
    if not found:
        sys.exit(f'{captures}: no set with lamps that were really moved (T_<light>@<edit>.exr)')
    work = a.keep or tempfile.mkdtemp()
    print('| set | light | edit | nothing | its level | warped | rule | dragged | and fader | dragged / nothing | dragged to | said |')
    print('|---|---|---|---|---|---|---|---|---|---|---|---|')
    told = []
    for name in a.sets.split(',') if a.sets else found:
        folder = os.path.join(work, name.replace('/', '_'))
        os.makedirs(folder, exist_ok=True)
        for row in rows(a, name, folder):
            told.append(row)
            print('| {set} | {light} | {edit} | {nothing:.2f} | {level:.2f} | {warped:.2f} | {rule:.2f} | {dragged:.2f} '
                  '| {fader:.2f} | {ratio:.2f} | {at} | {limits} |'.format(**row, ratio=row['dragged'] / row['nothing']), flush=True)
    print()
    for title, chosen in (('Constants chosen on', True), ('Kept back', False)):
        for kind in ('move', 'turn', 'spread'):
            of = [r for r in told if r['edit'].startswith(kind) and r['set'].endswith(CHOSEN_ON) == chosen]
            if of:
                means = {key: np.mean([r[key] / r['nothing'] for r in of]) for key in ('warped', 'rule', 'dragged', 'fader')}
                print(f'{title}, {kind}, {len(of)}: over nothing done ' +
                      ', '.join(f'{key} {value:.2f}' for key, value in means.items()))


if __name__ == '__main__':
    main()

#!/usr/bin/python3
"""How well a lamp gets another size after the fact: a table over every rendered set whose lamps were really made larger.

usage: light_size_table.py SWAPLIGHT SHARED [--sets random/random_1,...] [--keep FOLDER]

A row a truth T_<light>@size_<times>.exr, and one the other way round: the set photographed with the large lamp, made small
again. The mean CIEDE2000 of the picture lit by that lamp alone, as light_move_table.py measures it.

nothing   the light as it was
level     the same with its fader where it is best
told      our edit, with the lamp's real diameter
not told  our edit, the diameter left open
"""
import argparse
import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from light_move_table import Light, best_level, read, score

CHOSEN_ON = ('random_1', 'random_7')


def diameter_of(edit):
    """Of the lamp before, over its distance from where its axis meets the set."""
    lamp = edit['before'][0]
    reach = np.linalg.norm(np.subtract(lamp.get('axis_hit', lamp['target']), lamp['position']))
    return (2 * lamp['radius'] if 'radius' in lamp else max(lamp['size'])) / reach


def solve(a, source, folder, swapped=None):
    """The set solved; `swapped`: a light and the picture that it has instead."""
    solved = os.path.join(folder, 'solved.exr')
    if os.path.exists(solved):
        return solved
    os.makedirs(folder, exist_ok=True)
    shots = os.path.join(folder, 'scene')
    shutil.copytree(source, shots, dirs_exist_ok=True)
    if swapped:
        shutil.copy(os.path.join(source, swapped[1]), os.path.join(shots, f'T_{swapped[0]}.exr'))
    subprocess.run([os.path.join(a.shared, 'tools/compose.py'), shots, folder, '--bits', 'float'], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([a.swaplight, 'solve', os.path.join(folder, 'capture.json'), '-q', '-o', solved], check=True,
                   stdout=subprocess.DEVNULL)
    shutil.rmtree(shots)
    return solved


def rows(a, name, work):
    source = os.path.join(a.shared, 'captures', name)
    with open(os.path.join(source, 'scene.json')) as file:
        scene = json.load(file)
    lights = [entry['name'] for entry in scene['lights']]
    for edit in scene['edits']:
        if not edit['edit'].startswith('size'):
            continue
        times, diameter = float(edit['edit'].split('=')[1]), diameter_of(edit)
        own = f'T_{edit["light"]}.exr'
        for larger in (True, False):
            folder = os.path.join(work, name.replace('/', '_') + ('' if larger else '_back'))
            solved = solve(a, source, folder, None if larger else (edit['light'], edit['image']))
            light = Light(a.swaplight, solved, lights, edit['light'], folder)
            truth = read(os.path.join(source, edit['image'] if larger else own))
            factor, was = (times, diameter) if larger else (1 / times, times * diameter)
            before = light.picture()
            told = light.picture('size', dict(times=factor, diameter=was))
            yield dict(set=os.path.basename(name), light=edit['light'], lamp=edit['before'][0]['type'], was=was, times=factor,
                       nothing=score(before, truth), level=best_level(before, truth), told=score(told, truth),
                       fader=best_level(told, truth), open=score(light.picture('size', dict(times=factor)), truth))


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('swaplight')
    arguments.add_argument('shared')
    arguments.add_argument('--sets')
    arguments.add_argument('--keep')
    a = arguments.parse_args()
    sys.path.insert(0, os.path.join(a.shared, 'tools'))
    captures = os.path.join(a.shared, 'captures')
    found = sorted({os.path.relpath(os.path.dirname(f), captures)
                    for f in glob.glob(captures + '/**/T_*@size*.exr', recursive=True)})
    if not found:
        sys.exit(f'{captures}: no set with a lamp that was really made larger (T_<light>@size_<times>.exr)')
    work = a.keep or tempfile.mkdtemp()
    print('| set | lamp | was | times | nothing | level | told | and fader | not told | told / nothing |')
    print('|---|---|---|---|---|---|---|---|---|---|')
    for name in a.sets.split(',') if a.sets else found:
        for row in rows(a, name, work):
            chosen = ' (chosen on)' if row['set'] in CHOSEN_ON else ''
            print('| `{set}`{chosen} | {light}, {lamp} | {was:.3f} | {times:.2f} | {nothing:.2f} | {level:.2f} | {told:.2f} '
                  '| {fader:.2f} | {open:.2f} | {ratio:.2f} |'.format(**row, chosen=chosen, ratio=row['told'] / row['nothing']),
                  flush=True)


if __name__ == '__main__':
    main()

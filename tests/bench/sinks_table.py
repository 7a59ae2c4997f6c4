#!/usr/bin/python3
"""Where pools are found, and how many lamps: a table over the rendered sets, whose scene.json tells the lamps.

usage: sinks_table.py SWAPLIGHT SHARED [--sets random/random_1,...]     (default: random_1 to random_10)

A row a light. Distances are widths of the picture, from the first pool to where the lamp's point of aim, or the lamp itself,
lies in the picture (- : a sun has none; "out": it lies outside). An arrow's error is the angle to the direction in which the lamp
lies from there. Lamps: found, and there.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

from lightmap_table import CHOSEN_ON, SETS, read_rgb, write


def sinks_of(program, names, pictures):
    with tempfile.TemporaryDirectory() as folder:
        shots = []
        for k, picture in enumerate(pictures):
            write(f'{folder}/{k}.exr', picture)
            shots.append({'image': f'{k}.exr', 'light_colors': [[float(i == k)] * 3 for i in range(len(names))]})
        with open(folder + '/capture.json', 'w') as file:
            json.dump({'format': 'swaplight-capture', 'version': 1, 'name': 'rendered', 'color_space': 'lin_rec709',
                       'lights': [{'name': name} for name in names], 'shots': shots}, file)
        done = subprocess.run([program, 'sinks', folder, '--model', 'transport', '--json', '-q'], check=True,
                              capture_output=True, text=True)
        return json.loads(done.stdout)


def projected(scene, point, size):
    """Where a point of the world is seen, in pixels; nothing of what is behind the camera."""
    camera = scene['camera']
    forward = np.array(camera['forward']) / np.linalg.norm(camera['forward'])
    right = np.cross(forward, [0, 0, 1])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    away = np.array(point) - np.array(camera['position'])
    depth = away @ forward
    if depth <= 0:
        return None
    scale = camera['lens_mm'] / camera['sensor_width_mm'] * size[0] / depth
    return np.array([size[0] / 2 + scale * (away @ right), size[1] / 2 - scale * (away @ up)])


def distance(sink, place, size):
    if place is None:
        return '-'
    inside = 0 <= place[0] <= size[0] and 0 <= place[1] <= size[1]
    return f'{np.hypot(*(place - [sink["x"], sink["y"]])) / size[0]:.2f}' + ('' if inside else ' out')


def arrow(sink, lamp):
    """The angle between the arrow and the way to the lamp, degrees."""
    if 'outside' not in sink or lamp is None:
        return '-'
    way = lamp - [sink['x'], sink['y']]
    cosine = (way @ [sink['outside']['x'], sink['outside']['y']]) / max(np.hypot(*way), 1e-9)
    return f'{np.degrees(np.arccos(np.clip(cosine, -1, 1))):.0f}'


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('program')
    parser.add_argument('shared')
    parser.add_argument('--sets', default=','.join(SETS))
    arguments = parser.parse_args()
    captures = os.path.join(arguments.shared, 'captures')
    print('| set | light | lamp | lamps | to its aim | to itself | arrow |')
    print('|---|---|---|---|---|---|---|')
    right = []
    for name in arguments.sets.split(','):
        folder = os.path.join(captures, name)
        with open(folder + '/scene.json') as file:
            scene = json.load(file)
        lights = [light['name'] for light in scene['lights']]
        said = sinks_of(arguments.program, lights, [np.maximum(read_rgb(f'{folder}/T_{n}.exr'), 0) for n in lights])
        size = (said['width'], said['height'])
        counts = []
        for light in scene['lights']:
            found, lamp = said['lights'][light['name']], light['lamps'][0]
            sun = lamp['type'] == 'sun'
            aim, lies = (None if sun else projected(scene, lamp[key], size) for key in ('target', 'position'))
            sink = found['sinks'][0] if found['sinks'] else None
            places = [distance(sink, aim, size), distance(sink, lies, size), arrow(sink, lies)] if sink else ['even', '', '']
            counts.append(found['lamps'] == len(light['lamps']))
            print(f'| `{os.path.basename(name)}` | {light["name"]} | {lamp["type"]} | {found["lamps"]} of '
                  f'{len(light["lamps"])} | ' + ' | '.join(places) + ' |', flush=True)
        right.append((os.path.basename(name), all(counts)))
    others = [good for name, good in right if name not in CHOSEN_ON]
    print(f'\nsets whose every light has its number of lamps: {sum(good for _, good in right)} of {len(right)}; of those that '
          f'no constant was chosen on {sum(others)} of {len(others)}')


if __name__ == '__main__':
    sys.exit(main())

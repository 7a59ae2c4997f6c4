#!/usr/bin/python3
"""How well light is told from texture: a table over the rendered sets.

usage: lightmap_table.py SWAPLIGHT SHARED [--sets random/random_1,...]     (default: random_1 to random_10)

A row a set. The lights' contributions are taken as rendered; the truth is what a light gives over what an even dome gives
(ambient.exr), where both are above 2 % of their bright parts. An error is the standard deviation of the logarithm (beyond a
constant), the mean over the set's lights; a correlation that of logarithms.

picture   the light's contribution itself
share     its share of all light (beta)
map       swaplight lightmap --smooth 0
smooth    swaplight lightmap, as it is by default
repaint   how far the map moves when the set is repainted with tiles of random colours: the same, map against map
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

SETS = [f'random/random_{k}' for k in range(1, 11)]
CHOSEN_ON = ('random_1', 'random_3', 'random_7', 'random_8', 'random_10')  # the constants of core/illumination were


def read(path):
    buffer = oiio.ImageBuf(path)
    pixels = buffer.get_pixels(oiio.FLOAT)
    return {name: pixels[..., c] for c, name in enumerate(buffer.spec().channelnames)}


def read_rgb(path):
    found = read(path)
    return np.stack([found[c] for c in 'RGB'], -1)


def write(path, pixels):
    height, width = pixels.shape[:2]
    output = oiio.ImageOutput.create(path)
    spec = oiio.ImageSpec(width, height, 3, 'float')
    output.open(path, spec)
    output.write_image(np.ascontiguousarray(pixels, np.float32))
    output.close()


def maps_of(program, names, pictures, smooth):
    """swaplight lightmap of a set with these contributions."""
    with tempfile.TemporaryDirectory() as folder:
        shots = []
        for k, picture in enumerate(pictures):
            write(f'{folder}/{k}.exr', picture)
            colors = [[float(i == k)] * 3 for i in range(len(names))]
            shots.append({'image': f'{k}.exr', 'light_colors': colors})
        with open(folder + '/capture.json', 'w') as file:
            json.dump({'format': 'swaplight-capture', 'version': 1, 'name': 'rendered', 'color_space': 'lin_rec709',
                       'lights': [{'name': name} for name in names], 'shots': shots}, file)
        solved = folder + '/solved.exr'
        subprocess.run([program, 'solve', folder, '-o', solved, '--float', '--model', 'transport', '-q'], check=True,
                       stdout=subprocess.DEVNULL)
        maps = []
        for amount in smooth:
            subprocess.run([program, 'lightmap', solved, '-o', folder + '/map.exr', '--type', 'float', '-q', '--smooth',
                            str(amount)], check=True)
            oiio.ImageCache().invalidate(folder + '/map.exr')  # kept, where it changed within the second
            found = read(folder + '/map.exr')
            maps.append([found[name + '.G'] for name in names])
        return maps


def error(picture, truth):
    return np.log(picture / truth).std()


def correlation(picture, truth):
    return np.corrcoef(np.log(picture), np.log(truth))[0, 1]


def tiles(shape):
    colors = np.random.default_rng(1).uniform(.2, .9, (shape[0] // 8 + 1, shape[1] // 8 + 1, 3))
    return colors.repeat(8, 0).repeat(8, 1)[:shape[0], :shape[1]]


def row_of(program, folder):
    with open(folder + '/scene.json') as file:
        names = [light['name'] for light in json.load(file)['lights']]
    pictures = [np.maximum(read_rgb(f'{folder}/T_{name}.exr'), 0) for name in names]
    dome = read_rgb(folder + '/ambient.exr').mean(2)
    sharp, smooth = maps_of(program, names, pictures, (0, .03))
    painted = [picture * tiles(dome.shape) for picture in pictures]
    [again] = maps_of(program, names, painted, (0,))
    total = sum(pictures).mean(2)
    rows = []
    for k in range(len(names)):
        own = pictures[k].mean(2)
        lit = (own > .02 * np.percentile(own, 98)) & (dome > .02 * np.percentile(dome, 98))
        truth = own[lit] / dome[lit]
        columns = [own[lit], own[lit] / total[lit], sharp[k][lit], smooth[k][lit]]
        columns = [column + 1e-6 * own.max() for column in columns]
        rows.append([error(c, truth) for c in columns] + [correlation(c, truth) for c in columns] +
                    [error(again[k][lit] + 1e-9, sharp[k][lit] + 1e-9)])
    return len(names), np.mean(rows, 0)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('program')
    parser.add_argument('shared')
    parser.add_argument('--sets', default=','.join(SETS))
    arguments = parser.parse_args()
    captures = os.path.join(arguments.shared, 'captures')
    print('| set | lights | picture | share | map | smooth | picture r | share r | map r | smooth r | repaint |')
    print('|---|---|---|---|---|---|---|---|---|---|---|')
    for name in arguments.sets.split(','):
        lights, values = row_of(arguments.program, os.path.join(captures, name))
        mark = ' (chosen on)' if os.path.basename(name) in CHOSEN_ON else ''
        print(f'| `{os.path.basename(name)}`{mark} | {lights} | ' + ' | '.join(f'{v:.2f}' for v in values) + ' |',
              flush=True)


if __name__ == '__main__':
    sys.exit(main())

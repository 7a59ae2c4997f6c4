#!/usr/bin/python3
"""What flat fields mend: errors of a solve whose lamps' colours drift by 10 % from the middle of the field to its edges.

usage: flat_field_table.py SWAPLIGHT SHARED [--sets A,B] [--size 200]

The photographs are made of SHARED/captures' pictures of one light each, gels rotated, with noise (full well 20,000, read
.002), clipping, in 12 bits; the noise is not told. Every lamp has a field of its own: red rises by 10 % in one direction,
blue falls by as much, green drifts across. `lamp`: the same field under every gel; `lamp and gel`: the field turns round
with the gel. The cards are photographs of grey .6 under the lamp alone, which is one stop brighter at one side, by the same
camera, without a gel (`lamp`) or with each. A row: relative RMSE of the contributions under even lamps / mean CIEDE2000 of SHARED/tools/score.py, without drift,
with it, and with flat fields.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

from bracket_table import COLORS, SETS, Camera, read, write
from solve_table import shown_gain


LUMINANCE = np.array([.2126, .7152, .0722])


def fields(count, height, width, drift=.1):
    """The lamps' colours over their mean."""
    y, x = np.meshgrid(np.linspace(-1, 1, height), np.linspace(-1, 1, width), indexing='ij')
    found = []
    for i in range(count):
        along, across = np.cos(2 * i) * x + np.sin(2 * i) * y, np.cos(2 * i) * y - np.sin(2 * i) * x
        found.append(np.stack([1 + drift * along, 1 + drift * across, 1 - drift * along], -1))
    return found


class Set:
    def __init__(self, program, score, work, names, truth):
        self.program, self.score, self.work, self.names, self.truth = program, score, work, names, truth
        for name, pixels in zip(names, truth):
            write(f'{work}/T_{name}.exr', pixels, 'float')
        self.fields = fields(len(names), *truth.shape[1:3])
        self.level = np.linspace(1, .5, truth.shape[2])[None, :, None]

    def field(self, lamp, shot, gel, by_gel):
        """Of the colour alone: the luminance of the lamp with this gel, or without any, is the same everywhere."""
        field = 2 - self.fields[lamp] if by_gel and shot % 2 else self.fields[lamp]
        light = LUMINANCE * gel if by_gel else LUMINANCE
        return field * light.sum() / (field @ light)[..., None]

    def row(self, drift, by_gel, cards):
        camera, count = Camera(20000, .002, 12, False), len(self.names)
        manifest = {'format': 'swaplight-capture', 'version': 1, 'name': 'flat', 'color_space': 'lin_rec709', 'shots': [],
                    'lights': [{'name': n} for n in self.names], 'truth': {n: f'T_{n}.exr' for n in self.names}}
        for k in range(count):
            colors = np.array([COLORS[(i + k) % count] for i in range(count)])
            light = sum(colors[i] * self.truth[i] * (self.field(i, k, colors[i], by_gel) if drift else 1) for i in range(count))
            write(f'{self.work}/{k}.png', camera.photograph(light), 'uint16')
            shot = {'image': f'{k}.png', 'light_colors': colors.tolist()}
            if cards:
                shot['flats'] = {}
                for i, name in enumerate(self.names):
                    card = .6 * self.level * self.field(i, k, colors[i], by_gel) * (colors[i] if by_gel else 1)
                    write(f'{self.work}/flat_{name}_{k}.png', camera.photograph(card), 'uint16')
                    shot['flats'][name] = f'flat_{name}_{k}.png'
            manifest['shots'].append(shot)
        if cards and not by_gel:  # one card a lamp will do
            manifest['flats'] = manifest['shots'][0]['flats']
            for shot in manifest['shots']:
                del shot['flats']
        path = f'{self.work}/capture.json'
        with open(path, 'w') as file:
            json.dump(manifest, file)
        out = f'{self.work}/solved.exr'
        result = subprocess.run([self.program, 'solve', path, '-o', out, '--float', '--json'], capture_output=True, text=True)
        if result.returncode:
            sys.exit(result.stderr)
        found = self.score.score(path, out)
        return f'{found["rel_rmse"]:.4f} / {found["de_mean"]:.2f}'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('swaplight')
    parser.add_argument('shared')
    parser.add_argument('--size', type=int, default=200)
    parser.add_argument('--sets')
    a = parser.parse_args()
    sys.path.insert(0, os.path.join(a.shared, 'tools'))
    import score
    print('| set | field of the | even lamps | drift | flat fields |\n|---|---|---|---|---|')
    for name, lights in SETS:
        folder = os.path.join(a.shared, 'captures', name)
        if a.sets and name not in a.sets.split(','):
            continue
        names = lights.split(',') if lights else sorted(f[2:-4] for f in os.listdir(folder) if f.startswith('T_') and '@' not in f)[:3]
        truth = np.stack([read(f'{folder}/T_{n}.exr') for n in names]) * shown_gain(folder, names)
        step = -(-truth.shape[2] // a.size)
        h, w = truth.shape[1] // step * step, truth.shape[2] // step * step
        truth = truth[:, :h, :w].reshape(len(names), h // step, step, w // step, step, 3).mean((2, 4))
        with tempfile.TemporaryDirectory() as work:
            photographed = Set(a.swaplight, score, work, names, truth)
            clean = photographed.row(False, False, False)
            for words, by_gel in (('lamp', False), ('lamp and gel', True)):
                print(f'| {name.split("/")[0]} | {words} | {clean} | {photographed.row(True, by_gel, False)} | '
                      f'{photographed.row(True, by_gel, True)} |', flush=True)


if __name__ == '__main__':
    main()

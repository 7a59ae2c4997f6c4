#!/usr/bin/python3
"""What brackets gain: errors of a solve with one exposure, with the bracket handed over as shots, and merged first.

usage: bracket_table.py SWAPLIGHT SHARED [--sets A,B] [--series '0, -3, +2;0, +2'] [--size 200]

The photographs are made of SHARED/captures' pictures of one light each, gels rotated, with noise, clipping and 12 bits of
linear light or 8 bits of sRGB; the noise is not told. `merged first`: every lighting's exposures averaged into one picture,
weighted by the inverse of their variance, clipped values left out; it is handed over as float. A row: relative RMSE of the
contributions, and the mean CIEDE2000 of SHARED/tools/score.py.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

from solve_table import shown_gain

SETS = [('spheres', 'left,right'), ('portrait3', None), ('random/random_3', None)]
COLORS = [[.9, .2, .15], [.15, .8, .25], [.2, .25, .9], [.85, .75, .1]]
NOISE = {'12 bits, 20,000/.002': (20000, .002, 12, False), '8 bits, 3,000/.005': (3000, .005, 8, True)}
SERIES = {'0, -3': [0, -3], '0, +2': [0, 2], '0, -3, +2': [0, -3, 2], '0, -3, +3': [0, -3, 3]}


def read(path):
    return np.asarray(oiio.ImageBuf(path).get_pixels(oiio.FLOAT))[..., :3].astype(np.float64)


def write(path, pixels, kind):
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, kind)
    output = oiio.ImageOutput.create(path)
    if not output or not output.open(path, spec) or not output.write_image(np.ascontiguousarray(pixels, np.float32)):
        sys.exit(f'{path}: {oiio.geterror()}')
    output.close()


def encode(x):
    return np.where(x <= .0031308, 12.92 * x, 1.055 * np.maximum(x, 1e-9) ** (1 / 2.4) - .055)


def decode(v):
    return np.where(v <= .04045, v / 12.92, ((v + .055) / 1.055) ** 2.4)


class Camera:
    """Photographs: linear light with noise, clipped at 1, in steps of its bits."""

    def __init__(self, full_well, read_noise, bits, srgb):
        self.full_well, self.read_noise, self.steps, self.srgb = full_well, read_noise, 2 ** bits - 1, srgb
        self.random = np.random.default_rng(3)

    def photograph(self, light):
        y = light + self.random.standard_normal(light.shape) * np.sqrt(light / self.full_well + self.read_noise ** 2)
        y = np.clip(y, 0, 1)
        return np.round(encode(y) * self.steps) / self.steps if self.srgb else np.round(y * self.steps) / self.steps

    def linear(self, code):
        return decode(code) if self.srgb else code

    def merged(self, codes, exposures):
        total, weights = 0, 0
        for code, stops in zip(codes, exposures):
            y = self.linear(code)
            weight = 4.0 ** stops / (y / self.full_well + self.read_noise ** 2 + 1 / self.steps ** 2 / 12)
            weight = np.where(code < 1 - 1e-6, weight, 1e-9 * 2.0 ** -stops)
            total, weights = total + weight * y * 2.0 ** -stops, weights + weight
        return total / weights


def capture(folder, names, truth, camera, exposures, merge, ring):
    os.makedirs(folder, exist_ok=True)
    shots, count = [], len(names)
    for k in range(count):
        colors = [ring[(i + k) % count] for i in range(count)]
        light = np.einsum('ic,ihwc->hwc', np.array(colors), truth)
        codes = [camera.photograph(light * 2.0 ** stops) for stops in exposures]
        if merge:
            write(f'{folder}/{k}.exr', camera.merged(codes, exposures), 'float')
            shots.append({'image': f'{k}.exr', 'light_colors': colors})
            continue
        for j, (code, stops) in enumerate(zip(codes, exposures)):
            write(f'{folder}/{k}_{j}.png', code, 'uint8' if camera.steps == 255 else 'uint16')
            shots.append({'image': f'{k}_{j}.png', 'light_colors': colors, 'exposure_stops': stops})
    for name, pixels in zip(names, truth):
        write(f'{folder}/T_{name}.exr', pixels, 'float')
    manifest = {'format': 'swaplight-capture', 'version': 1, 'name': 'bracket', 'shots': shots,
                'color_space': 'srgb' if camera.srgb and not merge else 'lin_rec709',
                'lights': [{'name': n} for n in names], 'truth': {n: f'T_{n}.exr' for n in names}}
    with open(f'{folder}/capture.json', 'w') as file:
        json.dump(manifest, file)
    return f'{folder}/capture.json'


def figures(score, program, path, out):
    result = subprocess.run([program, 'solve', path, '-o', out, '--float', '--json'], capture_output=True, text=True)
    if result.returncode:
        sys.exit(f'{path}: {result.stderr}')
    found = score.score(path, out)
    return f'{found["rel_rmse"]:.4f} / {found["de_mean"]:.2f}'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('swaplight')
    parser.add_argument('shared')
    parser.add_argument('--size', type=int, default=200)
    parser.add_argument('--sets')
    parser.add_argument('--series')
    parser.add_argument('--keep')
    a = parser.parse_args()
    sys.path.insert(0, os.path.join(a.shared, 'tools'))
    import score
    work = a.keep or tempfile.mkdtemp()
    print('| set, camera | one exposure | bracket | as shots | merged first |\n|---|---|---|---|---|')
    for set_name, lights in SETS:
        folder = os.path.join(a.shared, 'captures', set_name)
        if a.sets and set_name not in a.sets.split(','):
            continue
        names = lights.split(',') if lights else sorted(f[2:-4] for f in os.listdir(folder)
                                                        if f.startswith('T_') and '@' not in f)[:3]
        gain = shown_gain(folder, names)
        truth = np.stack([read(f'{folder}/T_{n}.exr') for n in names]) * gain
        step = -(-truth.shape[2] // a.size)
        h, w = truth.shape[1] // step * step, truth.shape[2] // step * step
        truth = truth[:, :h, :w].reshape(len(names), h // step, step, w // step, step, 3).mean((2, 4))
        for noise, camera in NOISE.items():
            def row(series, merge):
                path = capture(os.path.join(work, 'bracket'), names, truth, Camera(*camera), series, merge, COLORS)
                return figures(score, a.swaplight, path, os.path.join(work, 'bracket.exr'))
            one = row([0], False)
            for name, series in SERIES.items():
                if a.series and name not in a.series.split(';'):
                    continue
                print(f'| {set_name.split("/")[0]}, {noise} | {one} | {name} | {row(series, False)} | {row(series, True)} |',
                      flush=True)


if __name__ == '__main__':
    main()

#!/usr/bin/python3
"""How well highlights are told with and without crossed polarisers (docs/solve.md, Highlights).

usage: polariser_table.py SWAPLIGHT SHARED

A row for each of gloss/spec1 to spec5: two lamps behind swapped gels, read noise .002, full well 20,000. The light of
gloss/lambert is matte, what is beyond it highlight; crossed photographs have .45/.43/.40 of the former and nothing of
the latter. Relative RMSE of both lights' highlights, and of both contributions together: of the two open photographs,
with the two crossed ones, and of one open and two crossed ones. Below: how much is called highlight where nothing is.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), '../cli'))
import swaplight_cli as cli  # noqa: E402

PASS = np.array([.45, .43, .40])
NOISE = {'read': .002, 'full_well': 20000}
LIGHTS = ('left', 'right')
OPEN, CROSSED = [(0, False), (1, False)], [(0, True), (1, True)]


def lights_of(shared, material):
    return np.stack([cli.read_rgb(f'{shared}/captures/gloss/{material}/T_{light}.exr') for light in LIGHTS]).astype(float)


def error(found, truth):
    return np.sqrt(((found - truth) ** 2).sum() / (truth ** 2).sum())


def solved(program, matte, shine, kinds, folder):
    """Contributions and highlights of a capture with a shot a kind: (lighting, whether it is crossed)."""
    random = np.random.default_rng(3)
    shots = []
    for k, (lighting, crossed) in enumerate(kinds):
        colors = cli.SWAPPED[lighting]
        clean = cli.photograph(matte, colors) * PASS if crossed else cli.photograph(matte + shine, colors)
        sigma = np.sqrt(np.maximum(clean, 0) / NOISE['full_well'] + NOISE['read'] ** 2)
        cli.write_image(f'{folder}/{k}.exr', clean + random.normal(size=clean.shape) * sigma)
        shots.append({'image': f'{k}.exr', 'light_colors': colors, 'polarisation': 'cross' if crossed else 'open'})
    with open(f'{folder}/capture.json', 'w') as file:
        json.dump({'format': 'swaplight-capture', 'version': 1, 'color_space': 'lin_rec709', 'noise': NOISE,
                   'lights': [{'name': light} for light in LIGHTS], 'shots': shots}, file)
    subprocess.run([program, 'solve', folder, '-o', f'{folder}/solved.exr', '-q'], check=True, capture_output=True)
    channels = cli.read_image(f'{folder}/solved.exr')

    def layers(suffix):
        return np.stack([np.stack([channels.get(f'{light}{suffix}.{c}', 0 * channels['R']) for c in 'RGB'], -1) for light in LIGHTS])
    return layers(''), layers('.spec')


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('program')
    arguments.add_argument('shared')
    a = arguments.parse_args()
    matte = lights_of(a.shared, 'lambert')
    print('| set | two photographs: highlights | T | and two crossed: highlights | T | one, and two crossed: highlights | T |')
    print('|---|---|---|---|---|---|---|')
    with tempfile.TemporaryDirectory() as folder:
        for material in ('spec1', 'spec2', 'spec3', 'spec4', 'spec5'):
            shine = np.maximum(lights_of(a.shared, material) - matte, 0)
            cells = []
            for kinds in (OPEN, OPEN + CROSSED, CROSSED + OPEN[1:]):
                found, highlights = solved(a.program, matte, shine, kinds, folder)
                cells += [' '.join(f'{error(h, s):.3f}' for h, s in zip(highlights, shine)), f'{error(found, matte + shine):.4f}']
            print(f'| {material} | {" | ".join(cells)} |', flush=True)
        for material in ('lambert', 'oren_nayar'):
            flat = lights_of(a.shared, material)
            _, highlights = solved(a.program, flat, 0 * flat, OPEN + CROSSED, folder)
            print(f'\n{material}: {highlights.sum() / flat.sum():.4%} of the light is called highlight')


if __name__ == '__main__':
    main()

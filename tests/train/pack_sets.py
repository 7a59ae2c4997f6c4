#!/usr/bin/python3
"""Packs rendered sets with truth as training data, in the format of packed_set.h.

usage: pack_sets.py OUT FOLDER...
       pack_sets.py OUT --solved KEEP --swaplight PROGRAM [--shared SHARED] FOLDER...

A FOLDER is what ../shared/tools/scenes/make_scenes.py writes; all have to be of one size. OUT.seeds gets their seeds, a
line each: train_umbra.py judges by every eighth. With --solved, the lights' contributions are those that swaplight
separates from noisy photographs of the set, which are composed in KEEP; what is already solved there is not solved
again. The truth of the visibility is the rendered one in both cases.
"""
import argparse
import json
import os
import pathlib
import subprocess

import numpy as np
import OpenImageIO as oiio

STEPS_A_STOP, STOPS_ABOVE = 16, 2  # 255 is so many stops above a light's 99th percentile

# How the photographs of a set are taken: by its seed, modulo 4.
PHOTOGRAPHS = (['--noise', 'read=.004,full_well=5000'], ['--noise', 'read=.002,full_well=20000'], ['--bits', '8'],
               ['--noise', 'read=.008,full_well=1500'])


def read(path):
    """Channel name -> picture."""
    source = oiio.ImageInput.open(str(path))
    if not source:
        raise SystemExit(f'{path}: {oiio.geterror()}')
    spec = source.spec()
    pixels = np.asarray(source.read_image('float')).reshape(spec.height, spec.width, spec.nchannels)
    source.close()
    return {name: pixels[..., i] for i, name in enumerate(spec.channelnames)}


def levels(contribution):
    """A light's R G B picture as bytes, in logarithmic steps; None where it gives nothing."""
    top = np.quantile(contribution.mean(2), .99)
    if not top > 0:
        return None
    stops = np.log2(np.maximum(contribution, 1e-20) / top) - STOPS_ABOVE
    steps = np.where(contribution > 0, STEPS_A_STOP * stops + 255, 0)
    return np.clip(np.round(steps), 0, 255).astype(np.uint8).transpose(2, 0, 1)


def visibility(folder, light):
    """How much of a light each pixel sees; 0, too, where it faces away."""
    truth = read(folder / f'shadow_{light}.exr')
    return np.round(np.where(truth['A'] > 0, truth['Y'], 0) * 255).astype(np.uint8)


def rendered(folder, lights):
    for light in lights:
        channels = read(folder / f'T_{light}.exr')
        yield light, np.stack([channels[c] for c in 'RGB'], 2)


def solved(folder, seed, keep, program, shared):
    capture, contributions = keep / str(seed) / 'capture.json', keep / str(seed) / 'solved.exr'
    if not contributions.exists():
        quiet = dict(check=True, stdout=subprocess.DEVNULL)
        compose = os.path.join(shared, 'tools/compose.py')
        subprocess.run([compose, folder, capture.parent, *PHOTOGRAPHS[seed % 4]], **quiet)
        subprocess.run([program, 'solve', capture, '-q', '-o', contributions], **quiet)
    channels = read(contributions)
    for light in json.loads(capture.read_text())['lights']:
        yield light['name'], np.stack([channels[f'{light["name"]}.{c}'] for c in 'RGB'], 2)


def packed(folder, contributions):
    planes = []
    for light, contribution in contributions:
        rgb = levels(contribution)
        if rgb is not None:
            planes += [rgb, visibility(folder, light)[None]]
    lights = np.int32(len(planes) // 2)
    return lights.tobytes() + np.concatenate(planes).tobytes()


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('out', type=pathlib.Path)
    arguments.add_argument('folders', nargs='+', type=pathlib.Path, metavar='FOLDER')
    arguments.add_argument('--solved', type=pathlib.Path, metavar='KEEP')
    arguments.add_argument('--swaplight', metavar='PROGRAM')
    arguments.add_argument('--shared', default='../shared')
    a = arguments.parse_args()
    if a.solved and not a.swaplight:
        arguments.error('--solved needs --swaplight PROGRAM, which solves the sets')
    with open(a.out, 'wb') as out, open(f'{a.out}.seeds', 'w') as seeds:
        for folder in a.folders:
            scene = json.loads((folder / 'scene.json').read_text())
            if a.solved:
                contributions = solved(folder, scene['seed'], a.solved, a.swaplight, a.shared)
            else:
                contributions = rendered(folder, [light['name'] for light in scene['lights']])
            out.write(packed(folder, contributions))
            seeds.write(f'{scene["seed"]}\n')


if __name__ == '__main__':
    main()

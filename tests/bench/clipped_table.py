#!/usr/bin/python3
"""What `auto` makes of pixels that are clipped in so many photographs that too little is left to tell the lights apart.

usage: clipped_table.py SWAPLIGHT SHARED [--sets A,B] [--lights 2,3] [--noise 8bit,clean] [--bright 99,95] [--size 240]
                        [--against OTHER_SWAPLIGHT]

Captures as those of solve_table.py, but exposed so that full scale is at that percentile of all lights' sum. A row: the
part of the pixels that is flagged clipped and filled in; over these, RMSE of beta, relative RMSE of the contributions
(over the contributions' rms), and how much of the light that a turned-off light's rest should not show stays: the mean
over lights of what the estimate gives where the truth gives less than a tenth of the pixel's light, over the pixel's
light. With --against, the other program's figures for the same pixels stand beside.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

import solve_table as tables


def parts(score, solved, names):
    channels = score.read(solved)
    return np.stack([score.rgb(channels, n) for n in names]), channels['quality.flags'].astype(int)


def figures(estimate, truth, where):
    estimate, truth = estimate[:, where], truth[:, where]
    beta = estimate.sum(-1) / np.maximum(estimate.sum((0, -1)), 1e-9)
    true_beta = truth.sum(-1) / np.maximum(truth.sum((0, -1)), 1e-9)
    absent = true_beta < .1
    return (float(np.sqrt(np.mean((beta - true_beta) ** 2))),
            float(np.sqrt(np.mean((estimate - truth) ** 2) / np.mean(truth ** 2))),
            float(beta[absent].mean()) if absent.any() else float('nan'))


def truth_of(score, capture):
    """The contributions that the capture was made of, brighter than full scale where they are."""
    with open(capture) as file:
        manifest = json.load(file)
    folder = os.path.dirname(capture)
    names = list(manifest['truth'])
    return names, np.stack([score.rgb(score.read(os.path.join(folder, manifest['truth'][n]))) for n in names])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('program')
    parser.add_argument('shared')
    parser.add_argument('--sets')
    parser.add_argument('--lights', default='2,3')
    parser.add_argument('--noise', default='8bit')
    parser.add_argument('--bright', default='97')
    parser.add_argument('--size', type=int, default=240)
    parser.add_argument('--against')
    asked = parser.parse_args()
    sys.path.insert(0, os.path.join(asked.shared, 'tools'))
    import score
    programs = [p for p in (asked.program, asked.against) if p]
    print('| set | lights | noise | percentile | of the pixels | beta RMSE | relative RMSE | light that is not there |')
    print('|---|---|---|---|---|---|---|---|')
    for name, (source, lights) in tables.one_light_sets(os.path.join(asked.shared, 'captures')).items():
        if asked.sets and name not in asked.sets.split(','):
            continue
        for count in map(int, asked.lights.split(',')):
            if count > len(lights):
                continue
            for noise in asked.noise.split(','):
                for bright in map(float, asked.bright.split(',')):
                    with tempfile.TemporaryDirectory() as work:
                        tables.shown_gain = lambda folder, names: 1 / max(float(np.percentile(sum(
                            score.rgb(score.read(f'{folder}/T_{n}.exr')) for n in names), bright)), 1e-9)
                        try:
                            capture = tables.compose(asked.shared, source, lights[:count], noise, asked.size, False,
                                                     os.path.join(work, 'capture'))
                        except subprocess.CalledProcessError as error:
                            print(f'| {name} | {count} | {error} |')
                            continue
                        names, truth = truth_of(score, capture)
                        solves = []
                        for i, program in enumerate(programs):
                            out = os.path.join(work, f'{i}.exr')
                            tables.solve(program, capture, 'auto', out)
                            solves.append(parts(score, out, names))
                        flags = solves[0][1]
                        where = ((flags & 1) > 0) & ((flags & 16) > 0)
                        if where.sum() < 20:
                            continue
                        rows = [figures(s[0], truth, where) for s in solves]
                        cells = [' <- '.join(f'{row[c]:.3f}' for row in rows) for c in range(3)]
                        print(f'| {name} | {count} | {noise} | {bright:g} | {where.mean():.2%} | ' + ' | '.join(cells) + ' |',
                              flush=True)


if __name__ == '__main__':
    main()

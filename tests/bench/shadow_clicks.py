#!/usr/bin/python3
"""What a click is worth: shadows of rendered sets after 0, 1, 2 ... labels by somebody who knows the truth.

usage: shadow_clicks.py SWAPLIGHT SHARED SOLVED [--sets random/random_6,...] [--clicks 3] [--noisy]

SOLVED is the folder that `shadow_table.py --keep` has filled. In each round every light gets one label ("this is shadow",
"this is lit") where a person would click: in the middle of the largest connected part that is wrongly called or cannot be
told, as the truth has it (umbra: visibility below .02; lit: above .98). A light with no such part of .1 % of the picture
gets none. A row a light: umbra and error over all pixels (unknown ones count as their visibility says), after each round.
"""
import argparse
import glob
import os
import subprocess
import tempfile

import cv2
import numpy as np

from shadow_table import iou, read, truth_of

LEAST = .001
UNKNOWN, UMBRA, LIT = 0, 1, 3


def click(label, visible):
    """The option that labels the largest part that is not what it is in truth, or nothing."""
    best = None
    for option, truth, other in (('--label-shadow', visible < .02, LIT), ('--label-lit', visible > .98, UMBRA)):
        missed = (truth & ((label == other) | (label == UNKNOWN))).astype(np.uint8)
        count, parts, statistics, _ = cv2.connectedComponentsWithStats(missed, connectivity=4)
        if count < 2:
            continue
        part = 1 + statistics[1:, cv2.CC_STAT_AREA].argmax()
        area = statistics[part, cv2.CC_STAT_AREA]
        if area < LEAST * label.size or best and area <= best[0]:
            continue
        depth = cv2.distanceTransform(np.pad((parts == part).astype(np.uint8), 1), cv2.DIST_L2, 5)[1:-1, 1:-1]
        y, x = np.unravel_index(depth.argmax(), depth.shape)
        best = (area, option, int(x), int(y))
    return best


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('swaplight')
    arguments.add_argument('shared')
    arguments.add_argument('solved')
    arguments.add_argument('--sets', default=','.join(f'random/random_{seed}' for seed in range(6, 11)))
    arguments.add_argument('--clicks', type=int, default=3)
    arguments.add_argument('--noisy', action='store_true')
    a = arguments.parse_args()
    rounds = range(a.clicks + 1)
    print('| set | light | ' + ' | '.join(f'umbra, {n}' for n in rounds) + ' | ' + ' | '.join(f'error, {n}' for n in rounds)
          + ' | ' + ' | '.join(f'unknown, {n}' for n in rounds) + ' |')
    print('|---|---|' + '---|' * (3 * len(rounds)))
    told = []
    for name in a.sets.split(','):
        solved = os.path.join(a.solved, name.replace('/', '_') + ('_noisy' if a.noisy else ''), 'solved.exr')
        truth = {os.path.basename(f)[7:-4]: read(f)['Y']
                 for f in sorted(glob.glob(truth_of(os.path.join(a.shared, 'captures'), name) + '/shadow_*.exr'))}
        labels, figures = [], {light: [] for light in truth}
        with tempfile.TemporaryDirectory() as folder:
            for n in rounds:
                out = os.path.join(folder, 'shadows.exr')
                subprocess.run([a.swaplight, 'shadows', solved, '-q', '-o', out, *labels], check=True, stdout=subprocess.DEVNULL)
                found = read(out)
                for light, visible in truth.items():
                    v, label = found[f'shadow_{light}.Y'], np.rint(found[f'shadow_{light}.label'])
                    figures[light].append((iou(v < .1, visible < .02), np.abs(v - visible).mean(), (label == UNKNOWN).mean()))
                    where = click(label, visible)
                    if where:
                        labels += [where[1], f'{light}={where[2]},{where[3]}']
        for light, rows in figures.items():
            umbra, error, unknown = zip(*rows)
            told.append((((truth[light] < .02).mean() > .002), umbra, error, unknown))
            print(f'| {name} | {light} | ' + ' | '.join(f'{v:.3f}' for v in umbra + error)
                  + ' | ' + ' | '.join(f'{v:.1%}' for v in unknown) + ' |', flush=True)
    mean = lambda column, some: ' '.join(f'{v:.3f}' for v in np.mean([t[column] for t in told if t[0] or not some], 0))
    print(f'\n{len(told)} lights after {", ".join(map(str, rounds))} labels: umbra {mean(1, True)}; error {mean(2, False)}; '
          f'unknown {mean(3, False)}')


if __name__ == '__main__':
    main()

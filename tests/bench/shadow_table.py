#!/usr/bin/python3
"""How well shadows are found: a table over every rendered set with truth, without and with noise.

usage: shadow_table.py SWAPLIGHT SHARED [--sets spheres,random/random_7] [--keep FOLDER] [--clean]

A row a set and light: intersection over union of umbra (truth: visibility below .02) and lit (above .98), mean absolute
error of the visibility, share of unknown pixels (which are left out of the others), and false umbra (share of the
picture that is called umbra but lit). Umbra in reach leaves out what faces away from the light. The last three columns:
umbra by the best of 50 plain thresholds on beta (chosen with the truth at hand), by Otsu's threshold on beta, and by
Otsu's on the luminance of the all-white picture. "All" counts unknown pixels as what their visibility says, umbra below .1.

Below the table, apart for the random sets 6 to 10, which no constant may be chosen on, and all other sets: the means, of
umbra over the lights whose umbra is at least .2 % of the picture; how many lights have more than 2 % false umbra, and
how many of the former are below the best threshold on beta less .03.

With --keep, what is already solved in the folder is not solved again.
"""
import argparse
import glob
import os
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

NOISY = 'read=.004,full_well=5000'
KEPT_BACK = [f'random/random_{seed}' for seed in range(6, 11)]


def read(path):
    source = oiio.ImageInput.open(path)
    spec = source.spec()
    pixels = np.asarray(source.read_image('float')).reshape(spec.height, spec.width, spec.nchannels)
    return {name: pixels[..., i] for i, name in enumerate(spec.channelnames)}


def iou(a, b):
    return (a & b).sum() / max((a | b).sum(), 1)


def otsu(values):
    counts, edges = np.histogram(values, 256)
    centers = (edges[1:] + edges[:-1]) / 2
    below = np.cumsum(counts)
    above = below[-1] - below
    sums = np.cumsum(counts * centers)
    mean_below = sums / np.maximum(below, 1)
    mean_above = (sums[-1] - sums) / np.maximum(above, 1)
    return centers[(below * above * (mean_below - mean_above) ** 2).argmax()]


def rows(name, shadows, solved, truth_folder):
    ours, set_ = read(shadows), read(solved)
    white = sum(set_[c] for c in 'RGB')
    for file in sorted(glob.glob(os.path.join(truth_folder, 'shadow_*.exr'))):
        light = os.path.basename(file)[7:-4]
        truth = read(file)
        visible, reach = truth['Y'], truth['A'] > .5
        v, label = ours[f'shadow_{light}.Y'], ours[f'shadow_{light}.label']
        known, umbra, lit = label > 0, visible < .02, visible > .98
        beta = set_[f'beta.{light}']
        yield dict(
            set=name, light=light, penumbra=(reach & ~umbra & ~lit).mean(),
            umbra=iou((label == 1)[known], umbra[known]), reach=iou((label == 1)[known & reach], umbra[known & reach]),
            lit=iou((label == 3)[known], lit[known]), error=np.abs(v - visible)[known].mean(), unknown=1 - known.mean(),
            false=((label == 1) & lit).mean(), truth=umbra.mean(), all=iou(v < .1, umbra),
            beta=max(iou(beta < t, umbra) for t in np.linspace(.01, .5, 50)), otsu=iou(beta < otsu(beta), umbra),
            luminance=iou(white < otsu(white), umbra))


def truth_of(captures, name):
    """The folder with a set's shadow_<light>.exr: its own, or that of its family."""
    own = os.path.join(captures, name)
    return own if glob.glob(own + '/shadow_*.exr') else os.path.join(captures, name.split('/')[0])


def summary(title, rows_):
    shadowed = [r for r in rows_ if r['truth'] > .002]
    if not shadowed:
        return
    mean = {k: np.mean([r[k] for r in shadowed]) for k in ('umbra', 'all', 'beta')}
    every = {k: np.mean([r[k] for r in rows_]) for k in ('error', 'unknown', 'false')}
    print(f'{title}: {len(rows_)} lights, umbra {mean["umbra"]:.3f} (all {mean["all"]:.3f}, best beta {mean["beta"]:.3f}), '
          f'error {every["error"]:.3f}, unknown {every["unknown"]:.1%}, false {every["false"]:.2%}; '
          f'{sum(r["false"] > .02 for r in rows_)} with more than 2 % false, '
          f'{sum(r["umbra"] < r["beta"] - .03 for r in shadowed)} below beta less .03')


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('swaplight')
    arguments.add_argument('shared')
    arguments.add_argument('--sets')
    arguments.add_argument('--keep')
    arguments.add_argument('--clean', action='store_true', help='without noise only')
    a = arguments.parse_args()
    captures = os.path.join(a.shared, 'captures')
    found = [os.path.relpath(os.path.dirname(f), captures)
             for f in sorted(glob.glob(captures + '/*/T_*.exr') + glob.glob(captures + '/*/*/T_*.exr'))]
    found = sorted({s for s in found if glob.glob(truth_of(captures, s) + '/shadow_*.exr')})
    work = a.keep or tempfile.mkdtemp()
    print('| set | light | penumbra | umbra | in reach | all | lit | error | unknown | false | best beta | Otsu beta | luminance |')
    print('|---|---|---|---|---|---|---|---|---|---|---|---|---|')
    told = []
    for noise in ('',) if a.clean else ('', NOISY):
        for s in a.sets.split(',') if a.sets else found:
            folder = os.path.join(work, s.replace('/', '_') + ('_noisy' if noise else ''))
            options = ['--noise', noise] if noise else ['--bits', 'float']
            solved, shadows = os.path.join(folder, 'solved.exr'), os.path.join(folder, 'shadows.exr')
            quiet = dict(check=True, stdout=subprocess.DEVNULL)
            if not (a.keep and os.path.exists(solved)):
                subprocess.run([os.path.join(a.shared, 'tools/compose.py'), os.path.join(captures, s), folder, *options], **quiet)
                subprocess.run([a.swaplight, 'solve', os.path.join(folder, 'capture.json'), '-q', '-o', solved], **quiet)
            subprocess.run([a.swaplight, 'shadows', solved, '-q', '-o', shadows], **quiet)
            for r in rows(s + (', noisy' if noise else ''), shadows, solved, truth_of(captures, s)):
                told.append(dict(r, kept_back=s in KEPT_BACK))
                print('| {set} | {light} | {penumbra:.1%} | {umbra:.3f} | {reach:.3f} | {all:.3f} | {lit:.3f} | {error:.3f} '
                      '| {unknown:.1%} | {false:.1%} | {beta:.3f} | {otsu:.3f} | {luminance:.3f} |'.format(**r))
            sys.stdout.flush()
    print()
    summary('Other sets', [r for r in told if not r['kept_back']])
    summary('Kept back', [r for r in told if r['kept_back']])


if __name__ == '__main__':
    main()

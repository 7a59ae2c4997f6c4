#!/usr/bin/python3
"""How well shadows are found: a table over every rendered set with truth, without and with noise.

usage: shadow_table.py SWAPLIGHT SHARED [--sets spheres,set4] [--keep FOLDER]

A row a set and light: intersection over union of umbra (truth: visibility below .02) and lit (above .98), mean absolute
error of the visibility, share of unknown pixels (which are left out of the others), and false umbra (share of the
picture that is called umbra but lit). Umbra in reach leaves out what faces away from the light. The last three columns:
umbra by the best of 50 plain thresholds on beta (chosen with the truth at hand), by Otsu's threshold on beta, and by
Otsu's on the luminance of the all-white picture.
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
            false=((label == 1) & lit).mean(),
            beta=max(iou(beta < t, umbra) for t in np.linspace(.01, .5, 50)), otsu=iou(beta < otsu(beta), umbra),
            luminance=iou(white < otsu(white), umbra))


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('swaplight')
    arguments.add_argument('shared')
    arguments.add_argument('--sets')
    arguments.add_argument('--keep')
    a = arguments.parse_args()
    captures = os.path.join(a.shared, 'captures')
    found = [os.path.relpath(os.path.dirname(f), captures)
             for f in sorted(glob.glob(captures + '/*/T_*.exr') + glob.glob(captures + '/*/*/T_*.exr'))]
    found = sorted({s for s in found if glob.glob(os.path.join(captures, s.split('/')[0], 'shadow_*.exr'))})
    work = a.keep or tempfile.mkdtemp()
    print('| set | light | penumbra | umbra | in reach | lit | error | unknown | false | best beta | Otsu beta | luminance |')
    print('|---|---|---|---|---|---|---|---|---|---|---|---|')
    for noise in ('', NOISY):
        for s in a.sets.split(',') if a.sets else found:
            folder = os.path.join(work, s.replace('/', '_') + ('_noisy' if noise else ''))
            options = ['--noise', noise] if noise else ['--bits', 'float']
            solved, shadows = os.path.join(folder, 'solved.exr'), os.path.join(folder, 'shadows.exr')
            quiet = dict(check=True, stdout=subprocess.DEVNULL)
            subprocess.run([os.path.join(a.shared, 'tools/compose.py'), os.path.join(captures, s), folder, *options], **quiet)
            subprocess.run([a.swaplight, 'solve', os.path.join(folder, 'capture.json'), '-q', '-o', solved], **quiet)
            subprocess.run([a.swaplight, 'shadows', solved, '-q', '-o', shadows], **quiet)
            for r in rows(s + (', noisy' if noise else ''), shadows, solved, os.path.join(captures, s.split('/')[0])):
                print('| {set} | {light} | {penumbra:.1%} | {umbra:.3f} | {reach:.3f} | {lit:.3f} | {error:.3f} | {unknown:.1%} '
                      '| {false:.1%} | {beta:.3f} | {otsu:.3f} | {luminance:.3f} |'.format(**r))
            sys.stdout.flush()


if __name__ == '__main__':
    main()

#!/usr/bin/python3
"""What spoils a solve, whether the solve says so, and what its remedy brings: a row a set and defect.

usage: cause_table.py SWAPLIGHT SHARED [--sets A,B] [--cases clean,tone] [--size 320] [--lights 2] [--remedy=--field]

Photographs are composed of SHARED/captures' pictures of one light each, with one thing wrong that the capture does not
tell. The noise is not told. With --sight two tables more: from what size on each set's clean photographs are said to show a
cause, and what those with one planted say of it. Columns: relative RMSE of the contributions (exposure, which nothing tells under an unknown
curve, taken off) and mean CIEDE2000 of SHARED/tools/score.py, nothing done about it; the causes that the report names, with
the best one's size and certainty; both errors of a solve that is asked for nothing, and what it did; then both with the remedy
that the named cause offers, where that did nothing and `solve` has it, or with --remedy.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio
from solve_table import one_light_sets

COLORS = [[.9, .2, .15], [.15, .8, .25], [.2, .25, .9], [.85, .75, .1]]
READ, FULL_WELL = .002, 20000
DRIFT_RMS = .3  # of a field's size: its colours' RMS over the picture
# What is planted, how much of it, and the bits of the files (None: floating point with noise).
CASES = {
    'clean': (0, None), 'clean 8 bit': (0, 8),
    'ambient .4 %': (.004, None), 'ambient 1.4 %': (.014, None), 'ambient 4.2 %': (.042, None), 'ambient 8 %': (.08, None), 'ambient 14 %': (.14, None),
    'field 5 %': (.05, None), 'field 10 %': (.1, None), 'field 20 %': (.2, None), 'field 10 % 8 bit': (.1, 8),
    'field of one 5 %': (.05, None), 'field of one 10 %': (.1, None), 'field of one 20 %': (.2, None), 'tone S mild': (.3, 8), 'tone S strong': (.8, 8), 'tone gamma .9': (.9, 8), 'tone gamma .8': (.8, 8), 'tone gamma 1.1': (1.1, 8),
    'colors 2 %': (.02, None), 'colors 5 %': (.05, None), 'colors 15 %': (.15, None), 'colors 30 %': (.3, None), 'moved 1 px': (1, 8), 'turned 2 px': (2, 8),
}
REMEDY = {'tone': ['--tone', 'auto'], 'moved': ['--align', 'on'], 'colors': ['--refine-colors'], 'field': ['--field']}
LUMINANCE = np.array([.2126, .7152, .0722])


def read(path):
    return np.asarray(oiio.ImageBuf(path).get_pixels(oiio.FLOAT))[..., :3].astype(float)


def smaller(picture, size):
    q = max(1, -(-picture.shape[1] // size))
    h, w = picture.shape[0] // q * q, picture.shape[1] // q * q
    return picture[:h, :w].reshape(h // q, q, w // q, q, 3).mean((1, 3))


def load(folder, lights, size):
    """Contributions with the 99.5th percentile of their sum at .9, and the ambient light, as bright as that in the mean."""
    truth = np.stack([smaller(read(f'{folder}/T_{name}.exr'), size) for name in lights])
    truth *= .9 / np.percentile(truth.sum(0), 99.5)
    path = f'{folder}/ambient.exr'
    ambient = smaller(read(path), size) if os.path.exists(path) else truth.sum(0).mean(-1, keepdims=True) * np.ones(3)
    return truth, ambient * truth.sum(0).mean() / ambient.mean()


def slid(picture, amounts, axis):
    """Every line along an axis slid by its own number of pixels, by Fourier's shift theorem."""
    pad = [(16, 16) if j == axis else (0, 0) for j in range(3)]
    wide = np.pad(picture, pad, 'edge')
    f = np.fft.rfftfreq(wide.shape[axis])
    phase = np.exp(-2j * np.pi * np.multiply.outer(amounts, f))
    phase = (phase if axis == 1 else phase.T)[..., None]
    return np.take(np.fft.irfft(np.fft.rfft(wide, axis=axis) * phase, wide.shape[axis], axis=axis),
                   np.arange(16, 16 + picture.shape[axis]), axis)


def moved(picture, size, turned):
    """Shifted by `size` pixels, or turned by as much at the sides, in three shears."""
    h, w = picture.shape[:2]
    if not turned:
        return slid(slid(picture, np.full(h, .8 * size), 1), np.full(w, .6 * size), 0)
    angle = size / (w / 2)
    y, x = np.arange(h) - h / 2, np.arange(w) - w / 2
    return slid(slid(slid(picture, -angle / 2 * y, 1), angle * x, 0), -angle / 2 * y, 1)


def srgb(x):
    x = np.clip(x, 0, 1)
    return np.where(x <= .0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - .055)


def field(truth, size, rng, one):
    """Each light, or the first one, with a colour that goes from -size to +size over the picture; its luminance stays."""
    h, w = truth.shape[1:3]
    y, x = np.mgrid[-1:1:h * 1j, -1:1:w * 1j]
    drifting = []
    for j, light in enumerate(truth):
        slope = rng.normal(size=(2, 3))
        slope /= np.abs(slope).sum(0).max()
        color = 1 + size * (x[..., None] * slope[0] + y[..., None] * slope[1])
        drifting.append(light if one and j > 0 else light * color / (color @ LUMINANCE)[..., None])
    return np.stack(drifting)


def coded(shot, case, size, bits, rng):
    shot = np.maximum(shot, 0)
    if not bits:
        shot = shot + rng.normal(size=shot.shape) * np.sqrt(READ ** 2 + shot / FULL_WELL)
        return np.minimum(shot, 1)
    v = srgb(shot)
    if case.startswith('tone S'):
        v = (1 - size) * v + size * (3 * v ** 2 - 2 * v ** 3)
    if case.startswith('tone gamma'):
        v = v ** size
    return np.round(v * 255).astype(np.uint8)


def write(path, picture):
    kind = 'uint8' if picture.dtype == np.uint8 else 'float'
    out = oiio.ImageBuf(oiio.ImageSpec(picture.shape[1], picture.shape[0], 3, kind))
    out.set_pixels(oiio.ROI(), np.ascontiguousarray(picture, np.uint8 if kind == 'uint8' else np.float32))
    out.write(path)


def compose(truth, ambient, names, case, out):
    size, bits = CASES[case]
    rng = np.random.default_rng(1)
    n = len(truth)
    colors = np.array([[COLORS[(i + k) % n] for i in range(n)] for k in range(n)])
    said = colors * (1 + size * rng.normal(size=colors.shape)) if case.startswith('colors') else colors
    lit = field(truth, size, rng, case.startswith('field of one')) if case.startswith('field') else truth
    shots = np.einsum('kic,ihwc->khwc', colors, lit)
    if case.startswith('ambient'):
        shots += size * ambient
    for k in range(1, n):
        if case.startswith(('moved', 'turned')):
            shots[k] = moved(shots[k], size * (1 if k % 2 else -1), case.startswith('turned'))
    manifest = {'format': 'swaplight-capture', 'version': 1, 'name': 'set', 'color_space': 'srgb' if bits else 'lin_rec709',
                'lights': [{'name': name, 'role': 'other'} for name in names], 'shots': [], 'truth': {}}
    os.makedirs(f'{out}/truth')
    for k in range(n):
        name = f'shot_{k + 1}.' + ('png' if bits else 'exr')
        write(f'{out}/{name}', coded(shots[k], case, size, bits, rng))
        manifest['shots'].append({'image': name, 'light_colors': np.round(said[k], 6).tolist()})
    for name, light in zip(names, truth):
        manifest['truth'][name] = f'truth/T_{name}.exr'
        write(f'{out}/truth/T_{name}.exr', light)
    with open(f'{out}/capture.json', 'w') as file:
        json.dump(manifest, file)
    return f'{out}/capture.json'


def solve(program, capture, out, *options):
    result = subprocess.run([program, 'solve', capture, '-o', out, '--json', '--float', *options], capture_output=True,
                            text=True)
    if result.returncode:
        sys.exit(f'{capture}: {result.stderr}')
    return json.loads(result.stdout)


def rescaled(score, solved, truth, names):
    """Relative RMSE with one factor for all lights: an unknown curve leaves the exposure open."""
    channels = score.read(solved)
    ours = np.stack([score.rgb(channels, name) for name in names])
    factor = (ours * truth).sum() / (ours * ours).sum()
    return float(np.sqrt(((factor * ours - truth) ** 2).mean() / (truth ** 2).mean()))


def row(score, program, truth, ambient, names, case, label, always):
    with tempfile.TemporaryDirectory() as work:
        capture, solved = compose(truth, ambient, names, case, work), f'{work}/solved.exr'

        def errors(*options):
            report = solve(program, capture, solved, *options)
            return report, f'{rescaled(score, solved, truth, names):.3f} | {score.score(capture, solved)["de_mean"]:.2f}'
        report, before = errors('--align', 'off', '--tone', 'declared')
        causes = report.get('misfit_causes', {'likely': [], 'all': []})
        best = causes['all'][0] if causes['all'] else None
        what = ' or '.join(causes['likely']) or 'none'
        detail = f'{best["cause"]} {best["size"]:.3f} ({best["certainty"]:.1f}, {best["explained"]:.2f})' if best else ''
        by_itself, usual = errors()
        done = 'curve taken off' if 'tone_correction' in by_itself else 'aligned' if by_itself['shifts'] else ''
        remedy = always or (REMEDY.get(causes['likely'][0]) if causes['likely'] and not done else None)
        after = errors(*remedy)[1] if remedy else ' | '
    print(f'| {label} | {case} | {before} | {what} | {detail} | {usual} | {done} | {after} |', flush=True)
    return causes


def planted(case):
    """The cause that a case plants, and its size as the report has it; None: another."""
    kind, *rest = case.split()
    if kind == 'ambient':
        return 'ambient', float(rest[0]) / 100
    if kind == 'field' and rest[0] != 'of':
        return 'field', DRIFT_RMS * float(rest[0]) / 100
    return ('tone', abs(1 - float(rest[1]))) if 'gamma' in case else None


def print_sight(found):
    """`found`: (set, case) -> causes."""
    told = dict.fromkeys(('said', 'not said, nor that it would be', 'not said, nor what would be', 'said that it would be seen'), 0)
    print('\n| set | ambient | tone | field |\n|---|---|---|---|')
    for label in dict.fromkeys(label for label, _ in found):
        seen = found.get((label, 'clean'), {}).get('seen_from')
        if seen:
            print('|', label, '|', ' | '.join(f'{f:.3f}' if f else '-' for f in
                                              (seen.get(name) for name in ('ambient', 'tone', 'field'))), '|')
        for case in (case for of, case in found if of == label):
            what, causes = planted(case), found[label, case]
            if what and (causes['likely'] or causes.get('unnamed')):
                told['said'] += 1
            elif what and 'seen_from' not in causes:
                told['not said, nor what would be'] += 1
            elif what:
                # What the photographs with it say, which nobody knows to hold it.
                limit = causes['seen_from'].get(what[0])
                told['not said, nor that it would be' if not limit or what[1] < limit else 'said that it would be seen'] += 1
    print('\n| planted | captures |\n|---|---|')
    for name, count in told.items():
        print(f'| {name} | {count} |')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('swaplight')
    parser.add_argument('shared')
    parser.add_argument('--sets')
    parser.add_argument('--cases', default=','.join(CASES))
    parser.add_argument('--size', type=int, default=320)
    parser.add_argument('--lights', type=int, default=2)
    parser.add_argument('--evidence', help='append every cause of every row to this file')
    parser.add_argument('--remedy', help='the same remedy in every row, as --remedy=--field')
    parser.add_argument('--sight', action='store_true', help='what might go unseen, and whether that is said')
    options = parser.parse_args()
    always = options.remedy.split() if options.remedy else None
    sys.path.insert(0, os.path.join(options.shared, 'tools'))
    import score
    sets = one_light_sets(os.path.join(options.shared, 'captures'))
    print('| set | defect | rel. RMSE | dE00 | named | best (certainty, explained) | by itself: RMSE | dE00 | done '
          '| RMSE with remedy | dE00 |')
    print('|---|---|---|---|---|---|---|---|---|---|---|')
    found = {}
    for label in options.sets.split(',') if options.sets else sets:
        folder, lights = sets[label]
        names = lights[:options.lights]
        truth, ambient = load(folder, names, options.size)
        for case in options.cases.split(','):
            causes = row(score, os.path.abspath(options.swaplight), truth, ambient, names, case, label, always)
            found[label, case] = causes
            if options.evidence:
                with open(options.evidence, 'a') as file:
                    file.write(json.dumps({'set': label, 'case': case, 'lights': len(names), **causes}) + '\n')
    if options.sight:
        print_sight(found)


if __name__ == '__main__':
    main()

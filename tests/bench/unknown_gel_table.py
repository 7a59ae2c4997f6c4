#!/usr/bin/python3
"""An unknown gel of two swapped ones: how near it comes, which lamp is taken for which, and what the solve loses.

usage: unknown_gel_table.py SWAPLIGHT SHARED [--third] [--rendered] [--sets A,B] [--pairs 8] [--seed 1] [options of solve]

By default the real swaps of SHARED/captures: each pair of photographs with all colours told, and with either gel unknown
("?a"); mean CIEDE2000 of relighting to the four other photographs, and the gel's error in per cent a channel of the mean of
what was fitted over all six photographs for either lamp. --third: the red and blue pair with a third photograph, under one of
its gels and none, by which the unknown one is determined. --rendered: pairs of lamps of the rendered sets, under pairs of gels
drawn at random, none (bare) among them, with noise; the gel's error, and how often the lamps are the wrong way round.
"""
import argparse
import itertools
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio
from solve_table import one_light_sets

# Linear Rec.709 over daylight: correction gels and their halves, deep ones, two that are nearly grey.
GELS = {
    'bare': (1, 1, 1), 'orange': (.88, .49, .19), 'half orange': (.94, .69, .44), 'quarter orange': (.97, .83, .67),
    'blue': (.22, .38, .68), 'half blue': (.42, .56, .78), 'quarter blue': (.63, .74, .87), 'straw': (1, .6, .05),
    'red': (.7, .23, .13), 'moss': (.03, .38, .11), 'plus green': (.73, .86, .66), 'minus green': (.87, .60, .80),
    'deep red': (.9, .2, .15), 'green': (.15, .8, .25), 'deep blue': (.2, .25, .9), 'pink': (.9, .5, .6), 'grey': (.5, .5, .5),
}


def solved(program, capture, folder, options):
    """(path of the solved set, what is told of its unknown colour)"""
    out, report = os.path.join(folder, 'solved.exr'), os.path.join(folder, 'report.json')
    done = subprocess.run([program, 'solve', capture, '-o', out, '--report', report, *options], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f'{capture}: {done.stderr}')
    with open(report) as file:
        report = json.load(file)
        told = report.get('open_color') or {}
        if report['estimated'] and not told:  # "... estimated from the pictures as 0.806/0.727/0.642"
            told = {'taken': [float(c) for c in report['estimated'][0].rsplit(' ', 1)[1].split('/')]}
        return out, told


def unknown_gel(manifest, gel, folder):
    """Writes the manifest with a gel's colour unknown wherever it stands: gel(shot, light) says where."""
    unknown = json.loads(json.dumps(manifest))
    for k, shot in enumerate(unknown['shots']):
        shot['light_colors'] = ['?a' if gel(k, i) else color for i, color in enumerate(shot['light_colors'])]
    path = os.path.join(folder, 'unknown.json')
    with open(path, 'w') as file:
        json.dump(unknown, file)
    return path


def errors(color, truth):
    return ' '.join(f'{100 * e:+.0f}' for e in np.array(color) / truth - 1)


def real(args):
    sys.path.insert(0, os.path.join(args.shared, 'tools'))
    from relight_test import test
    total = {'told': [], 'unknown': []}
    for scene in args.sets or ['swapped_bmug', 'swapped_diff', 'swapped_lion', 'swapped_spdif']:
        for pair in 'r_b', 'w_b', 'r_w':
            path = os.path.join(args.shared, 'captures', scene, f'capture_{pair}.json')
            with open(path) as file:
                manifest = json.load(file)
            for shot in manifest['shots'] + manifest['relight_tests']:
                shot['image'] = os.path.abspath(os.path.join(os.path.dirname(path), shot['image']))
            with tempfile.TemporaryDirectory() as folder:
                told = os.path.join(folder, 'told.json')
                with open(told, 'w') as file:
                    json.dump(manifest, file)
                base = test(told, solved(args.program, told, folder, args.options)[0])['de_mean']
                row = [f'{scene[8:]:6} {pair} told {base:5.2f}']
                for light in 0, 1:  # where the unknown gel is in the first photograph
                    truth = np.mean([manifest['shots'][0]['light_colors'][light], manifest['shots'][1]['light_colors'][1 - light]], 0)
                    capture = unknown_gel(manifest, lambda k, i: (i == light) == (k == 0), folder)
                    out, open_color = solved(args.program, capture, folder, args.options)
                    de = test(told, out)['de_mean']
                    total['told'].append(base)
                    total['unknown'].append(de)
                    row.append(f'{pair[2 * light]} unknown {de:5.2f} ({de / base:.2f}) {errors(open_color["taken"], truth)}')
                print(' | '.join(row), flush=True)
    print(f'mean: told {np.mean(total["told"]):.3f}, unknown {np.mean(total["unknown"]):.3f}')


def with_third(args):
    sys.path.insert(0, os.path.join(args.shared, 'tools'))
    from relight_test import test
    for scene in args.sets or ['swapped_bmug', 'swapped_diff', 'swapped_lion', 'swapped_spdif']:
        source = os.path.abspath(os.path.join(args.shared, 'captures', scene))
        colors = {}  # of a lamp (0: left) under a gel, by its letter
        for pair in 'r_b', 'w_b', 'r_w':
            with open(os.path.join(source, f'capture_{pair}.json')) as file:
                manifest = json.load(file)
            for shot in manifest['shots'] + manifest['relight_tests']:
                for light in 0, 1:
                    colors[light, shot['image'][6 + 2 * light]] = shot['light_colors'][light]

        def photographs(names):
            return [{'image': f'{source}/photo_{n}.exr', 'light_colors': [colors[0, n[0]], colors[1, n[2]]]} for n in names]
        for unknown, third in itertools.product('rb', ('w_b', 'w_r')):
            shots = ['r_b', 'b_r', third]
            manifest['shots'] = photographs(shots)
            manifest['relight_tests'] = photographs([n for n in ('w_b', 'b_w', 'w_r', 'r_w') if n != third])
            with tempfile.TemporaryDirectory() as folder:
                capture = unknown_gel(manifest, lambda k, i: False, folder)
                told = test(capture, solved(args.program, capture, folder, args.options)[0])['de_mean']
                capture = unknown_gel(manifest, lambda k, i: shots[k][2 * i] == unknown, folder)
                out, color = solved(args.program, capture, folder, args.options)
                de = test(capture, out)['de_mean']
            truth = np.mean([colors[0, unknown], colors[1, unknown]], 0)
            print(f'{scene[8:]:6} r_b b_r {third} told {told:5.2f} | {unknown} unknown {de:5.2f} ({de / told:.2f}) '
                  f'{errors(color["taken"], truth)}', flush=True)


def rendered(args):
    gels = {name: np.array(color, float) for name, color in GELS.items()}
    random = np.random.default_rng(args.seed)
    sets = one_light_sets(os.path.join(args.shared, 'captures'))
    wrong, error, rows = 0, [], 0
    for name, (source, lights) in sets.items():
        if name.startswith('photo') or (args.sets and name not in args.sets):
            continue
        lit = [np.asarray(oiio.ImageBuf(f'{source}/T_{n}.exr').get_pixels(oiio.FLOAT))[::2, ::2, :3].astype(float) for n in lights]
        pairs = list(itertools.combinations(range(len(lights)), 2))
        for _ in range(args.pairs):
            a, b = pairs[random.integers(len(pairs))]
            first, second = (random.choice(list(gels)) if random.random() > args.bare else 'bare' for _ in range(2))
            known, unknown = gels[first], gels[second]
            if np.abs((known - unknown) / (known + unknown)).max() < .08 or min(known.min(), unknown.min()) < .02:
                continue
            t = [lit[a] / lit[a].mean(), lit[b] / lit[b].mean()]
            t = [x * .9 / np.percentile(t[0] + t[1], 99.5) for x in t]
            shots = [t[0] * known + t[1] * unknown, t[0] * unknown + t[1] * known]
            with tempfile.TemporaryDirectory() as folder:
                manifest = {'format': 'swaplight-capture', 'version': 1, 'name': 'made', 'color_space': 'lin_rec709',
                            'lights': [{'name': 'a'}, {'name': 'b'}], 'shots': []}
                for k, shot in enumerate(shots):
                    shot = shot + np.sqrt(shot / 20000 + .002 ** 2) * random.standard_normal(shot.shape)
                    path = os.path.join(folder, f'{k}.exr')
                    picture = oiio.ImageBuf(oiio.ImageSpec(shot.shape[1], shot.shape[0], 3, oiio.FLOAT))
                    picture.set_pixels(oiio.ROI(), np.ascontiguousarray(shot, np.float32))
                    picture.write(path)
                    manifest['shots'].append({'image': path, 'light_colors': [known.tolist(), '?a'] if k == 0 else ['?a', known.tolist()]})
                capture = os.path.join(folder, 'capture.json')
                with open(capture, 'w') as file:
                    json.dump(manifest, file)
                found = solved(args.program, capture, folder, args.options)[1]
            off, other = (np.abs(np.array(found[key]) / unknown - 1).mean() for key in ('taken', 'exchanged'))
            rows += 1
            wrong += other < off
            error.append(min(off, other))
            print(f'{name:24} {lights[a]:10} {lights[b]:10} {first:8} known, {second:8} unknown: '
                  f'{"wrong way, " if other < off else ""}{errors(found["exchanged" if other < off else "taken"], unknown)}', flush=True)
    print(f'{rows} captures, {wrong} the wrong way round; mean error of a channel, lamps the right way: '
          f'median {100 * np.median(error):.1f} %, nine tenths below {100 * np.quantile(error, .9):.1f} %')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program')
    parser.add_argument('shared')
    parser.add_argument('--third', action='store_true')
    parser.add_argument('--rendered', action='store_true')
    parser.add_argument('--sets', type=lambda text: text.split(','))
    parser.add_argument('--pairs', type=int, default=8, help='of lamps and gels a rendered set')
    parser.add_argument('--seed', type=int, default=1, help='of lamps, gels and noise')
    parser.add_argument('--bare', type=float, default=.2, help='the share of lamps without a gel')
    args, args.options = parser.parse_known_args()
    (rendered if args.rendered else with_third if args.third else real)(args)


if __name__ == '__main__':
    main()

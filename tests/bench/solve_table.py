#!/usr/bin/python3
"""How `auto` compares with `lambert` and `transport` over every set with truth: a row a set, noise and number of lights.

usage: solve_table.py SWAPLIGHT SHARED [--sets A,B] [--noise 8bit,clean] [--lights 2,3] [--told] [--keep FOLDER] [--size 320]

Captures are composed by SHARED/tools/compose.py. The noise is not told to the solver unless --told. A row: relative RMSE
of the contributions, mean CIEDE2000 over the five lightings of SHARED/tools/score.py, RMSE of beta, coverage (lit pixels
and lights whose error, mean of the channels, is within two quality.sigma), all by `auto`; then `auto` over the better of
the two models by relative RMSE and by CIEDE2000. `single`: one light at a time; the last column is then the mean
CIEDE2000 of `auto` against `transport`. Real gel swaps (swapped_*) are relit to their other photographs.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

NOISE = {
    '8bit': ['--bits', '8', '--transfer', 'srgb'],
    'clean': ['--noise', 'read=.002,full_well=20000'],
    'noisy': ['--noise', 'read=.01,full_well=1000'],
    'wrong2': ['--noise', 'read=.002,full_well=20000', '--color-error', '.02'],
    'jpeg90': ['--bits', '8', '--transfer', 'srgb'],
    'single': ['--bits', '8', '--transfer', 'srgb', '--coding', 'single'],
}
MODELS = ('auto', 'lambert', 'transport')


def one_light_sets(captures):
    """Folders that hold pictures of one light each."""
    found = {}
    for folder, _, files in sorted(os.walk(captures)):
        lights = sorted(f[2:-4] for f in files if f.startswith('T_') and f.endswith('.exr') and '@' not in f)
        if len(lights) > 1:
            found[os.path.relpath(folder, captures).removesuffix('/truth')] = (folder, lights)
    return found


def shown_gain(folder, lights):
    """What brings the 99.5th percentile of all lights together to .9."""
    total = sum(np.asarray(oiio.ImageBuf(f'{folder}/T_{n}.exr').get_pixels(oiio.FLOAT))[..., :3] for n in lights)
    return .9 / max(float(np.percentile(total, 99.5)), 1e-9)


def as_jpeg(folder, manifest):
    for shot in manifest['shots']:
        picture = oiio.ImageBuf(os.path.join(folder, shot['image']))
        shot['image'] = shot['image'].replace('.png', '.jpg')
        picture.specmod().attribute('compression', 'jpeg:90')
        picture.write(os.path.join(folder, shot['image']))


def compose(shared, source, lights, noise, size, told, out):
    """A capture in `out`; returns its manifest's path."""
    path = os.path.join(out, 'capture.json')
    if os.path.exists(path):
        return path
    gain = shown_gain(source, lights)
    subprocess.run(['/usr/bin/python3', os.path.join(shared, 'tools', 'compose.py'), source, out, '--lights',
                    ','.join(lights), '--gain', f'{gain:.6f}', '--clip', '--max-size', str(size), *NOISE[noise]],
                   check=True, stderr=subprocess.DEVNULL)
    with open(path) as file:
        manifest = json.load(file)
    if not told:
        manifest.pop('noise', None)
    else:  # codes without any but their rounding
        manifest.setdefault('noise', {'read': 0, 'full_well': 1e9})
    if noise == 'jpeg90':
        as_jpeg(out, manifest)
    with open(path, 'w') as file:
        json.dump(manifest, file, indent=1)
    return path


def coverage(score, capture, solved):
    with open(capture) as file:
        truth = json.load(file)['truth']
    folder = os.path.dirname(capture)
    channels = score.read(solved)
    real = np.stack([score.rgb(score.read(os.path.join(folder, f))).mean(-1) for f in truth.values()])
    ours = np.stack([score.rgb(channels, name).mean(-1) for name in truth])
    lit = real.sum(0) > 0
    within = np.abs(ours - real) <= 2 * channels['quality.sigma'] * ours.sum(0)
    return float(within[:, lit].mean())


def against(score, first, second, names):
    """Mean CIEDE2000 between two solves of one set, each light alone."""
    a, b = score.read(first), score.read(second)
    scale = .9 / np.percentile(sum(score.rgb(b, n) for n in names), 99.5)
    return float(np.mean([score.de2000(score.lab(score.rgb(a, n) * scale), score.lab(score.rgb(b, n) * scale))
                          for n in names]))


def solve(program, capture, model, out):
    result = subprocess.run([program, 'solve', capture, '-o', out, '--model', model, '--json'], capture_output=True,
                            text=True)
    if result.returncode:
        sys.exit(f'{capture}: {result.stderr}')


def measure(score, program, capture, work):
    """Figures of every model, and how far `auto` is from `transport`."""
    figures, files = {}, {}
    for model in MODELS:
        files[model] = os.path.join(work, model + '.exr')
        solve(program, capture, model, files[model])
        figures[model] = score.score(capture, files[model])
    figures['auto']['coverage'] = coverage(score, capture, files['auto'])
    with open(capture) as file:
        names = [light['name'] for light in json.load(file)['lights']]
    return figures, against(score, files['auto'], files['transport'], names)


def swap_rows(program, captures, relight_test, work):
    folders = [f for f in sorted(os.listdir(captures)) if f.startswith('swapped_')]
    for folder in folders:
        for manifest in sorted(f for f in os.listdir(f'{captures}/{folder}') if f.startswith('capture')):
            capture, errors = f'{captures}/{folder}/{manifest}', []
            for model in MODELS:
                out = os.path.join(work, 'swap.exr')
                solve(program, capture, model, out)
                errors.append(relight_test.test(capture, out)['de_mean'])
            print(f'| {folder} {manifest[8:-5]} | ' + ' | '.join(f'{e:.3f}' for e in errors) +
                  f' | {errors[0] / min(errors[1:]):.3f} |', flush=True)
            yield errors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('swaplight')
    parser.add_argument('shared')
    parser.add_argument('--sets')
    parser.add_argument('--noise', default=','.join(NOISE))
    parser.add_argument('--lights', default='2,3,4')
    parser.add_argument('--size', type=int, default=320)
    parser.add_argument('--told', action='store_true')
    parser.add_argument('--swaps', action='store_true', help='the real gel swaps instead')
    parser.add_argument('--compose-only', action='store_true')
    parser.add_argument('--keep')
    a = parser.parse_args()
    captures = os.path.join(a.shared, 'captures')
    sys.path.insert(0, os.path.join(a.shared, 'tools'))
    import relight_test
    import score
    work = a.keep or tempfile.mkdtemp()
    os.makedirs(work, exist_ok=True)
    if a.swaps:
        print('| pair | auto | lambert | transport | auto / better |\n|---|---|---|---|---|')
        rows = list(swap_rows(a.swaplight, captures, relight_test, work))
        print('| mean | ' + ' | '.join(f'{e:.3f}' for e in np.mean(rows, 0)) + ' | |')
        return
    print('| set | lights | noise | rel. RMSE | dE00 | beta | coverage | RMSE / better | dE00 / better | |')
    print('|---|---|---|---|---|---|---|---|---|---|')
    ratios = []
    for name, (folder, lights) in one_light_sets(captures).items():
        if a.sets and name not in a.sets.split(','):
            continue
        for count in (int(n) for n in a.lights.split(',')):
            if count > len(lights):
                continue
            for noise in a.noise.split(','):
                out = os.path.join(work, f'{name.replace("/", "_")}_{count}_{noise}' + ('_told' if a.told else ''))
                capture = compose(a.shared, folder, lights[:count], noise, a.size, a.told, out)
                if a.compose_only:
                    continue
                f, gap = measure(score, a.swaplight, capture, work)
                ratio = [f['auto'][m] / max(min(f['lambert'][m], f['transport'][m]), 1e-9)
                         for m in ('rel_rmse', 'de_mean')]
                ratios.append(ratio)
                auto = f['auto']
                print(f'| {name} | {count} | {noise} | {auto["rel_rmse"]:.4f} | {auto["de_mean"]:.2f} | '
                      f'{auto["beta_rmse"]:.4f} | {auto["coverage"]:.3f} | {ratio[0]:.3f} | {ratio[1]:.3f} | '
                      f'{f"{gap:.3f}" if noise == "single" else ""} |', flush=True)
    if ratios:
        r = np.array(ratios)
        print(f'\n{len(r)} rows. RMSE / better: median {np.median(r[:, 0]):.3f}, above 1.05 {(r[:, 0] > 1.05).sum()}, '
              f'largest {r[:, 0].max():.2f}. dE00 / better: median {np.median(r[:, 1]):.3f}, '
              f'above 1.05 {(r[:, 1] > 1.05).sum()}, largest {r[:, 1].max():.2f}.')


if __name__ == '__main__':
    main()

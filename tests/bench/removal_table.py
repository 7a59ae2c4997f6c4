#!/usr/bin/python3
"""How well shadows are removed: a table over rendered sets whose lights are known without their shadows.

usage: removal_table.py SWAPLIGHT SHARED UNSHADOWED [--seeds 6,7,8] [--keep FOLDER]

UNSHADOWED/random_N holds what render_unshadowed.py makes. Each set is composed with noise (full well 5,000, read noise
.004) and solved by `auto`; its sum at unit white with one light's shadows removed is held against the truth: mean
CIEDE2000, the 99.5th percentile of the truth shown at .9, in the umbra (visibility below .02, in the light's reach) and
six pixels around it; elsewhere the removal should leave everything as it is. Beside it: nothing done, and the best plain threshold on beta (of 50, chosen with the truth at
hand), below which the light gets the ratio to the others that it has on the median pixel above.

A light with less than .5 % of umbra in its reach is left out. Rows marked * are of sets that no constant was chosen on.
"""
import argparse
import json
import os
import subprocess
import tempfile

import numpy as np
import OpenImageIO as oiio

from shadow_table import KEPT_BACK, NOISY, iou, read

LEAST_UMBRA = .005
AROUND = 6


def grown(mask, pixels):
    for _ in range(pixels):
        padded = np.pad(mask, 1)
        mask = mask | padded[:-2, 1:-1] | padded[2:, 1:-1] | padded[1:-1, :-2] | padded[1:-1, 2:]
    return mask


def rgb(channels, prefix=''):
    return np.stack([channels[prefix + c] for c in 'RGB'], -1)


def write(path, pixels):
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, 'float')
    spec.attribute('oiio:ColorSpace', 'lin_rec709')
    output = oiio.ImageOutput.create(path)
    output.open(path, spec)
    output.write_image(np.ascontiguousarray(pixels, np.float32))
    output.close()


class Bench:
    def __init__(self, swaplight, shared, work):
        self.swaplight, self.shared, self.work = swaplight, shared, work

    def run(self, *words):
        return subprocess.run([self.swaplight, *words], check=True, stdout=subprocess.PIPE, text=True).stdout

    def solved(self, name):
        folder = os.path.join(self.work, name.replace('/', '_') + '_noisy')
        path = os.path.join(folder, 'solved.exr')
        if not os.path.exists(path):
            subprocess.run([os.path.join(self.shared, 'tools/compose.py'), os.path.join(self.shared, 'captures', name), folder,
                            '--noise', NOISY], check=True, stdout=subprocess.DEVNULL)
            self.run('solve', os.path.join(folder, 'capture.json'), '-q', '-o', path)
        return path

    def difference(self, test, truth, where):
        """Mean CIEDE2000 over the pixels chosen, displayed as the whole picture is."""
        files = [os.path.join(self.work, f) for f in ('test.exr', 'truth.exr')]
        write(files[0], np.where(where[..., None], test, truth))
        write(files[1], truth)
        said = json.loads(self.run('evaluate', *files, '--metric', 'de2000', '--json'))
        return said['de2000']['mean'] * where.size / where.sum()

    def without_shadows(self, solved, light):
        edits, frame = os.path.join(self.work, 'edits.json'), os.path.join(self.work, 'frame.exr')
        with open(edits, 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1,
                       'edits': [{'lights': [light], 'operation': 'shadow', 'kind': 'lighten'}]}, file)
        self.run('relight', solved, '--edits', edits, '-o', frame, '--type', 'float', '-q')
        return rgb(read(frame))


def by_beta(set_, light, umbra):
    """The frame with what lies below the best threshold on beta lit as the median pixel above it is."""
    beta, own = set_[f'beta.{light}'], rgb(set_, light + '.')
    white = rgb(set_)
    threshold = max(np.linspace(.01, .5, 50), key=lambda t: iou(beta < t, umbra))
    others = white - own
    lit = (beta >= threshold) & (beta < 1)
    if not lit.any():
        return white
    middle = np.median(beta[lit])
    return np.where((beta < threshold)[..., None], others / (1 - middle), white)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('swaplight')
    arguments.add_argument('shared')
    arguments.add_argument('unshadowed')
    arguments.add_argument('--seeds', default='1,2,3,4,5,6,7,8,9,10')
    arguments.add_argument('--keep')
    a = arguments.parse_args()
    bench = Bench(a.swaplight, a.shared, a.keep or tempfile.mkdtemp())
    print('| set | light | umbra | nothing | by beta | removed | around: nothing | by beta | removed | elsewhere: nothing | by beta | removed |')
    print('|---|---|---|---|---|---|---|---|---|---|---|---|')
    told = []
    for seed in a.seeds.split(','):
        name = f'random/random_{seed}'
        captures = os.path.join(a.shared, 'captures', name)
        solved = bench.solved(name)
        set_ = read(solved)
        names = [c[5:] for c in set_ if c.startswith('beta.')]
        truths = {light: rgb(read(os.path.join(captures, f'T_{light}.exr'))) for light in names}
        for light in names:
            shadow = read(os.path.join(captures, f'shadow_{light}.exr'))
            reach = shadow['A'] > .5
            umbra = (shadow['Y'] < .02) & reach
            if umbra.mean() < LEAST_UMBRA:
                continue
            around = grown(umbra, AROUND) & ~umbra & reach
            truth = sum(truths[other] for other in names if other != light)
            truth = truth + rgb(read(os.path.join(a.unshadowed, f'random_{seed}', f'unshadowed_{light}.exr')))
            row = dict(seed=seed, light=light, umbra=umbra.mean())
            for method, frame in (('nothing', rgb(set_)), ('beta', by_beta(set_, light, shadow['Y'] < .02)),
                                  ('removed', bench.without_shadows(solved, light))):
                row[method], row[method + '_around'], row[method + '_elsewhere'] = (
                    bench.difference(frame, truth, zone) for zone in (umbra, around, ~(umbra | around)))
            told.append(row)
            mark = '*' if name in KEPT_BACK else ''
            print(f'| random {seed}{mark} | {light} | {row["umbra"]:.1%} | ' + ' | '.join(
                f'{row[method + zone]:.2f}' for zone in ('', '_around', '_elsewhere') for method in ('nothing', 'beta', 'removed')) + ' |', flush=True)
    print()
    for title, rows in (('Kept back', [r for r in told if f'random/random_{r["seed"]}' in KEPT_BACK]),
                        ('Others', [r for r in told if f'random/random_{r["seed"]}' not in KEPT_BACK])):
        if rows:
            mean = {k: np.mean([r[k] for r in rows]) for k in rows[0] if k not in ('seed', 'light')}
            print(f'{title}: {len(rows)} lights, umbra {mean["nothing"]:.2f} -> {mean["removed"]:.2f} (by beta {mean["beta"]:.2f}), '
                  f'around {mean["nothing_around"]:.2f} -> {mean["removed_around"]:.2f} (by beta {mean["beta_around"]:.2f}), elsewhere '
                  f'{mean["nothing_elsewhere"]:.2f} -> {mean["removed_elsewhere"]:.2f} (by beta {mean["beta_elsewhere"]:.2f}); '
                  f'better than nothing {sum(r["removed"] < r["nothing"] for r in rows)}, '
                  f'than beta {sum(r["removed"] < r["beta"] for r in rows)}')


if __name__ == '__main__':
    main()

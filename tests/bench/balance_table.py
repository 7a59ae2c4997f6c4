#!/usr/bin/python3
"""How well lamps are read from a photograph and photographs are balanced: the tables of docs/balance.md.

usage: balance_table.py SWAPLIGHT SHARED [--tables lamps,white,swaps,errors] [--max-size 480] [--keep FOLDER]

lamps: tables 6.1 and 6.2 of the dissertation: the second lamp's colour (and, by `lights`, the first's) in 8-bit codes,
error = Euclidean distance. Of two swapped photographs and a known beta: mean over all pixels and mode (in bins of 3
codes, over those that tell: beta off 1/2, not dark) of l_1 B / A, as published, least squares, and maximum likelihood; of one
photograph of the solved set: `swaplight lights`.
errors: how often two standard errors of `lights` cover the truth.
white: mean CIEDE2000 and angular error (degrees) against every lamp white at its own luminance.
swaps: the same on gels really swapped, balanced to white. The truth is the sum of photographs with each lamp white:
(w_r + r_w + w_b + b_w - r_b - b_r) / 2, by linearity; both pictures at one luminance a pixel, since lamps keep theirs;
pixels above a twentieth of the brightest, since the truth has the noise of six photographs.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

WEIGHTS = np.array([.2126, .7152, .0722])
NOISES = {'20,000/.002': (20000, .002), '3,000/.005': (3000, .005)}
DISSERTATION = {(91, 138, 240): (8.48, 6.40), (160, 160, 50): (14.46, 8.37), (115, 50, 110): (9.64, 4.12),
                (175, 50, 70): (6.63, 4.36), (175, 210, 212): (8.25, 3.00)}
FIRST = (255, 197, 143)
METHODS = ('grey-world', 'max-rgb', 'shades-of-grey', 'grey-edge', 'grey-edge-2', 'ebner', 'xphoto-simple',
           'xphoto-grey-world', 'xphoto-learning')


def linear(codes):
    x = np.asarray(codes, float) / 255
    return np.where(x <= .04045, x / 12.92, ((x + .055) / 1.055) ** 2.4)


def codes(light):
    x = np.clip(light, 0, None)
    return 255 * np.where(x <= .0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - .055)


LAMPS = {'255,197,143 + 201,226,255': (linear(FIRST), linear((201, 226, 255))),
         'R4660 + R89': (np.array([.701, .227, .133]), np.array([.023, .376, .114])),
         'R4660 + 91,138,240': (np.array([.701, .227, .133]), linear((91, 138, 240)))}


def read(path):
    source = oiio.ImageInput.open(path)
    spec = source.spec()
    pixels = np.asarray(source.read_image('float')).reshape(spec.height, spec.width, spec.nchannels)
    source.close()
    return {name: pixels[..., i].astype(float) for i, name in enumerate(spec.channelnames)}


def rgb(path, layer=''):
    channels = read(path)
    return np.stack([channels[(layer + '.' if layer else '') + c] for c in 'RGB'], -1)


def write(path, pixels):
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, 'float')
    output = oiio.ImageOutput.create(path)
    output.open(path, spec)
    output.write_image(np.ascontiguousarray(pixels, np.float32))
    output.close()
    return path


class Bench:
    def __init__(self, arguments):
        self.a = arguments
        self.work = arguments.keep or tempfile.mkdtemp()
        self.random = np.random.default_rng(1)
        sys.path.insert(0, os.path.join(arguments.shared, 'tools'))

    def run(self, *arguments):
        result = subprocess.run([self.a.swaplight, *arguments, '--json', '-q'], capture_output=True, text=True)
        if result.returncode:
            sys.exit(result.stderr)
        return json.loads(result.stdout or '{}')

    def noisy(self, picture, noise):
        well, dark = NOISES[noise]
        return picture + self.random.normal(size=picture.shape) * np.sqrt(np.maximum(picture, 0) / well + dark ** 2)

    def noise(self, noise):
        return 'read={1},full_well={0}'.format(*NOISES[noise])

    def solved(self, name, noise):
        """A set's folder, its file, its true contributions."""
        folder = os.path.join(self.work, (name + '_' + noise).translate(str.maketrans('/,.', '___')))
        solved = os.path.join(folder, 'solved.exr')
        if not os.path.exists(solved):
            subprocess.run([os.path.join(self.a.shared, 'tools/compose.py'), os.path.join(self.a.shared, 'captures', name),
                            folder, '--noise', self.noise(noise), '--max-size', str(self.a.max_size)], check=True,
                           stdout=subprocess.DEVNULL)
            self.run('solve', os.path.join(folder, 'capture.json'), '-o', solved)
        with open(os.path.join(folder, 'capture.json')) as file:
            truth = json.load(file)['truth']
        return folder, solved, list(truth), np.stack([rgb(os.path.join(folder, path)) for path in truth.values()])

    def lights(self, solved, photo, noise, names):
        said = self.run('lights', solved, photo, '--noise', self.noise(noise))
        lamps = [said['lights'][name] for name in names]
        return np.array([lamp['color'] for lamp in lamps]), np.array([lamp['standard_error'] for lamp in lamps])

    def two_shots(self, solved, truth, names, second, noise):
        """l_2 by the dissertation's methods: mean, mode; least squares; and maximum likelihood."""
        first, beta = linear(FIRST), read(solved)['beta.' + names[0]][..., None]
        one, two = (self.noisy(np.einsum('ic,ihwc->hwc', pair, truth), noise)
                    for pair in ((first, second), (second, first)))
        a, b = one * beta - two * (1 - beta), two * beta - one * (1 - beta)
        with np.errstate(all='ignore'):
            pixels = codes(np.clip(np.nan_to_num(first * b / a), 0, 1)).reshape(-1, 3)
        told = ((np.abs(2 * beta - 1) > .2) & (one.mean(-1, keepdims=True) > .02)).ravel()
        inner = [channel[(channel > 2) & (channel < 253)] for channel in pixels[told].T]
        mode = [np.histogram(channel, 85, (0, 255))[0].argmax() * 3 + 1.5 for channel in inner]
        squares = codes(first * (a * b).sum((0, 1)) / (a * a).sum((0, 1)))
        return np.mean(pixels, 0), np.array(mode), squares, codes(self.likeliest(one, two, beta, first, NOISES[noise]))

    @staticmethod
    def likeliest(one, two, beta, first, noise):
        """l_2 by maximum likelihood: with the reflectance that is the likeliest for it put in, each pixel leaves
        (C_1 p_2 - C_2 p_1)^2 over its variance, p the light that l_1 and l_2 bring to it in either photograph."""
        well, dark = noise
        found = []
        for c, known in enumerate(first):
            b, seen = beta[..., 0], np.stack([one[..., c], two[..., c]])

            def left(second, before):
                light = np.stack([b * known + (1 - b) * second, b * second + (1 - b) * known])
                guess = np.stack([b * known + (1 - b) * before, b * before + (1 - b) * known])
                signal = np.maximum((seen * guess).sum(0) / (guess * guess).sum(0), 0) * guess
                variance = signal / well + dark ** 2
                return ((seen[0] * light[1] - seen[1] * light[0]) ** 2
                        / (variance[0] * light[1] ** 2 + variance[1] * light[0] ** 2)).sum()
            best, step = .5, .5
            for _ in range(12):
                tried = np.clip(best + step * np.linspace(-1, 1, 11), 1e-4, 2)
                best, step = tried[np.argmin([left(value, best) for value in tried])], step / 2.5
            found.append(best)
        return np.array(found)

    def lamps(self):
        for noise in NOISES:
            folder, solved, names, truth = self.solved('spheres', noise)
            print(f'\n| full well/read {noise}: second lamp | mean, published | mode, published | mean | mode | least squares '
                  '| maximum likelihood | `lights` | `lights`, first lamp |\n|---|---|---|---|---|---|---|---|---|')
            rows = []
            for second, published in DISSERTATION.items():
                pair = np.array([linear(FIRST), linear(second)])
                photo = write(os.path.join(folder, 'photo.exr'), self.noisy(np.einsum('ic,ihwc->hwc', pair, truth), noise))
                found, _ = self.lights(solved, photo, noise, names)
                of = lambda value: np.linalg.norm(value - np.array(second))
                row = [*published, *map(of, self.two_shots(solved, truth, names, pair[1], noise)), of(codes(found[1])),
                       np.linalg.norm(codes(found[0]) - np.array(FIRST))]
                rows.append(row)
                print(f'| {",".join(map(str, second))} | ' + ' | '.join(f'{e:.2f}' for e in row) + ' |')
            print('| mean | ' + ' | '.join(f'{e:.2f}' for e in np.mean(rows, 0)) + ' |')
            sys.stdout.flush()

    def errors(self):
        print('\n| set | lights | noise | error of a lamp, codes: mean, most | within two standard errors |\n|---|---|---|---|---|')
        for name in self.a.sets.split(','):
            for noise in NOISES:
                folder, solved, names, truth = self.solved(name, noise)
                covered, distances = [], []
                for _ in range(6):
                    lamps = self.random.uniform(.05, 1, (len(names), 3))
                    photo = write(os.path.join(folder, 'photo.exr'),
                                  self.noisy(np.einsum('ic,ihwc->hwc', lamps, truth), noise))
                    found, error = self.lights(solved, photo, noise, names)
                    covered.append(np.abs(found - lamps) < 2 * error)
                    distances += list(np.linalg.norm(codes(found) - codes(lamps), axis=1))
                print(f'| {name} | {len(names)} | {noise} | {np.mean(distances):.2f}, {np.max(distances):.2f} '
                      f'| {np.mean(covered):.0%} |')
                sys.stdout.flush()

    def score(self, picture, truth, same_luminance=False):
        from score import de2000, lab
        if same_luminance:
            truth = truth * ((picture @ WEIGHTS) / np.maximum(truth @ WEIGHTS, 1e-6))[..., None]
        scale = .9 / np.percentile(truth, 99.5)
        bright = truth @ WEIGHTS > (.05 * np.percentile(truth @ WEIGHTS, 99.5) if same_luminance else -1)
        length = np.linalg.norm(picture, axis=-1) * np.linalg.norm(truth, axis=-1)
        seen = (length > 1e-6) & bright
        angle = np.degrees(np.arccos(np.clip((picture * truth).sum(-1)[seen] / length[seen], -1, 1)))
        return de2000(lab(picture * scale), lab(truth * scale))[bright].mean(), angle.mean()

    def every_way(self, photo, solved, given):
        out = os.path.join(self.work, f'balanced_{os.getpid()}.exr')  # others may use the folder
        yield 'nothing', rgb(photo)
        for method in METHODS:
            self.run('balance', photo, '--method', method, '-o', out)
            yield method, rgb(out)
        if given is not None:
            self.run('balance', photo, '--colors', ','.join('/'.join(f'{v:.6g}' for v in lamp) for lamp in given), '-o', out)
            yield 'two colours, no set (`--colors`)', rgb(out)
        self.run('balance', photo, '--beta', solved, '-o', out)
        yield 'a solved set (`--beta`), lamps read', rgb(out)

    def white(self):
        for name in ('spheres', *[s for s in self.a.sets.split(',') if s != 'spheres']):
            folder, solved, names, truth = self.solved(name, '20,000/.002')
            table = {}
            for title, pair in LAMPS.items():
                lamps = np.array([pair[i % 2] for i in range(len(names))])
                picture = self.noisy(np.einsum('ic,ihwc->hwc', lamps, truth), '20,000/.002')
                photo = write(os.path.join(folder, 'photo.exr'), picture)
                wanted = np.einsum('i,ihwc->hwc', lamps @ WEIGHTS, truth)
                for way, balanced in self.every_way(photo, solved, pair):
                    table.setdefault(way, []).append('{:.1f} / {:.1f}'.format(*self.score(balanced, wanted)))
            print(f'\n| {name} | ' + ' | '.join(LAMPS) + ' |\n|---' * 1 + '|---' * len(LAMPS) + '|')
            for way, cells in table.items():
                print(f'| {way} | ' + ' | '.join(cells) + ' |')
            sys.stdout.flush()

    def swaps(self):
        table, scenes = {}, ('bmug', 'diff', 'lion', 'spdif')
        for scene in scenes:
            folder = os.path.join(self.a.shared, 'captures', 'swapped_' + scene)
            pictures = {pair: rgb(os.path.join(folder, f'photo_{pair}.exr'))
                        for pair in ('w_r', 'r_w', 'w_b', 'b_w', 'r_b', 'b_r')}
            wanted = sum(pictures[p] for p in ('w_r', 'r_w', 'w_b', 'b_w')) / 2 - (pictures['r_b'] + pictures['b_r']) / 2
            solved = os.path.join(self.work, f'swapped_{scene}_w_b.exr')
            if not os.path.exists(solved):
                self.run('solve', os.path.join(folder, 'capture_w_b.json'), '-o', solved)
            with open(os.path.join(folder, 'capture_w_b.json')) as file:
                given = {t['image']: t['light_colors'] for t in json.load(file)['relight_tests']}['photo_r_b.exr']
            for way, balanced in self.every_way(os.path.join(folder, 'photo_r_b.exr'), solved, given):
                table.setdefault(way, []).append(self.score(balanced, np.maximum(wanted, 0), True))
        print('\n| photograph r_b, solved from w_b and b_w | ' + ' | '.join(scenes) + ' | mean |\n|---' + '|---' * 5 + '|')
        for way, scores in table.items():
            print(f'| {way} | ' + ' | '.join('{:.2f} / {:.2f}'.format(*s) for s in [*scores, np.mean(scores, 0)]) + ' |')


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('swaplight')
    arguments.add_argument('shared')
    arguments.add_argument('--tables', default='lamps,errors,white,swaps')
    arguments.add_argument('--sets', default='spheres,portrait3,random/random_3,random/random_8')
    arguments.add_argument('--max-size', type=int, default=480)
    arguments.add_argument('--keep', help='a folder in which solved sets are kept')
    bench = Bench(arguments.parse_args())
    for table in bench.a.tables.split(','):
        getattr(bench, table)()


if __name__ == '__main__':
    main()

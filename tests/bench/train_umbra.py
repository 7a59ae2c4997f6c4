#!/usr/bin/python3
"""Fits the weights by which evidence for umbra is weighed (core/shadow/odds/umbra_weights.h).

usage: train_umbra.py SHADOW_BENCH OUTPUT --keep FOLDER SET... [--kept-back SET...]

SET: a folder with T_<light>.exr and shadow_<light>.exr (../shared/captures/README.md). The features of each
(tests/bench/shadow_bench.cpp), without noise and with that of shots, are fitted to what each pixel sees of the light:
umbra (less than .02), penumbra, lit (more than .98). A network of one hidden layer, cross entropy, Adam (Kingma and Ba
2015); noise is added to the features, so that no weight rests on a fine difference of a few sets. Every light counts
alike; within a light umbra counts by the square root of its share, so that small shadows are not given up.

A quarter of the sets is left out by turns, and told by what the others give: the temperature and the offsets of the
classes that make the odds of sets left out as sure as they are right, every pixel counting alike (Guo et al., "On
calibration of modern neural networks", ICML 2017; with offsets Alexandari et al., ICML 2020), go into the weights.
Features are chosen by the same: those that say what a whole light or set is like made sets left out worse.

Weights in the source: random 1 to 5, and seeds 1001 to 1008 of ../shared/tools/scenes (--scene random --width 288
--samples 40). Sets that shadow_table.py calls kept back must not be among them; --kept-back only reports.
The same sets give the same weights.
"""
import argparse
import json
import os
import subprocess

import numpy as np

from shadow_table import read

HIDDEN, STEPS, BATCH, RATE, DECAY, NOISE = 24, 2000, 256, 3e-3, 3e-2, .6
SAMPLES = 2000  # pixels a light
FOLDS = 4
UMBRA, LIT = .02, .98


def shrunk(x, shape):
    factor = -(-x.shape[0] // shape[0])
    padded = np.pad(x, [(0, n * factor - m) for n, m in zip(shape, x.shape)], 'edge')
    return padded.reshape(shape[0], factor, shape[1], factor).mean((1, 3))


def lights_of(bench, folder, keep):
    """(name, features, visibility) of each light of a set, without and with noise."""
    for noise in '01':
        raw = os.path.join(keep, folder.strip('/').replace('/', '_') + '_' + noise)
        if not os.path.exists(raw + '.json'):
            sizes = subprocess.run([bench, folder, noise, raw], check=True, capture_output=True, text=True).stdout
            open(raw + '.json', 'w').write(sizes)
        sizes = json.load(open(raw + '.json'))
        shape = sizes['height'], sizes['width']
        pixels = np.fromfile(raw, np.float32).reshape(len(sizes['lights']), sizes['features'], -1)
        for light, features in zip(sizes['lights'], pixels):
            yield light, features, shrunk(read(os.path.join(folder, f'shadow_{light}.exr'))['Y'], shape).ravel()


def kind_of(visible):
    return np.where(visible < UMBRA, 0, np.where(visible > LIT, 2, 1))


def sample(features, visible, rng):
    kind = kind_of(visible)
    share = np.sqrt((kind == 0).mean())
    umbra = share / (share + np.sqrt(1 - (kind == 0).mean()))
    for where, part in ((kind == 0, umbra), (kind != 0, 1 - umbra)):
        some = np.flatnonzero(where)
        chosen = rng.choice(some, min(int(SAMPLES * part), len(some)), replace=False)
        yield features[:, chosen].T, kind[chosen]


class Network:
    """Fitted to x (pixels, features) and their kinds."""

    def __init__(self, x, kind, rng):
        self.least, self.most = np.percentile(x, [.5, 99.5], axis=0)
        clipped = np.clip(x, self.least, self.most)
        self.mean, self.spread = clipped.mean(0), clipped.std(0) + 1e-6
        self.temperature, self.offsets = 1, np.zeros(3)
        x = ((clipped - self.mean) / self.spread).astype(np.float32)
        sizes = [(x.shape[1], HIDDEN), (HIDDEN, 3)]
        self.weights = [rng.normal(0, np.sqrt(2 / a), (a, b)) for a, b in sizes] + [np.zeros(HIDDEN), np.zeros(3)]
        first, second = ([np.zeros_like(w) for w in self.weights] for _ in range(2))
        for step in range(STEPS):
            chosen = rng.integers(0, len(x), BATCH)
            slopes = self.slopes(x[chosen] + NOISE * rng.standard_normal((BATCH, x.shape[1])), kind[chosen])
            rate = RATE * .5 * (1 + np.cos(np.pi * step / STEPS))
            for i, slope in enumerate(slopes):
                first[i] = .9 * first[i] + .1 * slope
                second[i] = .999 * second[i] + .001 * slope ** 2
                gain = np.sqrt(1 - .999 ** (step + 1)) / (1 - .9 ** (step + 1))
                self.weights[i] -= rate * gain * first[i] / (np.sqrt(second[i]) + 1e-8)
                if i < 2:
                    self.weights[i] *= 1 - rate * DECAY

    def slopes(self, x, kind):
        w1, w2, b1, b2 = self.weights
        hidden = np.maximum(x @ w1 + b1, 0)
        error = (softmax(hidden @ w2 + b2) - np.eye(3)[kind]) / len(x)
        back = (error @ w2.T) * (hidden > 0)
        return x.T @ back, hidden.T @ error, back.sum(0), error.sum(0)

    def scores(self, x):
        w1, w2, b1, b2 = self.weights
        x = (np.clip(x, self.least, self.most) - self.mean) / self.spread
        return (np.maximum(x @ w1 + b1, 0) @ w2 + b2) / self.temperature + self.offsets


def softmax(scores):
    chance = np.exp(scores - scores.max(1, keepdims=True))
    return chance / chance.sum(1, keepdims=True)


def surprise(scores, kind):
    return -np.log(softmax(scores)[np.arange(len(kind)), kind] + 1e-9).mean()


def calibrated(scores, kind):
    """The temperature and the offsets by which scores surprise least: gradient descent."""
    sharpness, offsets = 1., np.zeros(3)
    truth = np.eye(3)[kind]
    for _ in range(400):
        error = softmax(scores * sharpness + offsets) - truth
        sharpness -= .05 * (error * scores).sum(1).mean()
        offsets -= .5 * error.mean(0)
    return 1 / sharpness, offsets - offsets.mean()


def told(title, network, lights):
    """Says how well lights (features, visibility) are told, pixel by pixel, before any cut."""
    rows = []
    for features, visible in lights:
        scores = network.scores(features.T)
        chance, kind = softmax(scores), kind_of(visible)
        umbra = kind == 0
        said = chance[:, 0] > .5
        sure = chance[:, 0] > .7
        rows.append([(said & umbra).sum() / max((said | umbra).sum(), 1) if umbra.mean() > .002 else np.nan,
                     (sure & (kind == 2)).mean(), surprise(scores, kind)])
    rows = np.array(rows)
    umbra, false, loss = np.nanmean(rows, 0)
    print(f'{title}: {len(rows)} lights, umbra {umbra:.3f}, false {false:.2%}, more than 2 %: '
          f'{(rows[:, 1] > .02).sum()}, cross entropy {loss:.3f}', flush=True)


def written(network, names):
    w1, w2, b1, b2 = network.weights
    w1 = w1 / network.spread[:, None]
    b1 = b1 - network.mean @ w1
    w2, b2 = w2 / network.temperature, b2 / network.temperature + network.offsets

    def row(values):
        texts = (f'{v:.4g}' for v in values)
        return '{' + ', '.join(t + ('f' if '.' in t or 'e' in t else '.f') for t in texts) + '}'

    def table(rows):
        return '{{' + ',\n    '.join(row(r) for r in rows) + '}}'
    return f'''// clang-format off
// Made by tests/bench/train_umbra.py: do not edit. Fitted to: {names}.
#pragma once

#include <array>
#include <cstddef>

namespace swaplight::umbra_weights {{

// A row a feature, in the order of umbraFeatureNames(); the last tables are calibrated on sets left out.
inline constexpr size_t kFeatures = {len(w1)}, kHidden = {HIDDEN};
// Features beyond what was seen count as the last that was.
inline constexpr std::array<float, kFeatures> kLeast = {row(network.least)};
inline constexpr std::array<float, kFeatures> kMost = {row(network.most)};
inline constexpr std::array<float, kHidden> kHiddenBias = {row(b1)};
inline constexpr std::array<std::array<float, kHidden>, kFeatures> kHiddenWeights = {table(w1)};
inline constexpr std::array<float, 3> kOutputBias = {row(b2)};
inline constexpr std::array<std::array<float, 3>, kHidden> kOutputWeights = {table(w2)};

}}  // namespace swaplight::umbra_weights
'''


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('bench')
    arguments.add_argument('output')
    arguments.add_argument('sets', nargs='+')
    arguments.add_argument('--keep', required=True)
    arguments.add_argument('--kept-back', nargs='*', default=[])
    a = arguments.parse_args()
    rng = np.random.default_rng(1)
    parts, fold, left_out = [], [], []
    for n, folder in enumerate(a.sets):
        for _, features, visible in lights_of(a.bench, folder, a.keep):
            some = list(sample(features, visible, rng))
            parts += some
            fold += [np.full(len(s[1]), n % FOLDS) for s in some]
            left_out.append((n % FOLDS, features[:, ::37], visible[::37]))
    x, kind = (np.concatenate(p) for p in zip(*parts))
    fold = np.concatenate(fold)

    scores, kinds = [], []
    for k in range(FOLDS):
        network = Network(x[fold != k], kind[fold != k], rng)
        some = [(f, v) for n, f, v in left_out if n == k]
        told(f'left out, {k + 1} of {FOLDS}', network, some)
        scores += [network.scores(f.T) for f, _ in some]
        kinds += [kind_of(v) for _, v in some]
    scores, kinds = np.concatenate(scores), np.concatenate(kinds)
    temperature, offsets = calibrated(scores, kinds)
    print(f'temperature {temperature:.2f}, offsets {offsets.round(2)}: cross entropy {surprise(scores, kinds):.3f} to '
          f'{surprise(scores / temperature + offsets, kinds):.3f}')

    network = Network(x, kind, rng)
    network.temperature, network.offsets = temperature, offsets
    told('fitted', network, [(f, v) for _, f, v in left_out])
    for folder in a.kept_back:
        told('kept back: ' + os.path.basename(folder), network,
             [(f[:, ::23], v[::23]) for _, f, v in lights_of(a.bench, folder, a.keep)])
    names = ', '.join(os.path.basename(s.strip('/')) for s in a.sets)
    with open(a.output, 'w') as out:
        out.write(written(network, names))


if __name__ == '__main__':
    main()

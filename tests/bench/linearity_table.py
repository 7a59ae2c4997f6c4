#!/usr/bin/python3
"""Whether `swaplight linear` tells a tone curve from light: a row a set.

usage: linearity_table.py SWAPLIGHT SHARED [--sets A,B] [--size 240]

Photographs of cause_table.py: two lights, gels swapped, the noise not told. `+` beside them: each lamp alone, and both
together. A cell: yes, no or ? (cannot be told).
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import cause_table
import numpy as np
from solve_table import one_light_sets

CASES = ('clean 8 bit', 'ambient 1.4 %', 'tone S mild', 'tone S strong', 'tone gamma .9')


def answer(program, capture):
    result = subprocess.run([program, 'linear', capture, '--json', '-q'], capture_output=True, text=True)
    if result.returncode:
        sys.exit(result.stderr)
    return {True: 'yes', False: 'no', None: '?'}[json.loads(result.stdout)['linear']]


def alone_and_together(truth, ambient, names, case, out):
    """The same set, one lamp after the other and both at once."""
    size, bits = cause_table.CASES[case]
    rng = np.random.default_rng(1)
    shots = []
    for k, on in enumerate(((1, 0), (0, 1), (1, 1))):
        light = .95 * np.einsum('i,ihwc->hwc', on, truth) + (size * ambient if case.startswith('ambient') else 0)
        name = f'shot_{k + 1}.' + ('png' if bits else 'exr')
        cause_table.write(f'{out}/{name}', cause_table.coded(light, case, size, bits, rng))
        shots.append({'image': name, 'light_colors': [[level] * 3 for level in on]})
    with open(f'{out}/capture.json', 'w') as file:
        json.dump({'format': 'swaplight-capture', 'version': 1, 'name': 'set',
                   'color_space': 'srgb' if bits else 'lin_rec709', 'lights': [{'name': name} for name in names],
                   'shots': shots}, file)
    return f'{out}/capture.json'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('swaplight')
    parser.add_argument('shared')
    parser.add_argument('--sets')
    parser.add_argument('--size', type=int, default=240)
    options = parser.parse_args()
    sets = one_light_sets(os.path.join(options.shared, 'captures'))
    print('| set | ' + ' | '.join(CASES) + ' |\n|---' + '|---' * len(CASES) + '|')
    for label in options.sets.split(',') if options.sets else sets:
        folder, lights = sets[label]
        truth, ambient = cause_table.load(folder, lights[:2], options.size)
        cells = []
        for case in CASES:
            found = []
            for make in (cause_table.compose, alone_and_together):
                with tempfile.TemporaryDirectory() as work:
                    found.append(answer(options.swaplight, make(truth, ambient, lights[:2], case, work)))
            cells.append('{}, + {}'.format(*found))
        print(f'| {label} | ' + ' | '.join(cells) + ' |', flush=True)


if __name__ == '__main__':
    main()

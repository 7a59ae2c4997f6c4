#!/usr/bin/python3
"""How well lamps are placed by how surfaces are turned: a table over rendered sets whose lamps really stood elsewhere.

usage: place_table.py SWAPLIGHT SHARED FOLDER [--seeds 1,2,...] [--widths 3] [--lamps 5] [--wrong 0] [--picture FILE.jpg]

FOLDER/random_SEED holds the renders of render_placed.py; what is missing is rendered (blender, a quarter of a minute a set).
The set is photographed with one lamp at a time, noise .002 and a full well of 20,000, and solved. The lamps' places are told,
with --wrong degrees of error each, and metered. Mean CIEDE2000 of one lamp's light alone, the truth's 99.5th percentile at .9:

moved: nothing  lamp1 where it stood, 43 degrees from where it has to come to
       level    the same with the level that suits best
       placed   after the edit `place`
new:   flat     a lamp that was not there, as all lamps together, with the level that suits best
       placed   after the edit `place`, with the level that suits best (the program gives it that of the strongest lamp)
picture: of the last set: lamp1 as it was, placed, the truth; the new lamp, and its truth
guess           what the program says is a guess; a set whose walls keep lamps out is left out
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio
from normals_table import solved_set, told

HERE = os.path.dirname(os.path.abspath(__file__))
LEAST_LIT = .3  # of the picture, above a hundredth of the lamp's brightest: else a wall is in the way


def read(path):
    oiio.ImageCache().invalidate(path)
    return oiio.ImageBuf(path).get_pixels(oiio.FLOAT)[..., :3].astype(float)


def rendered(shared, seed, widths, folder):
    out = os.path.join(folder, f'random_{seed}')
    if not os.path.exists(out + '/places.json'):
        subprocess.run(['nice', 'blender', '-b', '-P', os.path.join(HERE, 'render_placed.py'), '--', shared, str(seed), '64',
                        str(widths), out], check=True, stdout=subprocess.DEVNULL)
    with open(out + '/places.json') as file:
        places = json.load(file)['places']
    return {name: read(f'{out}/T_{name}.exr') for name in places}, places


def score(picture, truth):
    from score import de2000, lab  # of SHARED/tools
    scale = .9 / np.percentile(truth, 99.5)
    return de2000(lab(picture * scale), lab(truth * scale)).mean()


def best(picture, truth):
    return min(score(picture * level, truth) for level in np.exp2(np.linspace(-1.5, 1.5, 25)))


def edited(program, solved, light, place, places, widths, folder):
    """The light alone after the edit, and what of it is a guess; nothing where the program refuses."""
    names = list(places)
    file = {'format': 'swaplight-edits', 'version': 1, 'new_lights': [] if light in names else [light],
            'lamp_places': {name: {'azimuth': float(a), 'elevation': float(e), 'distance': widths, 'stops': 0}
                            for name, (a, e) in places.items()},
            'edits': [{'name': 'placed', 'lights': [light], 'operation': 'place', 'azimuth': place[0], 'elevation': place[1],
                       'distance': widths}]}
    with open(folder + '/edits.json', 'w') as out:
        json.dump(file, out)
    frame = folder + '/frame.exr'
    dark = [text for name in names if name != light for text in ('--light', name + '=off')]
    done = subprocess.run([program, 'relight', solved, '--edits', folder + '/edits.json', *dark, '-o', frame],
                          capture_output=True, text=True)
    if 'no lamp can be placed' in done.stderr:
        return None
    done.check_returncode()
    guess = re.search(r'guess on (\d+) %', done.stdout + done.stderr)
    return read(frame), int(guess[1]) if guess else 0


def write_picture(path, pictures, truth):
    """A row, as sRGB codes."""
    row = np.clip(np.concatenate(pictures, 1) * .9 / np.percentile(truth, 99.5), 0, 1)
    row = np.where(row <= .0031308, 12.92 * row, 1.055 * np.maximum(row, 1e-9) ** (1 / 2.4) - .055)
    spec = oiio.ImageSpec(row.shape[1], row.shape[0], 3, 'uint8')
    spec.attribute('Compression', 'jpeg:88')
    output = oiio.ImageOutput.create(path)
    output.open(path, spec)
    output.write_image(np.ascontiguousarray(row, np.float32))
    output.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('program')
    parser.add_argument('shared')
    parser.add_argument('folder')
    parser.add_argument('--seeds', default='1,2,3,4,5,6,7,8,9,10')
    parser.add_argument('--widths', type=float, default=3)
    parser.add_argument('--lamps', type=int, default=5)
    parser.add_argument('--wrong', type=float, default=0)
    parser.add_argument('--picture')
    arguments = parser.parse_args()
    sys.path.insert(0, os.path.join(arguments.shared, 'tools'))
    print('| set | moved: nothing | level | placed | new: flat | placed | guess |\n|---|---|---|---|---|---|---|')
    for seed in arguments.seeds.split(','):
        pictures, places = rendered(arguments.shared, int(seed), arguments.widths, arguments.folder)
        lamps = [f'lamp{k}' for k in range(arguments.lamps)]
        lit = [(pictures[name].mean(-1) > .01 * np.percentile(pictures[name], 99)).mean() for name in pictures]
        if min(lit) < LEAST_LIT:
            continue
        random = np.random.default_rng(int(seed))
        gain = .9 / np.percentile(sum(pictures[name] for name in lamps), 99.5)
        shots = [gain * pictures[name] for name in lamps]
        shots = [shot + random.normal(size=shot.shape) * np.sqrt(.002 ** 2 + shot / 20000) for shot in shots]
        said = {name: told(*places[name], random, arguments.wrong) for name in lamps}
        with tempfile.TemporaryDirectory() as folder:
            solved = solved_set(arguments.program, shots, folder)
            # The lamp is moved by as much as it really was, from where it is said to have stood.
            there = [said['lamp1'][k] + places['moved'][k] - places['lamp1'][k] for k in (0, 1)]
            placed = [edited(arguments.program, solved, light, place, said, arguments.widths, folder)
                      for light, place in (('lamp1', there), ('new', places['new']))]
        if None in placed:
            print(f'| `random_{seed}` | refused |', flush=True)
            continue
        (moved, guess), (new, _) = placed
        truth, sun = gain * pictures['moved'], gain * pictures['new']
        was, all_lamps = gain * pictures['lamp1'], gain * sum(pictures[name] for name in lamps)
        cells = [score(was, truth), best(was, truth), score(moved, truth), best(all_lamps, sun), best(new, sun)]
        if arguments.picture:
            write_picture(arguments.picture, [was, moved, truth, new, sun], truth)
        print(f'| `random_{seed}` | ' + ' | '.join(f'{cell:.2f}' for cell in cells) + f' | {guess} % |', flush=True)


if __name__ == '__main__':
    main()

"""What the command line finds of a light's shadows, for tests that click on them."""
import json
import os
import subprocess

import numpy as np

from studio import PROGRAM, read_float


def labels_of(capture, light, folder, *arguments):
    """height x width: 0 unknown, 1 umbra, 2 penumbra, 3 lit."""
    out = os.path.join(folder, 'shadows.exr')
    subprocess.run([PROGRAM, 'shadows', capture, '-o', out, '-q', *arguments], check=True)
    pixels, names = read_float(out)
    return np.rint(pixels[..., list(names).index(f'shadow_{light}.label')]).astype(int)


def missing_of(capture, light, folder):
    """height x width: how much brighter the set is without the light's shadows."""
    edits, frames = os.path.join(folder, 'lighten.json'), []
    with open(edits, 'w') as file:
        lighten = {'lights': [light], 'operation': 'shadow', 'kind': 'lighten'}
        json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': [lighten]}, file)
    for arguments in ((), ('--edits', edits)):
        out = os.path.join(folder, 'frame.exr')
        subprocess.run([PROGRAM, 'relight', capture, '-o', out, '-q', '--type', 'float', *arguments], check=True)
        frames.append(read_float(out)[0].mean(2))
    return frames[1] - frames[0]


def deepest(mask):
    """x, y of the middle of the largest square that lies wholly in the mask, and half its side."""
    sums = np.zeros((mask.shape[0] + 1, mask.shape[1] + 1), int)
    sums[1:, 1:] = mask.astype(int).cumsum(0).cumsum(1)
    best = None
    for half in range(1, 60):
        side = 2 * half + 1
        whole = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side] == side * side
        if not whole.any():
            break
        y, x = np.argwhere(whole)[0]
        best = (int(x) + half, int(y) + half, half)
    return best

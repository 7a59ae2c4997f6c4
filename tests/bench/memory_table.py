#!/usr/bin/python3
"""How much memory solve, relight and export hold, and how long they take: all in memory, and with --memory.

usage: memory_table.py SWAPLIGHT SHARED [--lights 16] [--width 7680] [--height 4320] [--memory 2] [--folder WORK] [--only-bounded]

The capture is made of SHARED/captures/random's pictures of one light, side by side and shaded anew for every light, with
noise, as half-float EXR: as many photographs as lights, of random colours. Whether both ways give the same bytes is said in
the last column.
"""
import argparse
import hashlib
import json
import os
import subprocess
import tempfile
import time

import numpy as np
import OpenImageIO as oiio

BAND = 540  # rows


def contributions(shared, most=8):
    pictures = []
    for name in ('random_9', 'random_1'):
        folder = os.path.join(shared, 'captures/random', name)
        pictures += [np.asarray(oiio.ImageBuf(os.path.join(folder, file)).get_pixels(oiio.FLOAT))[..., :3]
                     for file in sorted(os.listdir(folder)) if file.startswith('T_') and '@' not in file]
    pictures = pictures[:most]
    height, width = (min(picture.shape[axis] for picture in pictures) for axis in (0, 1))
    return [picture[:height, :width] for picture in pictures]


def make_capture(pictures, lights, width, height, folder):
    rng = np.random.default_rng(1)
    colors = rng.uniform(.1, .9, (lights, lights, 3))
    slopes = rng.uniform(-.4, .4, (lights, 2))
    high, wide = pictures[0].shape[:2]
    y, x = np.linspace(-1, 1, height)[:, None, None], np.linspace(-1, 1, width)[None, :, None]
    names = [f'shot_{k + 1}.exr' for k in range(lights)]
    files = []
    for name in names:
        spec = oiio.ImageSpec(width, height, 3, 'half')
        spec.attribute('compression', 'zips')
        files.append(oiio.ImageOutput.create(name))
        assert files[-1].open(os.path.join(folder, name), spec), oiio.geterror()
    for top in range(0, height, BAND):
        rows = np.arange(top, min(top + BAND, height))
        lit = []
        for i in range(lights):
            strip = np.tile(pictures[i % len(pictures)][rows % high], (1, -(-width // wide), 1))[:, :width]
            strip = strip if i < len(pictures) else strip[:, ::-1]
            lit.append((.15 * strip * (.6 + slopes[i, 0] * y[rows] + slopes[i, 1] * x)).astype(np.float32))
        for k, file in enumerate(files):
            shot = np.einsum('ic,ihwc->hwc', colors[k].astype(np.float32), np.stack(lit))
            noise = np.sqrt(1e-6 + np.maximum(shot, 0) / 40000)
            shot += noise * rng.standard_normal(shot.shape, np.float32)
            assert file.write_scanlines(top, top + len(rows), 0, np.ascontiguousarray(shot.astype(np.float16)))
    for file in files:
        file.close()
    manifest = {'format': 'swaplight-capture', 'version': 1, 'name': 'large', 'color_space': 'lin_rec709',
                'lights': [{'name': f'l{i + 1}', 'role': 'other'} for i in range(lights)],
                'shots': [{'image': name, 'light_colors': np.round(colors[k], 6).tolist()}
                          for k, name in enumerate(names)]}
    with open(os.path.join(folder, 'capture.json'), 'w') as file:
        json.dump(manifest, file)


def measured(program, *arguments):
    """Seconds by the clock, and the most GiB held. The system counts this process's own memory of what it starts, so the
    program's is asked for while it runs."""
    started, most = time.monotonic(), 0
    process = subprocess.Popen([program, *arguments, '-q'], stdout=subprocess.DEVNULL)
    while process.poll() is None:
        with open(f'/proc/{process.pid}/status') as file:
            most = max([most] + [int(line.split()[1]) for line in file if line.startswith('VmHWM')])
        time.sleep(.01)
    assert process.returncode == 0, arguments
    return time.monotonic() - started, most / 2 ** 20


def digest(path):
    hashed = hashlib.sha256()
    with open(path, 'rb') as file:
        while block := file.read(1 << 24):
            hashed.update(block)
    return hashed.hexdigest()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('swaplight')
    parser.add_argument('shared')
    parser.add_argument('--lights', type=int, default=16)
    parser.add_argument('--width', type=int, default=7680)
    parser.add_argument('--height', type=int, default=4320)
    parser.add_argument('--memory', default='2')
    parser.add_argument('--folder', help='where there is room for three times the set (default: the temporary folder)')
    parser.add_argument('--only-bounded', action='store_true', help='all in memory would not fit')
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=options.folder) as work:
        make_capture(contributions(options.shared), options.lights, options.width, options.height, work)
        solved = os.path.join(work, 'solved.exr')
        print('| verb | all in memory: s, GiB | --memory ' + options.memory + ': s, GiB | same bytes |\n|---|---|---|---|')
        for verb, source, name, *more in (('solve', work, 'solved.exr'), ('relight', solved, 'frame.exr', '--light', 'l1=50%'),
                                          ('relight', solved, 'frame.png'), ('export', solved, 'layers.exr')):
            out = os.path.join(work, name)
            usual, same = '', ''
            if not options.only_bounded:
                usual = '{:.1f}, {:.2f}'.format(*measured(options.swaplight, verb, source, '-o', out, *more))
                same = digest(out)
            bounded = '{:.1f}, {:.2f}'.format(
                *measured(options.swaplight, verb, source, '-o', out, *more, '--memory', options.memory))
            same = ('yes' if same == digest(out) else 'NO') if same else ''
            print(f'| {verb} {name} | {usual} | {bounded} | {same} |', flush=True)
            if verb != 'solve':
                os.remove(out)


if __name__ == '__main__':
    main()

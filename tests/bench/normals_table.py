#!/usr/bin/python3
"""How well normals are told: a table over the shapes of the rendered sets.

usage: normals_table.py SWAPLIGHT SHARED [--sets random/random_1,...] [--seeds 4]

The lamps of those sets stand so near (.3 to 1.5 widths of the picture) that normals are refused; so other lamps are made here,
of which the set's true normals and depth tell what they give: reflectance * (n.l falloff + .05), the .05 for bounced light,
noise .002, no cast shadows; reflectance is the set's own picture, .2 to .8. Three, four and five lamps that stand around the
camera, at 2, 3 and 10 widths of the picture. Places are told wrongly, each by 12 degrees in a random direction.

A cell: the mean angle to normal.exr in degrees over pixels that have a normal, and the share of pixels refused; the mean of
the seeds. Where the program refuses all of a set that is 100 %, and no angle. metered: with the lamps' true levels; bright: without. exact: metered, places told exactly.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

CHOSEN_ON = ('random/random_1', 'random/random_2', 'portrait3')
SETS = CHOSEN_ON + ('random/random_3', 'random/random_4', 'random/random_6', 'random/random_9', 'spheres')
LAMPS = {3: [(-50, 30), (45, 20), (10, 65)], 4: [(-60, 25), (50, 15), (0, 60), (10, 0)],
         5: [(-60, 25), (50, 15), (0, 60), (-20, -10), (30, 45)]}
DISTANCES = (2, 3, 10)
WRONG_DEGREES = 12


def read(path):
    return oiio.ImageBuf(path).get_pixels(oiio.FLOAT)


def write(path, pixels):
    height, width = pixels.shape[:2]
    output = oiio.ImageOutput.create(path)
    output.open(path, oiio.ImageSpec(width, height, 3, 'float'))
    output.write_image(np.ascontiguousarray(pixels, np.float32))
    output.close()


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)


def direction(azimuth, elevation):
    a, e = np.radians([azimuth, elevation])
    return np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])


def told(azimuth, elevation, random, degrees=WRONG_DEGREES):
    """The place as somebody says it who is wrong by that much."""
    right = direction(azimuth, elevation)
    aside = np.cross(right, random.normal(size=3))
    angle = np.radians(degrees)
    x, y, z = np.cos(angle) * right + np.sin(angle) * unit(aside)
    return np.degrees(np.arctan2(x, z)), np.degrees(np.arcsin(y))


class Shape:
    """A set's surfaces as its camera sees them: x to the right, y up, z towards the camera."""

    def __init__(self, folder):
        with open(folder + '/scene.json') as file:
            scene = json.load(file)
        camera = scene['camera']
        forward = unit(np.array(camera['forward']))
        right = unit(np.cross(forward, [0, 0, 1]))
        axes = np.stack([right, np.cross(right, forward), -forward])
        self.depth = read(folder + '/depth.exr')[..., 0]
        step = max(1, self.depth.shape[1] // 384)
        self.depth = self.depth[::step, ::step]
        self.normals = unit(read(folder + '/normal.exr')[::step, ::step, :3] @ axes.T)
        height, width = self.depth.shape
        slope = camera['sensor_width_mm'] / camera['lens_mm']
        x = ((np.arange(width) + .5) / width - .5) * slope
        y = (.5 * height - np.arange(height) - .5) / width * slope
        rays = np.stack([*np.meshgrid(x, y), -np.ones_like(self.depth)], -1)
        self.places = rays * self.depth[..., None]
        self.middle = np.median(self.depth[height // 4:3 * height // 4, width // 4:3 * width // 4])
        self.width = slope * self.middle
        self.seen = self.depth > 0
        sums = sum(read(f'{folder}/T_{light["name"]}.exr')[::step, ::step, :3] for light in scene['lights'])
        self.paint = .2 + .6 * np.minimum(sums / np.percentile(sums, 99), 1)

    def under(self, lamp, distance, random):
        """What a lamp gives at unit level."""
        way = np.array([0, 0, -self.middle]) + direction(*lamp) * distance * self.width - self.places
        length = np.linalg.norm(way, axis=-1)
        facing = np.maximum((way / length[..., None] * self.normals).sum(-1), 0)
        light = (distance * self.width / length) ** 2 * facing + .05
        light = self.paint * np.where(self.seen, light, 0)[..., None]
        return np.maximum(light + random.normal(0, .002, light.shape), 0)


def solved_set(program, pictures, folder):
    names = [f'lamp{k}' for k in range(len(pictures))]
    shots = []
    for k, picture in enumerate(pictures):
        write(f'{folder}/{k}.exr', picture)
        shots.append({'image': f'{k}.exr', 'light_colors': [[float(i == k)] * 3 for i in range(len(names))]})
    with open(folder + '/capture.json', 'w') as file:
        json.dump({'format': 'swaplight-capture', 'version': 1, 'name': 'made', 'color_space': 'lin_rec709',
                   'lights': [{'name': name} for name in names], 'shots': shots}, file)
    solved = folder + '/solved.exr'
    subprocess.run([program, 'solve', folder, '-o', solved, '--float', '--model', 'transport', '-q'], check=True,
                   stdout=subprocess.DEVNULL)
    return solved


def errors(program, solved, shape, lamps, distance, stops, folder):
    """The mean angle, and the share refused."""
    out = f'{folder}/normals.exr'
    options = []
    for k, (azimuth, elevation) in enumerate(lamps):
        level = '' if stops is None else f',{stops[k]:.3f}'
        options += ['--lamp', f'lamp{k}={azimuth:.2f},{elevation:.2f},{distance}{level}']
    done = subprocess.run([program, 'normals', solved, '-o', out, '-q', *options], capture_output=True, text=True)
    if done.returncode == 2 and 'on no pixel' in done.stderr:
        return np.nan, 1
    if done.returncode:
        sys.exit(done.stderr)
    oiio.ImageCache().invalidate(out)
    buffer = oiio.ImageBuf(out)
    names = list(buffer.spec().channelnames)
    found = buffer.get_pixels(oiio.FLOAT)[..., [names.index('normal.' + c) for c in 'XYZ']]
    known = (np.linalg.norm(found, axis=-1) > .5) & shape.seen
    angle = np.degrees(np.arccos(np.clip((found * shape.normals).sum(-1), -1, 1)))
    return (angle[known].mean() if known.any() else np.nan), 1 - known.sum() / shape.seen.sum()


def row(program, shape, count, distance, seeds):
    found = {'metered': [], 'bright': [], 'exact': []}
    for seed in range(seeds):
        random = np.random.default_rng(seed)
        stops = random.uniform(-1, 1, count)
        pictures = [2 ** stop * .8 * shape.under(lamp, distance, random) for lamp, stop in zip(LAMPS[count], stops)]
        wrong = [told(*lamp, random) for lamp in LAMPS[count]]
        with tempfile.TemporaryDirectory() as folder:
            solved = solved_set(program, pictures, folder)
            for kind, lamps, levels in (('metered', wrong, stops), ('bright', wrong, None), ('exact', LAMPS[count], stops)):
                found[kind].append(errors(program, solved, shape, lamps, distance, levels, folder))
    return {kind: np.nanmean(cells, 0) for kind, cells in found.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('program')
    parser.add_argument('shared')
    parser.add_argument('--sets', default=','.join(SETS))
    parser.add_argument('--seeds', type=int, default=4)
    parser.add_argument('--lamps', default='3,4,5')
    parser.add_argument('--distances', default=','.join(map(str, DISTANCES)))
    arguments = parser.parse_args()
    print('| set | lamps | widths | metered | bright | exact |\n|---|---|---|---|---|---|')
    for name in arguments.sets.split(','):
        shape = Shape(os.path.join(arguments.shared, 'captures', name))
        mark = ' (chosen on)' if name in CHOSEN_ON else ''
        for count in map(int, arguments.lamps.split(',')):
            for distance in map(int, arguments.distances.split(',')):
                cells = row(arguments.program, shape, count, distance, arguments.seeds)
                print(f'| `{os.path.basename(name)}`{mark} | {count} | {distance} | ' + ' | '.join(
                    f'{error:.1f}° / {100 * refused:.0f} %' for error, refused in cells.values()) + ' |', flush=True)


if __name__ == '__main__':
    main()

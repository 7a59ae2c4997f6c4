"""Renders each light of a scene of the ground-truth generator by itself, at any size, for scripts/make_samples.

usage: blender -b -P scripts/render_lights.py -- SCENES SCENE FOLDER WIDTH SAMPLES
       (SCENES: the generator's folder, ../shared/tools/scenes)

Writes FOLDER/T_<light>.exr as the generator does, but of few samples a pixel, their noise filtered away: the variance of
the noise is known from two halves of the samples, edges from the surfaces' colours and normals (the edge-avoiding
wavelets of Dammertz et al. 2010, with the weights by variance of Schied et al. 2017)."""
import os
import sys

import bpy
import numpy as np

SCENES, SCENE, FOLDER, WIDTH, SAMPLES = sys.argv[sys.argv.index('--') + 1:]
sys.path.insert(0, SCENES)

import kit  # noqa: E402
import passes  # noqa: E402
import scenes_dev  # noqa: E402

SPLINE = np.array([1, 4, 6, 4, 1], np.float32) / 16  # B3, the wavelet's scaling function
LEVELS = 4
NORMAL_WIDTH, COLOUR_WIDTH, LIGHT_WIDTH = .25, .06, 3.  # of normals; of surface colours; in standard deviations
FIREFLY = 1.4  # times the second brightest of its neighbours
DARKEST = .1  # of the surfaces' colours that are divided out: hair and metal send light that is not colour times light


def shifted(image, dy, dx):
    height, width = image.shape[:2]
    rows = np.clip(np.arange(height) + dy, 0, height - 1)
    columns = np.clip(np.arange(width) + dx, 0, width - 1)
    return image[rows][:, columns]


def smoothed(light, variance, guides):
    """The light on the surfaces, (h, w, 3), its variance (h, w) filtered along; guides: (image, width) pairs."""
    for level in range(LEVELS):
        step = 1 << level
        total, weights, spread = np.zeros_like(light), np.zeros(light.shape[:2], np.float32), np.zeros_like(variance)
        limit = LIGHT_WIDTH * np.sqrt(blurred(variance)) + 1e-6
        level_of = light.mean(2)
        for j, row in enumerate(SPLINE):
            for i, column in enumerate(SPLINE):
                dy, dx = (j - 2) * step, (i - 2) * step
                there = shifted(light, dy, dx)
                exponent = np.abs(there.mean(2) - level_of) / limit
                for image, width in guides:
                    exponent += ((shifted(image, dy, dx) - image) ** 2).sum(2) / (width * width)
                weight = row * column * np.exp(-exponent)
                total += weight[..., None] * there
                spread += weight * weight * shifted(variance, dy, dx)
                weights += weight
        light, variance = total / weights[..., None], spread / weights ** 2
    return light


def blurred(image):
    for axis in (0, 1):
        image = sum(w * shifted(image, *((k - 1, 0) if axis == 0 else (0, k - 1))) for k, w in enumerate((.25, .5, .25)))
    return image


def without_noise(halves, guides, colour):
    mean = .5 * (halves[0] + halves[1])
    divisor = np.maximum(colour, DARKEST)
    on_surfaces = [half / divisor for half in halves]
    difference = on_surfaces[0].mean(2) - on_surfaces[1].mean(2)
    squared = difference ** 2
    for _ in range(3):  # one pixel's two halves say little about its variance
        squared = blurred(squared)
    return np.maximum(smoothed(.5 * (on_surfaces[0] + on_surfaces[1]), squared / 4, guides) * divisor, 0).astype(mean.dtype)


def without_fireflies(image):
    """A single pixel far brighter than all around it is a path that was luckily found, not light on the set."""
    level = image.mean(2)
    around = np.sort([shifted(level, dy, dx) for dy in (-1, 0, 1) for dx in (-1, 0, 1) if dy or dx], axis=0)
    usual = around[6]  # the second brightest: hairs and edges stay
    gain = np.where(level > FIREFLY * usual + 1e-3, usual / np.maximum(level, 1e-6), 1)
    return (image * gain[..., None]).astype(image.dtype)


def read_layers(path, names, geometry):
    """As the generator's, with the surfaces' colours."""
    images = plain_read_layers(path, names, geometry)
    source = passes.oiio.ImageInput.open(path)
    channels = list(source.spec().channelnames)
    pixels = source.read_image(passes.oiio.FLOAT)
    source.close()
    for name in ('DiffCol', 'GlossCol') if geometry else ():
        images[name] = pixels[:, :, [channels.index(f'ViewLayer.{name}.{part}') for part in 'RGB']]
    return images


def render_filtered(render, lights, width, samples, seed, bounces, geometry=False):
    layer = bpy.context.view_layer
    layer.use_pass_diffuse_color = layer.use_pass_glossy_color = True
    first, second = (render(lights, width, samples // 2, 2 * seed + half, bounces, True) for half in (0, 1))
    mean = {name: .5 * (first[name] + second[name]) for name in first}
    guides = [(mean['normal'], NORMAL_WIDTH), (mean['DiffCol'], COLOUR_WIDTH), (mean['GlossCol'], COLOUR_WIDTH)]
    images = dict(mean)
    for light in lights:
        image = without_noise([first[light.name], second[light.name]], guides, mean['DiffCol'])
        images[light.name] = without_fireflies(image)
    images['combined'] = sum(images[light.name] for light in lights)
    return images, {light.name: 0. for light in lights}


plain_read_layers, passes.read_layers, passes.render_twice = passes.read_layers, read_layers, render_filtered
kit.clear_scene()
os.makedirs(FOLDER, exist_ok=True)
passes.produce(scenes_dev.SCENES[SCENE](1), FOLDER, int(WIDTH), int(SAMPLES), 1, extras=False)

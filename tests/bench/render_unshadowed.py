"""What each light of a rendered set would give if nothing cast a shadow: `unshadowed_LIGHT.exr`, for removal_table.py.

    blender -b -P render_unshadowed.py -- SHARED SEED SAMPLES FOLDER

Of ../shared/captures/random/random_SEED. What reaches a surface straight from the lamp is rendered with shadows and
without; the difference is added to the light's own picture, so that bounced light stays as it was.
"""
import json
import os
import sys

shared, seed, samples, folder = sys.argv[sys.argv.index('--') + 1:]
sys.path.insert(0, os.path.join(shared, 'tools/scenes'))
import bpy
import kit
import numpy as np
import OpenImageIO as oiio
import passes
import scenes_random

SET = os.path.join(shared, 'captures/random', f'random_{seed}')


def read(path):
    source = oiio.ImageInput.open(path)
    return np.asarray(source.read_image('float'))[..., :3]


with open(os.path.join(SET, 'scene.json')) as file:
    told = json.load(file)
kit.clear_scene()
stage = scenes_random.SCENES['random'](told['seed'])
bpy.context.view_layer.update()
lamps = [(lamp, lamp_told) for light, entry in zip(stage.lights, told['lights'])
         for lamp, lamp_told in zip(light.lamps, entry['lamps'])]
for lamp, lamp_told in lamps:
    lamp.data.energy = lamp_told['power_w']
    lamp.data.cycles.use_multiple_importance_sampling = False


def direct():
    return passes.render_apart(stage.lights, told['size'][0], int(samples), told['seed'], bounces=0)


shadowed = direct()
for lamp, _ in lamps:
    lamp.data.cycles.cast_shadow = False
unshadowed = direct()
os.makedirs(folder, exist_ok=True)
for light in stage.lights:
    missing = np.maximum(unshadowed[light.name] - shadowed[light.name], 0)
    whole = read(os.path.join(SET, f'T_{light.name}.exr')) + missing
    passes.write_exr(os.path.join(folder, f'unshadowed_{light.name}.exr'), whole)

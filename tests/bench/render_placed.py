"""A rendered set under lamps that stand far from it, all round the camera: `T_lamp0.exr` ..., for place_table.py.

    blender -b -P render_placed.py -- SHARED SEED SAMPLES WIDTHS FOLDER

Of ../shared/captures/random/random_SEED: its things and its camera, without its lamps. Each lamp is a disc of a tenth of its
distance, WIDTHS widths of the picture from the middle of the set, and of the same power; light bounces. PLACES are degrees to
the right of the camera and up; of the last two none is told to the program: one of them is where lamp1 comes to stand, the
other one a lamp that the set never had.
"""
import json
import math
import os
import sys

shared, seed, samples, widths, folder = sys.argv[sys.argv.index('--') + 1:]
sys.path.insert(0, os.path.join(shared, 'tools/scenes'))
import bpy
import kit
import mathutils
import numpy as np
import OpenImageIO as oiio
import passes
import scenes_random

PLACES = {'lamp0': (-60, 25), 'lamp1': (50, 15), 'lamp2': (0, 60), 'lamp3': (-25, 12), 'lamp4': (30, 45),
          'moved': (10, 30), 'new': (-35, 40)}
SET = os.path.join(shared, 'captures/random', f'random_{seed}')

with open(os.path.join(SET, 'scene.json')) as file:
    told = json.load(file)
kit.clear_scene()
stage = scenes_random.SCENES['random'](told['seed'])
bpy.context.view_layer.update()
for light in stage.lights:
    for lamp in light.lamps:
        lamp.hide_render = True

camera = told['camera']
depth = np.asarray(oiio.ImageInput.open(os.path.join(SET, 'depth.exr')).read_image('float')).reshape(told['size'][1], -1)
height, width = depth.shape
middle = float(np.median(depth[height // 4:3 * height // 4, width // 4:3 * width // 4]))
far = float(widths) * middle * camera['sensor_width_mm'] / camera['lens_mm']
forward = mathutils.Vector(camera['forward']).normalized()
right = forward.cross(mathutils.Vector((0, 0, 1))).normalized()
up = right.cross(forward)
target = mathutils.Vector(camera['position']) + middle * forward

lights = []
for name, (azimuth, elevation) in PLACES.items():
    a, e = math.radians(azimuth), math.radians(elevation)
    way = math.cos(e) * math.sin(a) * right + math.sin(e) * up - math.cos(e) * math.cos(a) * forward
    light = kit.area(kit.Light(name, 'other', 1), target + far * way, target, .1 * far)
    lamp = light.lamps[0]
    lamp.data.energy = 40 * far ** 2
    lamp.data.cycles.use_multiple_importance_sampling = False
    lights.append(light)
bpy.context.view_layer.update()
pictures = passes.render_apart(lights, 256, int(samples), told['seed'], bounces=4)
os.makedirs(folder, exist_ok=True)
for light in lights:
    passes.write_exr(os.path.join(folder, f'T_{light.name}.exr'), pictures[light.name])
with open(os.path.join(folder, 'places.json'), 'w') as file:
    json.dump({'widths': float(widths), 'places': PLACES}, file)

"""Run by Blender: adds up the light groups of a file in the compositor and compares with its Combined pass.
    blender --background --factory-startup --python blender_sum.py -- lights.exr FOLDER WIDTH HEIGHT LIGHT..."""
import sys

import bpy

source, target, width, height, *lights = sys.argv[sys.argv.index('--') + 1:]
image = bpy.data.images.load(source)
scene = bpy.context.scene
scene.render.resolution_x, scene.render.resolution_y = int(width), int(height)
scene.render.resolution_percentage = 100
scene.use_nodes = True
tree = scene.node_tree
tree.nodes.clear()
node = tree.nodes.new('CompositorNodeImage')
node.image = image
print('outputs:', [output.name for output in node.outputs], image.type, flush=True)


def mixed(kind, a, b):
    mix = tree.nodes.new('CompositorNodeMixRGB')
    mix.blend_type = kind
    tree.links.new(a, mix.inputs[1])
    tree.links.new(b, mix.inputs[2])
    return mix.outputs[0]


total = node.outputs['Combined_' + lights[0]]
for light in lights[1:]:
    total = mixed('ADD', total, node.outputs['Combined_' + light])
difference = mixed('DIFFERENCE', total, node.outputs['Combined'])
files = tree.nodes.new('CompositorNodeOutputFile')
files.format.file_format = 'OPEN_EXR'
files.format.color_depth = '32'
files.base_path = target
files.file_slots.clear()
for name, picture in (('difference', difference), ('sum', total)):
    files.file_slots.new(name)
    tree.links.new(picture, files.inputs[name])
composite = tree.nodes.new('CompositorNodeComposite')
tree.links.new(total, composite.inputs[0])
camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
scene.collection.objects.link(camera)
scene.camera = camera
scene.render.engine = 'CYCLES'
scene.cycles.samples = 1
scene.cycles.use_denoising = False
scene.render.filepath = target + '/render'
bpy.ops.render.render(write_still=False)

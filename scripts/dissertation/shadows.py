"""Shadows of each light (figures 5.13, 5.14), and the light without the set (figures 5.15, 5.16)."""
import os
import sys

import numpy as np
from dissertation.work import NOISE, codes, read, rgb, strip
from page import number, table


def umbra(work):
    sys.path.insert(0, 'tests/bench')
    from shadow_table import rows  # its measures
    solved = work.solved(work.captured('spheres', '--noise', NOISE))
    shadows = work.path('shadows.exr')
    work.run('shadows', solved, '-o', shadows)
    strip('docs/dissertation/shadows.jpg', [rgb(shadows.replace('.exr', '.png'))], 800)
    found = list(rows('spheres', shadows, solved, os.path.join(work.shared, 'captures/spheres')))
    return table(['light', 'found', 'best threshold on beta, the truth at hand', "Otsu's on beta", "Otsu's on luminance"],
                 [[row['light'], *(number(row[key], 2) for key in ('umbra', 'beta', 'otsu', 'luminance'))] for row in found])


def light_alone(work):
    solved = work.path('spheres', 'solved.exr')
    light = work.path('light.exr')
    work.run('lightmap', solved, '-o', light)
    channels = read(light)
    maps = [np.stack([channels[name + '.' + c] for c in 'RGB'], -1)
            for name in sorted({channel.rsplit('.', 1)[0] for channel in channels if channel.endswith('.R')})]
    frame = rgb(solved)
    strip('docs/dissertation/light_alone.jpg',
          [codes(.9 / np.quantile(picture, .995) * picture) for picture in (frame, *maps)])

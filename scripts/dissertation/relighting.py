"""Relit frames against the rendered truth, five lightings (figures 6.12, 6.13)."""
import numpy as np
from dissertation.work import NOISE, linear, rgb, strip, write_rgb
from page import number, table

FIRST = (255, 197, 143)
SECOND = [(91, 138, 240), (160, 160, 50), (115, 50, 110), (175, 50, 70), (175, 210, 212)]  # its five colours
SOLVERS = {'published': ['--solver', 'published'], '`auto`': []}


def setting(light, color):
    return ['--light', light + '=rgb:' + '/'.join(f'{value:.6f}' for value in color)]


def relit_errors(work):
    lights, truth = work.truth('spheres')
    capture = work.captured('spheres', '--noise', NOISE)
    rows = []
    for solver, options in SOLVERS.items():
        solved, name = work.solved(capture, *options), solver.strip('`')
        for second in SECOND:
            title = ','.join(map(str, second))
            lamps = [linear(FIRST), linear(second)]
            frame = work.path('relit', name, f'{title}.exr')
            work.run('relight', solved, *(a for light, lamp in zip(lights, lamps) for a in setting(light, lamp)), '-o', frame)
            reference = write_rgb(work.path('relit', 'truth', f'{title}.exr'), np.einsum('ic,ihwc->hwc', lamps, truth))
            row = [solver, title]
            for weights in ('5,1,1', '1,1,1'):
                error = work.run('evaluate', frame, reference, '--metric', 'de2000', '--weights', weights,
                                 '--threshold', '5')['de2000']
                row += [*(number(error[key], 2) for key in ('mean', 'median', 'p95')), f"{error['share_above']:.1%}"]
            rows.append(row)
            print(*row, sep='  ')
    maps, map_ = [], work.path('map.png')
    for name in ('published', 'auto'):
        work.run('evaluate', work.path('relit', name, '91,138,240.exr'), work.path('relit', 'truth', '91,138,240.exr'),
                 '--metric', 'de2000', '--weights', '5,1,1', '--map', map_, '--map-max', '6')
        maps.append(rgb(map_))
        plot = work.path('relit.png')
        work.run('evaluate', work.path('relit', name, ''), work.path('relit', 'truth', ''), '--metric', 'de2000',
                 '--weights', '5,1,1', '--plot', plot)
        strip(f'docs/dissertation/relit_{name}.jpg', [rgb(plot)], 1000)
    strip('docs/dissertation/relit_maps.jpg', maps, 640)
    heading = ['solver', 'second lamp']
    for weights in ('5:1:1', '1:1:1'):
        heading += [f'mean, {weights}', 'median', 'p95', 'above 5']
    return table(heading, rows)

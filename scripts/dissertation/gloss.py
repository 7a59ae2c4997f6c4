"""What gloss does to beta (figures 5.8, 6.10, 6.11), and gloss as a picture of its own (figure 5.9)."""
import os
import shutil

import numpy as np
from dissertation.work import codes, read, rgb, strip, write
from page import number, table

SETS = [f'gloss/spec{i}' for i in range(1, 6)]
SOLVERS = {'published': ['--solver', 'published'], 'matte': ['--model', 'lambert'], '`auto`': []}
THRESHOLD = .1  # what its script leaves out


def beta_of(lights, contributions):
    total = contributions.sum((0, 3))
    return {'beta.' + light: own.sum(-1) / np.maximum(total, 1e-9) for light, own in zip(lights, contributions)}


def beta_errors(work):
    lights, contributions = work.truth('gloss/lambert')
    total = contributions.sum((0, 3))
    unlit = total < 1e-3 * total.mean()  # no light, no share of it
    truth = {name: np.where(unlit, np.nan, beta) for name, beta in beta_of(lights, contributions).items()}
    reference = write(work.path('beta', 'truth.exr'), truth)
    rows = []
    for name in SETS:
        capture = work.captured(name, '--bits', 'float')
        for solver, options in SOLVERS.items():
            beta = work.path('beta', 'auto' if not options else solver, os.path.basename(name) + '.exr')
            work.run('beta', work.solved(capture, *options), '-o', beta)
            shutil.copy(reference, work.path('beta', 'matte scene', os.path.basename(name) + '.exr'))
            error = work.run('evaluate', beta, reference, '--channels', 'beta.left', '--metric', 'absdiff',
                             '--threshold', str(THRESHOLD))['absdiff']
            kept = np.abs(read(beta)['beta.left'] - truth['beta.left'])
            kept = kept[kept < THRESHOLD]
            rows.append([os.path.basename(name), solver, *(number(error[key], 4) for key in ('mean', 'p95')),
                         number(error['max'], 2), f"{error['share_above']:.2%}", number(kept.mean(), 4),
                         number(np.quantile(kept, .95), 4)])
            print(*rows[-1], sep='  ')
    # Box plots, as figure 6.11 has them.
    plot = work.path('beta.png')
    work.run('evaluate', work.path('beta', 'auto'), work.path('beta', 'matte scene'), '--channels', 'beta.left',
             '--metric', 'absdiff', '--plot', plot)
    strip('docs/dissertation/beta_error.jpg', [rgb(plot)], 1000)
    return table(['set', 'solver', 'mean', 'p95', 'largest', 'above .1', 'mean of the rest', 'p95 of the rest'], rows)


def layers(work):
    """The light from the left, its matte rest, and its highlights."""
    channels = read(work.solved(work.captured('gloss/spec3', '--noise', 'read=.002,full_well=20000')))
    whole = np.stack([channels['left.' + c] for c in 'RGB'], -1)
    shine = np.stack([channels['left.spec.' + c] for c in 'RGB'], -1)
    white = .9 / np.quantile(whole - shine, .995)
    strip('docs/dissertation/gloss_layers.jpg', [codes(white * picture) for picture in (whole, whole - shine, shine)])

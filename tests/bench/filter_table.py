#!/usr/bin/python3
"""What every filter takes at 1920 x 1080, and a pipeline of ten at 8K and 16K: tables of docs/speed.md.

usage: filter_table.py [--large FOLDER]     (SWAPLIGHT names the program)

Of a filter: the work of all threads together, which other programs on the machine do not disturb, of four of it in a
row beyond that of one. Of a large frame: seconds of work and by the clock, and the most memory that the program held
at once, what Mesa holds included."""
import json
import os
import subprocess
import sys
import tempfile
import time

import numpy as np
import OpenImageIO as oiio

PROGRAM = os.environ['SWAPLIGHT']
TEN = ['exposure,stops=0.5', 'white-balance,kelvin=5600', 'halation', 'bloom', 'local-contrast', 'chromatic-aberration',
       'film-grain', 'vignette', 'review,contrast=1.1', 'film-print']
MORE = 3


def write_frame(path, width, height):
    """Half float in rows, a part of them at a time."""
    spec = oiio.ImageSpec(width, height, 3, 'half')
    out = oiio.ImageOutput.create(path)
    assert out.open(path, spec), out.geterror()
    random = np.random.default_rng(1)
    x = np.linspace(0, 1, width, dtype=np.float32)[None, :, None]
    for top in range(0, height, 64):
        rows = min(64, height - top)
        y = np.linspace(top / height, (top + rows) / height, rows, dtype=np.float32)[:, None, None]
        light = .02 + x * y * np.array([1, .8, .6], np.float32) + .05 * random.random((rows, width, 1), np.float32)
        assert out.write_scanlines(top, top + rows, 0, np.ascontiguousarray(light + 20 * (light > .98))), out.geterror()
    out.close()


def measure(*arguments):
    """Seconds of work, seconds by the clock, megabytes."""
    pid = os.fork()
    if pid == 0:
        with open(os.devnull, 'w') as nothing:
            os.dup2(nothing.fileno(), 1)
        os.execv(PROGRAM, [PROGRAM, *map(str, arguments)])
    begin = time.time()
    _, status, used = os.wait4(pid, 0)
    assert status == 0, arguments
    return used.ru_utime + used.ru_stime, time.time() - begin, used.ru_maxrss / 1024


def apply(frame, stages, output, *options):
    return measure('look', 'apply', frame, *[part for stage in stages for part in ('--filter', stage)], '-o', output, *options)


def every_filter(folder):
    frame = os.path.join(folder, 'frame.exr')
    write_frame(frame, 1920, 1080)
    listed = json.loads(subprocess.run([PROGRAM, 'look', 'list', '--json'], check=True, capture_output=True).stdout)
    times = {}
    for filter in (f['name'] for f in listed['filters'] if f['built_in']):
        one, several = (min(apply(frame, [filter] * n, os.path.join(folder, 'out.exr'))[0] for _ in range(2))
                        for n in (1, 1 + MORE))
        times[filter] = 1000 * (several - one) / MORE
    print('| filter | milliseconds |\n|---|---|')
    for filter, ms in sorted(times.items(), key=lambda pair: -pair[1]):
        print(f'| {filter} | {max(0, ms):.0f} |')


def large(folder):
    print('| frame | seconds of work | by the clock | most memory, MiB |\n|---|---|---|---|')
    for name, width, height in (('8K', 7680, 4320), ('16K', 15360, 8640)):
        frame, out = (os.path.join(folder, f'{name} {part}.exr') for part in ('frame', 'out'))
        write_frame(frame, width, height)
        work, clock, memory = apply(frame, TEN, out)
        print(f'| {name}, {width} x {height} | {work:.0f} | {clock:.0f} | {memory:.0f} |', flush=True)


if __name__ == '__main__':
    if sys.argv[1:2] == ['--large']:
        large(sys.argv[2])
    else:
        with tempfile.TemporaryDirectory() as temporary:
            every_filter(temporary)

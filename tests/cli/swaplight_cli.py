"""What the tests of the command line share: calling the program as a user does, and making small captures."""
import copy
import hashlib
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np
import OpenImageIO as oiio

PROGRAM = os.path.abspath(os.environ.get('SWAPLIGHT') or
                          os.path.join(os.path.dirname(__file__), '../../build/release/swaplight'))
SHARED = os.environ.get('SWAPLIGHT_SHARED', '')
SWAPPED = [[[.9, .2, .15], [.15, .8, .25]], [[.15, .8, .25], [.9, .2, .15]]]


def run(*arguments, **options):
    """Runs the program; arguments become text. Gives returncode, stdout, stderr (text)."""
    environment = {**os.environ, 'LC_ALL': 'C.UTF-8'}
    environment.pop('OCIO', None)
    environment.update(options.pop('env', {}))
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=600,
                          env=environment, **options)


def limit_memory(gigabytes):
    """For preexec_fn: the program may not take more address space."""
    resource.setrlimit(resource.RLIMIT_AS, (gigabytes << 30, gigabytes << 30))


def write_image(path, pixels, pixel_type='float', channels='RGBA', window=None, **attributes):
    """pixels: height x width x 3, as the file holds them (0..1 for integer types). `window` of an EXR: where its corner
    lies in a picture of which width and height."""
    pixels = np.ascontiguousarray(pixels, np.float32)
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], pixel_type)
    spec.channelnames = tuple(channels)[:pixels.shape[2]]
    if window:
        spec.x, spec.y, spec.full_width, spec.full_height = window
    for name, value in attributes.items():
        spec.attribute(name, value)
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    output = oiio.ImageOutput.create(path)
    assert output.open(path, spec) and output.write_image(pixels), output.geterror()
    output.close()


def read_image(path):
    """A dictionary: the pixels of every channel by name. The parts of a multi-part EXR are layers; the part rgb
    has none. Colour is as the file has it: not multiplied by the alpha of a PNG."""
    as_it_is = oiio.ImageSpec()
    as_it_is.attribute('oiio:UnassociatedAlpha', 1)
    source = oiio.ImageInput.open(path, as_it_is)
    assert source, oiio.geterror()
    channels, part = {}, 0
    while source.seek_subimage(part, 0):
        spec = source.spec()
        pixels = np.asarray(source.read_image('float')).reshape(spec.height, spec.width, spec.nchannels)
        layer = spec.getattribute('name') or 'rgb'
        for c, name in enumerate(spec.channelnames):
            channels[name if layer == 'rgb' else f'{layer}.{name}'] = pixels[..., c]
        part += 1
    source.close()
    return channels


def read_rgb(path, layer=''):
    channels = read_image(path)
    prefix = layer + '.' if layer else ''
    return np.stack([channels[prefix + c] for c in 'RGB'], -1)


def sha256(path):
    with open(path, 'rb') as file:
        return hashlib.sha256(file.read()).hexdigest()


def smooth(random, height, width, low, high):
    """A smooth random field: a coarse grid of values, interpolated."""
    coarse = random.uniform(low, high, (4, 5))
    y, x = np.linspace(0, 3, height), np.linspace(0, 4, width)
    rows = np.stack([np.interp(x, range(5), row) for row in coarse])
    return np.stack([np.interp(y, range(4), column) for column in rows.T], -1)


def contributions(lights, height=12, width=16, seed=1):
    """Matte contributions of a random set at unit white: lights x height x width x 3."""
    random = np.random.default_rng(seed)
    albedo = np.stack([smooth(random, height, width, .1, .9) for _ in range(3)], -1)
    shading = np.stack([smooth(random, height, width, .02, .5) for _ in range(lights)])[..., None]
    return (albedo * shading).astype(np.float32)


def photograph(truth, light_colors):
    return np.einsum('ic,ihwc->hwc', np.array(light_colors), truth)


class Capture:
    """A small capture in a folder, with exact truth. Change `manifest` or the pictures, then save()."""

    def __init__(self, folder, names=('key', 'fill'), light_colors=None, **size):
        self.folder = folder
        self.path = os.path.join(folder, 'capture.json')
        self.truth = contributions(len(names), **size)
        light_colors = copy.deepcopy(light_colors or (SWAPPED if len(names) == 2 else rotated(len(names))))
        self.manifest = {
            'format': 'swaplight-capture', 'version': 1, 'name': 'small', 'color_space': 'lin_rec709',
            'lights': [{'name': n} for n in names],
            'shots': [{'image': f'shot_{k + 1:02d}.exr', 'light_colors': c} for k, c in enumerate(light_colors)]}
        self.shots = [photograph(self.truth, c) for c in light_colors]
        self.save()

    def save(self):
        os.makedirs(self.folder, exist_ok=True)
        with open(self.path, 'w') as file:
            json.dump(self.manifest, file, indent=1)
        for shot, pixels in zip(self.manifest['shots'], self.shots):
            write_image(os.path.join(self.folder, shot['image']), pixels)


def rotated(count):
    colors = [[.9, .2, .15], [.15, .8, .25], [.2, .25, .9], [.85, .75, .1], [.1, .75, .8], [.75, .15, .8]][:count]
    return [[colors[(i + k) % count] for i in range(count)] for k in range(count)]


class CliTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix='swaplight_cli_')
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def succeed(self, *arguments, **options):
        result = run(*arguments, **options)
        self.assertEqual(result.returncode, 0, f'{arguments}\n{result.stdout}\n{result.stderr}')
        return result

    def succeed_json(self, *arguments, **options):
        """Runs with --json: standard output must be exactly one object."""
        result = self.succeed(*arguments, '--json', **options)
        value = json.loads(result.stdout)
        self.assertIsInstance(value, dict)
        return value

    def deny(self, *arguments, naming=(), code=2, **options):
        """Runs what must be refused: nothing on standard output, one line on standard error that holds every text of
        `naming`, and no file made or left behind. Gives the line."""
        before = self.files()
        result = run(*arguments, **options)
        self.assertEqual(result.returncode, code, f'{arguments}\n{result.stdout}\n{result.stderr}')
        self.assertEqual(result.stdout, '')
        self.assertEqual(result.stderr.count('\n'), 1, 'one line expected:\n' + result.stderr)
        self.assertTrue(result.stderr.startswith('swaplight: '), result.stderr)
        for text in [naming] if isinstance(naming, str) else naming:
            self.assertIn(text, result.stderr)
        self.assertEqual(self.files(), before, 'files were made or changed')
        return result.stderr

    def interrupt(self, *arguments):
        """Starts the program, waits until it catches Ctrl-C, presses it. Gives exit code and standard error."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stderr=subprocess.PIPE, text=True)
        while process.poll() is None:
            with open(f'/proc/{process.pid}/status') as file:
                caught = next(line for line in file if line.startswith('SigCgt'))
            if int(caught.split()[1], 16) & 1 << signal.SIGINT - 1:
                break
            time.sleep(.01)
        process.send_signal(signal.SIGINT)
        return process.wait(60), process.communicate()[1]

    def files(self):
        """Every file of the test's folder with its size and time of change."""
        found = {}
        for folder, _, names in os.walk(self.folder):
            for name in names:
                status = os.lstat(os.path.join(folder, name))
                found[os.path.join(folder, name)] = (status.st_size, status.st_mtime_ns)
        return found


def main():
    if not os.path.exists(PROGRAM):
        sys.exit(f'{PROGRAM} is missing: build first, or name the program in $SWAPLIGHT')
    unittest.main()

"""Captures with truth, what the program makes of them, and pictures."""
import json
import os
import subprocess

import numpy as np
import OpenImageIO as oiio

NOISE = 'read=.002,full_well=20000'


class Work:
    """A folder for captures and what comes of them; where `shared` and the program are."""

    def __init__(self, program, shared, folder):
        self.program, self.shared, self.folder = program, shared, folder

    def path(self, *names):
        path = os.path.join(self.folder, *names)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        return path

    def run(self, *arguments):
        """What the program says with --json."""
        result = subprocess.run([self.program, *arguments, '--json', '-q'], check=True, stdout=subprocess.PIPE)
        return json.loads(result.stdout or '{}')

    def captured(self, name, *options):
        """Two photographs of a rendered set, its gels swapped between them."""
        folder = self.path(name.replace('/', '_'), '')
        subprocess.run([os.path.join(self.shared, 'tools/compose.py'), os.path.join(self.shared, 'captures', name), folder,
                        *options], check=True, stdout=subprocess.DEVNULL)
        return os.path.join(folder, 'capture.json')

    def solved(self, capture, *options):
        solved = capture.replace('capture.json', 'solved' + '_'.join(('', *options)) + '.exr')
        self.run('solve', capture, '-o', solved, *options)
        return solved

    def truth(self, name):
        """A rendered set's lights, and what each gives at unit white."""
        folder = os.path.join(self.shared, 'captures', name)
        lights = sorted(file[2:-4] for file in os.listdir(folder) if file.startswith('T_') and '@' not in file)
        return lights, np.stack([rgb(os.path.join(folder, f'T_{light}.exr')) for light in lights])


def read(path):
    picture = oiio.ImageBuf(path)
    pixels = picture.get_pixels(oiio.FLOAT)
    return {name: pixels[..., i] for i, name in enumerate(picture.spec().channelnames)}


def rgb(path, layer=''):
    channels = read(path)
    return np.stack([channels[(layer + '.' if layer else '') + c] for c in 'RGB'], -1)


def write(path, channels):
    """A file of floats with channels by name."""
    first = next(iter(channels.values()))
    spec = oiio.ImageSpec(first.shape[1], first.shape[0], len(channels), 'float')
    spec.channelnames = tuple(channels)
    picture = oiio.ImageBuf(spec)
    picture.set_pixels(oiio.ROI(), np.ascontiguousarray(np.stack(list(channels.values()), -1), np.float32))
    picture.write(path)
    return path


def write_rgb(path, pixels):
    return write(path, dict(zip('RGB', np.moveaxis(pixels, -1, 0))))


def codes(linear):
    x = np.clip(linear, 0, 1)
    return np.where(x <= .0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - .055)


def linear(codes_of_255):
    x = np.asarray(codes_of_255, float) / 255
    return np.where(x <= .04045, x / 12.92, ((x + .055) / 1.055) ** 2.4)


def small(pixels, width):
    height = pixels.shape[0] * width // pixels.shape[1]
    large = oiio.ImageBuf(oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, 'float'))
    large.set_pixels(oiio.ROI(), np.ascontiguousarray(pixels, np.float32))
    return np.clip(oiio.ImageBufAlgo.resize(large, roi=oiio.ROI(0, width, 0, height)).get_pixels(oiio.FLOAT), 0, 1)


def strip(path, pictures, width=480):
    """Pictures of codes 0..1 beside each other, as a JPEG of the documentation."""
    pixels = np.concatenate([small(picture, width) for picture in pictures], 1)
    picture = oiio.ImageBuf(oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, 'uint8'))
    picture.specmod().attribute('CompressionQuality', 90)
    picture.set_pixels(oiio.ROI(), np.ascontiguousarray(pixels, np.float32))
    picture.write(path)
    print(path + ': made')

"""Camera raw files for tests: what a sensor behind a mosaic of colour filters counts, in an uncompressed DNG
(Adobe DNG 1.4 over TIFF 6.0)."""
import struct

import numpy as np

BLACK, WHITE = 512, 16383


def mosaic(pixels):
    """height x width x 3, linear, 1 where the sensor saturates: what is counted behind red, green, green and blue."""
    counted = pixels[..., 1].copy()
    counted[::2, ::2] = pixels[::2, ::2, 0]
    counted[1::2, 1::2] = pixels[1::2, 1::2, 2]
    return np.round(BLACK + (WHITE - BLACK) * np.clip(counted, 0, 1)).astype('<u2')


def write_dng(path, pixels, taken='2026:11:21 10:00:00'):
    """The camera's own white balance is far from neutral: who applies it gets other colours."""
    height, width = pixels.shape[:2]
    counts = mosaic(pixels).tobytes()
    ascii_of = lambda text: (2, len(text) + 1, text.encode() + b'\0')
    shorts = lambda *values: (3, len(values), struct.pack(f'<{len(values)}H', *values))
    longs = lambda *values: (4, len(values), struct.pack(f'<{len(values)}I', *values))
    octets = lambda *values: (1, len(values), bytes(values))
    ratios = lambda kind, *values: (kind, len(values), b''.join(struct.pack('<iI', round(1e4 * v), 10000) for v in values))
    entries = {
        254: longs(0), 256: longs(width), 257: longs(height), 258: shorts(16), 259: shorts(1), 262: shorts(32803),
        271: ascii_of('Swaplight'), 272: ascii_of('Test'), 273: longs(8), 274: shorts(1), 277: shorts(1),
        278: longs(height), 279: longs(len(counts)), 284: shorts(1), 306: ascii_of(taken),
        33421: shorts(2, 2), 33422: octets(0, 1, 1, 2), 50706: octets(1, 4, 0, 0), 50708: ascii_of('Swaplight Test'),
        50714: shorts(BLACK), 50717: shorts(WHITE),
        50721: ratios(10, .6722, -.0635, -.0963, -.4287, 1.2460, .2028, -.0908, .2162, .5668),
        50728: ratios(5, .5, 1, .6), 50778: shorts(21)}
    start = 8 + len(counts)
    values_at = start + 2 + 12 * len(entries) + 4
    directory, values = struct.pack('<H', len(entries)), b''
    for tag, (kind, count, value) in sorted(entries.items()):
        if len(value) > 4:
            place = struct.pack('<I', values_at + len(values))
            values += value + b'\0' * (len(value) % 2)
        else:
            place = value.ljust(4, b'\0')
        directory += struct.pack('<HHI', tag, kind, count) + place
    with open(path, 'wb') as file:
        file.write(b'II*\0' + struct.pack('<I', start) + counts + directory + b'\0\0\0\0' + values)

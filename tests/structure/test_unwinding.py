"""An exception finds its way in the program that users run. g++ may leave an empty cold half of a function, whose
unwind entry has no length, at the address where the next function begins. Unwinding looks an address up among the
entries' beginnings and takes the last that fits: where a linker has put the empty entry there, an exception that
passes the next function ends the program."""
import os
import struct
import unittest

PROGRAM = os.environ.get('SWAPLIGHT', '')
TABLE = 0x3b  # how every linker writes the table: signed 4 bytes, from its section's beginning


def sections(elf):
    """name -> (address, bytes) of a 64-bit little-endian ELF file."""
    place, = struct.unpack_from('<Q', elf, 0x28)
    size, count, names = struct.unpack_from('<3H', elf, 0x3a)
    headers = [struct.unpack_from('<IIQQQQ', elf, place + i * size) for i in range(count)]
    start = headers[names][4]
    return {elf[start + name:elf.index(b'\0', start + name)].decode(): (address, elf[offset:offset + length])
            for name, _, _, address, offset, length in headers}


def empty_entries(file):
    """Addresses at which unwinding finds an entry without length."""
    with open(file, 'rb') as program:
        found = sections(program.read())
    base, table = found['.eh_frame_hdr']
    frames_at, frames = found['.eh_frame']
    if table[3] != TABLE:
        raise ValueError(f'{file}: an unwind table of an unknown kind')
    count, = struct.unpack_from('<I', table, 8)
    entries = [struct.unpack_from('<ii', table, 12 + 8 * i) for i in range(count)]
    empty = []
    for i, (begin, entry) in enumerate(entries):
        length, = struct.unpack_from('<I', frames, base + entry - frames_at + 12)
        last = i + 1 == count or entries[i + 1][0] != begin
        if last and length == 0:
            empty.append(hex(base + begin))
    return empty, count


@unittest.skipUnless(os.path.exists(PROGRAM), 'SKIPPED: $SWAPLIGHT names no program')
class Unwinding(unittest.TestCase):
    def test_every_address_has_an_entry_with_a_length(self):
        empty, count = empty_entries(PROGRAM)
        self.assertGreater(count, 1000)
        self.assertEqual(empty, [])


if __name__ == '__main__':
    unittest.main()

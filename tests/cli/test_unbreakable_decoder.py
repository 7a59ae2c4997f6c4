"""Pictures are decoded in processes of their own: one that crashes its decoder is a line, and what is read is the
same as in the program itself."""
import os
import struct
import subprocess
import time
import unittest

import numpy as np

import swaplight_cli as cli

TRUSTED = {'SWAPLIGHT_TRUST_PICTURES': '1'}


def crashing_tiff(path, side=256, bits=6):
    """Four inks of 6 bits in tiles of their own, after OpenImageIO's issue 5315: its reader writes beyond its memory."""
    tile = side * bits // 8 * side
    at = 8 + 2 + 12 * 11 + 4
    tags = [(256, 4, 1, side), (257, 4, 1, side), (258, 3, 4, at), (259, 3, 1, 1), (262, 3, 1, 5), (277, 3, 1, 4),
            (284, 3, 1, 2), (322, 4, 1, side), (323, 4, 1, side), (324, 4, 4, at + 8), (325, 4, 4, at + 24)]
    with open(path, 'wb') as file:
        file.write(b'II*\0' + struct.pack('<IH', 8, len(tags)))
        for tag in tags:
            file.write(struct.pack('<HHII', *tag))
        file.write(struct.pack('<I4H8I', 0, *[bits] * 4, *[at + 40] * 4, *[tile] * 4) + b'\xa5' * tile)


class DecoderTest(cli.CliTest):
    def test_a_picture_that_crashes_its_decoder_is_a_line(self):
        path = self.path('crash.tif')
        for bits in (1, 2, 4, 6):
            crashing_tiff(path, bits=bits)
            result = cli.run('evaluate', path, path)
            self.assertEqual(result.returncode, 2, result)
            self.assertIn(path, result.stderr)
            self.assertIn('crashed its decoder', result.stderr)
            self.assertEqual(result.stderr.count('\n'), 1)

    def test_as_a_shot_of_a_capture(self):
        capture = cli.Capture(self.path('set'), height=24, width=32)
        shot = capture.manifest['shots'][1]['image']
        crashing_tiff(self.path('set', shot))
        result = cli.run('solve', capture.path, '-o', self.path('out.exr'))
        self.assertEqual(result.returncode, 2, result)
        self.assertIn(shot, result.stderr)
        self.assertEqual(result.stderr.count('\n'), 1)
        self.assertFalse(os.path.exists(self.path('out.exr')))

    def test_the_same_is_read_with_and_without(self):
        noise = np.random.default_rng(0).uniform(0, 1, (60, 70, 3))
        for name, kind in (('a.exr', 'half'), ('a.png', 'uint16'), ('a.tif', 'uint8'), ('a.jpg', 'uint8'), ('a.hdr', 'float')):
            cli.write_image(self.path(name), noise, kind)
            apart = self.succeed('info', self.path(name), '--json')
            here = self.succeed('info', self.path(name), '--json', '--trust-pictures')
            self.assertEqual(apart.stdout, here.stdout)
            same = self.succeed('evaluate', self.path(name), self.path(name), '--json')
            self.assertEqual(same.stdout, self.succeed('evaluate', self.path(name), self.path(name), '--json',
                                                       '--trust-pictures').stdout)
        capture = cli.Capture(self.path('set'), height=24, width=32)
        for name, environment in (('apart.exr', {}), ('here.exr', TRUSTED)):
            result = cli.run('solve', capture.path, '-o', self.path(name), env=environment)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(cli.run('relight', self.path(name), '-o', self.path(name + '.png'), env=environment).returncode, 0)
        self.assertEqual(cli.sha256(self.path('apart.exr.png')), cli.sha256(self.path('here.exr.png')))

    def test_nobody_stays_behind(self):
        """Whoever reads the program's words does not wait for its helpers, and a kill takes them along."""
        capture = cli.Capture(self.path('set'), height=400, width=600)
        for wait in (.05, .1, .2, .4):
            program = subprocess.Popen([cli.PROGRAM, 'solve', capture.path, '-o', self.path('o.exr')],
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
            time.sleep(wait)
            program.kill()
            program.communicate(timeout=20)
            end = time.time() + 5
            while (left := self.processes_of(program.pid)) and time.time() < end:
                time.sleep(.1)
            self.assertEqual(left, [])

    @staticmethod
    def processes_of(session):
        """Those of a session that still run."""
        found = []
        for name in filter(str.isdigit, os.listdir('/proc')):
            try:
                with open(f'/proc/{name}/stat') as file:
                    state, _, _, own = file.read().rpartition(')')[2].split()[:4]
            except OSError:
                continue
            if state != 'Z' and int(own) == session:
                found.append(name)
        return found


if __name__ == '__main__':
    cli.main()

"""Pictures are decoded in processes of their own: one that crashes its decoder is a line, and what is read is the
same as in the program itself."""
import os
import subprocess
import time
import unittest

import numpy as np

import cli
from bad_tiff import crashing_tiff, ink_tiff

TRUSTED = {'SWAPLIGHT_TRUST_PICTURES': '1'}


class DecoderTest(cli.CliTest):
    def test_a_picture_that_crashes_its_decoder_is_a_line(self):
        path = self.path('crash.tif')
        crashing_tiff(path)
        result = cli.run('evaluate', path, path)
        self.assertEqual(result.returncode, 2, result)
        self.assertIn(path, result.stderr)
        self.assertIn('crashed its decoder', result.stderr)
        self.assertEqual(result.stderr.count('\n'), 1)

    def test_inks_that_would_be_read_beyond_memory_are_refused(self):
        """The pictures of OpenImageIO's issue 5315 (tests/core/image/tiff_layout_test.cpp looks at the pixels of those
        that are read)."""
        path = self.path('inks.tif')
        for bits in (1, 6, 8, 12):
            for tiled in (False, True):
                for separate in (False, True):
                    ink_tiff(path, bits, tiled, separate)
                    result = cli.run('evaluate', path, path)
                    with self.subTest(bits=bits, tiled=tiled, separate=separate):
                        if not tiled and (separate or bits == 8):
                            self.assertEqual(result.returncode, 0, result)
                            continue
                        self.assertEqual(result.returncode, 2, result)
                        self.assertIn(path + ': is a TIFF of four inks (CMYK)', result.stderr)
                        self.assertIn('Save it as RGB', result.stderr)
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

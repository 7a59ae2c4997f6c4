"""The k-th call fails, for all k (after SQLite's tests): every write, open, flush and rename of an output, and large
allocations. Afterwards: one clear line and exit code 3, or all is well; no half file, no temporary; and the next run
makes the same bytes. $SWAPLIGHT_FAULTS is the library that is preloaded (tests/faults/fail_call.cpp).

Of each kind the first call, the last and one between them; with SWAPLIGHT_ALL_FAILURES=1 every one (minutes)."""
import errno
import os
import shutil
import unittest

import cli

LIBRARY = os.environ.get('SWAPLIGHT_FAULTS', '')
ALL = os.environ.get('SWAPLIGHT_ALL_FAILURES', '') == '1'
KINDS = (('open', errno.ENOSPC), ('open', errno.EMFILE), ('write', errno.ENOSPC), ('write', errno.EIO),
         ('close', errno.ENOSPC), ('fsync', errno.EIO), ('rename', errno.EIO), ('rename', errno.ENOSPC))
ALLOCATIONS = 12  # of those of a solve, where not all are tried


def some_of(count, most=3):
    """Calls 1..count, or the first, the last and some between them."""
    if ALL or count <= most:
        return range(1, count + 1)
    return sorted({1 + round(i * (count - 1) / (most - 1)) for i in range(most)})


@unittest.skipUnless(os.path.exists(LIBRARY), 'SKIPPED: $SWAPLIGHT_FAULTS names no library to preload')
class FaultTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'), height=24, width=32)
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '-q')
        os.mkdir(self.path('out'))

    def run_failing(self, kind, error, at, arguments, **more):
        """Runs with one failing call. Gives the result, and whether there was such a call."""
        mark = self.path('mark')
        # Pictures are decoded in the same process, so that its calls are all there are.
        environment = {'LD_PRELOAD': LIBRARY, 'FAIL_CALL': kind, 'FAIL_AT': str(at), 'FAIL_ERRNO': str(error),
                       'FAIL_PATH': '/out/', 'FAIL_MARK': mark, 'SWAPLIGHT_TRUST_PICTURES': '1', **more}
        result = cli.run(*arguments, '-q', '--threads', 1, env=environment)
        said = None
        if os.path.exists(mark):
            with open(mark) as file:
                said = file.read()
            os.remove(mark)
        return result, said

    def count(self, kind, arguments, **more):
        """How many calls of a kind there are."""
        result, said = self.run_failing(kind, 0, 0, arguments, **more)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.clear()
        return int(said)

    def clear(self):
        shutil.rmtree(self.path('out'))
        os.mkdir(self.path('out'))

    def every_call(self, name, *arguments, codes=(3,)):
        """`arguments` write out/NAME."""
        output = self.path('out', name)
        self.succeed(*arguments, '-o', output, '-q')
        wanted = cli.sha256(output)
        os.remove(output)
        calls = 0
        counts = {kind: self.count(kind, [*arguments, '-o', output]) for kind, _ in KINDS}
        for kind, error in KINDS:
            for at in some_of(counts[kind]):
                with self.subTest(f'{arguments[0]} {name}: {kind} {at} fails with {errno.errorcode[error]}'):
                    result, failed = self.run_failing(kind, error, at, [*arguments, '-o', output])
                    self.assertIsNotNone(failed, 'there was no such call')
                    calls += 1
                    self.after(result, output, wanted, codes)
                self.clear()
        self.assertGreater(calls, 5, 'the failures did not reach the program')
        print(f'{arguments[0]} {name}: {calls} failing calls of {counts}', flush=True)

    def after(self, result, output, wanted, codes):
        left = os.listdir(self.path('out'))
        if result.returncode == 0:  # a failure that may be passed over, such as flushing the folder
            self.assertEqual(cli.sha256(output), wanted)
            return
        self.assertIn(result.returncode, codes, result.stderr)
        self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
        self.assertIn(os.path.basename(output).split('.')[0], result.stderr)
        self.assertEqual(left, [], 'something was left behind')

    def test_solve(self):
        self.every_call('s.exr', 'solve', self.capture.path)

    def test_frames(self):
        more = ('f.jpg', 'f.hdr') if ALL else ()  # these are written the way of f.png
        for name in ('f.exr', 'f.png', 'f.tif', *more):
            self.every_call(name, 'relight', self.solved)

    def test_layers_and_maps(self):
        self.every_call('l.exr', 'export', self.solved)
        self.every_call('b.exr', 'beta', self.solved)

    def test_a_page(self):
        self.every_call('r.html', 'report', self.solved)

    def test_memory(self):
        """Large allocations of a solve, one after the other; libraries do not survive that their small ones fail."""
        output = self.path('out', 's.exr')
        arguments = ['solve', self.capture.path, '-o', output]
        large = {'FAIL_SIZE': str(1 << 16)}
        allocations = some_of(self.count('malloc', arguments, **large), ALLOCATIONS)
        for at in allocations:
            with self.subTest(f'allocation {at}'):
                result, failed = self.run_failing('malloc', errno.ENOMEM, at, arguments, **large)
                self.assertIsNotNone(failed, 'there was no such allocation')
                if result.returncode != 0:
                    self.assertEqual(result.returncode, 3, result.stderr)
                    self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
                    self.assertEqual(os.listdir(self.path('out')), [])
            self.clear()
        print(f'solve: {len(allocations)} failing allocations', flush=True)
        self.succeed(*arguments, '-q')


if __name__ == '__main__':
    cli.main()

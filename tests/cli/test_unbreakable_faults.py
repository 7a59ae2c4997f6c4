"""The k-th call fails, for all k (after SQLite's tests): every write, open, flush and rename of an output, and large
allocations. Afterwards: one clear line and exit code 3, or all is well; no half file, no temporary; and the next run
makes the same bytes. $SWAPLIGHT_FAULTS is the library that is preloaded (tests/faults/fail_call.cpp)."""
import errno
import os
import shutil
import unittest

import swaplight_cli as cli

LIBRARY = os.environ.get('SWAPLIGHT_FAULTS', '')
KINDS = (('open', errno.ENOSPC), ('open', errno.EMFILE), ('write', errno.ENOSPC), ('write', errno.EIO),
         ('close', errno.ENOSPC), ('fsync', errno.EIO), ('rename', errno.EIO), ('rename', errno.ENOSPC))
MOST = 400  # calls of a kind: small pictures make far fewer


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
        environment = {'LD_PRELOAD': LIBRARY, 'FAIL_CALL': kind, 'FAIL_AT': str(at), 'FAIL_ERRNO': str(error),
                       'FAIL_PATH': '/out/', 'FAIL_MARK': mark, **more}
        result = cli.run(*arguments, '-q', '--threads', 1, env=environment)
        failed = os.path.exists(mark)
        if failed:
            os.remove(mark)
        return result, failed

    def every_call(self, name, *arguments, codes=(3,)):
        """`arguments` write out/NAME."""
        output = self.path('out', name)
        self.succeed(*arguments, '-o', output, '-q')
        wanted = cli.sha256(output)
        os.remove(output)
        calls = 0
        for kind, error in KINDS:
            for at in range(1, MOST):
                with self.subTest(f'{arguments[0]} {name}: {kind} {at} fails with {errno.errorcode[error]}'):
                    result, failed = self.run_failing(kind, error, at, [*arguments, '-o', output])
                    if failed:
                        calls += 1
                        self.after(result, output, wanted, codes)
                    else:
                        self.assertEqual(result.returncode, 0, result.stderr)
                shutil.rmtree(self.path('out'))
                os.mkdir(self.path('out'))
                if not failed:
                    break
        self.assertGreater(calls, 5, 'the failures did not reach the program')
        print(f'{arguments[0]} {name}: {calls} failing calls', flush=True)

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
        for name in ('f.exr', 'f.png', 'f.tif', 'f.jpg', 'f.hdr'):
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
        calls = 0
        for at in range(1, MOST):
            with self.subTest(f'allocation {at}'):
                result, failed = self.run_failing('malloc', errno.ENOMEM, at, arguments, FAIL_SIZE=str(1 << 16))
                if failed:
                    calls += 1
                    if result.returncode != 0:
                        self.assertIn(result.returncode, (3,), result.stderr)
                        self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
                        self.assertEqual(os.listdir(self.path('out')), [])
            shutil.rmtree(self.path('out'))
            os.mkdir(self.path('out'))
            if not failed:
                break
        print(f'solve: {calls} failing allocations', flush=True)
        self.succeed(*arguments, '-q')


if __name__ == '__main__':
    cli.main()

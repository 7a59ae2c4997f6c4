"""The k-th call fails, for all k (after SQLite's tests): every write, open, flush and rename of an output, and large
allocations. Afterwards: one clear line and exit code 3, or all is well; no half file, no temporary; a file that was
there before is the old one or the new one; and the next run makes the same bytes. $SWAPLIGHT_FAULTS is the library that is preloaded (tests/faults/fail_call.cpp).

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

    def outputs(self):
        return {name: cli.sha256(self.path('out', name)) for name in os.listdir(self.path('out'))}

    def every_call(self, name, *arguments, codes=(3,)):
        """`arguments` write out/NAME."""
        self.every_call_of(f'{arguments[0]} {name}', [*arguments, '-o', self.path('out', name)], name.split('.')[0], codes)

    def every_call_of(self, label, command, said, codes=(3,), before=lambda: None):
        """Every failing call of a command that writes into out/, where `before` has put what is there already. What
        fails names `said`."""
        before()
        old = self.outputs()
        self.succeed(*command, '-q')
        wanted = self.outputs()
        self.clear()
        calls, counts = 0, {}
        for kind, error in KINDS:
            if kind not in counts:
                before()
                counts[kind] = self.count(kind, command)
            for at in (last := some_of(counts[kind])):
                with self.subTest(f'{label}: {kind} {at} fails with {errno.errorcode[error]}'):
                    before()
                    result, failed = self.run_failing(kind, error, at, command)
                    self.assertIsNotNone(failed, 'there was no such call')
                    calls += 1
                    self.after(result, old, wanted, said, codes)
                    if at == last[-1] or self.outputs() != old:
                        self.succeed(*command, '-q')
                        self.assertEqual(self.outputs(), wanted, 'the next run')
                self.clear()
        self.assertGreater(calls, 5, 'the failures did not reach the program')
        print(f'{label}: {calls} failing calls of {counts}', flush=True)

    def after(self, result, old, wanted, said, codes):
        left = self.outputs()
        if result.returncode == 0:  # a failure that may be passed over, such as flushing the folder
            self.assertEqual(left, wanted)
            return
        self.assertIn(result.returncode, codes, result.stderr)
        self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
        self.assertIn(said, result.stderr)
        if len(wanted) == 1:
            self.assertEqual(left, old, 'something was left behind')
        for name, bytes_left in left.items():  # of a sequence, frames that were done
            self.assertIn(bytes_left, (old.get(name), wanted.get(name)), f'{name} is half')

    def test_solve(self):
        self.every_call('s.exr', 'solve', self.capture.path)

    def test_frames(self):
        more = ('f.jpg', 'f.hdr') if ALL else ()  # these are written the way of f.png
        for name in ('f.exr', 'f.png', 'f.tif', *more):
            self.every_call(name, 'relight', self.solved)

    def test_a_frame_that_gets_a_chunk_of_its_own(self):
        self.every_call('hdr.png', 'relight', self.solved, '--display', 'Rec.2100 PQ')

    def test_a_frame_that_cannot_be_read_back_from_memory(self):
        """A TIFF is made there; a failing read is not its end."""
        command = ['relight', self.solved, '-o', self.path('out', 'f.tif')]
        memory = {'FAIL_PATH': 'memfd:'}
        count = self.count('pread', command, **memory)
        self.assertGreater(count, 0)
        for at in range(1, count + 1):
            result, failed = self.run_failing('pread', errno.EIO, at, command, **memory)
            self.assertIsNotNone(failed, 'there was no such call')
            self.assertEqual(result.returncode, 3, result.stderr)
            self.after(result, {}, {'f.tif': ''}, 'f.tif', (3,))

    def test_layers_and_maps(self):
        self.every_call('l.exr', 'export', self.solved)
        self.every_call('b.exr', 'beta', self.solved)

    def test_a_page(self):
        self.every_call('r.html', 'report', self.solved)

    def test_a_sequence(self):
        """Frames that are done stay, those that are not are no files."""
        self.every_call_of('relight f.%04d.exr', ['relight', self.solved, '-F', '1-3', '--key', 'key@1=-2st', '--key',
                                                  'key@3=+2st', '-o', self.path('out', 'f.%04d.exr')], 'f.', (1, 3))

    def test_over_a_file(self):
        """A frame that is made again: it is the old one or the new one."""
        def earlier():
            shutil.copy(self.path('solved.exr'), self.path('out', 'f.exr'))

        self.every_call_of('relight f.exr again', ['relight', self.solved, '-o', self.path('out', 'f.exr')], 'f.exr',
                           before=earlier)

    def test_a_session(self):
        """The studio saves over an earlier session: there stands the earlier one or the new one, and a failure is said."""
        saved, home = self.path('out', 'mine.swaplight'), self.path('home')
        environment = {'HOME': home, **{f'XDG_{name}_HOME': '' for name in ('CONFIG', 'DATA', 'STATE')}}
        with open(self.path('save.txt'), 'w') as file:
            file.write(f'open {self.solved}\nwait\nlight key +1st\nsave {saved}\nwait\nquit\n')
        command = ['studio', '--script', self.path('save.txt'), '--screenshot', self.path('end.png'), '--size', '640x480']
        self.succeed(*command, '-q', env=environment)
        wanted = self.outputs()
        calls = 0
        for kind, error in KINDS if ALL else (('write', errno.ENOSPC), ('rename', errno.EIO)):
            for at in range(1, self.count(kind, command, **environment) + 1):
                with self.subTest(f'{kind} {at} fails with {errno.errorcode[error]}'):
                    shutil.rmtree(home)
                    with open(saved, 'w') as file:
                        file.write('the earlier one')
                    old = self.outputs()
                    result, failed = self.run_failing(kind, error, at, command, **environment)
                    self.assertIsNotNone(failed, 'there was no such call')
                    self.assertEqual(result.returncode, 0, result.stderr)
                    calls += 1
                    if self.outputs() != wanted:
                        self.assertEqual(self.outputs(), old)
                        with open(os.path.join(home, '.local/state/swaplight/swaplight.log')) as file:
                            said = [line for line in file if 'mine.swaplight' in line]
                        self.assertEqual(len(said), 1, said)
                        self.assertIn('error: ', said[0])
                    self.succeed(*command, '-q', env=environment)
                    self.assertEqual(self.outputs(), wanted, 'the next run')
                self.clear()
        print(f'a session: {calls} failing calls', flush=True)

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

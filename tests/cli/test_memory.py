"""--memory: sets larger than the memory lie in temporary files, and come out the same"""
import resource
import signal

import swaplight_cli as cli

LIGHTS = ('key', 'fill', 'back', 'lamp', 'window', 'sky')
LARGEST_FILE = 1_000_000  # bytes: a picture of 480 x 270 pixels takes 1.5 MB


def no_large_files():
    """Before the program starts: a file that grows beyond takes no more, and nothing is killed for it."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (LARGEST_FILE, LARGEST_FILE))


class MemoryTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'), names=LIGHTS, height=270, width=480)

    def made(self, verb, source, name, *options):
        self.succeed(verb, source, '-o', self.path(name), '-q', *options)
        return cli.sha256(self.path(name))

    def assert_same_in_files(self, verb, source, name, *options):
        usual = self.made(verb, source, name, *options)
        bounded = self.made(verb, source, name, *options, '--memory', '0.01')
        self.assertEqual(bounded, usual, f'{verb} {name}: other bytes')
        # The pictures really lie in files: where these find no room it says so.
        self.deny(verb, source, '-o', self.path('none.' + name), *options, '--memory', '0.01', '-q', '--trust-pictures',
                  code=3, naming=('no temporary file for a large picture', self.folder), preexec_fn=no_large_files)

    def test_a_solve_is_the_same_to_the_byte(self):
        self.assert_same_in_files('solve', self.capture.path, 'solved.exr')

    def test_frames_and_layers_are_the_same_to_the_byte(self):
        solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', solved, '-q')
        for name in ('frame.exr', 'frame.png'):
            self.assert_same_in_files('relight', solved, name, '--light', 'key=#ff8000')
        self.assert_same_in_files('export', solved, 'layers.exr', '--beta')
        self.assert_same_in_files('relight', self.capture.path, 'from_capture.exr')

    def test_a_limit_that_is_none_is_refused(self):
        self.deny('solve', self.capture.path, '-o', self.path('x.exr'), '--memory', '0', naming='--memory')


if __name__ == '__main__':
    cli.main()

"""What holds for every verb: help, version, threads, wrong calls."""
import os
import pty
import subprocess
import unittest

import swaplight_cli as cli


class CommonTest(cli.CliTest):
    def test_what_is_asserted_here_can_fail(self):
        """A helper that hides a method of TestCase would silence every assertion that calls it."""
        helpers = set(vars(cli.CliTest)) - {'setUp', '__doc__', '__module__'}
        self.assertFalse(helpers & set(dir(unittest.TestCase)))
        with self.assertRaises(AssertionError):
            self.assertLess(2, 1)

    def test_version_names_the_program(self):
        self.assertRegex(self.succeed('--version').stdout, r'^swaplight \d+\.\d+\.\d+\n$')

    def test_help_lists_the_verbs_and_every_verb_has_help(self):
        overview = self.succeed('--help').stdout
        verbs = [line.split()[0] for line in overview.split('Subcommands:')[1].splitlines() if line.startswith('  ')]
        self.assertIn('evaluate', verbs)
        for verb in verbs:
            text = self.succeed(verb, '--help').stdout
            for option in ('--help', '--json', '--quiet', '--verbose', '--threads'):
                self.assertIn(option, text, verb)

    def test_a_wrong_call_is_one_line_and_exit_2(self):
        self.deny(naming='evaluate')
        self.deny('develop', naming=['develop', 'evaluate'])
        self.deny('--frobnicate', naming='--frobnicate')
        self.deny('evaluate', 'a.exr', naming=['REFERENCE', '--help'])
        self.deny('evaluate', 'a.exr', 'b.exr', '--frobnicate', naming=['--frobnicate', '--help'])
        self.deny('evaluate', 'a.exr', 'b.exr', '--threads', 'many', naming='--threads')
        self.deny('evaluate', 'a.exr', 'b.exr', '--threads', '-1', naming='--threads')

    def test_a_class_of_processor_that_there_is_not_is_one_line_and_exit_2(self):
        capture = cli.Capture(self.path('set'), ('a', 'b', 'c', 'd'))
        for verb in (['info', capture.path], ['solve', capture.path, '-o', self.path('solved.exr')]):
            done = cli.run(*verb, env={'SWAPLIGHT_PROCESSOR_LEVEL': '7'})
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, r"^swaplight: SWAPLIGHT_PROCESSOR_LEVEL is '7': [^\n]* this processor has\n$")

    def test_progress_is_one_line_on_a_terminal_and_none_elsewhere_or_when_quiet(self):
        capture = cli.Capture(self.path('set'), ('a', 'b', 'c', 'd'), height=540, width=960)
        call = [cli.PROGRAM, 'solve', capture.path, '-o', self.path('solved.exr')]

        def on_terminal(*options):
            ours, theirs = pty.openpty()
            process = subprocess.Popen([*call, *options], stderr=theirs, stdout=subprocess.DEVNULL)
            os.close(theirs)
            text = b''
            try:
                while part := os.read(ours, 4096):
                    text += part
            except OSError:  # the other end is closed
                pass
            os.close(ours)
            self.assertEqual(process.wait(), 0)
            return text.decode()

        shown = on_terminal()
        self.assertRegex(shown, r'\r +\d+ % ')
        self.assertEqual(shown.count('\n'), 1, 'only the message about the file ends a line')
        self.assertRegex(shown, r'\r\x1b\[Kwrote .*solved.exr')
        self.assertEqual(on_terminal('-q'), '')
        self.assertNotIn('\r', self.succeed(*call[1:]).stderr)

    @unittest.skipUnless(os.path.exists('/dev/full'), 'no /dev/full here')
    def test_standard_output_that_cannot_be_written_is_an_error(self):
        path = self.path('a.exr')
        cli.write_image(path, cli.contributions(1)[0])
        with open('/dev/full', 'w') as full:
            result = subprocess.run([cli.PROGRAM, 'evaluate', path, path], stdout=full, stderr=subprocess.PIPE,
                                    text=True)
        self.assertEqual(result.returncode, 3)
        self.assertIn('standard output', result.stderr)


if __name__ == '__main__':
    cli.main()

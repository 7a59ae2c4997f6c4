"""What the program says: nothing in a file can speak to the terminal, and words that cannot be said end nothing."""
import json
import os
import subprocess
import unittest

import numpy as np
import OpenImageIO as oiio
import cli

EVIL = 'a\x1b[2Kb\rc\x1b]0;title\x07d\nline\u202eback\x9b31m'


class WordsTest(cli.CliTest):
    def assert_plain(self, text, said):
        for character in text:
            self.assertTrue(character == '\n' or character.isprintable(), f'{character!r} in {said!r}')

    def test_errors_that_quote_a_file(self):
        capture = cli.Capture(self.path('set'))
        capture.manifest['lights'][0]['name'] = EVIL
        capture.manifest[EVIL] = EVIL
        capture.save()
        self.assert_plain(self.deny('solve', capture.path, '-o', self.path('o.exr'), naming='\\x1b[2K'), 'light')
        for value in (EVIL, {EVIL: 1}, [EVIL]):
            with self.subTest(value):
                with open(self.path('rig.json'), 'w') as file:
                    json.dump({'format': 'swaplight-rig', 'version': 1, 'lights': [{'name': 'key', 'color': value}]}, file)
                self.assert_plain(self.deny('info', self.path('rig.json'), naming='rig.json'), value)

    def test_names_of_files(self):
        self.assert_plain(self.deny('info', self.path(EVIL), naming='\\x1b'), 'file name')
        self.assert_plain(self.deny(EVIL), 'verb')

    def test_results_keep_a_value_in_its_line(self):
        capture = cli.Capture(self.path('set'))
        capture.manifest['name'] = EVIL
        capture.save()
        said = self.succeed('info', capture.path).stdout
        self.assert_plain(said, 'capture')
        self.assertEqual(sum('capture "' in line for line in said.splitlines()), 1)
        self.assertIn('\\x0aline\\u202eback\\x9b31m"', said)

    def test_texts_of_a_picture(self):
        cli.write_image(self.path('a.exr'), np.ones((4, 4, 3)), ImageDescription=EVIL.replace('\x9b', ''))
        self.assert_plain(self.succeed('info', self.path('a.exr'), '-v').stdout, 'EXR')

    def test_names_of_channels(self):
        spec = oiio.ImageSpec(4, 4, 3, 'float')
        spec.channelnames = ('\x1b[31mR', 'G\r', 'B')
        out = oiio.ImageOutput.create(self.path('a.exr'))
        self.assertTrue(out.open(self.path('a.exr'), spec) and out.write_image(np.ones((4, 4, 3), np.float32)))
        out.close()
        self.assert_plain(self.succeed('info', self.path('a.exr')).stdout, 'channels')

    def test_json_is_as_it_was(self):
        capture = cli.Capture(self.path('set'))
        capture.manifest['name'] = EVIL
        capture.save()
        self.assertEqual(self.succeed_json('info', capture.path)['capture']['name'], EVIL)


class DeafTest(cli.CliTest):
    """Standard error and standard output that cannot be written."""

    def run_with(self, redirection, *arguments):
        return subprocess.run(['sh', '-c', f'exec "$0" "$@" {redirection}', cli.PROGRAM, *arguments],
                              capture_output=True, text=True, timeout=60)

    @unittest.skipUnless(os.path.exists('/dev/full'), 'SKIPPED: no /dev/full here')
    def test_standard_error(self):
        capture = cli.Capture(self.path('set'))
        for redirection in ('2>/dev/full', '2>&-', '2>/dev/full <&-'):
            with self.subTest(redirection):
                self.assertEqual(self.run_with(redirection, 'info', 'none').returncode, 2)
                self.assertEqual(self.run_with(redirection, 'solve', capture.path, '-o', self.path('o.exr')).returncode, 0)
                self.assertEqual(cli.read_rgb(self.path('o.exr')).shape, (12, 16, 3))
                os.remove(self.path('o.exr'))

    def test_messages_never_go_into_a_file_that_took_the_place_of_standard_error(self):
        capture = cli.Capture(self.path('set'))
        self.assertEqual(self.run_with('<&- 2>&-', 'solve', capture.path, '-o', self.path('o.exr')).returncode, 0)
        self.assertEqual(cli.read_rgb(self.path('o.exr')).shape, (12, 16, 3))
        # The result cannot be said: that is an error, and the file is whole.
        self.assertEqual(self.run_with('<&- >&- 2>&-', 'solve', capture.path, '-o', self.path('o.exr')).returncode, 3)
        self.assertEqual(cli.read_rgb(self.path('o.exr')).shape, (12, 16, 3))

    def test_a_reader_that_has_gone(self):
        capture = cli.Capture(self.path('set'))
        solved = self.path('o.exr')
        self.assertEqual(self.run_with('2>&1 | true', 'solve', capture.path, '-o', solved, '-v').returncode, 0)
        self.assertTrue(os.path.exists(solved))
        self.assertEqual(self.run_with('| true', 'info', solved).stderr, '')


if __name__ == '__main__':
    cli.main()

"""What is read is never replaced by what is made of it, and no name from a file leads out of the folder."""
import os
import shutil

import numpy as np
import OpenImageIO as oiio
import cli


def write_solved(path, lights, value=.3):
    """A solved set as another program may write it: without the capture in its header."""
    channels = ['R', 'G', 'B', *(f'{n}.{c}' for n in lights for c in 'RGB'), *(f'beta.{n}' for n in lights),
                'quality.residual', 'quality.sigma', 'quality.flags']
    spec = oiio.ImageSpec(8, 6, len(channels), 'float')
    spec.channelnames = tuple(channels)
    out = oiio.ImageOutput.create(path)
    assert out.open(path, spec) and out.write_image(np.full((6, 8, len(channels)), value, np.float32)), out.geterror()
    out.close()


class OutputOverInputTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '-q')

    def test_a_photograph(self):
        shot = self.path('set/shot_01.exr')
        for name in ('link.exr', 'hard.exr'):
            (os.symlink if name == 'link.exr' else os.link)(shot, self.path(name))
        for output in (shot, self.path('set/../set/shot_01.exr'), self.path('link.exr'), self.path('hard.exr')):
            for verb in (['solve', self.capture.path], ['solve', self.path('set')], ['relight', self.capture.path],
                         ['export', self.capture.path], ['beta', self.capture.path], ['shadows', self.capture.path]):
                with self.subTest(f'{verb[0]} {output}'):
                    self.deny(*verb, '-o', output, '-q', naming=[os.path.basename(output), 'is read here'])

    def test_a_solved_set(self):
        for verb in ('relight', 'export', 'beta', 'shadows'):
            self.deny(verb, self.solved, '-o', self.solved, '-q', naming=['solved.exr', 'is read here'])
        self.deny('relight', self.solved, '-F', '1-3', '-o', self.numbered(2, self.solved), '-q', naming='is read here')

    def numbered(self, frame, source):
        os.link(source, self.path(f'frame.{frame:04d}.exr'))
        return self.path('frame.%04d.exr')

    def test_a_rig_and_a_report(self):
        with open(self.path('rig.json'), 'w') as file:
            file.write('{"format": "swaplight-rig", "version": 1, "lights": []}')
        shutil.copy(self.path('rig.json'), self.path('rig.exr'))
        self.deny('relight', self.solved, '--rig', self.path('rig.exr'), '-o', self.path('rig.exr'), naming='is read here')
        self.deny('solve', self.capture.path, '-o', self.path('o.exr'), '--report', self.capture.path,
                  naming='is read here')
        self.deny('report', self.solved, '-o', self.solved, naming='is read here')
        self.deny('evaluate', self.solved, self.solved, '--map', self.solved, naming='is read here')


class NamesTest(cli.CliTest):
    def test_lights_without_a_capture_in_the_header(self):
        os.makedirs(self.path('sub/bb.x'))
        for name in ('x/../../out', '../out', 'a b', '<script>', '\x1b[31mred', 'ambient', '1st', 'caf\xe9'):
            with self.subTest(name):
                evil = self.path('evil.exr')
                write_solved(evil, [name])
                for verb, output in (('beta', 'sub/bb.png'), ('relight', 'o.exr'), ('report', 'r.html'),
                                     ('export', 'layers.exr')):
                    self.deny(verb, evil, '-o', self.path(output), naming='evil.exr')

    def test_two_lights_that_differ_in_case(self):
        write_solved(self.path('two.exr'), ['key', 'KEY'])
        self.deny('relight', self.path('two.exr'), '-o', self.path('o.exr'), naming=['two.exr', 'KEY'])

    def test_names_that_are_allowed(self):
        write_solved(self.path('good.exr'), ['key', 'fill_2'])
        self.succeed('beta', self.path('good.exr'), '-o', self.path('b.png'))
        self.assertTrue(os.path.exists(self.path('b.fill_2.png')))

    def test_info_reads_what_relight_reads(self):
        write_solved(self.path('good.exr'), ['key', 'fill'])
        self.assertIn('key', self.succeed('info', self.path('good.exr')).stdout)


if __name__ == '__main__':
    cli.main()

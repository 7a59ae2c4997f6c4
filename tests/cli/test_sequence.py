"""swaplight relight -F: sequences"""
import json
import os
import signal
import subprocess
import time

import numpy as np
import swaplight_cli as cli


class SequenceTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'))
        self.key, self.fill = self.capture.truth
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '--model', 'transport', '--float', '-q')

    def sequence(self, *arguments, out='out.%04d.exr', source=None, code=0, **options):
        result = cli.run('relight', source or self.solved, '-o', self.path(out), '--type', 'float', '--json', *arguments, **options)
        self.assertEqual(result.returncode, code, result.stderr)
        return json.loads(result.stdout)

    def made(self):
        return sorted(name for name in os.listdir(self.folder) if name.startswith('out'))

    def test_ranges_and_patterns(self):
        for frames, out, names in (
                ('1-3', 'out.%04d.exr', ['out.0001.exr', 'out.0002.exr', 'out.0003.exr']),
                ('1-10x4', 'out.####.exr', ['out.0001.exr', 'out.0005.exr', 'out.0009.exr']),
                ('1,3,8-9', 'out.@@.exr', ['out.01.exr', 'out.03.exr', 'out.08.exr', 'out.09.exr']),
                ('12', 'out.#.exr', ['out.0012.exr']), ('5-4 7', 'out%d.exr', ['out4.exr', 'out5.exr', 'out7.exr']),
                ('-2--1', 'out.%03d.exr', ['out.-01.exr', 'out.-02.exr'])):
            self.sequence('--frames=' + frames, out=out)
            self.assertEqual(self.made(), sorted(names))
            for name in names:
                os.remove(self.path(name))
        for frames, word in (('1-', '1-'), ('a', "'a'"), ('1-5x0', 'step'), ('', 'none'), ('1-9999999', 'million'),
                             ('1-1000000000', 'million')):
            if frames:
                self.deny('relight', self.solved, '-F', frames, '-o', self.path('out.%04d.exr'), naming=word)
        self.deny('relight', self.solved, '-F', '1-3', '-o', self.path('out.exr'), naming='%04d')
        os.rename(self.solved, self.path('s2.exr'))
        self.deny('relight', self.path('s2.exr'), '-F', '1-2', '-o', self.path('s%d.exr'), naming='is read here')

    def test_what_a_killed_batch_has_left_is_removed_on_restart(self):
        host = os.uname().nodename
        dead = subprocess.Popen(['true'])
        dead.wait()
        stale = self.path(f'.out.0002.{host}-{dead.pid}-7.tmp.exr')
        alive = self.path(f'.out.0002.{host}-{os.getpid()}-7.tmp.exr')
        other = self.path(f'.out.0002.another-machine-{dead.pid}-7.tmp.exr')
        for path in (stale, alive, other):
            with open(path, 'w') as file:
                file.write('half a frame')
        self.sequence('-F', '1-3', '--skip-existing')
        self.assertFalse(os.path.exists(stale))
        self.assertTrue(os.path.exists(alive) and os.path.exists(other), 'who may still be writing is left alone')

    def brightness(self, frame, light, layer=1):
        picture = cli.read_rgb(self.path(f'out.{frame:04d}.exr'))
        return (picture / light).mean()

    def test_a_light_changes_from_key_to_key(self):
        off = ('--light', 'fill=off')
        self.sequence('-F', '0-12', *off, '--key', 'key@1=+0st', '--key', 'key@11=+4st')
        for frame, stops in ((0, 0), (1, 0), (6, 2), (8, 2.8), (11, 4), (12, 4)):
            self.assertAlmostEqual(self.brightness(frame, self.key), 2 ** stops, places=3)
        self.sequence('-F', '0-12', *off, '--key', 'key@1=+0st', '--key', 'key@11=+4st', '--between', 'smooth')
        for frame, stops in ((1, 0), (3, 4 * .104), (6, 2), (11, 4)):
            self.assertAlmostEqual(self.brightness(frame, self.key), 2 ** stops, places=3)

    def test_a_light_fades_from_off_and_to_off_in_a_line_of_light(self):
        keys = ('--key', 'key@1=off', '--key', 'key@5=+1st', '--key', 'key@7=+1st', '--key', 'key@8=off')
        self.sequence('-F', '0-9', '--light', 'fill=off', *keys)
        for frame, level in ((0, 0), (1, 0), (2, .5), (4, 1.5), (5, 2), (6, 2), (7, 2), (8, 0), (9, 0)):
            self.assertAlmostEqual(self.brightness(frame, self.key), level, places=3, msg=f'frame {frame}')

    def test_keys_stand_in_a_rig_file_and_in_a_session_too(self):
        animation = {'between': 'linear', 'lights': {'key': [{'frame': 1, 'setting': '+0st'}, {'frame': 3, 'setting': '+2st'}]}}
        lights = [{'name': 'key'}, {'name': 'fill', 'on': False}]
        with open(self.path('rig.json'), 'w') as file:
            json.dump({'lights': lights, 'animation': animation}, file)
        with open(self.path('a.swaplight'), 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr', 'rig': {'lights': lights},
                       'animation': animation}, file)
        for arguments, source in ((('--rig', self.path('rig.json')), None), ((), self.path('a.swaplight'))):
            self.sequence('-F', '1-3', *arguments, source=source)
            self.assertAlmostEqual(self.brightness(2, self.key), 2, places=3)

    def test_wrong_keys_are_one_line(self):
        out = ('-F', '1-3', '-o', self.path('out.%04d.exr'))
        self.deny('relight', self.solved, *out, '--key', 'key=+1st', naming='NAME@FRAME')
        self.deny('relight', self.solved, *out, '--key', 'rim@1=+1st', naming=['rim', 'key, fill'])
        self.deny('relight', self.solved, *out, '--key', 'key@2=lots', naming=['frame 2', 'lots'])
        self.deny('relight', self.solved, *out, '--between', 'jumping', naming=['jumping', 'smooth'])

    def test_a_set_a_frame(self):
        for frame in (1, 2):
            capture = cli.Capture(self.path('set'), seed=frame)
            self.succeed('solve', capture.path, '-o', self.path(f'in.{frame:04d}.exr'), '--model', 'transport', '--float', '-q')
            setattr(self, f'truth{frame}', capture.truth)
        self.sequence('-F', '1-2', '--light', 'fill=off', source=self.path('in.####.exr'))
        for frame in (1, 2):
            np.testing.assert_allclose(cli.read_rgb(self.path(f'out.{frame:04d}.exr')), getattr(self, f'truth{frame}')[0], atol=1e-4)

    def test_failed_frames_exit_with_1_and_cont_goes_on(self):
        for frame in (1, 3):
            os.link(self.solved, self.path(f'in.{frame:04d}.exr'))
        source = self.path('in.%04d.exr')
        result = self.sequence('-F', '1-3', '--cont', source=source, code=1)
        self.assertEqual([f['state'] for f in result['frames']], ['written', 'failed', 'written'])
        self.assertIn('in.0002.exr', result['frames'][1]['error'])
        self.assertEqual(self.made(), ['out.0001.exr', 'out.0003.exr'])
        result = self.sequence('-F', '1-3', '--workers', '1', source=source, code=1)
        self.assertEqual([f['state'] for f in result['frames']], ['written', 'failed'])
        self.sequence('-F', '2', source=source, code=2)

    def test_a_failed_frame_is_said_to_the_quiet(self):
        os.link(self.solved, self.path('in.0001.exr'))
        result = cli.run('relight', self.path('in.%04d.exr'), '-F', '1-2', '--workers', 1, '-q', '-o', self.path('out.%04d.exr'))
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
        self.assertIn('in.0002.exr', result.stderr)

    def bytes(self):
        return {name: cli.sha256(self.path(name)) for name in self.made()}

    def test_workers_and_parts_make_the_same_bytes(self):
        moving = ('-F', '1-9', '--key', 'key@1=2000K,-2st', '--key', 'key@9=9000K,+2st')
        self.sequence(*moving, '--workers', '1', '--threads', '1')
        expected = self.bytes()
        self.sequence(*moving, '--workers', '4')
        self.assertEqual(self.bytes(), expected)
        for how in ('options', 'slurm'):
            for name in self.made():
                os.remove(self.path(name))
            for part in range(4):
                if how == 'options':
                    self.sequence(*moving, '--frame-index', part, '--frame-count', 4)
                else:
                    self.sequence(*moving, env={'SLURM_ARRAY_TASK_ID': str(2 + 3 * part), 'SLURM_ARRAY_TASK_MIN': '2',
                                                'SLURM_ARRAY_TASK_STEP': '3', 'SLURM_ARRAY_TASK_COUNT': '4'})
            self.assertEqual(self.bytes(), expected, how)
        self.deny('relight', self.solved, '-F', '1-3', '--frame-index', 4, '--frame-count', 4, '-o', self.path('x.%d.exr'), naming='part 4')
        self.deny('relight', self.solved, '-F', '1-3', '--frame-index', 0, '-o', self.path('x.%d.exr'), naming='together')

    def test_a_killed_batch_finishes_the_rest_and_nothing_else(self):
        big = cli.Capture(self.path('big'), height=540, width=960)
        solved = self.path('big.exr')
        self.succeed('solve', big.path, '-o', solved, '--model', 'transport', '-q')
        arguments = ('relight', solved, '-F', '1-30', '--key', 'key@1=-2st', '--key', 'key@30=+2st', '-o', self.path('out.%04d.exr'))
        process = subprocess.Popen([cli.PROGRAM, *arguments], stderr=subprocess.DEVNULL)
        while process.poll() is None and sum(name.endswith('.exr') and name.count('.') == 2 for name in self.made()) < 3:
            time.sleep(.01)
        process.send_signal(signal.SIGKILL)
        process.wait()
        there = {n for n in self.made() if n.count('.') == 2}
        self.assertTrue(3 <= len(there) < 30, there)
        before = {n: os.stat(self.path(n)).st_mtime_ns for n in there}
        result = json.loads(self.succeed(*arguments, '--skip-existing', '--json').stdout)
        self.assertEqual((result['written'], result['skipped'], result['failed']), (30 - len(there), len(there), 0))
        self.assertEqual({n: os.stat(self.path(n)).st_mtime_ns for n in there}, before)
        for frame in (1, 15, 30):
            self.assertGreater(cli.read_rgb(self.path(f'out.{frame:04d}.exr')).max(), 0)

    def test_one_line_a_frame(self):
        result = cli.run('relight', self.solved, '-F', '1-3', '-o', self.path('out.%04d.png'))
        lines = [line for line in result.stderr.splitlines() if line.startswith('Frame')]
        self.assertEqual(len(lines), 3)


if __name__ == '__main__':
    cli.main()

"""Pipes, Ctrl-C and limits: the program never waits for somebody who does not come, and ends when it is told to."""
import json
import os
import resource
import signal
import subprocess
import time

import cli


class PipeTest(cli.CliTest):
    def test_a_pipe_that_nobody_writes_to(self):
        os.mkfifo(self.path('pipe.json'))
        begun = time.time()
        self.deny('info', self.path('pipe.json'), naming=['pipe.json', 'pipe'])
        self.deny('relight', cli.Capture(self.path('set')).path, '--rig', self.path('pipe.json'),
                  '-o', self.path('o.exr'), naming='pipe.json')
        self.assertLess(time.time() - begun, 60)  # it would wait for ever

    def test_a_pipe_as_a_shot(self):
        capture = cli.Capture(self.path('set'))
        os.remove(self.path('set/shot_02.exr'))
        os.mkfifo(self.path('set/shot_02.exr'))
        self.deny('solve', capture.path, '-o', self.path('o.exr'), naming=['shot_02.exr', 'regular file'])
        self.deny('info', self.path('set/shot_02.exr'), naming=['shot_02.exr', 'regular file'])

    def test_what_a_shell_puts_in_the_place_of_a_file(self):
        capture = cli.Capture(self.path('set'))
        rig = json.dumps({'format': 'swaplight-rig', 'version': 1, 'lights': [{'name': 'key', 'color': 'off'}]})
        result = subprocess.run(['bash', '-c', '"$0" relight "$1" --rig <(sleep .2; echo "$2") -o "$3"', cli.PROGRAM,
                                 capture.path, rig, self.path('o.exr')], capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)


class StopTest(cli.CliTest):
    def wait_until_it_listens(self, process, number):
        """Until the process catches the signal: a busy machine starts it slowly."""
        for _ in range(600):
            with open(f'/proc/{process.pid}/status') as status:
                caught = next(line for line in status if line.startswith('SigCgt'))
            if int(caught.split()[1], 16) >> (number - 1) & 1:
                return
            time.sleep(.05)
        self.fail('the signal is never caught')

    def stop(self, number, *arguments):
        """Starts, sends the signal a moment later. Gives the exit code, the words, the seconds that it took."""
        process = subprocess.Popen([cli.PROGRAM, *arguments], stderr=subprocess.PIPE, text=True)
        self.wait_until_it_listens(process, number)
        time.sleep(.3)
        self.assertIsNone(process.poll(), 'done before it could be stopped')
        begun = time.time()
        process.send_signal(number)
        words = process.communicate(timeout=60)[1]
        return process.returncode, words, time.time() - begun

    def test_work_that_never_asks_is_ended_within_a_second(self):
        # A capture of which one shot comes out of a pipe with a silent writer.
        os.mkfifo(self.path('pipe.json'))
        keep = os.open(self.path('pipe.json'), os.O_RDWR)
        self.addCleanup(os.close, keep)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            code, words, seconds = self.stop(number, 'info', self.path('pipe.json'))
            self.assertEqual(code, 128 + number)
            self.assertEqual(words, 'swaplight: stopped\n')
            self.assertLess(seconds, 20)  # one second on a machine with nothing else to do

    def test_a_large_solve_stops_within_a_second_and_leaves_nothing(self):
        capture = cli.Capture(self.path('set'), height=2000, width=3000)
        for delay in (.1, .4, .8, 1.3):
            before = self.files()
            process = subprocess.Popen([cli.PROGRAM, 'solve', capture.path, '-o', self.path('o.exr'), '-q'],
                                       stderr=subprocess.PIPE, text=True)
            time.sleep(delay)
            process.send_signal(signal.SIGINT)
            begun = time.time()
            words = process.communicate(timeout=60)[1]
            self.assertLess(time.time() - begun, 20, 'the machine may be busy, but not that busy')
            if process.returncode == 0:
                break
            if process.returncode == 130:
                self.assertEqual(words, 'swaplight: stopped\n')
            else:
                self.assertEqual(process.returncode, -signal.SIGINT, 'before the program catches it')
            self.assertEqual(self.files(), before)


class LimitTest(cli.CliTest):
    def test_a_file_larger_than_the_limit(self):
        capture = cli.Capture(self.path('set'), height=120, width=160)
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))
        for name in ('o.exr', 'o.tif', 'o.png'):
            verb = ('solve', capture.path) if name == 'o.exr' else ('relight', capture.path)
            self.deny(*verb, '-o', self.path(name), '-q', naming='ulimit -f', code=3, preexec_fn=limit)
            self.deny(*verb, '-o', self.path(name), '-q', '--trust-pictures', naming=name, code=3, preexec_fn=limit)

    def test_too_little_memory_for_threads(self):
        capture = cli.Capture(self.path('set'))
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (500_000 << 10, 500_000 << 10))
        result = cli.run('solve', capture.path, '-o', self.path('o.exr'), '-q', preexec_fn=limit)
        self.assertIn(result.returncode, (0, 3), result.stderr)
        self.assertNotIn('should not', result.stderr)


if __name__ == '__main__':
    cli.main()

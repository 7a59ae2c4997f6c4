"""Verbs that are killed at some moment, and what they leave behind."""
import os
import random
import subprocess
import tempfile
import time

import cli


class Killer:
    """Kills solve, export, frames and sequences with SIGKILL. After each kill a file of the final name is whole or
    missing; at last the same command finishes, makes the same bytes, and leaves no temporary file."""

    def __init__(self, folder, seed=None):
        self.random = random.Random(seed)
        self.folder = folder
        self.capture = cli.Capture(os.path.join(folder, 'set'), height=240, width=320).path
        self.solved = os.path.join(folder, 'solved.exr')
        self.check([cli.PROGRAM, 'solve', self.capture, '-q', '-o', self.solved])
        self.truth, self.seconds = {}, {}
        with tempfile.TemporaryDirectory(dir=folder) as out:
            for name, command in self.commands(out).items():
                self.finish(name, command, out)
            self.truth = {name: cli.sha256(os.path.join(out, name)) for name in os.listdir(out)}
        self.kills = self.final = self.temporary = 0

    def finish(self, name, command, out):
        """How long all of it takes says when to kill the next; other work of the machine changes it."""
        begins = name not in self.seconds or not os.listdir(out)
        begun = time.time()
        self.check(command)
        if begins:
            self.seconds[name] = time.time() - begun

    def commands(self, out):
        begin = [cli.PROGRAM]
        return {'solve': [*begin, 'solve', self.capture, '-q', '-o', f'{out}/s.exr'],
                'export': [*begin, 'export', self.solved, '-q', '-o', f'{out}/l.exr'],
                'frame': [*begin, 'relight', self.solved, '-q', '-o', f'{out}/f.tif'],
                'sequence': [*begin, 'relight', self.solved, '-q', '-F', '1-6', '--key', 'key@1=-2st', '--key',
                             'key@6=+2st', '--skip-existing', '-o', f'{out}/f.%04d.exr']}

    @staticmethod
    def check(command):
        subprocess.run(command, check=True, capture_output=True)

    def kill(self, times=1):
        """One command, so many times in a row. Raises AssertionError."""
        with tempfile.TemporaryDirectory(dir=self.folder) as out:
            name, command = self.random.choice(sorted(self.commands(out).items()))
            for _ in range(times):
                self.kill_once(name, command, out)
            self.finish(name, command, out)
            self.compare(out, os.listdir(out), f'{name}, run again')
            assert self.truth.keys() & set(os.listdir(out)), f'{name}, run again: nothing is there'

    def kill_once(self, name, command, out):
        program = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(self.random.uniform(.3, 1.1) * self.seconds[name])
        program.kill()
        program.wait()
        whole = [found for found in os.listdir(out) if '.tmp' not in found]
        self.kills += 1
        self.final += bool(whole)
        self.temporary += len(whole) < len(os.listdir(out))
        self.compare(out, whole, f'{name}, killed')

    def compare(self, out, names, when):
        for name in names:
            assert name in self.truth, f'{when}: {name} stays'
            assert cli.sha256(os.path.join(out, name)) == self.truth[name], f'{when}: {name} differs'

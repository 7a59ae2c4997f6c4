"""What is said of a machine and of a crash: doctor, and the report that a crash leaves."""
import json
import os
import signal
import subprocess
import time

import swaplight_cli as cli


class DoctorTest(cli.CliTest):
    def test_says_what_there_is(self):
        said = json.loads(self.succeed('doctor', '--json').stdout)
        what = {fact['what']: fact for fact in said['facts']}
        for name in ('version', 'system', 'processor', 'memory', 'graphics', 'colour', 'pictures', 'cameras', 'lamps',
                     'fonts', 'settings', 'data', 'state', 'crashes'):
            self.assertIn(name, what)
            self.assertTrue(what[name]['words'])
        self.assertIn('processes of their own', what['pictures']['words'])
        self.assertIn('OpenImageIO', self.succeed('doctor').stdout)

    def test_names_a_broken_configuration(self):
        result = cli.run('doctor', env={'OCIO': self.path('none.ocio')})
        self.assertEqual(result.returncode, 0)
        self.assertIn('PROBLEM', result.stdout)
        self.assertIn('none.ocio', result.stdout)


class CrashReportTest(cli.CliTest):
    def test_a_crash_says_where_its_report_is(self):
        state = self.path('state')
        os.mkfifo(self.path('edits.json'))
        solved = self.path('solved.exr')
        self.succeed('solve', cli.Capture(self.path('set'), height=24, width=32).path, '-o', solved, '-q')
        for number in (signal.SIGSEGV, signal.SIGABRT):
            program = subprocess.Popen([cli.PROGRAM, 'relight', solved, '--edits', self.path('edits.json'), '-o', self.path('o.exr')],
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                       env={**os.environ, 'XDG_STATE_HOME': state})
            with open(self.path('edits.json'), 'w'):  # it waits for what it is to read
                time.sleep(.2)
                program.send_signal(number)
                said = program.communicate(timeout=30)[1]
            self.assertEqual(program.returncode, -number)
            self.assertEqual(said.count('\n'), 1, said)
            report = said.split(' stands in ')[1].strip()
            self.assertTrue(report.startswith(state))
            with open(report) as file:
                words = file.read()
            for expected in (number.name, 'verb: relight', 'system: ', 'pictures: ', os.path.basename(cli.PROGRAM) + '('):
                self.assertIn(expected, words)
            self.assertEqual(os.stat(report).st_mode & 0o777, 0o600)
        self.assertIn('2 reports', cli.run('doctor', env={'XDG_STATE_HOME': state}).stdout)


if __name__ == '__main__':
    cli.main()

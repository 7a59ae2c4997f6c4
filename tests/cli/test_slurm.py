"""An array job of a real Slurm (slurmctld, slurmd and munge of Debian, on this machine's loopback) makes the same bytes
as one process does."""
import os
import shutil
import socket
import subprocess
import sys
import time

import swaplight_cli as cli

CONFIG = """ClusterName=swaplight
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmdPort={nodePort}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


class SlurmTest(cli.CliTest):
    def skip(self, why):
        print('SKIPPED: ' + why, file=sys.stderr)
        self.skipTest(why)

    def start(self):
        paths = os.environ['PATH'] + ':/usr/sbin:/sbin'
        missing = [name for name in ('munged', 'slurmctld', 'slurmd', 'sbatch', 'sinfo') if not shutil.which(name, path=paths)]
        if missing:
            self.skip(f'{", ".join(missing)} missing (apt install slurmctld slurmd slurm-client munge)')
        if os.geteuid() != 0:
            self.skip('Slurm needs root here')
        folder = self.path('slurm')
        for name in ('state', 'spool'):
            os.makedirs(os.path.join(folder, name))
        os.chmod(self.folder, 0o755)
        with open(os.path.join(folder, 'munge.key'), 'wb') as file:
            file.write(os.urandom(128))
        os.chmod(os.path.join(folder, 'munge.key'), 0o600)
        conf = os.path.join(folder, 'slurm.conf')
        with open(conf, 'w') as file:
            file.write(CONFIG.format(host=socket.gethostname().split('.')[0], port=free_port(), nodePort=free_port(),
                                     folder=folder, cpus=os.cpu_count()))
        self.environment = {**os.environ, 'PATH': paths, 'SLURM_CONF': conf}
        for command in (['munged', '--foreground', '--force', f'--key-file={folder}/munge.key', f'--socket={folder}/munge.socket',
                         f'--pid-file={folder}/munge.pid', f'--log-file={folder}/munge.log', f'--seed-file={folder}/munge.seed'],
                        ['slurmctld', '-D', '-f', conf], ['slurmd', '-D', '-f', conf]):
            with open(os.path.join(folder, command[0] + '.out'), 'w') as log:
                process = subprocess.Popen(command, env=self.environment, stdout=log, stderr=log)
            self.addCleanup(self.end, process)
            time.sleep(1)
        for _ in range(60):
            state = subprocess.run(['sinfo', '-h', '-o', '%t'], env=self.environment, capture_output=True, text=True)
            if state.stdout.strip() in ('idle', 'mix'):
                return
            time.sleep(.5)
        logs = ''
        for name in os.listdir(folder):
            if name.endswith(('.log', '.out')):
                with open(os.path.join(folder, name), errors='replace') as file:
                    logs += file.read()[-600:]
        self.skip(f'Slurm did not start: {state.stdout}{state.stderr}\n{logs}')

    def end(self, process):
        process.terminate()
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def frames(self, name):
        return {file[len(name):]: cli.sha256(self.path(file))
                for file in os.listdir(self.folder) if file.startswith(name) and file.endswith('.exr')}

    def test_an_array_of_four_tasks_makes_the_same_bytes(self):
        self.start()
        capture = cli.Capture(self.path('set'))
        solved = self.path('solved.exr')
        self.succeed('solve', capture.path, '-o', solved, '-q')
        work = ['relight', solved, '-F', '1-10', '--key', 'key@1=-2st', '--key', 'key@10=2500K,+2st', '-o']
        self.succeed(*work, self.path('one.%04d.exr'))
        script = self.path('job.sh')
        with open(script, 'w') as file:
            file.write('#!/bin/sh\nexec ' + ' '.join([cli.PROGRAM, *work, self.path('array.%04d.exr')]) + '\n')
        job = subprocess.run(['sbatch', '--wait', '--array=0-3', '--chdir', self.folder, '--output', self.path('task_%a.log'), script],
                             env=self.environment, capture_output=True, text=True, timeout=180)
        self.assertEqual(job.returncode, 0, job.stdout + job.stderr)
        self.assertEqual(len(self.frames('one')), 10)
        self.assertEqual(self.frames('array'), self.frames('one'))
        for task in range(4):
            with open(self.path(f'task_{task}.log')) as file:
                self.assertIn('of', file.read())


if __name__ == '__main__':
    cli.main()

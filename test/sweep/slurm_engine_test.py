#!/usr/bin/python3
"""Slurm, with a controller and two nodes on this machine that the test starts: one slurmd is killed in mid-run with all
that it runs; the table is the one that the threads of one program make."""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import unittest

import engine_cases

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())

CONFIGURATION = '''
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
AuthType=auth/munge
AuthInfo=socket={directory}/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
JobRequeue=1
SlurmdTimeout=5
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,bf_interval=1,sched_min_interval=0
MpiDefault=none
PlugStackConfig={directory}/plugstack.conf
StateSaveLocation={directory}/state
SlurmdSpoolDir={directory}/spool.%n
SlurmctldPidFile={directory}/slurmctld.pid
SlurmdPidFile={directory}/slurmd.%n.pid
SlurmctldLogFile={directory}/slurmctld.log
SlurmdLogFile={directory}/slurmd.%n.log
NodeName=node1 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1 RealMemory=500
NodeName=node2 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1 RealMemory=500
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
'''


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(('127.0.0.1', 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


@unittest.skipUnless(os.getuid() == 0, 'Slurm starts tasks as root alone')
class SlurmEngine(unittest.TestCase):
    def setUp(self):
        self.directory = pathlib.Path(tempfile.mkdtemp(prefix='ratchet_sieve_'))
        self.addCleanup(shutil.rmtree, self.directory, ignore_errors=True)
        (self.directory / 'slurm.conf').write_text(CONFIGURATION.format(
            host=socket.gethostname().split('.')[0], directory=self.directory, ports=free_ports(3)))
        (self.directory / 'plugstack.conf').write_text('')
        (self.directory / 'state').mkdir()
        (self.directory / 'key').write_bytes(os.urandom(128))
        (self.directory / 'key').chmod(0o400)
        self.addCleanup(self.kill_leftovers)
        self.environment = dict(os.environ, SLURM_CONF=str(self.directory / 'slurm.conf'))
        names = {name: self.directory / f'munge.{name}' for name in ('socket', 'pid', 'log', 'seed')}
        self.daemon('munged', '--foreground', '--force', '--key-file', self.directory / 'key', '--socket', names['socket'],
                    '--pid-file', names['pid'], '--log-file', names['log'], '--seed-file', names['seed'])
        engine_cases.wait_for(names['socket'].exists, 'munged answered')
        self.daemon('slurmctld', '-D')
        self.nodes = [self.daemon('slurmd', '-D', '-N', name) for name in ('node1', 'node2')]
        engine_cases.wait_for(lambda: self.nodes_are('idle') == 2, 'both nodes were idle')
        self.expected = engine_cases.reference(PROGRAM, self.directory)

    def kill_leftovers(self):
        """A task's slurmstepd is no child of slurmd, but has its environment."""
        own = f'SLURM_CONF={self.directory}'.encode()
        for directory in pathlib.Path('/proc').glob('[0-9]*'):
            try:
                if own in (directory / 'environ').read_bytes():
                    os.kill(int(directory.name), signal.SIGKILL)
            except OSError:
                pass

    def daemon(self, name, *arguments):
        program = shutil.which(name, path='/usr/sbin:/usr/bin')
        with open(self.directory / f'{name}.out', 'a', encoding='utf-8') as log:
            process = subprocess.Popen([program, *arguments], env=self.environment, stdout=log, stderr=log)
        self.addCleanup(engine_cases.kill_all, process)
        return process

    def ask(self, *words):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, check=False).stdout

    def nodes_are(self, state):
        return self.ask('sinfo', '-h', '-N', '-o', '%t').split().count(state)

    def start(self):
        process = subprocess.Popen([PROGRAM, 'run', 's.yaml', '--engine', 'slurm', '--per-job', '2'], cwd=self.directory,
                                   env=self.environment, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        return process

    def expect_same_table(self, process):
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 0, errors)
        self.assertEqual(engine_cases.table(self.directory / 's.db'), self.expected)

    def test_a_node_killed_in_mid_run_loses_nothing(self):
        process = self.start()
        engine_cases.wait_for(lambda: engine_cases.count(self.directory / 's.db') >= 2 and
                              'node2' in self.ask('squeue', '-h', '-t', 'R', '-o', '%N'), 'node2 worked', process)
        engine_cases.kill_all(self.nodes[1])
        self.assertLess(engine_cases.count(self.directory / 's.db'), engine_cases.CASES)
        self.expect_same_table(process)

    def test_a_coordinator_that_is_killed_goes_on(self):
        process = self.start()
        engine_cases.wait_for(lambda: engine_cases.count(self.directory / 's.db') >= 2, 'a few cases were done', process)
        engine_cases.kill_all(process)
        self.assertLess(engine_cases.count(self.directory / 's.db'), engine_cases.CASES)
        self.expect_same_table(self.start())

    def test_interrupted_it_leaves_nothing_in_the_queue(self):
        process = self.start()
        engine_cases.wait_for(lambda: engine_cases.count(self.directory / 's.db') >= 2, 'a few cases were done', process)
        process.send_signal(signal.SIGINT)
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 130, errors)
        self.assertEqual(self.ask('squeue', '-h'), '')


if __name__ == '__main__':
    unittest.main()

#!/usr/bin/python3
"""Slurm, with a controller and two nodes on this machine that the test starts: one slurmd is killed during the run with
all its tasks; the table equals that of a run on threads."""
import getpass
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import unittest

import engine_cases

CONFIGURATION = '''
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
AuthType=auth/munge
AuthInfo=socket={directory}/munge.socket
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
JobRequeue=1
SlurmdTimeout=3
MessageTimeout=3
TCPTimeout=1
KillWait=1
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


def case_of(pid):
    """The case file that a process runs; None for other programs."""
    try:
        words = (pathlib.Path('/proc') / str(pid) / 'cmdline').read_bytes().decode().split('\0')
        directory = pathlib.Path(os.readlink(f'/proc/{pid}/cwd'))
    except OSError:
        return None
    return directory / words[2] if words[1:2] == ['case'] else None


class SlurmEngine(engine_cases.EngineTest):
    def setUp(self):
        super().setUp()
        (self.directory / 'slurm.conf').write_text(CONFIGURATION.format(
            user=getpass.getuser(), host=socket.gethostname().split('.')[0], directory=self.directory,
            ports=free_ports(3)))
        (self.directory / 'plugstack.conf').write_text('')
        # Given explicitly, because slurmd exits if no control groups are mounted (in a bare root).
        (self.directory / 'cgroup.conf').write_text('CgroupPlugin=cgroup/v1\n')
        (self.directory / 'state').mkdir()
        (self.directory / 'key').write_bytes(os.urandom(128))
        (self.directory / 'key').chmod(0o400)
        self.environment = dict(os.environ, SLURM_CONF=str(self.directory / 'slurm.conf'))
        names = {name: self.directory / f'munge.{name}' for name in ('socket', 'pid', 'log', 'seed')}
        self.daemon('munged', '--foreground', '--force', '--key-file', self.directory / 'key', '--socket', names['socket'],
                    '--pid-file', names['pid'], '--log-file', names['log'], '--seed-file', names['seed'])
        engine_cases.wait_for(names['socket'].exists, 'munged answered')
        self.daemon('slurmctld', '-D')
        self.nodes = [self.daemon('slurmd', '-D', '-N', name) for name in ('node1', 'node2')]
        engine_cases.wait_for(lambda: self.nodes_are('idle') == 2, 'both nodes were idle')

    def daemon(self, name, *arguments):
        program = shutil.which(name, path='/usr/sbin:/usr/bin')
        with open(self.directory / f'{name}.out', 'a', encoding='utf-8') as log:
            return self.background(program, *arguments, env=self.environment, stdout=log, stderr=log)

    def ask(self, *words):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, check=False).stdout

    def nodes_are(self, state):
        return self.ask('sinfo', '-h', '-N', '-o', '%t').split().count(state)

    def start(self):
        return self.start_sweep('--engine', 'slurm', '--per-job', '3', env=self.environment)

    def start_and_wait(self):
        process = self.start()
        engine_cases.wait_for(lambda: self.rows() >= 3, 'a few cases were done', process)
        self.expect_under_way()
        return process

    def steps_of(self, node):
        """The processes of a node that are no children of its slurmd: its tasks and their slurmstepd."""
        steps = set()
        for pid in engine_cases.descendants(os.getpid()):
            directory = pathlib.Path('/proc') / str(pid)
            try:
                if f'SLURMD_NODENAME={node}'.encode() in (directory / 'environ').read_bytes().split(b'\0'):
                    steps |= {pid, int((directory / 'stat').read_text().rsplit(')', 1)[1].split()[1])}
            except OSError:
                continue
        return steps - {os.getpid()}

    def freeze_in_mid_case(self, node):
        """Stops the tasks of a node if they run cases without results."""
        steps = self.steps_of(node)
        engine_cases.send(steps, signal.SIGSTOP)
        cases = [path for path in map(case_of, steps) if path]
        if cases and not any(path.with_suffix('.results').exists() for path in cases):
            return True
        engine_cases.send(steps, signal.SIGCONT)
        return False

    def start_and_freeze_node2(self):
        process = self.start_and_wait()
        engine_cases.wait_for(lambda: self.freeze_in_mid_case('node2'), 'node2 was at a case', process)
        self.expect_under_way()
        return process

    def test_a_node_killed_in_mid_run_loses_nothing(self):
        process = self.start_and_freeze_node2()
        steps = self.steps_of('node2')
        engine_cases.kill_all(self.nodes[1].pid)
        engine_cases.send(steps, signal.SIGKILL)
        self.expect_same_table(process)

    def test_a_case_counts_once_that_a_node_given_up_for_lost_runs_on(self):
        process = self.start_and_freeze_node2()
        engine_cases.kill_all(self.nodes[1].pid)
        engine_cases.send(self.steps_of('node2'), signal.SIGCONT)
        self.expect_same_table(process)

    def test_a_coordinator_that_is_killed_goes_on(self):
        engine_cases.kill_all(self.start_and_wait().pid)
        self.expect_under_way()
        self.expect_same_table(self.start())

    def test_a_directory_may_be_named_like_a_pattern_of_slurm(self):
        place = self.directory / 'a b; %j'
        place.mkdir()
        process = self.start_sweep('--engine', 'slurm', '--per-job', '3', '--db', place / 's.db', env=self.environment)
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 0, errors)
        self.assertEqual(engine_cases.table(place / 's.db'), engine_cases.reference())

    def test_interrupted_it_leaves_nothing_in_the_queue(self):
        self.expect_interrupted(self.start_and_wait())
        self.assertEqual(self.ask('squeue', '-h'), '')


if __name__ == '__main__':
    unittest.main()

#!/usr/bin/python3
"""The recipes of docs/sweeps.md for many machines, with real sshd, GNU parallel and Slurm on this one. Hosts, nodes and
what hands out the parts are killed during the run; the merged table equals that of one run."""
import ctypes
import functools
import getpass
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from ratchet_sieve.processes import free_port

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / 'docs/sweeps.md'

TIME_LIMIT = 180  # of a test [s]; about ten times its duration on an idle machine
PR_SET_CHILD_SUBREAPER = 36  # of linux/prctl.h

SCENE = '''
base: {teeth: 4, asymmetry: 0.1}
boundary: periodic
species:
  - {name: A, count: 6, radius: 0.001, mass: 0.010}
  - {name: B, count: 6, radius: 0.003, mass: 0.001}
duration: 200
'''
SWEEP = '''
scene: paper_fig9.yaml
grid: {base.inclination: [-0.1, 0, 0.1]}
seed: {first: 1, count: 12}
'''

SLURM = '''
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


def recipe(heading):
    """The commands below a heading of the document, and last the one that merges."""
    block = re.search(rf'^## {heading}$.*?^```sh\n(.*?)^```', DOCUMENT.read_text(), re.MULTILINE | re.DOTALL).group(1)
    commands = re.sub(r'rosrun ratchet_sieve sieve_sweep|/\S*/sieve_sweep', PROGRAM, block).strip()
    return commands.rsplit('\n', 1)


def table(directory):
    """The exported results, without wall time and host, which are the last two columns."""
    lines = subprocess.run([PROGRAM, 'export', 'fig9.yaml'], cwd=directory, check=True, capture_output=True).stdout.splitlines()
    return [line.rsplit(b',', 2)[0] for line in lines]


def write_sweep(directory):
    (directory / 'paper_fig9.yaml').write_text(SCENE)
    (directory / 'fig9.yaml').write_text(SWEEP)


@functools.lru_cache(maxsize=None)
def reference():
    """The table of one run."""
    with tempfile.TemporaryDirectory(prefix='ratchet_sieve_') as name:
        write_sweep(pathlib.Path(name))
        subprocess.run([PROGRAM, 'run', 'fig9.yaml'], cwd=name, check=True, stderr=subprocess.DEVNULL)
        return table(name)


def wait_for(condition, what, process=None):
    """Waits for a condition, at most until the test's time limit."""
    while not condition():
        if process is not None and process.poll() is not None:
            raise AssertionError(f'ended before {what}: {process.returncode}')
        time.sleep(0.02)


def descendants(pid):
    """All descendants of a process."""
    children = {}
    for directory in pathlib.Path('/proc').glob('[0-9]*'):
        try:
            parent = int((directory / 'stat').read_text().rsplit(')', 1)[1].split()[1])
        except OSError:
            continue
        children.setdefault(parent, []).append(int(directory.name))
    found = []
    waiting = [pid]
    while waiting:
        found += children.get(waiting[-1], [])
        waiting = waiting[:-1] + children.get(waiting[-1], [])
    return found


def kill_all(*pids):
    """Kills processes and their descendants. Each is stopped first, so that none starts another meanwhile."""
    stopped = set()
    while True:
        alive = {*pids, *(child for pid in pids for child in descendants(pid))} - stopped
        if not alive:
            break
        send(alive, signal.SIGSTOP)
        stopped |= alive
    send(stopped, signal.SIGKILL)


def send(pids, number):
    """Sends a signal to those processes that still exist."""
    for pid in pids:
        try:
            os.kill(pid, number)
        except ProcessLookupError:
            pass


def runs_part(pid):
    """Whether a process runs a part of the sweep."""
    try:
        return (pathlib.Path('/proc') / str(pid) / 'cmdline').read_bytes().startswith(f'{PROGRAM}\0run\0'.encode())
    except OSError:
        return False


class ManyMachinesTest(unittest.TestCase):
    """A test with its own directory and time limit, which leaves no process behind in any case."""

    def setUp(self):
        # An orphaned process, for example a task of Slurm, becomes a child of this process.
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        signal.signal(signal.SIGALRM, self.give_up)
        signal.alarm(TIME_LIMIT)
        self.addCleanup(signal.alarm, 0)
        self.directory = pathlib.Path(tempfile.mkdtemp(prefix='ratchet_sieve_'))
        self.addCleanup(shutil.rmtree, self.directory, ignore_errors=True)
        self.addCleanup(lambda: kill_all(*descendants(os.getpid())))
        self.environment = dict(os.environ)
        write_sweep(self.directory)

    @staticmethod
    def give_up(*_):
        raise TimeoutError(f'not through after {TIME_LIMIT} s')

    def background(self, *words, **options):
        """Starts a program. It ends with the test."""
        with open(self.directory / 'log', 'a', encoding='utf-8') as log:
            process = subprocess.Popen(words, cwd=self.directory, env=self.environment, stdout=log, stderr=log, **options)
        self.addCleanup(process.wait)
        self.addCleanup(kill_all, process.pid)
        return process

    def start(self, command):
        return self.background('bash', '-c', command)

    def expect_done(self, process):
        self.assertEqual(process.wait(), 0, (self.directory / 'log').read_text())

    def expect_same_table(self, merge):
        self.expect_done(self.start(merge))
        self.assertEqual(table(self.directory), reference())


class OverSsh(ManyMachinesTest):
    def setUp(self):
        super().setUp()
        if os.getuid() == 0:
            os.makedirs('/run/sshd', exist_ok=True)
        subprocess.run(['ssh-keygen', '-q', '-t', 'ed25519', '-N', '', '-f', self.directory / 'key'], check=True)
        self.hosts = [self.host(name) for name in ('host1', 'host2')]
        commands, self.merge = recipe('On many computers over ssh')
        self.run_parts = commands.split('\n', 1)[1]
        (self.directory / 'hosts').write_text(
            ''.join(f'1//usr/bin/ssh -F {self.directory}/ssh {name}\n' for name in ('host1', 'host2')))

    def host(self, name):
        """An sshd under a name known only to this test's ssh. Logins have an empty home directory, because the user's
        own shell scripts may have any effect."""
        port = free_port()
        home = self.directory / name
        home.mkdir()
        config = self.directory / f'{name}.sshd'
        config.write_text(f'Port {port}\nListenAddress 127.0.0.1\nHostKey {self.directory}/key\nUsePAM no\n'
                          f'PidFile none\nAuthorizedKeysFile {self.directory}/key.pub\nStrictModes no\nMaxStartups 100\n'
                          f'SetEnv HOME={home}\nForceCommand cd {home} && exec sh -c "$SSH_ORIGINAL_COMMAND"\n')
        with open(self.directory / 'ssh', 'a', encoding='utf-8') as clients:
            clients.write(f'Host {name}\n  HostName 127.0.0.1\n  Port {port}\n  User {getpass.getuser()}\n'
                          f'  IdentityFile {self.directory}/key\n  StrictHostKeyChecking no\n'
                          '  UserKnownHostsFile /dev/null\n  LogLevel ERROR\n')
        sshd = self.background(shutil.which('sshd', path='/usr/sbin:' + os.environ['PATH']), '-D', '-e', '-r', '-f', config)

        def answers():
            with socket.socket() as probe:
                return probe.connect_ex(('127.0.0.1', port)) == 0
        wait_for(answers, 'it answered', sshd)
        return sshd

    def start_and_wait(self):
        process = self.start(self.run_parts)
        wait_for(lambda: any(map(runs_part, descendants(self.hosts[1].pid))), 'the second host worked', process)
        return process

    def test_a_host_killed_in_mid_run_loses_nothing(self):
        process = self.start_and_wait()
        kill_all(self.hosts[1].pid)
        self.expect_done(process)
        self.expect_same_table(self.merge)

    def test_killed_the_same_command_goes_on(self):
        kill_all(self.start_and_wait().pid)
        self.expect_done(self.start(self.run_parts))
        self.expect_same_table(self.merge)


class OnSlurm(ManyMachinesTest):
    def setUp(self):
        super().setUp()
        (self.directory / 'slurm.conf').write_text(SLURM.format(
            user=getpass.getuser(), host=socket.gethostname().split('.')[0], directory=self.directory, ports=[free_port() for _ in range(3)]))
        (self.directory / 'plugstack.conf').write_text('')
        # Given explicitly, because slurmd exits if no control groups are mounted (in a bare root).
        (self.directory / 'cgroup.conf').write_text('CgroupPlugin=cgroup/v1\n')
        (self.directory / 'state').mkdir()
        (self.directory / 'key').write_bytes(os.urandom(128))
        (self.directory / 'key').chmod(0o400)
        self.environment.update(SLURM_CONF=f'{self.directory}/slurm.conf', PATH='/usr/sbin:' + os.environ['PATH'])
        names = {name: self.directory / f'munge.{name}' for name in ('socket', 'pid', 'log', 'seed')}
        self.background('munged', '--foreground', '--force', '--key-file', self.directory / 'key', '--socket', names['socket'],
                        '--pid-file', names['pid'], '--log-file', names['log'], '--seed-file', names['seed'])
        wait_for(names['socket'].exists, 'munged answered')
        self.background('slurmctld', '-D')
        self.nodes = [self.background('slurmd', '-D', '-N', name) for name in ('node1', 'node2')]
        wait_for(lambda: self.ask('sinfo', '-h', '-N', '-o', '%t').stdout.split().count('idle') == 2, 'both nodes were idle')
        submit, self.merge = recipe('On a Slurm cluster')
        # The test waits by itself: sbatch looks for the end only now and then.
        self.submit = submit.replace('--cpus-per-task=16', '--cpus-per-task=1').replace('--wait ', '')
        self.requeued = set()

    def ask(self, *words):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, check=False)

    def steps_of_node2(self):
        """The processes of the second node that are no children of its slurmd: its tasks and their slurmstepd."""
        steps = set()
        for pid in descendants(os.getpid()):
            directory = pathlib.Path('/proc') / str(pid)
            try:
                if b'SLURMD_NODENAME=node2' in (directory / 'environ').read_bytes().split(b'\0'):
                    steps |= {pid, int((directory / 'stat').read_text().rsplit(')', 1)[1].split()[1])}
            except OSError:
                continue
        return steps - {os.getpid()}

    def is_through(self):
        """Whether no task is left. Tasks of a lost node are started at once, which Slurm holds for two minutes."""
        queue = self.ask('squeue', '-h', '-o', '%i %r')
        tasks = [line.split() for line in queue.stdout.splitlines()]
        held = [words[0] for words in tasks if words[1] == 'BeginTime']
        for task in held:
            self.ask('scontrol', 'update', f'jobid={task}', 'StartTime=now')
        self.requeued |= {*held}
        return queue.returncode == 0 and not tasks

    def test_a_node_killed_in_mid_run_loses_nothing(self):
        self.expect_done(self.start(self.submit))
        wait_for(lambda: any(map(runs_part, self.steps_of_node2())), 'the second node worked')
        steps = self.steps_of_node2()
        kill_all(self.nodes[1].pid)
        send(steps, signal.SIGKILL)
        wait_for(self.is_through, 'all was done')
        self.assertTrue(self.requeued)
        self.expect_same_table(self.merge)


if __name__ == '__main__':
    unittest.main()

#!/usr/bin/python3
"""GNU parallel over ssh, on two hosts that are sshd on this machine: one of them is killed during the run, then
the coordinator; the table equals that of a run on threads."""
import getpass
import os
import shutil
import socket
import subprocess
import unittest

import engine_cases

def free_port():
    with socket.socket() as any_socket:
        any_socket.bind(('127.0.0.1', 0))
        return any_socket.getsockname()[1]


class Host:
    """An sshd under a name known only to this test's ssh. Logins have an empty home directory, because the user's own
    shell scripts may have any effect."""

    def __init__(self, test, name):
        directory = test.directory
        self.name, self.port = name, free_port()
        home = directory / name
        home.mkdir()
        config = directory / f'{name}.sshd'
        config.write_text(f'Port {self.port}\nListenAddress 127.0.0.1\nHostKey {directory}/key\nUsePAM no\n'
                          f'PidFile none\nAuthorizedKeysFile {directory}/key.pub\nStrictModes no\nMaxStartups 100\n'
                          f'SetEnv HOME={home}\nForceCommand cd {home} && exec sh -c "$SSH_ORIGINAL_COMMAND"\n')
        program = shutil.which('sshd', path='/usr/sbin:' + os.environ['PATH'])
        with open(directory / f'{name}.log', 'w', encoding='utf-8') as log:
            self.sshd = test.background(program, '-D', '-e', '-r', '-f', config, stderr=log)

    def client_config(self, directory):
        return (f'Host {self.name}\n  HostName 127.0.0.1\n  Port {self.port}\n  User {getpass.getuser()}\n'
                f'  IdentityFile {directory}/key\n  StrictHostKeyChecking no\n  UserKnownHostsFile /dev/null\n'
                '  LogLevel ERROR\n')

    def answers(self):
        with socket.socket() as probe:
            return probe.connect_ex(('127.0.0.1', self.port)) == 0


class ParallelEngine(engine_cases.EngineTest):
    def setUp(self):
        super().setUp()
        if os.getuid() == 0:
            os.makedirs('/run/sshd', exist_ok=True)
        subprocess.run(['ssh-keygen', '-q', '-t', 'ed25519', '-N', '', '-f', self.directory / 'key'], check=True)
        self.hosts = [Host(self, name) for name in ('host1', 'host2')]
        for host in self.hosts:
            engine_cases.wait_for(host.answers, 'it answered', host.sshd)
        config = self.directory / 'ssh'
        config.write_text(''.join(host.client_config(self.directory) for host in self.hosts))
        (self.directory / 'hosts').write_text(''.join(f'2//usr/bin/ssh -F {config} {host.name}\n' for host in self.hosts))

    def start(self):
        return self.start_sweep('--engine', 'parallel', '--hosts', 'hosts', '--per-job', '6')

    def start_with(self, hosts, *options, **environment):
        (self.directory / 'hosts').write_text(hosts)
        return self.start_sweep('--engine', 'parallel', '--hosts', 'hosts', '--per-job', '6', *options, **environment)

    def joblog(self):
        """GNU parallel's log of completed jobs."""
        return ''.join(path.read_text() for path in self.directory.glob('s.db.d/*.cases/joblog'))

    def start_and_wait(self):
        process = self.start()
        engine_cases.wait_for(lambda: self.rows() >= 3, 'a few cases were done', process)
        self.expect_under_way()
        return process

    def test_a_host_killed_in_mid_run_loses_nothing(self):
        process = self.start()
        engine_cases.wait_for(lambda: 'host2' in self.joblog(), 'the second host worked', process)
        engine_cases.kill_all(self.hosts[1].sshd.pid)
        self.expect_under_way()
        self.expect_same_table(process)

    def test_a_coordinator_that_is_killed_goes_on(self):
        engine_cases.kill_all(self.start_and_wait().pid)
        self.expect_under_way()
        self.expect_same_table(self.start())

    def test_interrupted_it_stops_and_goes_on(self):
        self.expect_interrupted(self.start_and_wait())
        self.expect_same_table(self.start())

    def test_this_machine_may_be_the_only_host_in_a_bare_environment(self):
        """As an unattended run has it: a home that cannot be written and no SHELL."""
        bare = {'PATH': os.environ['PATH'], 'HOME': '/proc'}
        self.expect_same_table(self.start_with('# slots/login\n2/:\n', env=bare))

    def test_this_machine_works_beside_others_wherever_the_program_stands(self):
        place = self.directory / "a b; 'c' {} {.} $d"
        place.mkdir()
        (place / 'sieve_sweep').symlink_to(engine_cases.PROGRAM)
        process = self.start_with('1/:\n1/' + (self.directory / 'hosts').read_text().splitlines()[0][2:] + '\n',
                                  '--program', place / 'sieve_sweep')
        engine_cases.wait_for(lambda: all(name in self.joblog() for name in ('host1', 'localhost')), 'both worked', process)
        self.expect_same_table(process)

    def test_two_coordinators_of_one_sweep_share_it(self):
        both = [self.start(), self.start()]
        errors = [process.communicate()[1] for process in both]
        self.assertEqual([process.returncode for process in both], [0, 0], errors)
        self.assertIn('also runs this sweep', ''.join(errors))
        self.assertEqual(engine_cases.table(self.directory / 's.db'), engine_cases.reference())

    def test_two_sweeps_of_one_results_file_keep_apart(self):
        (self.directory / 't.yaml').write_text(engine_cases.SWEEP.replace(
            'grid: {', 'set: {duration: 20}\ngrid: {base.frequency: [23, 20], '))
        options = ('--engine', 'parallel', '--hosts', 'hosts', '--per-job', '6', '--db')
        both = [self.start_sweep(*options, 's.db'), self.start_sweep(*options, 's.db', sweep='t.yaml')]
        errors = [process.communicate()[1] for process in both]
        self.assertEqual([process.returncode for process in both], [0, 0], errors)
        for sweep in ('s.yaml', 't.yaml'):
            process = self.start_sweep('--db', 'threads.db', sweep=sweep)
            process.communicate()
        self.assertEqual(engine_cases.table(self.directory / 's.db'), engine_cases.table(self.directory / 'threads.db'))

    def test_hosts_that_do_not_answer_are_an_error(self):
        for host in self.hosts:
            engine_cases.kill_all(host.sshd.pid)
        process = self.start()
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 1, errors)
        self.assertIn('no result came back; ', errors)


if __name__ == '__main__':
    unittest.main()

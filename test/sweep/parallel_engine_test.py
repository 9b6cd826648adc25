#!/usr/bin/python3
"""GNU parallel over ssh, on two hosts that are sshd on this machine: one of them is killed in mid-run, then the
coordinator is; the table is the one that the threads of one program make."""
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
    """An sshd of its own, by a name that only this test's ssh knows. Who logs in finds an empty home: the user's own shell
    scripts may do anything."""

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

    def start_and_wait(self):
        process = self.start()
        engine_cases.wait_for(lambda: self.rows() >= 3, 'a few cases were done', process)
        self.expect_under_way()
        return process

    def test_a_host_killed_in_mid_run_loses_nothing(self):
        process = self.start()
        joblog = self.directory / 's.db.d/cases/joblog'
        engine_cases.wait_for(lambda: joblog.exists() and 'host2' in joblog.read_text(), 'the second host worked', process)
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

    def test_hosts_that_do_not_answer_are_an_error(self):
        for host in self.hosts:
            engine_cases.kill_all(host.sshd.pid)
        process = self.start()
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 1, errors)
        self.assertIn('no result came back; ', errors)


if __name__ == '__main__':
    unittest.main()

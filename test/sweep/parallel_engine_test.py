#!/usr/bin/python3
"""GNU parallel over ssh, on two hosts that are sshd on this machine: one of them is killed in mid-run, then the
coordinator is; the table is the one that the threads of one program make."""
import getpass
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


def free_port():
    with socket.socket() as any_socket:
        any_socket.bind(('127.0.0.1', 0))
        return any_socket.getsockname()[1]


class Host:
    """An sshd of its own, by a name that only this test's ssh knows."""

    def __init__(self, directory, name):
        self.name, self.port = name, free_port()
        config = directory / f'{name}.sshd'
        config.write_text(f'Port {self.port}\nListenAddress 127.0.0.1\nHostKey {directory}/key\nUsePAM no\n'
                          f'PidFile none\nAuthorizedKeysFile {directory}/key.pub\nStrictModes no\nMaxStartups 100\n')
        with open(directory / f'{name}.log', 'w', encoding='utf-8') as log:
            self.sshd = subprocess.Popen([shutil.which('sshd', path='/usr/sbin:' + os.environ['PATH']), '-D', '-e', '-r',
                                          '-f', config], stderr=log)

    def client_config(self, directory):
        return (f'Host {self.name}\n  HostName 127.0.0.1\n  Port {self.port}\n  User {getpass.getuser()}\n'
                f'  IdentityFile {directory}/key\n  StrictHostKeyChecking no\n  UserKnownHostsFile /dev/null\n'
                '  LogLevel ERROR\n')

    def answers(self):
        with socket.socket() as probe:
            return probe.connect_ex(('127.0.0.1', self.port)) == 0


class ParallelEngine(unittest.TestCase):
    def setUp(self):
        self.directory = pathlib.Path(tempfile.mkdtemp(prefix='ratchet_sieve_'))
        self.addCleanup(shutil.rmtree, self.directory)
        if os.getuid() == 0:
            os.makedirs('/run/sshd', exist_ok=True)
        subprocess.run(['ssh-keygen', '-q', '-t', 'ed25519', '-N', '', '-f', self.directory / 'key'], check=True)
        self.hosts = [Host(self.directory, name) for name in ('host1', 'host2')]
        for host in self.hosts:
            self.addCleanup(engine_cases.kill_all, host.sshd)
            engine_cases.wait_for(host.answers, 'it answered', host.sshd)
        config = self.directory / 'ssh'
        config.write_text(''.join(host.client_config(self.directory) for host in self.hosts))
        (self.directory / 'hosts').write_text(''.join(f'2//usr/bin/ssh -F {config} {host.name}\n' for host in self.hosts))
        self.expected = engine_cases.reference(PROGRAM, self.directory)

    def start(self):
        process = subprocess.Popen([PROGRAM, 'run', 's.yaml', '--engine', 'parallel', '--hosts', 'hosts', '--per-job', '3'],
                                   cwd=self.directory, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        return process

    def rows(self):
        return engine_cases.count(self.directory / 's.db')

    def expect_same_table(self, process):
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 0, errors)
        self.assertEqual(engine_cases.table(self.directory / 's.db'), self.expected)
        self.assertFalse((self.directory / 's.db.d').exists())

    def test_a_host_killed_in_mid_run_loses_nothing(self):
        process = self.start()
        joblog = self.directory / 's.db.d/cases/joblog'
        engine_cases.wait_for(lambda: joblog.exists() and 'host2' in joblog.read_text(), 'the second host worked', process)
        engine_cases.kill_all(self.hosts[1].sshd)
        self.assertLess(self.rows(), engine_cases.CASES)
        self.expect_same_table(process)

    def test_a_coordinator_that_is_killed_goes_on(self):
        process = self.start()
        engine_cases.wait_for(lambda: self.rows() >= 4, 'a few cases were done', process)
        engine_cases.kill_all(process)
        self.assertLess(self.rows(), engine_cases.CASES)
        self.expect_same_table(self.start())

    def test_interrupted_it_stops_and_goes_on(self):
        process = self.start()
        engine_cases.wait_for(lambda: self.rows() >= 4, 'a few cases were done', process)
        process.send_signal(signal.SIGINT)
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 130, errors)
        self.assertIn('the same command goes on', errors)
        self.expect_same_table(self.start())

    def test_hosts_that_do_not_answer_are_an_error(self):
        for host in self.hosts:
            engine_cases.kill_all(host.sshd)
        process = self.start()
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 1, errors)
        self.assertIn('no result came back; ', errors)


if __name__ == '__main__':
    unittest.main()

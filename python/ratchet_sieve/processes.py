"""Other programs: waiting for them, and a ROS master."""
import contextlib
import os
import socket
import subprocess
import time

TIMEOUT = 60.0  # on a slow machine [s]


def wait_for(condition, what):
    """Waits until the condition holds."""
    deadline = time.monotonic() + TIMEOUT
    while not condition():
        if time.monotonic() > deadline:
            raise RuntimeError(f'{what}: not within {TIMEOUT:g} s')
        time.sleep(0.05)


def free_port():
    with socket.socket() as listener:
        listener.bind(('localhost', 0))
        return listener.getsockname()[1]


def choose_master(scratch):
    """Makes a free port that of the master; logs go into the scratch directory. @return the port"""
    port = str(free_port())
    os.environ.update(ROS_MASTER_URI=f'http://localhost:{port}', ROS_HOSTNAME='localhost', ROS_HOME=str(scratch),
                      ROS_LOG_DIR=str(scratch / 'log'), ROSCONSOLE_FORMAT='${walltime} ${message}')
    os.environ.pop('ROS_IP', None)
    return port


@contextlib.contextmanager
def master(scratch):
    """A roscore that ends with the block."""
    import rosgraph  # without ROS there is none

    core = subprocess.Popen(['roscore', '-p', choose_master(scratch)],
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        client = rosgraph.Master('/ratchet_sieve')
        wait_for(lambda: core.poll() is None and client.is_online(), 'roscore answers')
        yield client
    finally:
        core.terminate()
        core.wait()

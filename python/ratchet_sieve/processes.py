"""Waiting for other programs."""
import socket
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

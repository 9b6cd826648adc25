"""Tests of ROS nodes as they are, in step: the sieve stands still while the node decides (docs/your_package.md)."""
import time

import rospy
from std_srvs.srv import Empty

from ratchet_sieve.msg import BaseState, Command
from ratchet_sieve.srv import ResetSimulation, StepSimulation

POLL = 0.001  # [s of wall time]


class InStep:
    """A sieve that moves by steps alone. `time`: where it stands [s]; None before the first reset()."""

    def __init__(self, sieve='sieve', timeout=60.0):
        """@param sieve name of its node @param timeout of each wait [s of wall time]"""
        self.name, self.timeout, self.time = rospy.resolve_name(sieve), timeout, None
        self._base, self._echoes = None, []
        rospy.Subscriber(f'{self.name}/base', BaseState, self._take_base, tcp_nodelay=True)
        rospy.Subscriber(f'{self.name}/commands', Command, self._echoes.append, tcp_nodelay=True)
        for service in ('pause_physics', 'reset', 'step'):
            rospy.wait_for_service(f'{self.name}/{service}', timeout)
        self.wait_for(lambda: self._base, 'base')

    def _take_base(self, base):
        self._base = base

    def _call(self, name, kind, *request):
        answer = rospy.ServiceProxy(f'{self.name}/{name}', kind)(*request)
        if not getattr(answer, 'success', True):
            raise RuntimeError(f'{self.name}/{name}: {answer.message}')
        return answer

    def reset(self, seed=0, overrides=()):
        """Pauses it, and begins a run. @param seed 0: the scene's @param overrides such as 'base.inclination=0.1'"""
        self._call('pause_physics', Empty)
        self._base = None
        self._echoes.clear()
        self._call('reset', ResetSimulation, seed, overrides, False)
        self.time = 0.0
        self.wait_for(lambda: self._base and self._base.time == 0.0, 'new run')

    def step(self, duration):
        """Advances it. @param duration [s]"""
        self.time = self._call('step', StepSimulation, duration).time

    def wait_for_setpoint(self, quantity='inclination', value=None):
        """Waits until it follows a setpoint: this value, or where None is given another one than at the last step."""
        kind = getattr(Command, quantity.upper())

        def taken():
            echoes = [echo for echo in [*self._echoes] if echo.kind == kind]
            if value is None:
                # A drive echoes its moves, too, with the setpoint that it follows.
                before = [echo.values[0] for echo in echoes if echo.time < self.time][-1:]
                return any(echo.time == self.time and [echo.values[0]] != before for echo in echoes)
            if echoes:
                return echoes[-1].values[0] == value
            return self._base.time == self.time and getattr(self._base, f'commanded_{quantity}') == value
        self.wait_for(taken, f'setpoint of {quantity}' if value is None else f'{quantity} = {value}')

    def wait_for(self, holds, what):
        """Waits until `holds()`. @throws RuntimeError after `timeout`"""
        deadline = time.monotonic() + self.timeout
        while not holds():
            if time.monotonic() > deadline or rospy.is_shutdown():
                raise RuntimeError(f'{self.name} at {self.time} s: no {what} within {self.timeout:g} s')
            time.sleep(POLL)

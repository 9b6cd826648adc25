"""What examples/schedule.py refuses; test/ros has it run."""
import pytest

from searches import example

ENTRY = r'schedule/{}: must have time and inclination, frequency or amplitude, which are numbers'


@pytest.mark.parametrize('schedule, error', [
    (None, 'schedule: must be a list of {time, inclination, frequency, amplitude}'),
    ({'time': 1}, 'schedule: must be a list'),
    ([1], ENTRY.format(0)),
    ([{'inclination': 1}], ENTRY.format(0)),
    ([{'time': 1}], ENTRY.format(0)),
    ([{'time': 1, 'frequency': 2}, {'time': 'soon', 'frequency': 1}], ENTRY.format(1)),
    ([{'time': 1, 'frequency': 2, 'angle': 2}], ENTRY.format(0)),
    ([{'time': 2, 'frequency': 1}, {'time': 1, 'frequency': 1}], 'schedule/1/time: must not be before that of the entry'),
])
def test_refuses_what_it_cannot_follow(schedule, error):
    with pytest.raises(ValueError) as refused:
        example('schedule').checked(schedule)
    assert error in str(refused.value)


def test_takes_times_that_are_equal():
    schedule = [{'time': 1, 'inclination': 0.1}, {'time': 1, 'frequency': 25.0, 'amplitude': 0.001}]
    assert example('schedule').checked(schedule) == schedule

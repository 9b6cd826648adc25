"""The simulation in Python: the engine's bits, whole arrays, and a way out at any time."""
import copy
import gc
import pickle
import signal
import threading
import time

import numpy as np
import pytest

import ratchet_sieve as rs

NAMES = ("id", "species", "radius", "mass", "x", "y", "vx", "vy", "angle", "spin", "displacement")


def endless(scene):
    """A layer whose next second takes long."""
    return scene.replace({"base.teeth": 400, "species.0.count": 4000, "species.1.count": 4000})


def test_disks_are_an_array_of_their_own(layer):
    simulation = rs.Simulation(layer)
    simulation.advance(0.1)
    disks = simulation.disks
    assert disks.dtype.names == NAMES and len(disks) == simulation.active_disks == 40
    assert sorted(disks["id"]) == list(range(40))
    before = disks.copy()
    disks["x"] = -1.0
    assert np.array_equal(simulation.disks, before)
    simulation.advance(0.1)
    assert not np.array_equal(simulation.disks["x"], before["x"])
    del simulation
    gc.collect()
    assert disks["x"].tolist() == [-1.0] * 40 and np.array_equal(disks["y"], before["y"])
    masses = {0: 0.010, 1: 0.001}
    assert all(mass == masses[kind] for mass, kind in zip(disks["mass"], disks["species"]))


def test_energy_is_that_of_the_disks_as_they_are_shown(layer):
    simulation = rs.Simulation(layer.replace({"base.inclination": 0.3}))
    simulation.advance(2.0)
    assert abs(simulation.disks["displacement"]).max() > layer.width  # some went round the ring
    disks = simulation.disks
    inertia = np.array([layer[f"species.{kind}.inertia_factor"] for kind in disks["species"]]) * \
        disks["mass"] * disks["radius"] ** 2
    energy = 0.5 * disks["mass"] * (disks["vx"] ** 2 + disks["vy"] ** 2) + 0.5 * inertia * disks["spin"] ** 2 + \
        disks["mass"] * layer["gravity"] * disks["y"]
    assert simulation.energy == pytest.approx(energy.sum(), rel=1e-12)


def test_a_saved_state_goes_on_bit_for_bit(layer):
    simulation = rs.Simulation(layer)
    simulation.advance(0.3)
    simulation.command(inclination=0.05)
    again = rs.Simulation.restore(layer, simulation.save())
    for each in (simulation, again):
        each.advance(0.3)
    assert np.array_equal(simulation.disks, again.disks) and simulation.base == again.base
    with pytest.raises(rs.StateError, match="it is damaged"):
        rs.Simulation.restore(layer, simulation.save()[:-9])


@pytest.mark.parametrize("key, value, own", (("seed", 8, "7"), ("feed.rate", 3, "0"), ("settle", 0.1, "0.2"),
                                             ("species.0.radius", 0.002, "0.001"), ("boundary", "open", "periodic")))
def test_a_state_of_another_scene_is_refused_by_its_key(layer, key, value, own):
    saved = rs.Simulation(layer).save()
    line = f"the state cannot be restored: its {key} is {own}, but this scene's is {value}"
    with pytest.raises(rs.StateError) as error:
        rs.Simulation.restore(layer.replace({key: value}), saved)
    assert str(error.value) == line
    rs.Simulation.restore(layer.replace({"duration": 9, "accuracy.confidence": 0.9}), saved)


@pytest.mark.parametrize("copied", (copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))))
def test_a_copy_goes_on_by_itself(layer, copied):
    simulation = rs.Simulation(layer)
    simulation.advance(0.2)
    other = copied(simulation)
    simulation.command(inclination=0.1)
    for each in (simulation, other):
        each.advance(0.3)
    assert other.base.commanded_inclination == layer["base.inclination"]
    assert not np.array_equal(simulation.disks, other.disks)


def test_commands_are_checked_before_any_is_taken(layer):
    simulation = rs.Simulation(layer)
    with pytest.raises(ValueError, match="frequency = -1"):
        simulation.command(amplitude=0.001, frequency=-1)
    assert simulation.base.commanded_amplitude == layer["base.amplitude"]
    simulation.command(inclination=0.1)
    simulation.advance(0.5)
    assert simulation.base.inclination == pytest.approx(0.05)
    simulation.set_slew_rates(inclination=1.0)
    simulation.advance(0.1)
    assert simulation.base.inclination == pytest.approx(0.1)
    for wrong in (float("nan"), 2.0):
        with pytest.raises(ValueError, match="inclination"):
            simulation.command(inclination=wrong)
    with pytest.raises(ValueError, match="slew rate"):
        simulation.set_slew_rates(frequency=0.0)


def test_pour_takes_a_name_or_a_number(layer):
    simulation = rs.Simulation(layer)
    simulation.pour("B", 5)
    simulation.pour(0, 2)
    assert (simulation.bins.A.on_base, simulation.bins.B.on_base) == (22, 25)
    with pytest.raises(ValueError, match="there are A, B"):
        simulation.pour("C", 1)
    with pytest.raises(ValueError, match="no species 2"):
        simulation.pour(2, 1)
    simulation.pour("A", 3, between=(0.1, 0.11))
    assert ((simulation.disks["x"][-3:] >= 0.1) & (simulation.disks["x"][-3:] <= 0.11)).all()
    for wrong in (-0.1, 0.1), (0.2, 0.1), (0.1,), 0.1, ("a", 0.1):
        with pytest.raises(ValueError, match="between"):
            simulation.pour("A", 1, between=wrong)


def test_a_collapse_is_an_error_and_the_run_stays_readable(layer):
    stuck = layer.replace({"contact": {"min_rebound_speed": 0, "contact_duration": 0, "collapse_events": 10000},
                           "species.0.restitution": 0.1, "species.1.restitution": 0.1})
    simulation = rs.Simulation(stuck)
    with pytest.raises(rs.StallError):
        simulation.advance(20.0)
    assert 0.0 < simulation.time < 20.0 and len(simulation.disks) == 40


def test_ctrl_c_stops_at_once_and_leaves_the_simulation_usable(scene):
    simulation = rs.Simulation(endless(scene).replace({"boundary": "periodic"}))
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    began = time.monotonic()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        simulation.advance(1e4)
    assert time.monotonic() - began < 60.0  # of 10,000 s that take hours
    stopped = simulation.time
    assert 0.0 < stopped < 1e4
    reference = rs.Simulation(simulation.scene)
    simulation.advance_to(stopped + 1e-3)
    reference.advance_to(stopped + 1e-3)
    assert np.array_equal(simulation.disks, reference.disks)


def test_a_later_pour_has_the_limits_of_a_scene_and_can_be_stopped(scene):
    simulation = rs.Simulation(scene)
    before = simulation.save()
    with pytest.raises(ValueError, match="at most 10000000 in total"):
        simulation.pour(0, 2**31)
    threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
    with pytest.raises(KeyboardInterrupt):
        simulation.pour(0, 5_000_000)
    assert simulation.save() == before


def test_threads_of_python_run_meanwhile_and_cannot_interfere(scene):
    simulation = rs.Simulation(endless(scene).replace({"boundary": "periodic"}))
    refused = threading.Event()
    done = threading.Event()

    def interfere():
        while not done.is_set():
            try:
                simulation.disks
            except RuntimeError as error:
                assert "in use by another thread" in str(error)
                refused.set()

    other = threading.Thread(target=interfere)
    other.start()
    while not refused.is_set():
        try:
            simulation.advance(1e-3)
        except RuntimeError:
            pass  # the other thread was first
    done.set()
    other.join()

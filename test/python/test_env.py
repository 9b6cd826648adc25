"""Environments for learning and control: Gymnasium's contract, and that they tell the truth about the sieve."""
import math
import pickle
import runpy

import numpy as np
import pytest

import ratchet_sieve as rs
from ratchet_sieve import places
from ratchet_sieve.env import SieveEnv, SieveVectorEnv

ALL = ("time", "bins", "departures", "quality", "processed", "mean_vx", "histogram", "base")
ACTION = [0.15]


@pytest.fixture(scope="module")
def scene():
    return rs.Scene.load(places.SHARE / "config/seek.yaml")


def element(env, observation, name):
    return observation[..., env.observation_names.index(name)]


def is_within(observation, space):
    return bool((observation >= space.low).all() and (observation <= space.high).all())


# The contract of gymnasium.Env.

def test_reset_and_step_give_what_gymnasium_asks_for(scene):
    env = SieveEnv(scene, episode=3.0, observations=ALL)
    observation, info = env.reset(seed=1)
    assert observation.dtype == env.observation_space.dtype == np.float64
    assert observation.shape == env.observation_space.shape == (len(set(env.observation_names)),)
    assert is_within(observation, env.observation_space)
    assert set(info) == {"time", "seed"} and info["time"] == 0.0
    for k in range(1, 4):
        observation, reward, terminated, truncated, info = env.step(env.action_space.high)
        assert is_within(observation, env.observation_space) and np.isfinite(observation).all()
        assert type(reward) is float and type(terminated) is bool and type(truncated) is bool
        assert info["time"] == element(env, observation, "time") == k
        assert (terminated, truncated) == (False, k == 3)


def test_a_seed_begins_a_series_of_different_episodes_that_comes_again(scene):
    def series(env):
        episodes = []
        for seed in (5, None, None):
            env.reset(seed=seed)
            episodes.append(np.array([env.step(ACTION)[0] for _ in range(3)]))
        return episodes

    env = SieveEnv(scene)
    first, again = series(env), series(SieveEnv(scene))
    assert all(np.array_equal(a, b) for a, b in zip(first, again))
    assert all(np.array_equal(a, b) for a, b in zip(first, series(env)))
    assert not np.array_equal(first[0], first[1]) and not np.array_equal(first[1], first[2])


@pytest.mark.parametrize("make", (lambda scene: SieveEnv(scene, observations=ALL), lambda scene: SieveVectorEnv(scene, 2)))
def test_an_environment_is_pickled_and_goes_on(scene, make):
    env = make(scene)
    env.reset(seed=1)
    action = np.full(env.action_space.shape, 0.15)
    env.step(action)
    other = pickle.loads(pickle.dumps(env))
    for _ in range(2):
        assert all(np.array_equal(one, same) for one, same in zip(env.step(action)[:4], other.step(action)[:4]))
        assert np.array_equal(env.reset()[0], other.reset()[0])  # their generators go on, too


def test_a_scene_may_be_the_path_of_its_file(scene):
    assert SieveEnv(places.SHARE / "config/seek.yaml").task.scene == SieveEnv(scene).task.scene
    with pytest.raises(ValueError, match="scene = 5: must be a Scene, the path"):
        SieveVectorEnv(5, 2)


def test_needs_an_episode(scene):
    env = SieveEnv(scene, episode=1.0)
    with pytest.raises(RuntimeError, match="call reset"):
        env.step(ACTION)
    env.reset(seed=1)
    env.step(ACTION)
    with pytest.raises(RuntimeError, match="call reset"):
        env.step(ACTION)
    env.close()
    env.close()
    with pytest.raises(RuntimeError, match="closed"):
        env.reset()


def test_refuses_an_action_outside_the_space_and_changes_nothing(scene):
    env, untouched = SieveEnv(scene), SieveEnv(scene)
    env.reset(seed=1)
    untouched.reset(seed=1)
    for action, error in (([0.6], r"^action: inclination = 0.6: must be -0.5 to 0.5 rad$"),
                          ([math.nan], "inclination = nan: must be"),
                          ([0.1, 0.2], r"^action of shape \(2,\): must be \(inclination\)$"), (0.1, "shape")):
        with pytest.raises(ValueError, match=error):
            env.step(action)
    assert env.simulation.base.commanded_inclination == 0.0
    assert np.array_equal(env.step(ACTION)[0], untouched.step(ACTION)[0])


def test_takes_a_limit_rounded_to_32_bits_for_the_limit(scene):
    env = SieveEnv(scene, limits={"inclination": (-0.1, 0.1)})
    env.reset(seed=1)
    env.step(np.array([0.1], dtype=np.float32))  # more than 0.1
    assert env.simulation.base.commanded_inclination == 0.1


def test_options_change_the_scene_for_one_episode(scene):
    env = SieveEnv(scene)
    observation, _ = env.reset(options={"scene": {"base.frequency": 18.0}})
    assert element(env, observation, "base.frequency") == 18.0
    observation, _ = env.reset()
    assert element(env, observation, "base.frequency") == 23.0


def test_refuses_a_reset_and_goes_on(scene):
    env = SieveEnv(scene)
    env.reset(seed=1)
    env.step(ACTION)
    for wrong, error in (({"seed": -1}, "seed = -1"), ({"seed": 1.5}, "seed = 1.5"), ({"seed": "one"}, "seed = 'one'"),
                         ({"options": {"frequency": 18.0}}, "options: there is none of the name 'frequency'"),
                         ({"options": {"scene": {"base.inclination": 0.51}}}, "0.51: must be within the limits"),
                         ({"options": {"scene": {"base.inclination": 7}}}, "base.inclination"),
                         ({"options": {"scene": {"species.0.name": "C"}}}, "species"),
                         ({"options": {"scene": {"boundary": "walled"}}}, "boundary")):
        with pytest.raises(ValueError, match=error):
            env.reset(**wrong)
    assert env.step(ACTION)[4]["time"] == 2.0


def test_renders_pixels(scene):
    env = SieveEnv(scene, render_mode="rgb_array")
    env.reset(seed=1)
    before = env.render()
    assert before.dtype == np.uint8 and before.ndim == 3 and before.shape[2] == 3
    env.step(ACTION)
    assert not np.array_equal(env.render(), before)
    silent = SieveEnv(scene)
    silent.reset()
    assert silent.render() is None


def test_passes_the_checker_of_gymnasium(scene):
    pytest.importorskip("gymnasium")
    from gymnasium.utils.env_checker import check_env

    assert SieveEnv.__mro__[1].__module__.startswith("gymnasium")
    check_env(SieveEnv(scene, observations=ALL), skip_render_check=True)
    many = SieveVectorEnv(scene, 2)
    assert SieveVectorEnv.__mro__[1].__module__.startswith("gymnasium")
    assert many.metadata["autoreset_mode"].name == "NEXT_STEP" and many.reset(seed=1)[0] in many.observation_space
    many.close()


# What the observations say.

def test_the_bits_are_those_of_a_simulation_that_is_commanded(scene):
    env = SieveEnv(scene, step=0.5)
    _, info = env.reset(seed=3)
    simulation = rs.Simulation(scene.replace(seed=info["seed"]))
    for k, inclination in enumerate((0.2, -0.1, 0.3)):
        env.step([inclination])
        simulation.command(inclination=inclination)
        simulation.advance_to(0.5 * (k + 1))
    assert env.simulation.disks.tobytes() == simulation.disks.tobytes()
    assert env.readings.base == simulation.base
    assert env.readings.bins == simulation.bins


def test_all_quantities_are_commanded_at_their_slew_rates(scene):
    env = SieveEnv(scene, actions=("amplitude", "inclination", "frequency"), slew_rates={"inclination": 0.3})
    assert env.action_space.low.tolist() == [0.0, -0.5, 0.0] and env.action_space.high.tolist() == [0.01, 0.5, 100.0]
    env.reset(seed=1)
    env.step([0.0015, 0.5, 40.0])
    base = env.readings.base
    assert (base.inclination, base.frequency, base.amplitude) == pytest.approx((0.3, 33.0, 0.0015))
    assert (base.commanded_inclination, base.commanded_frequency) == (0.5, 40.0)


def test_departures_are_what_fell_into_the_bins_within_the_window(scene):
    env = SieveEnv(scene, window=3.0, observations=ALL)
    env.reset(seed=1)
    past = [env.readings.bins]
    for _ in range(6):
        observation, reward, *_ = env.step(ACTION)
        now, then = env.readings.bins, past[-3:][0]
        left = {kind: now[kind].left - then[kind].left for kind in "AB"}
        right = {kind: now[kind].right - then[kind].right for kind in "AB"}
        for kind in "AB":
            assert element(env, observation, f"departures.left.{kind}") == left[kind]
            assert element(env, observation, f"departures.right.{kind}") == right[kind]
            assert element(env, observation, f"departures.on_base.{kind}") == now[kind].on_base
        gone = {kind: left[kind] + right[kind] for kind in "AB"}
        if min(gone.values()):  # eq. (2) of the paper
            shares = {kind: left[kind] / gone[kind] for kind in "AB"}
            assert reward == element(env, observation, "quality") == pytest.approx(abs(shares["A"] - shares["B"]))
        on_base = sum(now[kind].on_base for kind in "AB")
        assert env.readings.processed == pytest.approx(sum(gone.values()) / (sum(gone.values()) + on_base))
        past.append(now)
    assert min(gone.values()) > 0 and env.readings.window == 3.0


def test_velocities_and_histogram_are_those_of_the_disks(scene):
    env = SieveEnv(scene, observations=ALL, cells=4)
    env.reset(seed=1)
    for _ in range(3):
        before = {disk["id"]: disk["displacement"] for disk in env.simulation.disks}
        observation, *_ = env.step([0.3])
        disks, base = env.simulation.disks, env.simulation.base
        along = ((disks["x"] - base.horizontal_displacement) * math.cos(base.inclination) +
                 (disks["y"] - base.displacement) * math.sin(base.inclination))
        for number, kind in enumerate("AB"):
            of_kind = disks["species"] == number
            stayed = [disk["displacement"] - before[disk["id"]] for disk in disks[of_kind] if disk["id"] in before]
            assert element(env, observation, f"mean_vx.{kind}") == pytest.approx(np.mean(stayed))
            counts, _ = np.histogram(np.clip(along[of_kind], 0.0, scene.width), 4, (0.0, scene.width))
            assert [element(env, observation, f"histogram.{kind}.{cell}") for cell in range(4)] == counts.tolist()
            assert counts.sum() > 0


def test_what_is_undefined_is_0_beside_a_flag_and_none_in_the_readings(scene):
    env = SieveEnv(scene, observations=ALL)
    observation, _ = env.reset(seed=1)
    assert (env.readings.quality, env.readings.mean_vx.A) == (None, None)
    for name in ("quality", "quality_defined", "mean_vx.A", "mean_vx_defined.A"):
        assert element(env, observation, name) == 0.0
    for _ in range(5):
        observation, *_ = env.step(ACTION)
    for name in ("quality_defined", "processed_defined", "mean_vx_defined.A", "mean_vx_defined.B"):
        assert element(env, observation, name) == 1.0


# Rewards and ends.

def test_rewards_by_name(scene):
    expected = {
        "purity:A:right": lambda d: d.A.right / (d.A.right + d.B.right),
        "recovery:B:left": lambda d: d.B.left / (d.B.left + d.B.right),
        "flow:A:right:mass": lambda d: d.A.right_mass / 2.0,
        "throughput": lambda d: sum(bins.left + bins.right for bins in d.values()) / 2.0,
    }
    for name, value in expected.items():
        env = SieveEnv(scene, reward=name, window=2.0)
        env.reset(seed=1)
        rewards = [env.step(ACTION)[1] for _ in range(5)]
        assert rewards[-1] == pytest.approx(value(env.readings.departures)) and rewards[-1] > 0.0


def test_rewards_by_a_function_also_of_a_periodic_base():
    periodic = rs.Scene.load(places.SHARE / "config/paper_fig8.yaml", {"duration": 5.0})
    env = SieveEnv(periodic, reward=lambda readings: (readings.mean_vx.B or 0.0) - (readings.mean_vx.A or 0.0))
    env.reset(seed=1)
    _, reward, *_ = env.step([0.0])
    velocities = env.readings.mean_vx
    assert reward == velocities.B - velocities.A != 0.0
    with pytest.raises(ValueError, match="nothing leaves a periodic base"):
        SieveEnv(periodic)
    env = SieveEnv(periodic, reward=lambda readings: math.nan)
    env.reset(seed=1)
    with pytest.raises(ValueError, match="reward = nan"):
        env.step(ACTION)


def test_an_empty_base_that_is_not_fed_terminates(scene):
    env = SieveEnv(scene.replace({"feed.rate": 0.0}))
    env.reset(seed=1)
    terminated = False
    while not terminated:
        _, _, terminated, truncated, info = env.step([0.5])
        assert not truncated
    assert info["empty"] and env.simulation.active_disks == 0


@pytest.mark.parametrize("settings, error", [
    ({"actions": ("tilt",)}, "actions: there is no quantity 'tilt'; there are inclination, frequency, amplitude"),
    ({"actions": ()}, "actions = "),
    ({"actions": ("frequency", "frequency")}, "different quantities"),
    ({"limits": {"frequency": (0, 1)}}, "limits: there is no quantity 'frequency'"),
    ({"limits": {"inclination": (0.1, 0.0)}}, r"limits of inclination = \(0.1, 0.0\)"),
    ({"limits": {"inclination": (0.1, 9.0)}}, "within -1.5 to 1.5 rad"),
    ({"limits": {"inclination": (0.1, 0.2)}}, "base.inclination = 0: must be within the limits"),
    ({"slew_rates": {"inclination": 0.0}}, "slew rate of inclination = 0.0: must be 1.5e-09 to 15 rad/s"),
    ({"observations": ("colour",)}, "observations: there is none of the name 'colour'; there are time, bins"),
    ({"observations": ()}, "one or more"),
    ({"reward": "beauty"}, "reward: beauty: must be quality, purity:SPECIES:BIN"),
    ({"reward": "purity:C:left"}, "there is no species C; there are A, B"),
    ({"reward": 3}, "reward = 3"),
    ({"step": 0.0}, "step = 0.0: must be a time"),
    ({"episode": math.inf}, "episode = inf"),
    ({"window": math.nan}, "window = nan"),
    ({"cells": 0}, "cells = 0: must be an integer, 1 to 10000"),
    ({"limits": {"inclination": 5}}, "limits of inclination = 5: must be two"),
    ({"slew_rates": {"inclination": "x"}}, "slew rate of inclination = 'x': must be"),
    ({"step": "x"}, "step = 'x': must be 0 s or more"),
    ({"render_mode": "human"}, "render_mode = 'human': must be None or rgb_array"),
])
def test_refuses_settings_with_one_line(scene, settings, error):
    with pytest.raises(ValueError, match=error) as raised:
        SieveEnv(scene, **settings)
    assert "\n" not in str(raised.value)


# Many sieves.

def series_of(env, actions, seed):
    first, _ = env.reset(seed=seed)
    return [first] + [env.step(action) for action in actions]


@pytest.mark.parametrize("threads", [1, 3])
def test_many_sieves_are_as_many_single_ones(scene, threads):
    random = np.random.default_rng(1)
    actions = random.uniform(-0.3, 0.3, (9, 4, 1))
    many = SieveVectorEnv(scene, 4, threads=threads, episode=3.0)
    together = series_of(many, actions, 7)
    assert many.num_envs == 4 and many.action_space.shape == (4, 1) and many.single_action_space.shape == (1,)
    assert is_within(together[0], many.observation_space)
    assert [array.dtype for array in together[1][1:4]] == [np.float64, bool, bool]
    for k in range(4):
        env = SieveEnv(scene, episode=3.0)
        assert np.array_equal(env.reset(seed=7 + k)[0], together[0][k])
        ended = False
        for action, (observations, rewards, terminations, truncations, infos) in zip(actions[:, k], together[1:]):
            if ended:  # next_step: this step is the reset
                observation, info = env.reset()
                reward, terminated, truncated = 0.0, False, False
            else:
                observation, reward, terminated, truncated, info = env.step(action)
            ended = terminated or truncated
            assert np.array_equal(observations[k], observation)
            assert (rewards[k], terminations[k], truncations[k]) == (reward, terminated, truncated)
            assert {key: infos[key][k] for key in info} == info and all(infos[f"_{key}"][k] for key in info)


def test_same_step_returns_the_next_episode_and_the_end_of_the_last(scene):
    actions = np.full((3, 2, 1), 0.1)
    plain = series_of(SieveVectorEnv(scene, 2, episode=2.0), actions, 1)
    env = SieveVectorEnv(scene, 2, episode=2.0, autoreset="same_step")
    env.reset(seed=1)
    env.step(actions[0])
    observations, rewards, _, truncations, infos = env.step(actions[1])
    assert truncations.all() and np.array_equal(rewards, plain[2][1])
    assert all(np.array_equal(infos["final_obs"][k], plain[2][0][k]) for k in range(2))
    assert infos["final_info"]["time"].tolist() == [2.0, 2.0] and infos["_final_info"].all()
    assert np.array_equal(observations, plain[3][0]) and infos["time"].tolist() == [0.0, 0.0]
    assert "final_obs" not in env.step(actions[2])[4]


def test_disabled_waits_for_a_reset_of_those_that_have_ended(scene):
    env = SieveVectorEnv(scene, 2, episode=2.0, autoreset="disabled")
    actions = np.full((2, 1), 0.1)
    env.reset(seed=1)
    env.step(actions)
    second = series_of(SieveVectorEnv(scene, 2, episode=2.0), [actions] * 2, 1)[2][0][1]
    _, infos = env.reset(seed=[9, 9], options={"reset_mask": np.array([True, False])})
    assert infos["_time"].tolist() == [True, False]
    observations, _, _, truncations, _ = env.step(actions)
    assert truncations.tolist() == [False, True] and np.array_equal(observations[1], second)
    with pytest.raises(RuntimeError, match="the episode of sieve 1 has ended"):
        env.step(actions)
    env.reset(options={"reset_mask": np.array([False, True])})
    assert env.step(actions)[3].tolist() == [True, False]


def test_a_collapse_of_one_sieve_leaves_the_others(scene):
    env = SieveVectorEnv(scene.replace({"contact.collapse_events": 10000}), 2, autoreset="disabled")
    env.reset(seed=1)
    env.reset(options={"scene": {"contact.min_rebound_speed": 0.0, "base.frequency": 0.0},
                       "reset_mask": np.array([True, False])})
    terminated = np.zeros(2, dtype=bool)
    while not terminated.any():
        observations, _, terminated, truncated, infos = env.step(np.zeros((2, 1)))
        assert not truncated.any()
    assert terminated.tolist() == infos["_stalled"].tolist() == [True, False]
    assert "collapse" in infos["stalled"][0] and infos["stalled"][1] is None
    assert infos["time"][0] == env.simulations[0].time
    assert is_within(observations, env.observation_space)


def test_refuses_batches_with_one_line(scene):
    env = SieveVectorEnv(scene, 3)
    with pytest.raises(RuntimeError, match="call reset"):
        env.step(np.zeros((3, 1)))
    env.reset(seed=1)
    for call, error in (
            (lambda: env.step(np.zeros((2, 1))), r"actions of shape \(2, 1\): must be \(3, 1\)"),
            (lambda: env.step(np.array([[0.0], [0.9], [0.0]])), "action of sieve 1: inclination = 0.9: must be"),
            (lambda: env.reset(seed=[1, 2]), "2 seeds: must be 3"),
            (lambda: env.reset(options={"reset_mask": np.zeros(3, dtype=bool)}), "reset_mask"),
            (lambda: env.reset(options={"reset_mask": [True] * 3}), "reset_mask"),
            (lambda: SieveVectorEnv(scene, 0), "n = 0"),
            (lambda: SieveVectorEnv(scene, 2, autoreset="never"), "autoreset = 'never': must be next_step")):
        with pytest.raises(ValueError, match=error):
            call()
    assert env.step(np.zeros((3, 1)))[4]["time"].tolist() == [1.0] * 3


def test_the_example_learns_the_best_inclination(tmp_path):
    learned = runpy.run_path(str(places.CHECKOUT / "examples/learn_inclination.py"))["main"]
    assert learned(["--generations", "2", "--picture", str(tmp_path / "learned.png")]) == pytest.approx(0.15, abs=0.03)
    assert (tmp_path / "learned.png").stat().st_size > 10000


# Sensors.

SENSORS = {"scale": {"rate": 1}, "count": {"rate": 1}, "level": {"rate": 1}}


def test_exact_sensors_say_what_is_true(scene):
    env = SieveEnv(scene, sensors=SENSORS, observations=("sensors", "bins"))
    observation, _ = env.reset(seed=1)
    assert element(env, observation, "level") == sum(of.on_base for of in env.readings.bins.values())
    for _ in range(8):
        observation, *_ = env.step(ACTION)
    bins = env.readings.bins
    assert sum(of.right for of in bins.values()) > 10
    for side in ("left", "right"):
        for kind, of in bins.items():
            assert element(env, observation, f"{side}/count.{kind}") == of[side]
        mass = sum(of[f"{side}_mass"] for of in bins.values())
        assert math.isclose(element(env, observation, f"{side}/scale"), mass, abs_tol=1e-12)
    assert element(env, observation, "level") == sum(of.on_base for of in bins.values())
    assert env.readings.sensors["level"] == element(env, observation, "level")


def test_sensors_of_a_real_machine_come_again_and_change_nothing(scene):
    noisy = {"count": {"miss": 0.2, "delay": 1.0}, "scale": {"noise": 0.1}}

    def run(env):
        env.reset(seed=3)
        return np.array([env.step(np.full(env.action_space.shape, 0.15))[0] for _ in range(5)])

    both = SieveVectorEnv(scene, 2, sensors=noisy, observations=("sensors", "bins"))
    runs = run(both)
    assert np.array_equal(runs, run(both))
    assert np.array_equal(runs[:, 0], run(SieveEnv(scene, sensors=noisy, observations=("sensors", "bins"))))
    plain = SieveEnv(scene, observations=("bins",))
    assert np.array_equal(runs[:, 0, -len(plain.observation_names):], run(plain))
    assert not np.array_equal(element(both, runs, "left/scale"), element(both, runs, "right/scale"))


def test_sensors_are_asked_for_by_their_names(scene):
    with pytest.raises(rs.SceneError, match="camera: unknown key; must be one of count, level, scale"):
        SieveEnv(scene, sensors={"camera": {}})
    with pytest.raises(rs.SceneError, match="^sensors: count.miss = 2: must be a number from 0 to 1; did you mean"):
        SieveEnv(scene, sensors={"count": {"miss": 2}})
    with pytest.raises(ValueError, match="observations: there is none of the name 'sensors'"):
        SieveEnv(scene, observations=("sensors",))
    env = pickle.loads(pickle.dumps(SieveEnv(scene, sensors=SENSORS)))
    env.reset(seed=1)
    with pytest.raises(TypeError, match="before its first reset"):
        pickle.dumps(env)

"""The pictures of results: one call each, with the means, errors and places of the data."""
import io

import matplotlib
import numpy as np
import pandas
import pytest

import ratchet_sieve as rs
from conftest import SCENE

matplotlib.use("agg")
THETA = "base.inclination"


@pytest.fixture(scope="module")
def layer():
    """A run on a ring, from which no disk leaves."""
    return rs.run(rs.Scene(SCENE, {"settle": 0.0, "boundary": "periodic"}), frames=20)


@pytest.fixture(scope="module")
def emptied():
    """A run whose first disk leaves, and the last one, too."""
    return rs.run(rs.Scene(SCENE, {"settle": 0.0, "duration": 5.0, THETA: 0.5}), frames=10)


@pytest.fixture(scope="module")
def table():
    return rs.sweep(rs.Scene(SCENE, {"settle": 0.0}), {THETA: [0.0, 0.1], "base.frequency": [20.0, 25.0]}, seeds=3)


def points_of(container):
    line, _, (bars,) = container
    return line.get_xydata(), np.array([0.5 * (high - low) for (_, low), (_, high) in bars.get_segments()])


def test_curves_have_means_and_standard_errors(table):
    part = table[table["base.frequency"] == 20.0]
    points, errors = points_of(rs.plots.sweep_curves(part, THETA, "mean_vx.A").containers[0])
    for (theta, value), error in zip(points, errors):
        mean = rs.stats.mean_of(part[part[THETA] == theta]["mean_vx.A"])
        assert value == mean.value
        assert error == pytest.approx(mean.error)
    assert list(points[:, 0]) == [0.0, 0.1]


def test_there_is_a_curve_for_each_value_of_a_second_key(table):
    axes = rs.plots.sweep_curves(table, THETA, "mean_vx.A", by="base.frequency")
    assert len(axes.containers) == 2
    assert [text.get_text() for text in axes.texts][-1] == "$f$ [Hz]"


def test_a_map_has_the_mean_of_each_cell(table):
    mesh = rs.plots.sweep_map(table, THETA, "base.frequency", "mean_vx.B").collections[0]
    expected = table.pivot_table(index="base.frequency", columns=THETA, values="mean_vx.B").to_numpy()
    assert np.asarray(mesh.get_array()).reshape(2, 2) == pytest.approx(expected)


def test_cases_that_failed_are_left_out(table):
    failed = table.copy()
    failed.loc[0, "status"] = "failed"
    points, _ = points_of(rs.plots.sweep_curves(failed, THETA, "mean_vx.A", by="base.frequency").containers[0])
    assert points[0, 1] == failed["mean_vx.A"][1:3].mean()


@pytest.mark.parametrize("arguments, error", (
    (("base.teeth",), "there is no column base.teeth"),
    ((THETA, "speed"), "there is no column speed"),
    ((THETA, "quality", "density"), "there is no column density"),
    ((THETA,), "several rows have the same base.inclination, seed"),
))
def test_what_cannot_be_drawn_is_one_error_line(table, arguments, error):
    with pytest.raises(ValueError, match=error):
        rs.plots.sweep_curves(table, *arguments)


def test_displacements_have_the_area_of_their_species(layer):
    width = 0.01
    axes = rs.plots.displacements(layer, width=width)
    for kind, container in enumerate(axes.containers):
        points, _ = points_of(container)
        assert points[:, 1].sum() * width == pytest.approx(1.0)
        disks = layer.frames.disks[-1]
        own = disks["displacement"][disks["species"] == kind]
        assert (points[:, 0] * points[:, 1]).sum() * width == pytest.approx(own.mean(), abs=0.5 * width)
    assert axes.get_title() == "after 1 s"


def test_an_empty_machine_has_no_displacements(emptied):
    assert len(emptied.frames.disks[-1]) == 0
    assert [text.get_text() for text in rs.plots.displacements(emptied).texts] == ["all disks have left"]


def test_tracks_go_where_their_disks_go(layer):
    line, = rs.plots.tracks(layer, [7]).lines
    steps = line.get_xydata()[~np.isnan(line.get_xdata())]
    places = [disks[disks["id"] == 7][0] for disks in layer.frames.disks]
    assert steps == pytest.approx(np.array([[1e3 * place["x"], 1e3 * place["y"]] for place in places]))
    with pytest.raises(ValueError, match="there is no disk 40"):
        rs.plots.tracks(layer, [40])


def test_tracks_show_a_disk_of_each_species_and_end_where_it_leaves(emptied):
    labels = [line.get_label() for line in rs.plots.tracks(emptied).lines]
    assert [label[0] for label in labels] == ["A", "B"]


def test_bins_are_drawn_over_time(emptied):
    lines = rs.plots.bins(emptied).lines
    assert [line.get_linestyle() for line in lines] == ["--", "-"] * 2  # left, right, as in all pictures
    assert [line.get_label() for line in lines] == ["A, left", "A, right", "B, left", "B, right"]
    assert sum(line.get_ydata()[-1] for line in lines) == 40


def test_species_keep_their_colours_while_disks_leave(emptied):
    for frame in range(0, len(emptied.frames), 5):
        axes = emptied.plot(frame)
        colours = dict(zip(axes.get_legend_handles_labels()[1], (line.get_color() for line in axes.lines)))
        assert colours == dict(zip("AB", rs.plots.COLOURS))
        matplotlib.pyplot.close(axes.figure)


def test_an_animation_shows_each_frame(tmp_path):
    run = rs.run(rs.Scene(SCENE, {"settle": 0.0, "duration": 0.2}), frames=10)
    film = run.animate(speed=2.0)
    film.save(tmp_path / "run.gif", writer="pillow", dpi=30)
    from PIL import Image

    with Image.open(tmp_path / "run.gif") as picture:
        assert picture.n_frames == len(run.frames) == 3


def test_pictures_are_those_of_the_package_whatever_the_users_style(layer, table):
    def bytes_of(axes):
        with io.BytesIO() as file:
            axes.figure.savefig(file, format="png")
            matplotlib.pyplot.close(axes.figure)
            return file.getvalue()

    def pictures():
        return [bytes_of(axes) for axes in (
            layer.plot(), rs.plots.bins(layer), rs.plots.displacements(layer), rs.plots.tracks(layer),
            rs.plots.sweep_curves(table, THETA, "mean_vx.A", by="base.frequency"),
            rs.plots.sweep_map(table, THETA, "base.frequency", "mean_vx.B"))]

    own = pictures()
    with matplotlib.rc_context({"text.usetex": True, "font.family": "serif", "lines.linewidth": 9.0,
                                "xtick.labelsize": 20.0, "axes.facecolor": "black"}):
        assert pictures() == own
        film = layer.animate()
        film._func(1)
        assert not film._fig.axes[0].title.get_usetex()
        film._draw_was_started = True


def test_a_run_without_frames_has_no_pictures_of_them():
    run = rs.run(rs.Scene(SCENE, {"settle": 0.0, "duration": 0.1}))
    assert run.plot().get_xlabel() == "$x$ [mm]"
    for draw in (rs.plots.displacements, rs.plots.tracks, rs.plots.bins, rs.Run.animate):
        with pytest.raises(ValueError, match="the run has no frames"):
            draw(run)


def test_a_sweep_that_is_cut_hands_out_what_it_has_and_goes_on_later_with_the_same_bits(tmp_path):
    scene, results = rs.Scene(SCENE, {"boundary": "periodic", "duration": 1e6}), tmp_path / "runs.db"
    cut = rs.sweep(scene, seeds=(3, 4), results=results, threads=1, budget=0.2, progress=False)
    assert list(cut.status) == ["cut"] and list(cut.seed) == [3] and cut.index.tolist() == [0]
    assert 0.0 < cut.simulated_time[0] < 1e6 and cut["mean_vx.A"].notna().all() and rs.read_sweep(results).empty
    shorter = scene.replace(duration=60.0)
    for budget in (0.1, None):
        whole = rs.sweep(shorter, seeds=(3, 4), results=results, budget=budget, progress=False)
    again = rs.sweep(shorter, seeds=(3, 4), progress=False)
    pandas.testing.assert_frame_equal(*(rows.drop(columns=["wall_time", "host"]) for rows in (whole, again)))
    assert rs.sweep(shorter, seeds=(3, 4), results=results, budget=100.0).index.tolist() == [0, 1, 2, 3]
    with pytest.raises(ValueError, match="budget = -1"):
        rs.sweep(scene, budget=-1)


def test_a_sweep_tells_a_function_how_far_it_is(scene):
    told = []
    rs.sweep(scene, seeds=2, progress=lambda *counts: told.append(counts))
    assert told[-1] == (2, 0, 2)

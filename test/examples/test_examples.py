"""The notebooks of examples/ run from the first cell to the last, with less to compute."""
import os
import pathlib
import re

import nbclient
import nbformat
import pytest

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
LONGEST = 300  # of a cell [s]
PROGRESS = re.compile(r"\r[^\r\n]*\n?")  # with what is said of it

# Of each notebook, other parameters, and how many pictures it makes.
QUICK = {
    "first_steps": ("DURATION, INCLINATIONS, SEEDS, FILM = 4.0, [0.1, 0.2], 2, 0.2", 2),
    "my_two_grains": ("BASE[\"teeth\"], WITHIN = 10, 0.2", 3),
    "calibrate": ("FEEDER[\"duration\"], SETTINGS = 20.0, SETTINGS[::2]; UNKNOWN = dict(list(UNKNOWN.items())[:1])", 1),
    "controller": ("DURATION, CHANGE, SEEDS = 40.0, 20.0, [1, 2]", 1),
}


def notebooks():
    return sorted(path.stem for path in (PACKAGE / "examples").glob("*.ipynb"))


def read(name):
    return nbformat.read(PACKAGE / "examples" / f"{name}.ipynb", as_version=4)


@pytest.fixture
def place(tmp_path, monkeypatch):
    """A directory beside the scenes, and one for what Jupyter writes."""
    for name in ("config", "docs"):
        (tmp_path / name).symlink_to(PACKAGE / name)
    (tmp_path / "examples").mkdir()
    (tmp_path / "examples/sealed_feeder.txt").symlink_to(PACKAGE / "examples/sealed_feeder.txt")
    for variable in ("IPYTHONDIR", "JUPYTER_RUNTIME_DIR", "MPLCONFIGDIR"):
        monkeypatch.setenv(variable, str(tmp_path / variable))
    return tmp_path / "examples"


def executed(name, place, parameters=""):
    """With other parameters, behind the notebook's own."""
    notebook = read(name)
    own = [k for k, cell in enumerate(notebook.cells) if "parameters" in cell.metadata.get("tags", [])]
    assert len(own) == 1, "one cell has the tag `parameters`"
    notebook.cells[own[0]].source += f"\n{parameters}"
    # The kernel is this interpreter, which finds the package.
    nbclient.NotebookClient(notebook, timeout=LONGEST, kernel_name="python3",
                            resources={"metadata": {"path": str(place)}}).execute()
    if "EXAMPLES_OUT" in os.environ:
        nbformat.write(notebook, pathlib.Path(os.environ["EXAMPLES_OUT"]) / f"{name}.ipynb")
    return notebook


def outputs(notebook):
    return [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]


def test_each_notebook_is_tested():
    assert notebooks() == sorted(QUICK)


@pytest.mark.parametrize("name", sorted(QUICK))
def test_runs(name, place):
    parameters, pictures = QUICK[name]
    found = outputs(executed(name, place, parameters))
    said = "".join(output.text for output in found if output.get("name") == "stderr")
    assert PROGRESS.sub("", said) == ""
    assert sum("image/png" in output.get("data", {}) for output in found) == pictures


@pytest.mark.parametrize("name", notebooks())
def test_is_stored_without_outputs(name):
    assert outputs(read(name)) == []
    assert all(cell.execution_count is None for cell in read(name).cells if cell.cell_type == "code")

"""Where the package's files are: in a checkout, or where it is installed."""
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
PREFIX = HERE.parents[3]  # of PREFIX/lib/python3/dist-packages/ratchet_sieve

CHECKOUT = HERE.parents[1] if (HERE.parents[1] / "package.xml").exists() else None
SHARE = CHECKOUT or PREFIX / "share/ratchet_sieve"  # has config, launch and rviz
WORK = CHECKOUT or pathlib.Path()  # where documents and results go unless a path is given


def program(name):
    """The path of one of the package's programs, or its bare name."""
    folders = (SHARE / "devel/lib/ratchet_sieve", PREFIX / "lib/ratchet_sieve", PREFIX / "bin")
    return next((folder / name for folder in folders if (folder / name).exists()), pathlib.Path(name))

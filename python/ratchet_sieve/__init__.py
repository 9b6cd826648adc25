"""The vibrating-ratchet feeder in Python: tables and statistics of its runs, pictures, studies and searches."""
import importlib
import pkgutil

# In ROS the messages, msg and srv, are in another directory of the same name.
__path__ = pkgutil.extend_path(__path__, __name__)

# Imported when they are first used: pandas and matplotlib take longer to load than the rest.
_SUBMODULES = ("documents", "origin", "plots", "stats", "tables")


def __getattr__(name):
    if name in _SUBMODULES:
        return importlib.import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *_SUBMODULES})

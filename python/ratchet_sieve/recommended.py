"""Programs that need what the Debian package only recommends."""
import runpy
import sys


def run(module, program=None):
    """Runs a module. Without matplotlib or scipy, or stopped while it loads, it ends with one line and status 1."""
    try:
        runpy.run_module(module, run_name="__main__", alter_sys=True)
    except ModuleNotFoundError as missing:
        sys.exit(f"{program or module}: {missing}: apt-get install --no-install-recommends python3-matplotlib python3-scipy")
    except KeyboardInterrupt:
        sys.exit(f"{program or module}: interrupted")

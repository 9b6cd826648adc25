"""Programs that need what the Debian package only recommends."""
import io
import runpy
import signal
import sys

ENDING = signal.SIGTERM, signal.SIGHUP  # by kill, by a closed terminal


class Unfailing(io.FileIO):
    """Standard error, which may be gone, as with its terminal: what is written there is lost, and no more."""

    def write(self, data):
        try:
            return super().write(data)
        except OSError:
            return len(data)


def run(module, program=None):
    """Runs a module. Without matplotlib or scipy, or stopped while it loads, it ends with one line and status 1. ENDING
    interrupts it as Ctrl-C does, unless they are ignored, as under nohup."""
    for number in ENDING:
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, _interrupt)
    sys.stderr = io.TextIOWrapper(Unfailing(sys.stderr.fileno(), "w", closefd=False), sys.stderr.encoding,
                                  sys.stderr.errors, write_through=True)
    try:
        runpy.run_module(module, run_name="__main__", alter_sys=True)
    except ModuleNotFoundError as missing:
        sys.exit(f"{program or module}: {missing}: apt-get install --no-install-recommends python3-matplotlib python3-scipy")
    except KeyboardInterrupt:
        sys.exit(f"{program or module}: interrupted")


def _interrupt(number, _):
    """Once: a closed terminal sends several, and a second interrupt would end what the first one left to do."""
    for each in ENDING:
        signal.signal(each, lambda *_: None)  # Python complains of SIG_IGN where the next one waits already
    raise KeyboardInterrupt(signal.Signals(number).name)

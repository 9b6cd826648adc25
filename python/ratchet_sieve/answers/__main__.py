"""The program sieve_separate."""
import argparse
import functools
import pathlib
import re
import sys
import warnings

DESCRIPTION = """Which settings of a machine part its kinds best, how well, and how surely.

Runs the scene at many settings, more often and longer where it pays, until no setting is better than the best by more
than --within, and then the best with fresh seeds until the result is as sure."""
EPILOG = """Exit status: 0 if there is an answer, also that nothing is separated; 2 for bad arguments or a bad scene
(nothing is run); 1 for any other error. Ctrl-C and the end of --budget give the answer so far; the same command
continues.

Example: sieve_separate feeder.yaml --over base.inclination=0:0.35 --over base.frequency=10:50 --html answer.html"""


class Paragraphs(argparse.HelpFormatter):
    """Fills each paragraph of a description by itself."""

    def _fill_text(self, text, width, indent):
        return "\n\n".join(super(Paragraphs, self)._fill_text(each, width, indent) for each in text.split("\n\n"))


def make_parser():
    parser = argparse.ArgumentParser(prog="sieve_separate", description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=Paragraphs)
    parser.add_argument("scene", metavar="SCENE", help="scene file (YAML)")
    parser.add_argument("--over", metavar="KEY=FROM:TO", action="append", required=True,
                        help="a key of the scene and its range; repeatable")
    parser.add_argument("--unknown", metavar="KEY=LOW:HIGH", action="append", default=[],
                        help="a key of the grains or of the machine that is not known, and where it may be; "
                             "KEY=VALUE±ERROR: normal, the error at 95 %%; repeatable")
    parser.add_argument("--set", metavar="KEY=VALUE", action="append", default=[],
                        help="set a key of the scene; repeatable")
    parser.add_argument("--within", metavar="X", type=float,
                        help="by how much another setting may be better, and half the width of the result's interval, "
                             "both at 95 %% (default: 0.02; of a machine without open ends 0.001 m/s)")
    parser.add_argument("--budget", metavar="T", help='wall time at most, such as "90 s", "2 min" or "1 h"')
    parser.add_argument("--goal", metavar="KEY",
                        help="a column of sieve_sweep export that is to be large, such as purity.left.mass.A, in place "
                             "of the separation; needs --within, in its unit")
    parser.add_argument("--seed", metavar="N", type=int, default=1, help="of the search and of the runs (default: 1)")
    parser.add_argument("--db", metavar="FILE", type=pathlib.Path,
                        help="where the runs are kept (default: SCENE.separate.db in the working directory)")
    parser.add_argument("--threads", metavar="N", type=int, default=0, help="0: one per processor (default: 0)")
    for ending, what in (("html", "the answer as one HTML file for any browser"), ("json", "the answer as JSON"),
                         ("plot", "the map of the ranges, as .png, .svg or .pdf"), ("best", "the scene with the best "
                                                                                  "settings, as YAML")):
        parser.add_argument(f"--{ending}", metavar="FILE", type=pathlib.Path, help=what)
    parser.add_argument("--version", action="store_true", help="print the version and exit")
    return parser


def read_over(texts, option="--over", form="KEY=FROM:TO, such as base.inclination=0:0.35"):
    """@return map from keys to (from, to). Raises ValueError."""
    over = {}
    for text in texts:
        key, equals, span = text.partition("=")
        if key in over:
            raise ValueError(f"{option} {text}: {key} is there twice")
        ends = span.split(":")
        try:
            over[key] = tuple(int(end) if end.strip("+-").isdigit() else float(end) for end in ends)
        except ValueError:
            ends = []
        if not equals or not key or len(ends) != 2:
            raise ValueError(f"{option} {text}: must be {form}")
    return over


def read_unknown(texts):
    """@return as separate() takes it; None: all is known. Raises ValueError."""
    form, found = "KEY=LOW:HIGH, or KEY=VALUE±ERROR", {}
    for text in texts:
        normal = re.fullmatch(r"([^=]+)=([\d.e+-]+)(?:±|\+-)([\d.e+-]+)", text)
        try:
            each = {normal[1]: (float(normal[2]), "±", float(normal[3]))} if normal else \
                read_over([text], "--unknown", form)
        except ValueError:
            raise ValueError(f"--unknown {text}: must be {form}") from None
        if set(each) & set(found):
            raise ValueError(f"--unknown {text}: the key is there twice")
        found.update(each)
    return found or None


def require_outputs(options):
    """Raises ValueError for a file that could not be written at the end."""
    for name, endings in (("html", (".html",)), ("json", (".json",)), ("plot", (".png", ".svg", ".pdf")), ("best", ())):
        path = getattr(options, name)
        if path and endings and path.suffix not in endings:
            raise ValueError(f"--{name} {path}: must end in {' or '.join(endings)}")
        if path and not path.absolute().parent.is_dir():
            raise ValueError(f"--{name} {path}: there is no such directory")
    for text in options.set:
        if "=" not in text:
            raise ValueError(f"--set {text}: must be KEY=VALUE")


def run(options):
    import ratchet_sieve as rs
    from ratchet_sieve.tables import write_each, write_text

    require_outputs(options)
    warnings.showwarning = lambda message, *_: print(f"sieve_separate: warning: {message}", file=sys.stderr)
    scene = rs.Scene.load(options.scene, dict(text.partition("=")[::2] for text in options.set))
    options.db = options.db or pathlib.Path(pathlib.Path(options.scene).stem + ".separate.db")
    scene.require_other(*((f"--{name}", getattr(options, name)) for name in ("db", "html", "json", "plot", "best")))
    answer = rs.separate(scene, read_over(options.over), within=options.within, budget=options.budget,
                         goal=options.goal, unknown=read_unknown(options.unknown), seed=options.seed,
                         threads=options.threads, results=options.db)
    print(f"sieve_separate: the runs are kept in {options.db}; the same command continues", file=sys.stderr)
    writers = [functools.partial(answer.write, path) for path in (options.html, options.json, options.plot) if path]
    if options.best and answer.best:
        writers.append(lambda: write_text(options.best, answer.scene.yaml))
    elif options.best:
        print(f"sieve_separate: {options.best} is not written: nothing is separated", file=sys.stderr)
    write_each("sieve_separate", [lambda: print(answer), *writers])


def main():
    if "--version" in sys.argv[1:]:
        import ratchet_sieve

        print(f"sieve_separate {ratchet_sieve.__version__}")
        return
    options = make_parser().parse_args()
    try:
        run(options)
    except ValueError as error:
        print(f"sieve_separate: {error}", file=sys.stderr)
        sys.exit(2)
    except (OSError, RuntimeError) as error:
        sys.exit(f"sieve_separate: {error}")
    except KeyboardInterrupt:
        sys.exit("sieve_separate: interrupted before there is an answer; the same command continues")


if __name__ == "__main__":
    main()

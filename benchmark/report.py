"""What the measurements have in common: their arguments, and the document that their tables go into."""
import argparse
import json
import pathlib
import subprocess

from ratchet_sieve import documents, origin
from ratchet_sieve.texts import table

ROOT = pathlib.Path(__file__).resolve().parent.parent


def arguments_of(about, *marks, rounds=None, short=None, **others):
    """The arguments. Ends the program, before it measures anything, if the document has no place for the tables.
    @param marks of the tables. @param rounds, others defaults of options; None: there is none. @param short help of an
    option; None: there is none"""
    parser = argparse.ArgumentParser(description=about)
    parser.add_argument('--programs', type=pathlib.Path, default=ROOT / 'devel/lib/ratchet_sieve', metavar='DIR',
                        help='where the programs are')
    for name, default in {'rounds': rounds, **others}.items():
        if default:
            parser.add_argument(f'--{name}', type=type(default), default=default, help=f'default: {default}')
    if short:
        parser.add_argument('--short', action='store_true', help=short)
    parser.add_argument('--write', type=pathlib.Path, metavar='FILE',
                        help='put the table between the marks of this document')
    arguments = parser.parse_args()
    if arguments.write:
        for mark in marks:
            documents.require_place(parser, arguments.write, mark)
    return arguments


def benchmarks(arguments, wanted, rounds=1):
    """@param wanted the beginning of their names. @return the runs of engine_benchmark, which take turns"""
    finished = subprocess.run(
        [arguments.programs / 'engine_benchmark', f'--benchmark_filter=^({wanted})', '--benchmark_format=json',
         f'--benchmark_repetitions={rounds}', '--benchmark_enable_random_interleaving=true'],
        check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return [run for run in json.loads(finished.stdout)['benchmarks'] if run['run_type'] == 'iteration']


def publish(arguments, mark, lines, figures=None, about=None):
    """Prints a table, and puts it into the document. @param figures, about what documents.quote() takes for them"""
    text = '\n'.join(lines)
    print(text)
    if arguments.write:
        documents.put(arguments.write, mark, text)
    if figures:
        quote(arguments, mark.replace('-', '_'), figures, about)


def quote(arguments, name, figures, about):
    """Prints figures, and writes them into performance.json beside the document."""
    print(origin.text(about), table(['', 'measured'], figures.items()), sep='\n\n')
    if arguments.write:
        documents.quote(arguments.write.with_name('performance.md'), name, figures, about)

"""What the measurements have in common: their arguments, and the document that their tables go into."""
import argparse
import pathlib

from ratchet_sieve import documents, origin
from ratchet_sieve.texts import table

ROOT = pathlib.Path(__file__).resolve().parent.parent


def parser_of(about, rounds=None):
    parser = argparse.ArgumentParser(description=about)
    parser.add_argument('--programs', type=pathlib.Path, default=ROOT / 'devel/lib/ratchet_sieve', metavar='DIR',
                        help='where the programs are')
    if rounds:
        parser.add_argument('--rounds', type=int, default=rounds, help=f'repetitions (default: {rounds})')
    parser.add_argument('--write', type=pathlib.Path, metavar='FILE',
                        help='put the table between the marks of this document')
    return parser


def parsed(parser, *marks):
    """The arguments. Ends the program, before it measures anything, if the document has no place for the tables."""
    arguments = parser.parse_args()
    if arguments.write:
        for mark in marks:
            documents.require_place(parser, arguments.write, mark)
    return arguments


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

"""Numbers, words and tables as text, in Markdown."""
import math
import textwrap

WIDTH = 120  # of a line


def rounded(value, decimals):
    """With a true minus sign, and no minus before a zero."""
    text = f"{value:.{decimals}f}"
    if float(text) == 0.0:
        text = text.lstrip("-")
    return text.replace("-", "−")


def shown(value):
    """A number of few digits, with a true minus sign; a text as it is."""
    return value if isinstance(value, str) else f"{value:g}".replace("-", "−")


def decimals_of(error):
    """How many decimals show an error: two digits where the first is a one, else one digit."""
    exponent = math.floor(math.log10(error))
    if error / 10.0 ** exponent < 1.95:
        exponent -= 1
    return max(0, -exponent)


def plus_minus(value, error):
    """As 12.3 ± 0.4. @pre error > 0"""
    decimals = decimals_of(error)
    return f"{rounded(value, decimals)} ± {rounded(error, decimals)}"


def two_digits(value):
    """0.074, 7.4, 120."""
    return f"{float(f'{value:.2g}'):g}"


def at_most(bound):
    """Of two digits, rounded up. @pre bound > 0"""
    step = 10.0 ** (math.floor(math.log10(bound)) - 1)
    return two_digits(step * math.ceil(bound / step))


def percent(part):
    return f"{two_digits(100.0 * part)} %"


def counted(number, noun):
    """`1 run`, `2 runs`."""
    return f"{number} {noun}{'' if number == 1 else 's'}"


def which_way(separation, names, left=None):
    """Where two kinds go. @param separation s: above 0 the first leaves more to the left
    @param left of each the share that leaves to the left, where it is known"""
    order = (0, 1) if separation > 0.0 else (1, 0)
    to_left, to_right = (names[k] for k in order)
    more = "" if left is not None and left[order[0]] > 0.5 > left[order[1]] else "more "
    return f"{to_right} goes {more}to the right, {to_left} {more}to the left"


def span(values, unit=""):
    """From the first to the last."""
    return f"{values[0]:g}{unit}" if len(values) == 1 else f"{values[0]:g} to {values[-1]:g}{unit}"


def table(header, lines):
    """In Markdown."""
    rows = [header, ["---"] * len(header), *lines]
    return "\n".join("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows)


def wrapped(text):
    """A document with its paragraphs in lines of WIDTH at most; tables, lists, pictures and titles stay as they are."""
    return "\n\n".join(block if block.startswith(("|", "- ", "![", "#")) else
                       textwrap.fill(block, WIDTH, break_long_words=False, break_on_hyphens=False)
                       for block in text.strip().split("\n\n")) + "\n"

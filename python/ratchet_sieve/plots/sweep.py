"""Draws the results of a sweep, from cases.csv and findings.json that sieve_sweep wrote into a directory: curves
over one key, maps over two, means over the seeds. Settings whose Q is not comparable are hatched or hollow. Writes PNG,
SVG, means.csv and report.html there, and prints their paths."""
import base64
import html
import json
import math

from ratchet_sieve.plots.curves import STEPS, curve, end_labels, key_colours
from ratchet_sieve.plots.maps import mark_cells, shown, value_map
from ratchet_sieve.plots.program import parser_of, run_program
from ratchet_sieve.plots.style import GREY, panels, save
from ratchet_sieve.tables import Refusal, read_rows, throughput, typed, write_csv, writing
from ratchet_sieve.texts import counted

SMALLEST_DIFFERENCE = 1e-6  # of an axis: steps that differ by a smaller part are taken as equal
MOST_CURVES = STEPS  # in one picture
FINDINGS = {'lines', 'least_processed', 'least_counted', 'best'}  # of findings.json

LABELS = {
    'base.inclination': r'$\theta$ [rad]',
    'base.frequency': '$f$ [Hz]',
    'base.amplitude': '$A$ [m]',
    'density': 'density $d$',
    'quality': 'quality $Q$',
    'processed': 'processed ratio $P$',
    'throughput': 'throughput [disks/s]',
}


def label(name):
    if name is None:
        return ''
    if name.startswith('mean_vx.'):
        return rf"$\langle V_x \rangle$ of {name.split('.', 1)[1]} [m/s]"
    return LABELS.get(name, name)


def read_cases(path):
    """The swept keys, and the rows of the cases that are done, with their throughput."""
    rows = read_rows(path)
    rows.column('seed')
    keys = list(rows.frame.columns)
    keys = keys[:keys.index('seed')]
    rows.column('simulated_time')
    rows.samples('simulated_time')
    rows.frame['throughput'] = throughput(rows.frame)
    return keys, rows


def parse_where(conditions, keys):
    pairs = [condition.partition('=')[::2] for condition in conditions]
    for key, _ in pairs:
        require_known(key, keys, '--where')
    return {key: typed(text) for key, text in pairs}


def require_known(name, known, option):
    if name not in known:
        raise Refusal(f"{option} {name}: no such name; there are {', '.join(known)}")


def choose_axes(options, keys, rows):
    """@return the key along x, and the key along y or of the curves (None: there is none)"""
    count = {key: len(rows.values(key)) for key in keys}
    varied = [key for key in keys if count[key] > 1]
    for name, option in ((options.x, '--x'), (options.y, '--y')):
        if name is not None:
            require_known(name, keys, option)
    numbers = sorted((key for key in varied if key != options.y), key=lambda key: -count[key])
    x = options.x or (numbers + keys + [None])[0]
    if x is None:
        raise Refusal('the sweep has no key to draw over, seeds alone')
    others = [key for key in varied if key != x]
    y = options.y or (others[0] if others else None)
    left = [key for key in others if key != y]
    if left:
        raise Refusal(f"{', '.join(left)} vary as well: choose one value of each with --where {left[0]}=VALUE")
    return x, y


def of_all(rows, field):
    """The mean in which an undefined value counts as 0: no disk has left."""
    return sum(rows.samples(field)) / len(rows)


class Means:
    """The mean of each field over the seeds at each (x, y); the places where P or the counted disks are too few for Q
    to be compared; and the best place, if it is known."""

    def __init__(self, rows, x, y, fields, findings):
        groups = rows.by(x, y) if y else {(place, None): group for place, group in rows.by(x).items()}
        self.fields = fields
        self.counts = {place: len(group) for place, group in groups.items()}
        self.below = {place for place, group in groups.items()
                      if of_all(group, 'processed') < findings['least_processed']
                      or of_all(group, 'counted') < findings['least_counted']}
        best = findings['best'] and {key: typed(text) for key, text in findings['best']['values'].items()}
        self.best = (best[x], best[y] if y else None) if best else None
        self.at = {(field, place): group.mean(field) for field in fields for place, group in groups.items()}
        self.xs = rows.values(x)
        self.ys = rows.values(y) if y else [None]

    def get(self, field, x, y):
        """@return a Mean, or None"""
        return self.at.get((field, (x, y)))

    def value(self, field, x, y):
        mean = self.get(field, x, y)
        return mean.value if mean else math.nan


def default_fields(rows):
    wanted = ['quality', 'processed', 'throughput'] + [name for name in rows.frame if name.startswith('mean_vx.')]
    fields = [field for field in wanted if rows.samples(field)]
    if not fields:
        raise Refusal('no field is defined in any case')
    return fields


def is_even(values):
    """Whether they are evenly spaced numbers."""
    if len(values) < 2 or any(isinstance(v, str) for v in values):
        return False
    steps = [b - a for a, b in zip(values, values[1:])]
    return max(steps) - min(steps) <= SMALLEST_DIFFERENCE * (values[-1] - values[0])


def draw_curves(axes, means, field, x, y):
    places = means.xs
    if any(isinstance(v, str) for v in means.xs):
        places = list(range(len(means.xs)))
        axes.set_xticks(places, map(shown, means.xs))
    ends = []
    for colour, other in zip(key_colours(means.ys), means.ys):
        points = [(place, means.get(field, v, other)) for place, v in zip(places, means.xs)]
        curve(axes, points, color=colour)
        known = [mean.value for _, mean in points if mean]
        if known and y is not None:
            ends.append((known[-1], shown(other), colour))
        if field == 'quality':
            mark_curve(axes, means, dict(zip(means.xs, places)), other, colour)
    end_labels(axes, ends, label(y))
    axes.set_xlabel(label(x))
    axes.set_ylabel(label(field))


def mark_curve(axes, means, places, other, colour):
    """Hollow points where Q is not comparable, and a star at the best. @param places map from x to its place"""
    hollow = [(place, means.value('quality', v, other)) for v, place in places.items() if (v, other) in means.below]
    axes.plot([place for place, _ in hollow], [mean for _, mean in hollow], 'o', color=colour, markersize=5,
              markerfacecolor='white', zorder=3)
    if means.best and means.best[1] == other:
        axes.plot(places[means.best[0]], means.value('quality', *means.best), '*', color=colour, markersize=11,
                  zorder=4)


def cells(axis, values):
    """The edges of a map's cells, and their places: the values if they are evenly spaced, else 0, 1, 2, …"""
    places = values if is_even(values) else list(range(len(values)))
    if places is not values:
        axis.set_ticks(places, map(shown, values))
    inner = [(a + b) / 2 for a, b in zip(places, places[1:])]
    return [2 * places[0] - inner[0], *inner, 2 * places[-1] - inner[-1]], places


def draw_map(axes, means, field, x, y):
    (x_edges, xs), (y_edges, ys) = cells(axes.xaxis, means.xs), cells(axes.yaxis, means.ys)
    value_map(axes, x_edges, y_edges, [[means.value(field, u, v) for u in means.xs] for v in means.ys], label(field))
    if field == 'quality':
        mark_cells(axes, x_edges, y_edges, [(means.xs.index(u), means.ys.index(v)) for u, v in means.below])
        if means.best:
            axes.plot(xs[means.xs.index(means.best[0])], ys[means.ys.index(means.best[1])], '*', color='white',
                      markeredgecolor='black', markersize=12)
    axes.set_xlabel(label(x))
    axes.set_ylabel(label(y))


def draw_all(means, x, y, directory, origin):
    """Curves of each field, if they are few, and its map if there are two keys. @return paths of the PNG files"""
    pictures = []
    for field in means.fields:
        for kind, draw, is_wanted in (('curves', draw_curves, len(means.ys) <= MOST_CURVES),
                                      ('map', draw_map, len(means.xs) > 1 and len(means.ys) > 1)):
            if is_wanted:
                figure, axes = panels(1, 1, (6.4, 3.8), None)
                draw(axes, means, field, x, y)
                figure.text(0.01, -0.02, origin, fontsize=7, color=GREY, va='top')
                paths = save(figure, directory / f'{field}_{kind}.png', bbox_inches='tight')
                print(*paths, sep='\n')
                pictures.append(paths[0])
    return pictures


def table(means, x, y):
    """Header and lines: place, number of seeds, mean and standard error of each field."""
    header = [x] + ([y] if y else []) + ['seeds']
    for field in means.fields:
        header += [field, f'{field}_stderr']
    lines = []
    for place in ((u, v) for v in means.ys for u in means.xs if (u, v) in means.counts):
        found = [means.get(field, *place) for field in means.fields]
        lines.append([*place[:2 if y else 1], means.counts[place],
                      *(number for mean in found for number in ((mean.value, mean.error) if mean else (None, None)))])
    return header, lines


def html_row(cells, tag):
    text = (f'{cell:.4g}' if isinstance(cell, float) else '' if cell is None else str(cell) for cell in cells)
    return '<tr>' + ''.join(f'<{tag}>{html.escape(cell)}</{tag}>' for cell in text) + '</tr>'


def write_page(path, title, origin, findings, pictures, header, lines):
    parts = [f'<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>{html.escape(title)}</title>',
             '<style>body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em}img{max-width:100%}'
             'table{border-collapse:collapse;font-size:.85em}td,th{border:1px solid #ccc;padding:.2em .5em;'
             'text-align:right}div{overflow-x:auto}</style>',
             f'<h1>{html.escape(title)}</h1><p>{html.escape(origin)}</p>']
    parts += [f'<p>{html.escape(line)}</p>' for line in findings['lines']]
    for picture in pictures:
        content = base64.b64encode(picture.read_bytes()).decode()
        name = html.escape(picture.stem)
        parts.append(f'<figure><img alt="{name}" src="data:image/png;base64,{content}">'
                     f'<figcaption>{name}: <a href="{name}.svg">SVG</a></figcaption></figure>')
    parts.append('<p>Means over the seeds, and standard errors from them.</p><div><table>' + html_row(header, 'th') +
                 ''.join(html_row(line, 'td') for line in lines) + '</table></div></html>\n')
    with writing(path):
        path.write_text('\n'.join(parts), encoding='utf-8')
    print(path)


def read_findings(path):
    """The best setting, and the limits of comparable settings; see FINDINGS."""
    try:
        findings = json.loads(path.read_text(encoding='utf-8'))
    except ValueError as error:
        raise Refusal(f'{path}: no JSON: {error}') from error
    missing = FINDINGS - set(findings) if isinstance(findings, dict) else FINDINGS
    if missing:
        raise Refusal(f"{path}: has no {', '.join(sorted(missing))}")
    return findings


def report(options):
    keys, every = read_cases(options.directory / 'cases.csv')
    where = parse_where(options.where, keys)
    rows = every.where(where)
    if not len(rows):
        raise Refusal('no case is done' + (' of those that --where asks for' if where else ''))
    x, y = choose_axes(options, keys, rows)
    fields = options.field or default_fields(rows)
    for field in fields:
        require_known(field, [name for name in rows.frame if name not in keys], '--field')
    findings = read_findings(options.directory / 'findings.json')
    means = Means(rows, x, y, fields, findings)
    counts = sorted(set(means.counts.values()))
    seeds = f'n = {counts[0]}' if len(counts) == 1 else f'n = {counts[0]} to {counts[-1]}'
    origin = f"{counted(len(rows), 'run')}, {seeds}, ratchet_sieve {rows.column('version').iloc[0]}"
    origin += ''.join(f', {key} = {shown(text)}' for key, text in where.items())
    if every.failed:
        origin += f"; {every.failed} failed and {'is' if every.failed == 1 else 'are'} left out"
    warned = sum(count > 0 for count in rows.samples('warnings'))
    if warned:
        origin += f"; {warned} with warnings"
    if 'quality' in fields and means.below:
        origin += (f"; Q hatched or hollow: P < {findings['least_processed']:g} or fewer than "
                   f"{findings['least_counted']:g} disks counted, in the mean")
    pictures = draw_all(means, x, y, options.directory, origin)
    header, lines = table(means, x, y)
    write_csv(options.directory / 'means.csv', header, lines, '\r\n')
    print(options.directory / 'means.csv')
    write_page(options.directory / 'report.html', options.title, origin, findings, pictures, header, lines)


def main():
    parser = parser_of('sweep', __doc__, 'with the file cases.csv')
    parser.add_argument('--x', metavar='KEY', help='along x (default: the key with the most values)')
    parser.add_argument('--y', metavar='KEY', help='along y of a map, and one curve for each of its values')
    parser.add_argument('--field', metavar='NAME', action='append', default=[],
                        help='a column to draw; may be given again (default: Q, P, throughput and mean velocities)')
    parser.add_argument('--where', metavar='KEY=VALUE', action='append', default=[],
                        help='only cases with this value; may be given again')
    parser.add_argument('--title', default='Sweep', help='of the page')
    options = parser.parse_args()
    run_program(parser.prog, lambda: report(options))


if __name__ == '__main__':
    main()

#!/usr/bin/python3
"""Draws what a sweep came to, from the table cases.csv that sieve_sweep exported into a directory: curves over one key,
maps over two, averaged over the seeds. Writes PNG, SVG, means.csv and report.html there, and prints their paths."""
import argparse
import base64
import csv
import html
import math
import pathlib
import statistics
import sys

from plot_analysis import COLOURS, GREY, STYLE, matplotlib, plt

SMALLEST_DIFFERENCE = 1e-6  # of an axis: steps that differ by a smaller part are taken as equal
MOST_CURVES = 8  # in one picture

LABELS = {
    'base.inclination': r'$\theta$ [rad]',
    'base.frequency': '$f$ [Hz]',
    'base.amplitude': '$A$ [m]',
    'density': 'density $d$',
    'quality': 'quality $Q$',
    'processed': 'processed ratio $P$',
    'throughput': 'throughput [disks/s]',
}


class Refusal(Exception):
    """What cannot be drawn, in one line."""


def label(name):
    if name.startswith('mean_vx.'):
        return rf"$\langle V_x \rangle$ of {name.split('.', 1)[1]} [m/s]"
    return LABELS.get(name, name)


def value(text):
    """A field as a number, or as the text that it is."""
    try:
        return float(text)
    except ValueError:
        return text


def read_cases(path):
    """The swept keys, and the rows of the cases that are done."""
    with open(path, newline='', encoding='utf-8') as file:
        lines = csv.reader(file)
        columns = next(lines, ['seed'])
        rows = [dict(zip(columns, line)) for line in lines]
    keys = columns[:columns.index('seed')]
    done = [row for row in rows if row['status'] == 'done']
    for row in done:
        row.update({key: value(row[key]) for key in keys})
        add_throughput(row)
    return keys, done, len(rows) - len(done)


def add_throughput(row):
    """Disks of all species that left in a second."""
    left = [float(row[name]) for name in row if name.startswith(('left.', 'right.')) and row[name]]
    time = float(row['simulated_time'] or 0)
    row['throughput'] = repr(sum(left) / time) if time > 0 else ''


def in_order(values):
    """The different ones: numbers by size, then texts."""
    return sorted(set(values), key=lambda v: (isinstance(v, str), v))


def parse_where(conditions, keys):
    pairs = [condition.partition('=')[::2] for condition in conditions]
    for key, _ in pairs:
        require_known(key, keys, '--where')
    return {key: value(text) for key, text in pairs}


def require_known(name, known, option):
    if name not in known:
        raise Refusal(f"{option} {name}: no such name; there are {', '.join(known)}")


def choose_axes(options, keys, rows):
    """Key along x and key along y or of the curves (None: there is none)."""
    varied = [key for key in keys if len(set(row[key] for row in rows)) > 1]
    for name, option in ((options.x, '--x'), (options.y, '--y')):
        if name is not None:
            require_known(name, keys, option)
    numbers = sorted((key for key in varied if key != options.y),
                     key=lambda key: -len(set(row[key] for row in rows)))
    x = options.x or (numbers + keys + [None])[0]
    if x is None:
        raise Refusal('the sweep has no key to draw over, seeds alone')
    others = [key for key in varied if key != x]
    y = options.y or (others[0] if others else None)
    left = [key for key in others if key != y]
    if left:
        raise Refusal(f"{', '.join(left)} vary as well: choose one value of each with --where {left[0]}=VALUE")
    return x, y


def mean_and_error(values):
    """Mean and standard error over the seeds; the error of one value is not defined."""
    if not values:
        return math.nan, math.nan
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.nan
    return statistics.fmean(values), error


class Means:
    """Of each field its mean over the seeds at each (x, y)."""

    def __init__(self, rows, x, y, fields):
        groups = {}
        for row in rows:
            groups.setdefault((row[x], row[y] if y else None), []).append(row)
        self.fields = fields
        self.counts = {place: len(group) for place, group in groups.items()}
        self.at = {(field, place): mean_and_error([float(row[field]) for row in group if row.get(field)])
                   for field in fields for place, group in groups.items()}
        self.xs = in_order(place[0] for place in groups)
        self.ys = in_order(place[1] for place in groups) if y else [None]

    def get(self, field, x, y):
        return self.at.get((field, (x, y)), (math.nan, math.nan))


def default_fields(rows):
    wanted = ['quality', 'processed', 'throughput'] + [name for name in rows[0] if name.startswith('mean_vx.')]
    fields = [field for field in wanted if any(row.get(field) for row in rows)]
    if not fields:
        raise Refusal('no field is defined in any case')
    return fields


def positions(values):
    """Where values stand on an axis: as they are where they are evenly spaced numbers, or else side by side."""
    if len(values) > 1 and not any(isinstance(v, str) for v in values):
        steps = [b - a for a, b in zip(values, values[1:])]
        if max(steps) - min(steps) <= SMALLEST_DIFFERENCE * (values[-1] - values[0]):
            return values, False
    return list(range(len(values))), True


def show_values(axis, places, values, are_named):
    if are_named:
        axis.set_ticks(places, [f'{v:g}' if isinstance(v, float) else v for v in values])


def draw_curves(axes, means, field, x, y):
    places, are_named = means.xs, any(isinstance(v, str) for v in means.xs)
    if are_named:
        places = list(range(len(means.xs)))
    for k, other in enumerate(means.ys):
        points = [means.get(field, v, other) for v in means.xs]
        name = None if y is None else f'{label(y)} = {other:g}' if isinstance(other, float) else f'{label(y)} = {other}'
        axes.errorbar(places, [mean for mean, _ in points],
                      yerr=[0.0 if math.isnan(error) else error for _, error in points], color=COLOURS[k % len(COLOURS)],
                      linestyle='-' if k < len(COLOURS) else '--', marker='o', markersize=2.5, elinewidth=0.9, capsize=2,
                      label=name)
    show_values(axes.xaxis, places, means.xs, are_named)
    if y is not None:
        axes.legend()
    axes.set_xlabel(label(x))
    axes.set_ylabel(label(field))


def draw_map(figure, axes, means, field, x, y):
    xs, x_named = positions(means.xs)
    ys, y_named = positions(means.ys)
    grid = [[means.get(field, u, v)[0] for u in means.xs] for v in means.ys]
    defined = [mean for line in grid for mean in line if not math.isnan(mean)]
    limits = {}
    if defined and min(defined) < 0 < max(defined):
        extreme = max(-min(defined), max(defined))
        limits = {'cmap': 'RdBu_r', 'vmin': -extreme, 'vmax': extreme}
    axes.grid(False)
    mesh = axes.pcolormesh(xs, ys, grid, shading='nearest', rasterized=True, **limits)
    figure.colorbar(mesh, ax=axes, label=label(field))
    show_values(axes.xaxis, xs, means.xs, x_named)
    show_values(axes.yaxis, ys, means.ys, y_named)
    axes.set_xlabel(label(x))
    axes.set_ylabel(label(y))


def save(figure, directory, name, origin):
    figure.text(0.01, -0.02, origin, fontsize=7, color=GREY, va='top')
    for ending in ('png', 'svg'):
        path = directory / f'{name}.{ending}'
        metadata = {'Date': None} if ending == 'svg' else None
        figure.savefig(path, bbox_inches='tight', metadata=metadata)
        print(path)
    plt.close(figure)
    return directory / f'{name}.png'


def draw_all(means, x, y, directory, origin):
    """Curves of each field, where they are few, and its map where there are two keys. Paths of the PNG."""
    pictures = []
    for field in means.fields:
        if len(means.ys) <= MOST_CURVES:
            figure, axes = plt.subplots(figsize=(6.4, 3.8))
            draw_curves(axes, means, field, x, y)
            pictures.append(save(figure, directory, f'{field}_curves', origin))
        if len(means.xs) > 1 and len(means.ys) > 1:
            figure, axes = plt.subplots(figsize=(6.4, 3.8))
            draw_map(figure, axes, means, field, x, y)
            pictures.append(save(figure, directory, f'{field}_map', origin))
    return pictures


def table(means, x, y):
    """Header and lines: place, number of seeds, and of each field its mean and standard error."""
    header = [x] + ([y] if y else []) + ['seeds']
    for field in means.fields:
        header += [field, f'{field}_stderr']
    lines = []
    for v in means.ys:
        for u in means.xs:
            if (u, v) not in means.counts:
                continue
            line = [u] + ([v] if y else []) + [means.counts[u, v]]
            for field in means.fields:
                line += ['' if math.isnan(number) else number for number in means.get(field, u, v)]
            lines.append(line)
    return header, lines


def write_csv(path, header, lines):
    with open(path, 'w', newline='', encoding='utf-8') as file:
        csv.writer(file).writerows([header] + lines)
    print(path)


def html_row(cells, tag):
    text = (f'{cell:.4g}' if isinstance(cell, float) else str(cell) for cell in cells)
    return '<tr>' + ''.join(f'<{tag}>{html.escape(cell)}</{tag}>' for cell in text) + '</tr>'


def write_page(path, title, origin, pictures, header, lines):
    parts = [f'<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>{html.escape(title)}</title>',
             '<style>body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em}img{max-width:100%}'
             'table{border-collapse:collapse;font-size:.85em}td,th{border:1px solid #ccc;padding:.2em .5em;'
             'text-align:right}div{overflow-x:auto}</style>',
             f'<h1>{html.escape(title)}</h1><p>{html.escape(origin)}</p>']
    for picture in pictures:
        content = base64.b64encode(picture.read_bytes()).decode()
        name = html.escape(picture.stem)
        parts.append(f'<figure><img alt="{name}" src="data:image/png;base64,{content}">'
                     f'<figcaption>{name}: <a href="{name}.svg">SVG</a></figcaption></figure>')
    parts.append('<p>Means over the seeds, and standard errors from them.</p><div><table>' + html_row(header, 'th') +
                 ''.join(html_row(line, 'td') for line in lines) + '</table></div></html>\n')
    path.write_text('\n'.join(parts), encoding='utf-8')
    print(path)


def report(options):
    keys, rows, others = read_cases(options.directory / 'cases.csv')
    where = parse_where(options.where, keys)
    rows = [row for row in rows if all(row[key] == wanted for key, wanted in where.items())]
    if not rows:
        raise Refusal('no case is done' + (' of those that --where asks for' if where else ''))
    x, y = choose_axes(options, keys, rows)
    fields = options.field or default_fields(rows)
    for field in fields:
        require_known(field, [name for name in rows[0] if name not in keys], '--field')
    means = Means(rows, x, y, fields)
    origin = f"{len(rows)} runs, ratchet_sieve {rows[0]['version']}"
    origin += ''.join(f', {key} = {text:g}' if isinstance(text, float) else f', {key} = {text}'
                      for key, text in where.items())
    if others:
        origin += f'; {others} failed and are left out'
    pictures = draw_all(means, x, y, options.directory, origin)
    header, lines = table(means, x, y)
    write_csv(options.directory / 'means.csv', header, lines)
    write_page(options.directory / 'report.html', options.title, origin, pictures, header, lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('directory', metavar='DIR', type=pathlib.Path, help='with the file cases.csv')
    parser.add_argument('--x', metavar='KEY', help='along x (the key with the most values)')
    parser.add_argument('--y', metavar='KEY', help='along y of a map, and one curve for each of its values')
    parser.add_argument('--field', metavar='NAME', action='append', default=[],
                        help='a column to be drawn; may be given again (Q, P, throughput and mean velocities)')
    parser.add_argument('--where', metavar='KEY=VALUE', action='append', default=[],
                        help='only cases of this value; may be given again')
    parser.add_argument('--title', default='Sweep', help='of the page')
    options = parser.parse_args()
    style = dict(STYLE, **{'svg.hashsalt': 'ratchet_sieve'})
    try:
        with matplotlib.rc_context(style):
            report(options)
    except OSError as error:
        sys.exit(f'plot_sweep.py: {error.filename}: {error.strerror}')
    except Refusal as refusal:
        print(f'plot_sweep.py: {refusal}', file=sys.stderr)
        sys.exit(2)


if __name__ == '__main__':
    main()

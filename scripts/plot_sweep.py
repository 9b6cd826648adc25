#!/usr/bin/python3
"""Draws the results of a sweep, from cases.csv and findings.json that sieve_sweep wrote into a directory: curves
over one key, maps over two, means over the seeds. Settings whose Q is not comparable are hatched or hollow. Writes PNG,
SVG, means.csv and report.html there, and prints their paths."""
import argparse
import base64
import csv
import html
import json
import math
import pathlib
import statistics

from matplotlib.patches import Rectangle

from plot_tables import GREY, Refusal, Row, matplotlib, plt, read_csv, run_program, writing
from sweep_colours import COLOUR_STEPS, colour_steps, curve_colours, label_ends

SMALLEST_DIFFERENCE = 1e-6  # of an axis: steps that differ by a smaller part are taken as equal
MOST_CURVES = COLOUR_STEPS  # in one picture
FINDINGS = {'lines', 'least_processed', 'least_counted', 'best'}  # of findings.json
VEIL = (1.0, 1.0, 1.0, 0.6)  # over hatched settings

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
    columns, lines = read_csv(path)
    if 'seed' not in columns:
        raise Refusal(f'{path}: has no column seed')
    rows = [Row(path, columns, line) for line in lines]
    keys = columns[:columns.index('seed')]
    done = [row for row in rows if row['status'] == 'done']
    for row in done:
        row.update({key: value(row[key]) for key in keys})
        add_throughput(row)
    return keys, done, len(rows) - len(done)


def add_throughput(row):
    """Disks of all species that left in a second."""
    left = [row.number(name) for name in row if name.startswith(('left.', 'right.')) and row[name]]
    time = row.number('simulated_time')
    row['throughput'] = repr(sum(left) / time) if time > 0 else ''


def in_order(values):
    """Without repetitions: numbers by size, then texts."""
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
    """@return the key along x, and the key along y or of the curves (None: there is none)"""
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


def mean_of(rows, field):
    """An undefined value counts as 0: no disk has left."""
    return statistics.fmean(row.number(field) if row[field] else 0.0 for row in rows)


class Means:
    """The mean of each field over the seeds at each (x, y); the places where P or the counted disks are too few for Q
    to be compared; and the best place, if it is known."""

    def __init__(self, rows, x, y, fields, findings):
        groups = {}
        for row in rows:
            groups.setdefault((row[x], row[y] if y else None), []).append(row)
        self.fields = fields
        self.counts = {place: len(group) for place, group in groups.items()}
        self.below = {place for place, group in groups.items()
                      if mean_of(group, 'processed') < findings['least_processed']
                      or mean_of(group, 'counted') < findings['least_counted']}
        best = findings['best'] and {key: value(text) for key, text in findings['best']['values'].items()}
        self.best = (best[x], best[y] if y else None) if best else None
        self.at = {(field, place): mean_and_error([row.number(field) for row in group if row.get(field)])
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
    """Their places on an axis: the values themselves if they are evenly spaced numbers, else 0, 1, 2, …"""
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
    ends = []
    for colour, other in zip(curve_colours(means.ys), means.ys):
        points = [means.get(field, v, other) for v in means.xs]
        axes.errorbar(places, [mean for mean, _ in points],
                      yerr=[0.0 if math.isnan(error) else error for _, error in points], color=colour,
                      marker='o', markersize=2.5, elinewidth=0.9, capsize=2)
        known = [(place, mean) for place, (mean, _) in zip(places, points) if math.isfinite(mean)]
        if known:
            ends.append((known[-1], f'{other:g}' if isinstance(other, float) else str(other), colour))
        if field == 'quality':
            mark_curve(axes, means, places, points, other, colour)
    show_values(axes.xaxis, places, means.xs, are_named)
    if y is not None:
        label_ends(axes, ends, label(y))
    axes.set_xlabel(label(x))
    axes.set_ylabel(label(field))


def mark_curve(axes, means, places, points, other, colour):
    """Hollow points where Q is not comparable, and a star at the best."""
    hollow = [(place, mean) for place, v, (mean, _) in zip(places, means.xs, points) if (v, other) in means.below]
    axes.plot([place for place, _ in hollow], [mean for _, mean in hollow], 'o', color=colour, markersize=5,
              markerfacecolor='white', zorder=3)
    if means.best and means.best[1] == other:
        axes.plot(places[means.xs.index(means.best[0])], means.get('quality', *means.best)[0], '*', color=colour,
                  markersize=11, zorder=4)


def draw_map(figure, axes, means, field, x, y):
    xs, x_named = positions(means.xs)
    ys, y_named = positions(means.ys)
    grid = [[means.get(field, u, v)[0] for u in means.xs] for v in means.ys]
    defined = [mean for line in grid for mean in line if math.isfinite(mean)]
    axes.grid(False)
    mesh = axes.pcolormesh(xs, ys, grid, shading='nearest', rasterized=True,
                           **(colour_steps(defined) if defined else {}))
    if field == 'quality':
        mark_map(axes, means, xs, ys)
    figure.colorbar(mesh, ax=axes, label=label(field))
    show_values(axes.xaxis, xs, means.xs, x_named)
    show_values(axes.yaxis, ys, means.ys, y_named)
    axes.set_xlabel(label(x))
    axes.set_ylabel(label(y))


def edges_of(places):
    """The edges of a map's cells: between places, and half a step beyond the first and the last."""
    inner = [(a + b) / 2 for a, b in zip(places, places[1:])]
    return [places[0] - (inner[0] - places[0])] + inner + [places[-1] + (places[-1] - inner[-1])]


def mark_map(axes, means, xs, ys):
    """Hatches the settings whose Q is not comparable, and stars the best."""
    x_edges, y_edges = edges_of(xs), edges_of(ys)
    for (u, v) in means.below:
        i, k = means.xs.index(u), means.ys.index(v)
        axes.add_patch(Rectangle((x_edges[i], y_edges[k]), x_edges[i + 1] - x_edges[i], y_edges[k + 1] - y_edges[k],
                                 facecolor=VEIL, edgecolor=GREY, hatch='////', linewidth=0.0))
    if means.best:
        axes.plot(xs[means.xs.index(means.best[0])], ys[means.ys.index(means.best[1])], '*', color='white',
                  markeredgecolor='black', markersize=12)


def save(figure, directory, name, origin):
    figure.text(0.01, -0.02, origin, fontsize=7, color=GREY, va='top')
    for ending in ('png', 'svg'):
        path = directory / f'{name}.{ending}'
        metadata = {'Date': None} if ending == 'svg' else None
        with writing(path):
            figure.savefig(path, bbox_inches='tight', metadata=metadata)
        print(path)
    plt.close(figure)
    return directory / f'{name}.png'


def draw_all(means, x, y, directory, origin):
    """Curves of each field, if they are few, and its map if there are two keys. @return paths of the PNG files"""
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
    """Header and lines: place, number of seeds, mean and standard error of each field."""
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
    with writing(path), open(path, 'w', newline='', encoding='utf-8') as file:
        csv.writer(file).writerows([header] + lines)
    print(path)


def html_row(cells, tag):
    text = (f'{cell:.4g}' if isinstance(cell, float) else str(cell) for cell in cells)
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
    keys, rows, others = read_cases(options.directory / 'cases.csv')
    where = parse_where(options.where, keys)
    rows = [row for row in rows if all(row[key] == wanted for key, wanted in where.items())]
    if not rows:
        raise Refusal('no case is done' + (' of those that --where asks for' if where else ''))
    x, y = choose_axes(options, keys, rows)
    fields = options.field or default_fields(rows)
    for field in fields:
        require_known(field, [name for name in rows[0] if name not in keys], '--field')
    findings = read_findings(options.directory / 'findings.json')
    means = Means(rows, x, y, fields, findings)
    counts = sorted(set(means.counts.values()))
    seeds = f'n = {counts[0]}' if len(counts) == 1 else f'n = {counts[0]} to {counts[-1]}'
    origin = f"{len(rows)} run{'' if len(rows) == 1 else 's'}, {seeds}, ratchet_sieve {rows[0]['version']}"
    origin += ''.join(f', {key} = {text:g}' if isinstance(text, float) else f', {key} = {text}'
                      for key, text in where.items())
    if others:
        origin += f"; {others} failed and {'is' if others == 1 else 'are'} left out"
    warned = sum(row.number('warnings') > 0 for row in rows)
    if warned:
        origin += f"; {warned} with warnings"
    if 'quality' in fields and means.below:
        origin += (f"; Q hatched or hollow: P < {findings['least_processed']:g} or fewer than "
                   f"{findings['least_counted']:g} disks counted, in the mean")
    pictures = draw_all(means, x, y, options.directory, origin)
    header, lines = table(means, x, y)
    write_csv(options.directory / 'means.csv', header, lines)
    write_page(options.directory / 'report.html', options.title, origin, findings, pictures, header, lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('directory', metavar='DIR', type=pathlib.Path, help='with the file cases.csv')
    parser.add_argument('--x', metavar='KEY', help='along x (default: the key with the most values)')
    parser.add_argument('--y', metavar='KEY', help='along y of a map, and one curve for each of its values')
    parser.add_argument('--field', metavar='NAME', action='append', default=[],
                        help='a column to draw; may be given again (default: Q, P, throughput and mean velocities)')
    parser.add_argument('--where', metavar='KEY=VALUE', action='append', default=[],
                        help='only cases with this value; may be given again')
    parser.add_argument('--title', default='Sweep', help='of the page')
    options = parser.parse_args()
    with matplotlib.rc_context({'svg.hashsalt': 'ratchet_sieve'}):
        run_program('plot_sweep.py', lambda: report(options))


if __name__ == '__main__':
    main()

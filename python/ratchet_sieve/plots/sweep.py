"""Draws the results of a sweep, from cases.csv and findings.json that sieve_sweep wrote into a directory: curves
over one key, maps over two, means over the seeds. Settings whose Q is not comparable are hatched or hollow. Writes PNG,
SVG, means.csv and report.json there, of which sieve_sweep makes report.html, and prints their paths."""
import json
import pathlib

from ratchet_sieve.plots.curves import STEPS
from ratchet_sieve.plots.maps import shown
from ratchet_sieve.plots.means import Means, draw_curves, draw_map, plain_label
from ratchet_sieve.plots.program import parser_of, run_program
from ratchet_sieve.plots.style import GREY, panels, save
from ratchet_sieve.plots.sweep_page import Pages, report_of, write_report
from ratchet_sieve.tables import Refusal, read_rows, throughput, typed, write_csv
from ratchet_sieve.texts import counted

MOST_CURVES = STEPS  # in one picture
FINDINGS = {'lines', 'least_processed', 'least_counted', 'best', 'command'}  # of findings.json


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


def default_fields(rows):
    wanted = ['quality', 'processed', 'throughput'] + [name for name in rows.frame if name.startswith('mean_vx.')]
    fields = [field for field in wanted if rows.samples(field)]
    if not fields:
        raise Refusal('no field is defined in any case')
    return fields


def draw_all(means, x, y, directory, origin):
    """Curves of each field, if they are few, and its map if there are two keys."""
    for field in means.fields:
        for kind, draw, is_wanted in (('curves', draw_curves, len(means.ys) <= MOST_CURVES),
                                      ('map', draw_map, len(means.xs) > 1 and len(means.ys) > 1)):
            if is_wanted:
                figure, axes = panels(1, 1, (6.4, 3.8), None)
                draw(axes, means, field, x, y)
                figure.text(0.01, -0.02, origin, fontsize=7, color=GREY, va='top')
                print(*save(figure, directory / f'{field}_{kind}.png', bbox_inches='tight'), sep='\n')


def with_unit(name, ending=''):
    """As the head of a column."""
    unit = plain_label(name)[1]
    return f'{name}{ending} [{unit}]' if unit else name + ending


def table(means, x, y):
    """Header and lines: place, number of seeds, mean and standard error of each field."""
    header = [*map(with_unit, [x] + ([y] if y else [])), 'seeds']
    for field in means.fields:
        header += [with_unit(field), with_unit(field, '_stderr')]
    lines = []
    for place in ((u, v) for v in means.ys for u in means.xs if (u, v) in means.counts):
        found = [means.get(field, *place) for field in means.fields]
        lines.append([*place[:2 if y else 1], means.counts[place],
                      *(number for mean in found for number in ((mean.value, mean.error) if mean else (None, None)))])
    return header, lines


def read_findings(path):
    """The best setting, the limits of comparable settings, and how a case is run; see FINDINGS."""
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
    draw_all(means, x, y, options.directory, origin)
    header, lines = table(means, x, y)
    write_csv(options.directory / 'means.csv', header, lines, '\r\n')
    print(options.directory / 'means.csv')
    write_report(options.directory / 'report.json',
                 report_of(means, (x, y), {'title': options.title, 'origin': origin}, findings,
                           Pages(options.html, options.directory)))


def main():
    parser = parser_of('sweep', __doc__, 'with the file cases.csv')
    parser.add_argument('--x', metavar='KEY', help='along x (default: the key with the most values)')
    parser.add_argument('--y', metavar='KEY', help='along y of a map, and one curve for each of its values')
    parser.add_argument('--field', metavar='NAME', action='append', default=[],
                        help='a column to draw; may be given again (default: Q, P, throughput and mean velocities)')
    parser.add_argument('--where', metavar='KEY=VALUE', action='append', default=[],
                        help='only cases with this value; may be given again')
    parser.add_argument('--title', default='Sweep', help='of the page')
    parser.add_argument('--html', metavar='PAGES', type=pathlib.Path,
                        help='directory of the pages of cases that sieve_sweep run --html has kept')
    options = parser.parse_args()
    run_program(parser.prog, lambda: report(options))


if __name__ == '__main__':
    main()

"""Draws the results of a sweep, from cases.csv and sweep.json that sieve_sweep wrote into a directory: curves
over one key, maps over two, means over the seeds. Settings whose Q is not comparable are hatched or hollow. Writes PNG,
SVG, means.csv, findings.json and report.json there, of which sieve_sweep makes report.html, and prints their paths."""
import collections
import functools
import json
import pathlib
import sys

from ratchet_sieve.plots.curves import STEPS
from ratchet_sieve.plots.findings import check_floor, findings_of, setting_of
from ratchet_sieve.plots.maps import shown
from ratchet_sieve.plots.means import Limits, Means, draw_curves, draw_map, plain_label
from ratchet_sieve.plots.program import parser_of, run_program
from ratchet_sieve.plots.style import GREY, panels, save
from ratchet_sieve.plots.sweep_page import pages_of, report_of
from ratchet_sieve.tables import (
    QUALITIES, QUALITY, STEADY_QUALITY, Refusal, column_of, departed, read_csv, read_rows, throughput, typed, write_csv,
    write_each, write_text)
from ratchet_sieve.texts import counted

MOST_CURVES = STEPS  # in one picture
SWEEP = {'command', 'seeds', 'warnings'}  # of sweep.json


def read_cases(path):
    """The swept keys; the rows of the cases that are done, with their throughput; and the number of cases of each
    setting, failed ones too."""
    texts = read_csv(path)
    rows = read_rows(path, texts)
    rows.column('seed')
    keys = list(rows.frame.columns)
    keys = keys[:keys.index('seed')]
    rows.column('simulated_time')
    rows.samples('simulated_time')
    rows.frame['throughput'] = throughput(rows.frame)
    # Results of earlier versions have no column of the counted disks.
    rows.frame['counted'] = rows.frame.get('counted', departed(rows.frame)).fillna(departed(rows.frame))
    return keys, rows, collections.Counter(map(setting_of, column_of(texts, 'arguments', path)))


def parse_where(conditions, keys):
    pairs = [condition.partition('=')[::2] for condition in conditions]
    for key, _ in pairs:
        require_known(key, keys, '--where')
    return {key: typed(text) for key, text in pairs}


def require_known(name, known, option):
    if name not in known:
        raise Refusal(f"{option} {name}: no such name; "
                      + (f"there are {', '.join(known)}" if known else "the sweep has no keys, seeds alone"))


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
    wanted = [STEADY_QUALITY, QUALITY, 'separation', 'processed', 'throughput',
              *(name for name in rows.frame if name.startswith('mean_vx.'))]
    fields = [field for field in wanted if rows.samples(field)]
    if not fields:
        raise Refusal('no field is defined in any case')
    return fields


def pictures_of(means, x, y, directory, origin):
    """What draws the curves of each field, if they are few, and its map if there are two keys."""
    def picture(field, kind, draw):
        figure, axes = panels(1, 1, (6.4, 3.8), None)
        draw(axes, means, field, x, y)
        figure.text(0.01, -0.02, origin, fontsize=7, color=GREY, va='top')
        print(*save(figure, directory / f'{field}_{kind}.png', bbox_inches='tight'), sep='\n')

    for field in means.fields:
        if len(means.ys) <= MOST_CURVES:
            yield functools.partial(picture, field, 'curves', draw_curves)
        if len(means.xs) > 1 and len(means.ys) > 1:
            yield functools.partial(picture, field, 'map', draw_map)


def with_unit(name, ending=''):
    """As the head of a column."""
    unit = plain_label(name)[1]
    return f'{name}{ending} [{unit}]' if unit else name + ending


def write_table(path, means, x, y):
    """A line for each place: the values of the keys, the number of seeds, mean and standard error of each field."""
    header = [*map(with_unit, [x] + ([y] if y else [])), 'seeds']
    for field in means.fields:
        header += [with_unit(field), with_unit(field, '_stderr')]
    lines = []
    for place in ((u, v) for v in means.ys for u in means.xs if (u, v) in means.counts):
        found = [means.get(field, *place) for field in means.fields]
        lines.append([*place[:2 if y else 1], means.counts[place],
                      *(number for mean in found for number in ((mean.value, mean.error) if mean else (None, None)))])
    write_csv(path, header, lines, '\r\n')
    print(path)


def read_sweep(path):
    """What the table of cases does not say: how a case is run, the seeds of each setting, lines on warnings."""
    try:
        sweep = json.loads(path.read_text(encoding='utf-8'))
    except ValueError as error:
        raise Refusal(f'{path}: no JSON: {error}') from error
    missing = SWEEP - set(sweep) if isinstance(sweep, dict) else SWEEP
    if missing:
        raise Refusal(f"{path}: has no {', '.join(sorted(missing))}")
    return sweep


def write_json(path, content, **options):
    write_text(path, json.dumps(content, ensure_ascii=False, allow_nan=False, **options) + '\n',
               errors='replace')  # of names of files that are not UTF-8


def origin_of(rows, means, where, failed, limits):
    """The line below each picture."""
    counts = sorted(set(means.counts.values()))
    seeds = f'n = {counts[0]}' if len(counts) == 1 else f'n = {counts[0]} to {counts[-1]}'
    origin = f"{counted(len(rows), 'run')}, {seeds}, ratchet_sieve {rows.column('version').iloc[0]}"
    origin += ''.join(f', {key} = {shown(text)}' for key, text in where.items())
    if failed:
        origin += f"; {failed} failed and {'is' if failed == 1 else 'are'} left out"
    warned = sum(count > 0 for count in rows.samples('warnings'))
    if warned:
        origin += f"; {warned} with warnings"
    if means.below and not {*QUALITIES}.isdisjoint(means.fields):
        origin += (f"; Q hatched or hollow: P < {limits.processed:g} or fewer than "
                   f"{limits.counted:g} disks counted, in the mean")
    return origin


def report(options):
    keys, every, ended = read_cases(options.directory / 'cases.csv')
    where = parse_where(options.where, keys)
    rows = every.where(where)
    if not len(rows):
        raise Refusal('no case is done' + (' of those that --where asks for' if where else ''))
    x, y = choose_axes(options, keys, rows)
    fields = options.field or default_fields(rows)
    for field in fields:
        require_known(field, [name for name in rows.frame if name not in keys], '--field')
    sweep = read_sweep(options.directory / 'sweep.json')
    limits = Limits(options.least_processed, options.least_counted)
    findings, best = findings_of(rows, ended, keys, sweep, limits)
    if options.check_floor:
        lines, findings['floor_check'] = check_floor(best, sweep['command'], options.check_floor, options.threads)
        findings['lines'] += lines
    means = Means(rows, x, y, fields, limits, best and (best[0][x], best[0][y] if y else None))
    origin = origin_of(rows, means, where, every.failed, limits)
    page = report_of(means, (x, y), {'title': options.title, 'origin': origin}, findings,
                     pages_of(options.html, options.directory) if options.html else {})
    write_each('ratchet_sieve.plots.sweep', [
        *pictures_of(means, x, y, options.directory, origin),
        lambda: write_table(options.directory / 'means.csv', means, x, y),
        lambda: write_json(options.directory / 'findings.json', findings, indent=2),
        lambda: write_json(options.directory / 'report.json', page)])
    print(options.directory / 'report.json')


def main():
    parser = parser_of('sweep', __doc__, 'with the file cases.csv')
    parser.add_argument('--x', metavar='KEY', help='along x (default: the key with the most values)')
    parser.add_argument('--y', metavar='KEY', help='along y of a map, and one curve for each of its values')
    parser.add_argument('--field', metavar='NAME', action='append', default=[],
                        help='a column to draw; may be given again (default: Q, also of the filled machine, P, throughput and '
                             'mean velocities)')
    parser.add_argument('--where', metavar='KEY=VALUE', action='append', default=[],
                        help='only cases with this value; may be given again')
    parser.add_argument('--least-processed', metavar='P', type=float, default=0.5,
                        help='least P of a setting whose Q is compared, averaged over its seeds (default: 0.5)')
    parser.add_argument('--least-counted', metavar='N', type=float, default=50.0,
                        help='least number of disks that left in it, averaged over its seeds (default: 50)')
    parser.add_argument('--check-floor', metavar='RESULTS',
                        help='run the seeds of the best setting at lower contact.min_rebound_speed, into this file')
    parser.add_argument('--threads', metavar='N', type=int, default=0,
                        help='cases run at the same time; 0: one per processor (default: 0)')
    parser.add_argument('--title', default='Sweep', help='of the page')
    parser.add_argument('--html', metavar='PAGES', type=pathlib.Path,
                        help='directory of the pages of cases that sieve_sweep run --html has kept')
    options = parser.parse_args()
    try:
        run_program(parser.prog, lambda: report(options))
    except KeyboardInterrupt:
        sys.exit('sieve_sweep: stopped; run the same command to continue')


if __name__ == '__main__':
    main()

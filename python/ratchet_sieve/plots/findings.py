"""What a report says of a sweep: its best setting, and whether Q there depends on the minimum rebound speed."""
import math
import re
import shlex
import warnings

from ratchet_sieve.plots.maps import shown
from ratchet_sieve.plots.means import of_all
from ratchet_sieve.tables import QUALITY, STEADY_QUALITY, Refusal, Rows, rows_of, species_of
from ratchet_sieve.texts import counted, which_way

ARGUMENTS = re.compile(r'(.*?) ?(?:--seed (\d+))?')  # of a case
FLOOR = 'contact.min_rebound_speed'
SETTLED = 0.8  # of the runs of a setting that is compared by the filled machine
FLOORS = (1.0, 0.5, 0.25)  # of the scene's own: two halvings also show the trend of a dependence
NOT_KNOWN = f'no error is known, so a dependence on {FLOOR} cannot be tested'


def setting_and_seed(arguments):
    """Of a case's arguments of sieve_run. The seed is a text, or None: that of the scene."""
    return ARGUMENTS.fullmatch(arguments).groups()


def setting_of(arguments):
    return setting_and_seed(arguments or '')[0]


def assignments(command):
    """key -> YAML text, of the options --set of a command line."""
    words = shlex.split(command)
    return dict(word.partition('=')[::2] for option, word in zip(words, words[1:]) if option == '--set')


def compared_by(rows):
    """Q of the filled machine, where any run has filled one."""
    return STEADY_QUALITY if rows.samples('steady.separation.value') else QUALITY


def best_setting(rows, ended, seeds, limits):
    """The setting with the highest |mean s|, which is without the bias of a mean of |s|, of those that are within the
    limits and whose seeds have all ended, and where s is that of the filled machine have settled as a rule.
    @param ended map from setting to its cases with a result
    @return its name and its Rows; None: there is none"""
    field = compared_by(rows)
    groups = rows.frame.groupby(rows.column('arguments').map(setting_of), sort=False)
    means = {}
    for setting, frame in groups:
        group = Rows(frame, rows.path)
        mean = group.mean(field) if ended[setting] >= seeds and limits.hold(group) else None
        if mean and (field == QUALITY or mean.count >= SETTLED * len(group)):
            means[setting] = mean.value, group
    best = max(means, key=lambda setting: means[setting][0], default=None)
    return None if best is None else (best, means[best][1])


def mean_text(rows, field=QUALITY):
    """With Q since the start beside that of the filled machine."""
    def text(mean):
        over = f"over {counted(mean.count, 'seed')}"
        over = f'{over} (error unknown)' if mean.error is None else f'± {mean.error:.3f} {over}'
        return f'{mean.value:.3f} {over}'

    whole = rows.mean(QUALITY) if field != QUALITY else None
    disks = counted(math.floor(of_all(rows, 'counted') + 0.5), 'disk')
    return text(rows.mean(field)) + (f' (since the start {text(whole)})' if whole else '') + \
        f", P {of_all(rows, 'processed'):.2f}, {disks} counted"


def way_of(group, field=QUALITY):
    """Where the two kinds go there."""
    names, separation = species_of(group.frame), group.mean(field.replace('quality', 'separation'))
    if len(names) != 2 or not separation:
        return ''
    recovery = 'recovery.left.number.' if field == QUALITY else 'steady.recovery.left.number.value.'
    left = [group.mean(recovery + name) for name in names]
    left = [share.value for share in left] if all(left) else None
    return f'; s {separation.value:+.3f}: {which_way(separation.value, names, left)}'


def best_text(setting, group, at_edge, field=QUALITY):
    text = f"{mean_text(group, field)}: {' '.join(map('='.join, assignments(setting).items())) or 'the scene itself'}"
    mean, name = group.mean(field), 'mean Q' if field == QUALITY else 'mean Q of the filled machine'
    if mean.error is not None and mean.value <= mean.half_width():
        return f'not separated: the interval of 95 % contains 0 even at the largest {name}, {text}'
    edge = f"; at the grid's edge in {', '.join(at_edge)}" if at_edge else ''
    return f'best {name} {text}{way_of(group, field)}{edge}'


def findings_of(rows, ended, keys, sweep, limits):
    """@param sweep see read_sweep() of ratchet_sieve.plots.sweep
    @return what is in findings.json, and the rows of the best setting: None if there is none"""
    found = best_setting(rows, ended, sweep['seeds'], limits)
    findings = {'lines': [], 'least_processed': limits.processed, 'least_counted': limits.counted, 'best': None,
                'floor_check': None, 'command': sweep['command']}
    field = compared_by(rows)
    if found:
        setting, group = found
        mean, given, case = group.mean(QUALITY), assignments(setting), group[0]
        steady = group.mean(STEADY_QUALITY)
        values = {key: rows.values(key) for key in keys}
        # Of three numbers or more the first or the last: a better one may lie beyond.
        at_edge = [key for key, own in values.items() if len(own) > 2 and case[key] in (own[0], own[-1])
                   and not any(isinstance(value, str) for value in own)]
        findings['best'] = {
            'values': {key: given.get(key, '' if case[key] is None else shown(case[key])) for key in keys},
            'quality': mean.value, 'separation': group.mean('separation').value, 'quality_stderr': mean.error,
            'steady': steady and {'quality': steady.value, 'separation': group.mean('steady.separation.value').value,
                                  'quality_stderr': steady.error, 'seeds': steady.count},
            'seeds': mean.count, 'processed': of_all(group, 'processed'), 'counted': of_all(group, 'counted'),
            'at_edge': at_edge}
        findings['lines'] = [best_text(setting, group, at_edge, field)]
    elif rows.samples('separation'):
        findings['lines'] = [f'no best Q: no setting with all seeds completed has a mean P >= {limits.processed:g} and '
                             f'a mean of {limits.counted:g} counted disks (--least-processed, --least-counted)'
                             + ('' if field == QUALITY else ', and has filled')]
    findings['lines'] += sweep['warnings']
    return findings, found[1] if found else None


def check_floor(best, command, results, threads):
    """Runs the seeds of a setting at its minimum rebound speed and at lower ones, into the sweep's results file.
    @param best rows of the setting. @return lines, and what is in findings.json"""
    from ratchet_sieve.scene import Scene  # needs the engine, without which all else is drawn
    from ratchet_sieve.sweeps import sweep

    if best is None:
        raise Refusal('--check-floor: there is no best setting to check')
    cases = [setting_and_seed(arguments or '') for arguments in best.column('arguments')]
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')  # of scenes: the sweep's own run has said them
        scene = Scene.load(shlex.split(command)[1], {**assignments(command), **assignments(cases[0][0])})
        own = scene[FLOOR]
        if own <= 0.0:
            raise Refusal(f'--check-floor: {FLOOR} of the best setting is 0: there is no floor to check')
        seeds = [int(seed) for _, seed in cases if seed is not None] or None
        table = sweep(scene, {FLOOR: [part * own for part in FLOORS]}, seeds=seeds, results=results, threads=threads)
    groups = rows_of(table).by(FLOOR)
    return floor_lines([(part * own, groups.get(part * own, Rows())) for part in FLOORS], compared_by(best))


def floor_lines(checked, field=QUALITY):
    """@param checked pairs of a floor and its Rows. @return lines, and what is in findings.json"""
    means = [rows.mean(field) for _, rows in checked]
    lines = [f'best setting at {FLOOR} = {floor:g} m/s: Q {mean_text(rows, field) if mean else "not defined"}'
             for (floor, rows), mean in zip(checked, means)]
    found = [{'min_rebound_speed': floor, 'quality': mean and mean.value, 'quality_stderr': mean and mean.error,
              'seeds': mean.count if mean else 0} for (floor, _), mean in zip(checked, means)]
    first, last = means[0], means[-1]
    if not first or not last or first.error is None or last.error is None:
        return [*lines, NOT_KNOWN], found
    moved, width = last.value - first.value, math.hypot(first.half_width(), last.half_width())
    verdict = f'it depends on {FLOOR}' if abs(moved) > width else \
        f'no significant dependence on {FLOOR}; a change of up to {abs(moved) + width:.2g} is not excluded'
    return [*lines, f'quality changes by {moved:+.3g} ± {width:.2g} from {checked[0][0]:g} to {checked[-1][0]:g} m/s: '
                    f'{verdict} (half-width of 95 %)'], found

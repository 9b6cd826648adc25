"""What the page of a sweep's report shows, as report.json: an object, in which null is what is undefined.

title, origin, findings   the sweep's name, what the means are from, lines on the best setting and on warnings
least_processed, least_counted   limits of comparable settings
x, y      the keys along the axes (y null if one key varies): key, label, unit, values in order
fields    what is averaged: name (the column), label, unit
best      the best setting: numbers x and y in the axes' values, from 0
places    the settings with a result: x, y, runs, comparable; means, of each field null or value, error (the standard
          error, null for one run) and count, the runs in which it is defined; and cases
cases     arguments, which follow `command`, the common part of all command lines, for the directory in which the report
          was made; seeds, as texts for --seed, null: the scene's own; pages, relative to the report, null: not kept
"""
import os
import urllib.parse

from ratchet_sieve.plots.findings import setting_and_seed
from ratchet_sieve.plots.means import plain_label


def labelled(name, species=()):
    return dict(zip(('label', 'unit'), plain_label(name, species)))


def pages_of(directory, base):
    """@return of each run whose page was kept in a directory, by its hash, the page's address from another one"""
    address = urllib.parse.quote(os.fsencode(os.path.relpath(directory, base)))
    return {path.stem: f'{address}/{path.name}' for path in directory.glob('*.html')}


def cases_of(rows, pages):
    """The runs of one place; those that differ in the seed alone are together. Seeds are texts, since not all of them
    are numbers of JavaScript, or None: that of the scene."""
    settings = {}
    for every, run_hash in zip(rows.column('arguments').fillna(''), rows.column('run_hash')):
        arguments, seed = setting_and_seed(every)
        case = settings.setdefault(arguments, {'arguments': arguments, 'seeds': [], 'pages': []})
        case['seeds'].append(seed)
        case['pages'].append(pages.get(run_hash))
    return list(settings.values())


def places_of(means, pages):
    for k, y in enumerate(means.ys):
        for i, x in enumerate(means.xs):
            place = (x, y)
            if place in means.groups:
                found = [means.get(field, x, y) for field in means.fields]
                yield {'x': i, 'y': k, 'runs': means.counts[place], 'comparable': place not in means.below,
                       'means': [mean and {'value': mean.value, 'error': mean.error, 'count': mean.count}
                                 for mean in found],
                       'cases': cases_of(means.groups[place], pages)}


def report_of(means, keys, texts, findings, pages):
    """@param keys x and y, which may be None. @param texts title and origin. @param findings see findings_of()"""
    x, y = keys
    best = means.best if means.best in means.groups else None
    return {**texts, 'findings': findings['lines'], 'command': findings['command'],
            'least_processed': findings['least_processed'], 'least_counted': findings['least_counted'],
            'x': {'key': x, **labelled(x), 'values': list(means.xs)},
            'y': {'key': y, **labelled(y), 'values': list(means.ys)} if y else None,
            'fields': [{'name': name, **labelled(name, means.species)} for name in means.fields],
            'best': best and {'x': means.xs.index(best[0]), 'y': means.ys.index(best[1])},
            'places': list(places_of(means, pages))}

"""What the page of a sweep's report shows, as report.json. Its structure is in docs/sweeps.md."""
import json
import os
import urllib.parse

from ratchet_sieve.plots.findings import setting_and_seed
from ratchet_sieve.plots.means import plain_label


def axis_of(key, values):
    name, unit = plain_label(key)
    return {'key': key, 'label': name, 'unit': unit, 'values': list(values)}


def field_of(name):
    label, unit = plain_label(name)
    return {'name': name, 'label': label, 'unit': unit}


def mean_of(mean):
    return mean and {'value': mean.value, 'error': mean.error, 'count': mean.count}


class Pages:
    """The cases' pages in a directory, and their addresses from another one."""

    def __init__(self, directory, base):
        self.names = {path.name for path in directory.glob('*.html')} if directory else set()
        self.address = urllib.parse.quote(os.fsencode(os.path.relpath(directory, base))) if directory else ''

    def of(self, run_hash):
        """None: it was not kept."""
        name = run_hash + '.html'
        return f'{self.address}/{name}' if name in self.names else None


def cases_of(rows, pages):
    """The runs of one place; those that differ in the seed alone are together. Seeds are texts, since not all of them
    are numbers of JavaScript, or None: that of the scene."""
    settings = {}
    for every, run_hash in zip(rows.column('arguments').fillna(''), rows.column('run_hash')):
        arguments, seed = setting_and_seed(every)
        case = settings.setdefault(arguments, {'arguments': arguments, 'seeds': [], 'pages': []})
        case['seeds'].append(seed)
        case['pages'].append(pages.of(run_hash))
    return list(settings.values())


def places_of(means, pages):
    for k, y in enumerate(means.ys):
        for i, x in enumerate(means.xs):
            place = (x, y)
            if place in means.groups:
                yield {'x': i, 'y': k, 'runs': means.counts[place], 'comparable': place not in means.below,
                       'means': [mean_of(means.get(field, x, y)) for field in means.fields],
                       'cases': cases_of(means.groups[place], pages)}


def best_of(means):
    if not means.best or means.best not in means.groups:
        return None
    return {'x': means.xs.index(means.best[0]), 'y': means.ys.index(means.best[1])}


def report_of(means, keys, texts, findings, pages):
    """@param keys x and y, which may be None. @param texts title and origin. @param findings see findings_of()"""
    x, y = keys
    return {**texts, 'findings': findings['lines'], 'command': findings['command'],
            'least_processed': findings['least_processed'], 'least_counted': findings['least_counted'],
            'x': axis_of(x, means.xs), 'y': axis_of(y, means.ys) if y else None,
            'fields': [field_of(name) for name in means.fields], 'best': best_of(means),
            'places': list(places_of(means, pages))}

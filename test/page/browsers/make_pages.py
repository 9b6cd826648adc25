#!/usr/bin/python3
"""Makes the pages that the tests open, by the package's programs, and beside NAME.html what its bag holds, NAME.json.

The live page is live.html, where the engine was compiled for browsers.

Usage: make_pages.py PROGRAMS CONFIG OUT
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys

import ratchet_sieve as rs
import rosbag
import yaml

HERE = pathlib.Path(__file__).resolve().parent
# Texts that are programs where somebody takes them for HTML.
IMAGE = '<img src=x onerror=alert(1)>'
SCRIPT = '<script>alert(2)</script>'
LEAVING = '</script><img src=x onerror=alert(3)>'
COMMENT = '<!--<script>'
ATTRIBUTE = '"><svg onload=alert(4)>'


def make_hostile(message):
    kind = message._type.partition('/')[2]
    if kind == 'SceneDescription':
        message.version, message.scene_hash = SCRIPT, LEAVING
        message.yaml = f'# {COMMENT} {LEAVING}\n{message.yaml}'
    elif kind == 'BinCounts':
        message.species = [SCRIPT] * len(message.species)
    elif kind == 'SieveStatistics':
        for species in message.species:
            species.name = SCRIPT
    elif kind == 'Observations':
        for row in (row for observation in message.observed for row in observation.rows):
            for entry in [*row.numbers, *row.table]:
                entry.name, entry.unit = f'{entry.name} {IMAGE}', ATTRIBUTE


# What a bag holds, for tests to compare a page with, is read by rosbag alone, by no code of the package.
# Disks are taken at whole multiples of it, which every thinning of the frames keeps [s].
STEP = 0.5
# At most so many times, spread evenly: 10^4 disks take a megabyte a time.
TIMES = 5

BASE_FIELDS = ('time', 'inclination', 'frequency', 'amplitude', 'phase', 'displacement', 'horizontal_displacement')


def messages(path, kind):
    """The messages of a type, in their order."""
    with rosbag.Bag(str(path)) as bag:
        topics = [topic for topic, about in bag.get_type_and_topic_info().topics.items()
                  if about.msg_type == f'ratchet_sieve/{kind}']
        return [message for _, message, _ in bag.read_messages(topics=topics)] if topics else []


def spread(times):
    """The first, the last, and some between them that are multiples of STEP."""
    multiples = [time for time in times[1:-1] if math.isclose(time / STEP, round(time / STEP), abs_tol=1e-9)]
    stride = max(1, math.ceil(len(multiples) / (TIMES - 2)))
    return [times[0], *multiples[stride // 2::stride], times[-1]]


def disks_of(message, scene):
    radii = message.radius or [scene['species'][k]['radius'] for k in message.species]
    columns = (message.id, message.species, message.x, message.y, radii, message.angle)
    return [dict(zip(('id', 'species', 'x', 'y', 'radius', 'angle'), row)) for row in zip(*columns)]


def bins_of(message):
    return {'time': message.time,
            'quality': message.quality if message.quality_defined else None,
            'processed': message.processed if message.processed_defined else None}


def facts(bag):
    """The scene, the base and the bins at every recorded time, the disks at some."""
    description = messages(bag, 'SceneDescription')[0]
    scene = yaml.safe_load(description.yaml)
    particles = {message.time: message for message in messages(bag, 'ParticleStates')}
    return {
        'scene': scene,
        'yaml': description.yaml,
        'scene_hash': description.scene_hash,
        'seed': description.seed,
        'version': description.version,
        'times': sorted(particles),
        'frames': [{'time': time, 'disks': disks_of(particles[time], scene)} for time in spread(sorted(particles))],
        'base': [{name: getattr(message, name) for name in BASE_FIELDS} for message in messages(bag, 'BaseState')],
        'bins': [bins_of(message) for message in messages(bag, 'BinCounts')],
    }


class Pages:
    def __init__(self, programs, config, out):
        self.programs, self.config, self.out = (pathlib.Path(path).resolve() for path in (programs, config, out))

    def program(self, name, *arguments):
        subprocess.run([self.programs / name, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    def page(self, name, bag):
        """The page of a bag, and the facts."""
        self.program('sieve_analyze', bag, '--html', self.out / f'{name}.html')
        (self.out / f'{name}.json').write_text(json.dumps(facts(bag), allow_nan=False))

    def thinned(self, scene, *options):
        """Pages of one run that lack most of its frames, or the later ones, and the highest place of a disk at each time."""
        bag = self.run('whole', scene, *options, '--bag-rate', 240, '--html', self.out / 'cut.html', '--html-size', 0.6)
        self.run('few', scene, *options, '--bag-rate', 10)
        self.program('sieve_analyze', self.out / 'few.bag', '--html', self.out / 'few.html')
        tops = [[message.time, max(message.y)] for message in messages(bag, 'ParticleStates')]
        (self.out / 'tops.json').write_text(json.dumps(tops))

    def run(self, name, scene, *options):
        """Runs a scene. @return its bag"""
        bag = self.out / f'{name}.bag'
        self.program('sieve_run', scene, '--bag', bag, *options)
        return bag

    def hostile(self, name, source):
        """A bag whose texts, as far as sieve_analyze takes them, are program text; so is its file's name."""
        bag = self.out / f'{IMAGE}.bag'
        with rosbag.Bag(str(source)) as given, rosbag.Bag(str(bag), 'w') as changed:
            for topic, message, time in given.read_messages():
                make_hostile(message)
                changed.write(topic, message, time)
        self.page(name, bag)

    def sweep(self, name):
        """The report of a sweep whose file's name is program text, and the pages of its runs."""
        sweep, database = self.out / f'{IMAGE}.yaml', self.out / f'{name}.db'
        shutil.copy(HERE / 'sweep.yaml', sweep)
        shutil.copy(HERE / 'observed.yaml', self.out)
        kept = self.out / f'{name}_runs'
        self.program('sieve_sweep', 'run', sweep, '--db', database, '--html', kept)
        self.program('sieve_sweep', 'report', sweep, '--db', database, '--html', kept, '--out', self.out / name)

    def live(self, *names):
        """The live page of scenes of config/."""
        try:
            rs.live(*(self.config / f'{name}.yaml' for name in names)).write(self.out / 'live.html')
        except FileNotFoundError as error:
            print(error)


def main():
    pages = Pages(*sys.argv[1:])
    shutil.rmtree(pages.out, ignore_errors=True)
    pages.out.mkdir(parents=True)
    pages.page('demo', pages.run('demo', pages.config / 'demo.yaml', '--set', 'base.inclination=0.19'))
    pages.page('sizes', pages.run('sizes', HERE / 'sizes.yaml'))
    pages.thinned(pages.config / 'paper_fig8.yaml', '--duration', 4, '--set', 'settle=0')
    pages.hostile('hostile', pages.run('observed', HERE / 'observed.yaml'))
    pages.sweep('sweep')
    pages.live('machine_fig9', 'demo', 'paper_fig8')


if __name__ == '__main__':
    main()

"""What a bag holds, for tests to compare a page with. Read by rosbag alone, by no code of the package."""
import math

import rosbag
import yaml

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

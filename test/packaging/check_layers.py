#!/usr/bin/python3
"""Checks that no layer includes a header of a layer above it, and that only the ROS layer and those above use ROS; within
the core, that no sublayer ("floor") includes one above it."""

import re
import sys
from pathlib import Path

# Each layer may include itself and these.
BELOW = {
    'core': [],
    'scene': ['core'],
    'recording': ['core', 'scene'],
    'sweep': ['core', 'scene', 'recording'],
    'analysis': ['core', 'scene', 'recording'],
    'page': ['core', 'scene', 'recording', 'analysis'],
    'live': ['core', 'scene', 'recording'],
    'web': ['core'],
    'python': ['core', 'scene', 'recording', 'sweep', 'analysis', 'page'],
    'ros': ['core', 'scene', 'recording', 'analysis', 'live'],
    'nodes': ['core', 'scene', 'recording', 'sweep', 'analysis', 'page', 'live', 'ros'],
}
# External libraries that a layer may use, by the first folder or name of the include, or the header;
# None: any.
LIBRARIES = {
    'core': ['Eigen'],
    'scene': ['Eigen', 'yaml-cpp'],
    'recording': ['Eigen', 'yaml-cpp', 'nlohmann', 'fmt', 'boost'],
    'sweep': ['Eigen', 'yaml-cpp', 'nlohmann', 'fmt', 'sqlite3'],
    'analysis': ['Eigen', 'yaml-cpp', 'nlohmann', 'fmt'],
    'page': ['Eigen', 'yaml-cpp', 'nlohmann', 'fmt', 'zlib', 'boost'],
    'live': ['Eigen', 'yaml-cpp', 'fmt'],
    'web': ['Eigen'],
    'python': ['Eigen', 'yaml-cpp', 'nlohmann', 'fmt', 'pybind11'],
    'ros': None,
    'nodes': None,
}
# Standard C++ headers have no dot and no slash; these are the headers of POSIX and of compilers.
POSIX = {'unistd.h', 'signal.h', 'fcntl.h', 'sys'}
COMPILER = {'emmintrin.h', 'immintrin.h'}
# The core's sublayers ("floors"), folders of src/core, from the lowest up; files in no folder are above them all.
FLOORS = ['model', 'search', 'state', 'simd', 'events']
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def errors_in(layer, path):
    """Yields the errors in the includes of one file of a layer."""
    for quote, header in INCLUDE.findall(path.read_text()):
        own = re.match(r'ratchet_sieve/(\w+)/', header)
        if own and own.group(1) in BELOW:
            if own.group(1) != layer and own.group(1) not in BELOW[layer]:
                yield f'{path}: {layer} includes {header} of a layer above it'
            continue
        library = re.split(r'[/.]', header)[0]
        known = LIBRARIES[layer]
        is_local = quote == '"' and any((place / header).exists() for place in (path.parent, source_root(path)))
        is_standard = re.fullmatch(r'\w+', header) or header.split('/')[0] in POSIX | COMPILER
        if known is not None and not is_local and not is_standard and not {library, header} & set(known):
            yield f'{path}: {layer} includes {header}, allowed are {", ".join(known)}'


def source_root(path):
    """The directory src/LAYER of a file, or the file's own directory."""
    return next((p for p in path.parents if p.parent.name == 'src'), path.parent)


def floor_of(folder):
    """Index of a folder of the core among the floors; None if it is none."""
    return FLOORS.index(folder) if folder in FLOORS else None


def floor_errors(root):
    """Yields the errors in the includes between the core's floors."""
    core = root / 'src/core'
    for path in layer_files(root, 'core'):
        own = floor_of(path.parent.name)
        for _, header in INCLUDE.findall(path.read_text()):
            floor = floor_of(header.split('/')[0])
            if header == 'ratchet_sieve/core/simulation.h' and own is not None:
                yield f'{path}: includes the facade, which is above all floors'
            if floor is None:
                continue
            if core not in path.parents:
                yield f'{path}: a public header includes {header}'
            elif own is not None and floor > own:
                yield f'{path}: {FLOORS[own]} includes {header} of a floor above it'


def layer_files(root, layer):
    """All sources and headers of a layer."""
    for directory in (root / 'src' / layer, root / 'include/ratchet_sieve' / layer):
        yield from sorted(p for p in directory.rglob('*') if p.suffix in ('.h', '.cpp', '.inc'))


def main(root):
    """Checks the source tree `root`; returns the exit status."""
    files = [(layer, path) for layer in BELOW for path in layer_files(root, layer)]
    unknown = [p.name for p in (root / 'src').iterdir() if p.is_dir() and p.name not in BELOW]
    errors = [f'src/{name} is no known layer' for name in unknown]
    errors += [error for layer, path in files for error in errors_in(layer, path)]
    errors += floor_errors(root)
    for error in errors:
        print(error, file=sys.stderr)
    if not files:
        print(f'{root}: no sources found', file=sys.stderr)
        return 2
    print(f'{len(files)} files checked, {len(errors)} errors')
    return 1 if errors else 0


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1])))

#!/usr/bin/python3
"""Checks what the include paths of a layer (cmake/Layers.cmake) leave open: that a layer uses no other library than its
own, and that within the core no sublayer ("floor") includes one above it. And that no two files define one name: of two
structs with one name a linker takes the members of either (the one definition rule)."""

import collections
import re
import sys
from pathlib import Path

# External libraries that a layer may use, by the first folder or name of the include, or the header; None: any.
LIBRARIES = {
    'statistics': set(),
    'geometry': set(),
    'core': {'Eigen'},
    'scene': {'Eigen', 'yaml-cpp', 'fmt'},
    'recording': {'Eigen', 'yaml-cpp', 'nlohmann', 'fmt', 'boost'},
    'sweep': {'Eigen', 'yaml-cpp', 'nlohmann', 'fmt', 'sqlite3'},
    'analysis': {'Eigen', 'yaml-cpp', 'nlohmann', 'fmt'},
    'page': {'Eigen', 'yaml-cpp', 'nlohmann', 'fmt', 'zlib', 'boost'},
    'live': {'Eigen', 'yaml-cpp', 'fmt'},
    'web': {'Eigen'},
    'python': {'Eigen', 'yaml-cpp', 'nlohmann', 'fmt', 'pybind11'},
    'ros': None,
    'nodes': None,
}
# Standard C++ headers have no dot and no slash; these are the headers of POSIX and of compilers.
POSIX_AND_COMPILER = {'unistd.h', 'signal.h', 'fcntl.h', 'sys', 'emmintrin.h', 'immintrin.h'}
# The core's sublayers ("floors"), folders of src/core, from the lowest up; files in no folder are above them all.
FLOORS = ['model', 'search', 'state', 'observe', 'simd', 'events']
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
TYPE = re.compile(r'(?:template <.+> )?(?:struct|class|union|enum|enum class) (?:alignas\(.+?\) )?(\w+)(?: final)?(?: : .+)?')


def library_errors(path, known, source_root):
    for quote, header in INCLUDE.findall(path.read_text()):
        folder = header.split('/')[0]
        is_local = quote == '"' and any((place / header).exists() for place in (path.parent, source_root))
        is_known = not {folder, header.split('.')[0], header}.isdisjoint(known | POSIX_AND_COMPILER)
        if not (is_local or is_known or re.fullmatch(r'\w+|ratchet_sieve/\w+/\w+\.h', header)):
            yield f'includes {header}, allowed are {", ".join(sorted(known))}'


def floor_errors(path, core):
    own = path.parent.name
    for _, header in INCLUDE.findall(path.read_text()):
        floor = header.split('/')[0]
        if own in FLOORS and header == 'ratchet_sieve/core/simulation.h':
            yield 'includes the facade, which is above all floors'
        if floor in FLOORS and core not in path.parents:
            yield f'a public header includes {header}'
        elif {own, floor} <= {*FLOORS} and FLOORS.index(floor) > FLOORS.index(own):
            yield f'{own} includes {header} of a floor above it'


def definitions(text):
    """The types and functions that are defined at the scope of a named namespace, in the layout of .clang-format."""
    scopes, head = [], ''
    for line in text.split('\n'):
        if re.match(r'namespace\b', line):
            scopes.append(line[len('namespace '):].split(' ')[0])
        elif line.startswith('}  // namespace'):
            scopes.pop()
        elif line.startswith('{') and head and '' not in scopes and not re.match(r'static |int main\(|extern "C"', head):
            is_type = TYPE.fullmatch(head)
            yield '::'.join([*scopes, is_type[1] if is_type else head])
        elif line and line[0] not in '#/{}' and line[-1] != ';' and (head or line[0] != ' '):
            head = f'{head} {line.strip()}'.lstrip()
            continue
        head = ''


def name_errors(root):
    """Sources that are included more than once, in a namespace of each includer, are left out."""
    places = collections.defaultdict(set)
    for folder in ('include', 'src', 'test', 'benchmark'):
        for path in sorted(p for p in (root / folder).rglob('*') if p.suffix in ('.h', '.cpp')):
            for name in definitions(path.read_text()):
                places[name].add(str(path.relative_to(root)))
    return [f'{name}: is defined in {" and in ".join(sorted(paths))}' for name, paths in places.items() if len(paths) > 1]


def main(root):
    """Checks the source tree `root`; returns the exit status."""
    layers = {path.name for path in (root / 'src').iterdir() if path.is_dir()}
    errors = [f'src/{name} is no known layer' for name in layers - LIBRARIES.keys()]
    for layer in layers & LIBRARIES.keys():
        for directory in (root / 'src' / layer, root / 'include/ratchet_sieve' / layer):
            for path in sorted(p for p in directory.rglob('*') if p.suffix in ('.h', '.cpp', '.inc')):
                found = []
                if LIBRARIES[layer] is not None:
                    found += library_errors(path, LIBRARIES[layer], root / 'src' / layer)
                if layer == 'core':
                    found += floor_errors(path, root / 'src/core')
                errors += [f'{path}: {error}' for error in found]
    errors += name_errors(root)
    print(*errors, f'{len(layers)} layers checked, {len(errors)} errors', sep='\n')
    return 1 if errors or not layers else 0


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1])))

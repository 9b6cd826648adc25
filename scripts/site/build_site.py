#!/usr/bin/python3
"""Builds the site of the documents. Usage: build_site.py WORK SITE

WORK is a folder for what MkDocs reads. Needs ratchet_sieve with its engine for browsers, MkDocs, mkdocstrings, Doxygen.
"""

import ast
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from mkdocs.utils import clean_directory

import ratchet_sieve as rs

HERE = Path(__file__).resolve().parent
PACKAGE = HERE.parents[1]
KATEX = Path('/usr/share/javascript/katex')
KEPT = {'.md', '.csv', '.gif', '.png', '.svg'}  # any other file that a page links to becomes a page
LINK = re.compile(r'(?<=\]\()([^)\s:#]+)(?=[)#])')
PICTURE = re.compile(r'^!\[(.+)\]\((.+)\)\n(?:\n\*([^*]+)\*)?', re.MULTILINE)  # with the paragraph that says more
HERO = '\n\n<iframe class="hero" src="live.html" title="The machine, live"></iframe>\n'
RUNS = {'demo': {'base.inclination': 0.19, 'duration': 15}, 'machine_mass': {'duration': 8},
        'circular_feeder': {'duration': 8, 'settle': 1}}
MODULES = ('scene', 'size_tables', 'runs', 'simulation', 'values', 'sweeps', 'answers', 'answers.answer',
           'answers.calibrate', 'answers.grains', 'answers.front', 'bags', 'pages', 'errors')
ROW = re.compile(r'(\w+(?:, \w+)*)  +(\S.*)')


def stage_documents(source):
    """Copies the documents, and what they link to."""
    waiting = [PACKAGE / 'README.md', PACKAGE / 'CONTRIBUTING.md', *(PACKAGE / 'docs').rglob('*.md'),
               *(PACKAGE / f'config/{name}.yaml' for name in RUNS)]
    staged = set()
    while waiting:
        path = Path(os.path.normpath(waiting.pop()))
        if path in staged or not path.exists():  # MkDocs finds the dead link
            continue
        staged.add(path)
        to = source / page_of(str(path.relative_to(PACKAGE)))
        to.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix == '.md':
            text = path.read_text()
            waiting += [path.parent / link for link in LINK.findall(text)]
            text = as_markdown(LINK.sub(lambda link: page_of(link[0]), text))
            to.write_text(HERO.join(text.partition('\n')[::2]) if path.name == 'README.md' else pictures_first(text))
        elif path.suffix in KEPT:
            shutil.copy(path, to)
        else:
            to.write_text(page_of_text(path))


def pictures_first(text):
    """The first picture of a page below its title, and each with its caption."""
    first = PICTURE.search(text)
    if first:
        title, rest = text.replace(first[0], '', 1).split('\n', 1)
        text = f'{title}\n\n{first[0]}\n{rest}'
    return PICTURE.sub(lambda found: f'<figure><img src="{found[2]}" alt="{found[1]}">\n<figcaption>'
                       f'{found[3] or found[1]}</figcaption></figure>\n\n', text)


def page_of(link):
    return link if Path(link).suffix in KEPT else link + '.md'


def page_of_text(path):
    """A page of what is no Markdown, or of the files in a folder."""
    name = path.relative_to(PACKAGE)
    if path.is_dir():
        return f'# {name}\n\n' + '\n'.join(f'## {file.name}\n\n{fenced(file)}' for file in sorted(path.iterdir()))
    if path.suffix == '.rst':
        return as_markdown(re.sub(r'\A\^+\n(.*)\n\^+\n', r'# \1\n', path.read_text()))
    return f'# {name}\n\n{fenced(path)}'


def fenced(path):
    language = {'.yaml': 'yaml', '.cff': 'yaml'}.get(path.suffix, 'text')
    return f'```{language}\n{path.read_text()}```\n'


def as_markdown(text):
    """GitHub's Markdown as Python's: lists in lists are indented by four, and a list begins after an empty line."""
    parts = re.split(r'(^```.*?^```$)', text, flags=re.MULTILINE | re.DOTALL)
    for k in range(0, len(parts), 2):
        parts[k] = re.sub(r'\] \[(\w+)\]', r'] \\[\1]', parts[k])  # a unit, no link
        parts[k] = re.sub(r'^ +(?=\S)', lambda found: 2 * found[0], parts[k], flags=re.MULTILINE)
        parts[k] = re.sub(r'^([^\s*|-].*\n)(?=[-*] )', r'\1\n', parts[k], flags=re.MULTILINE)
    return ''.join(parts)


def stage_python(work):
    """Copies the Python package with docstrings as mkdocstrings reads them, and writes the page of its names."""
    for path in (PACKAGE / 'python').rglob('*.py'):
        to = work / path.relative_to(PACKAGE)
        to.parent.mkdir(parents=True, exist_ok=True)
        lines = path.read_text().splitlines()
        nodes = [node for node in ast.walk(ast.parse(path.read_text()))
                 if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node)]
        for node in sorted(nodes, key=lambda node: -node.body[0].lineno):
            old = node.body[0]
            heading = 'Attributes:' if isinstance(node, ast.ClassDef) else 'Args:'
            new = repr(google_style(ast.get_docstring(node), heading))
            lines[old.lineno - 1:old.end_lineno] = [' ' * old.col_offset + new]
        to.write_text('\n'.join(lines) + '\n')
    names = {}
    for name in rs.__all__:
        names.setdefault(rs._NAMES[name], []).append(name)
    lines = ['# Python', '', 'The names of `ratchet_sieve`, by topic. How they are used: [Python](../docs/python.md).']
    for module in sorted(names, key=MODULES.index):
        lines += ['', f'::: ratchet_sieve.{module}', f'    options: {json.dumps({"members": names[module]})}']
    (work / 'source/reference/python.md').write_text('\n'.join(lines) + '\n')


def google_style(docstring, heading):
    """A docstring in Google's style, of one whose lists have rows `name  what it is`."""
    lines, in_rows = [], False
    for line in docstring.splitlines():
        line = re.sub(r'\bdocs/(\w+)\.md', r'[\g<0>](../docs/\1.md)', line)
        row = ROW.fullmatch(line)
        if row:
            lines += ([] if in_rows else [heading]) + [f'    {name}: {row[2]}' for name in row[1].split(', ')]
        elif in_rows and line.startswith('   '):
            lines.append(f'        {line.strip()}')
        else:
            lines += ['', line] if in_rows or line.startswith(('Raises ', 'Returns ')) else [line]
        in_rows = bool(row) or in_rows and line.startswith('   ')
    return '\n'.join(lines)


def stage_pages(source):
    """The live page, and pages of runs."""
    rs.live().write(source / 'live.html')
    (source / 'runs').mkdir()
    for name, overrides in RUNS.items():
        scene = rs.Scene.load(PACKAGE / f'config/{name}.yaml', overrides)
        result = rs.run(scene, frames=60, progress=False)
        result.write(source / f'runs/{name}.html', megabytes=1.5)
        axes = result.plot()
        axes.set_axis_off()
        axes.figure.savefig(source / f'runs/{name}.png', bbox_inches='tight')


def embed_search(site):
    """Writes what search needs where a page may neither fetch its index nor start its worker: opened as a file."""
    index = (site / 'search/search_index.json').read_text()
    worker = next(site.glob('assets/javascripts/workers/search.*.js')).read_text()
    (site / 'search/search_index.js').write_text(f'''if (location.protocol === "file:") {{
  window.__search = {{index: Promise.resolve({index})}};
  const script = URL.createObjectURL(new Blob([{json.dumps(worker)}]));
  window.Worker = class extends Worker {{ constructor() {{ super(script); }} }};
}}
''')


def main(work, site):
    if any(site.glob('[!.]*')) and not (site / 'runs/machine_mass.html').exists():
        sys.exit(f'build_site: {site}: is not empty and holds no site of this script: name another directory')
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(HERE, work)
    source = work / 'source'
    stage_documents(source)
    stage_python(work)
    stage_pages(source)
    shutil.copytree(KATEX, source / 'katex')
    subprocess.run(['doxygen', HERE / 'Doxyfile'], cwd=PACKAGE, check=True,
                   env={**os.environ, 'OUTPUT': str(source / 'reference')})
    subprocess.run(['mkdocs', 'build', '--config-file', work / 'mkdocs.yml'], check=True)
    built = work / 'site'
    (built / '404.html').unlink()  # for servers, with absolute links
    embed_search(built)
    clean_directory(site)
    shutil.copytree(built, site, dirs_exist_ok=True)


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        main(*(Path(name).resolve() for name in sys.argv[1:]))
    except subprocess.CalledProcessError as error:
        sys.exit(f'build_site: {error.cmd[0]} failed, see above')

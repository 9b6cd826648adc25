#!/usr/bin/python3
"""Builds the site of the documents, and sees that each of its links leads somewhere and that no page asks another host
for anything. Needs the groups docs and web of scripts/packages.txt."""

import html.parser
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from urllib.parse import unquote, urlsplit

from commands import PACKAGE

BUILD = PACKAGE / 'scripts/site/build_site.py'
DOXYGENS = '#nested-classes'  # where all nested classes are private
ELSEWHERE = re.compile(r'(https?:)?//')


class Page(html.parser.HTMLParser):
    """What a page has to be linked to (`anchors`), links to, and loads."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loads = {'', '__top'}, set(), set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ('id', 'name'):
                self.anchors.add(value)
            elif name in ('href', 'src', 'data', 'poster') and value and not value.startswith(('data:', 'javascript:')):
                (self.links if tag in ('a', 'area') else self.loads).add(value)


def complaints(site):
    """What is wrong with the site, a text each."""
    pages = {path: Page(path) for path in site.rglob('*.html')}
    for path, page in pages.items():
        for target in (page.links | page.loads) - {DOXYGENS}:
            if ELSEWHERE.match(target):
                if target in page.loads:
                    yield f'{path.relative_to(site)}: asks for {target}'
                continue
            link = urlsplit(target)
            to = (path.parent / unquote(link.path)).resolve() if link.path else path
            to = to / 'index.html' if to.is_dir() else to
            if not link.scheme and (not to.exists() or to in pages and unquote(link.fragment) not in pages[to].anchors):
                yield f'{path.relative_to(site)}: {target} leads nowhere'
    for path in site.rglob('*.css'):
        for target in re.findall(r'(?:url\(|@import )["\']?((?:https?:)?//[^"\')]*)', path.read_text()):
            yield f'{path.relative_to(site)}: asks for {target}'


class Site(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_the_site_is_whole(self):
        site = self.folder / 'site'
        (site / 'runs').mkdir(parents=True)
        for name in ('runs/machine_mass.html', 'of_an_earlier_site'):
            (site / name).touch()
        subprocess.run([sys.executable, BUILD, self.folder / 'work', site], check=True)
        self.assertEqual(sorted(complaints(site)), [])
        self.assertFalse((site / 'of_an_earlier_site').exists())
        for name in ('index', 'docs/tutorial', 'gallery', 'live', 'reference/python', 'reference/cpp/annotated'):
            self.assertTrue((site / f'{name}.html').exists(), name)

    def test_a_directory_of_something_else_is_refused(self):
        (self.folder / 'mine').touch()
        refused = subprocess.run([sys.executable, BUILD, self.folder / 'work', self.folder], stderr=subprocess.PIPE)
        self.assertIn(b'name another directory', refused.stderr)
        self.assertTrue((self.folder / 'mine').exists())

    def test_what_is_wrong_is_found(self):
        (self.folder / 'a.html').write_text(
            '<p id=here><a href="a.html#here">1</a><a href="#there">2</a><a href="b.html">3</a>'
            '<a href="https://a.example">4</a><script src="https://b.example/c.js"></script>')
        (self.folder / 'd.css').write_text('@import url("//c.example/e.css");')
        self.assertEqual(sorted(complaints(self.folder)), [
            'a.html: #there leads nowhere', 'a.html: asks for https://b.example/c.js', 'a.html: b.html leads nowhere',
            'd.css: asks for //c.example/e.css'])


if __name__ == '__main__':
    unittest.main()

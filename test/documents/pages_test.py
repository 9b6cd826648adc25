#!/usr/bin/python3
"""Sees that the README is short, that the version is cited, and that every relative link of a page leads somewhere.

Usage: pages_test.py [TEST...]"""

import re
import unittest

from commands import DOCUMENTS, PACKAGE

MOST_LINES, MOST_COLUMNS = 150, 120
FENCED = re.compile(r'^```.*?^```$', re.MULTILINE | re.DOTALL)


def prose(document):
    return FENCED.sub('', document.read_text())


def links(document):
    """Targets of links and pictures."""
    return re.findall(r'\]\(([^)\s]+)\)', re.sub(r'`[^`\n]*`', '', prose(document)))


def anchors(document):
    """What GitHub makes of the headings."""
    return {re.sub(r'[^\w\- ]', '', heading.lower()).replace(' ', '-')
            for heading in re.findall(r'^#+ (.*)$', prose(document), re.MULTILINE)}


class Pages(unittest.TestCase):
    def test_readme_is_short(self):
        lines = (PACKAGE / 'README.md').read_text().splitlines()
        self.assertLessEqual(len(lines), MOST_LINES)
        for line in lines:
            if not line.startswith(('|', '![')):  # tables and pictures cannot be wrapped
                self.assertLessEqual(len(line), MOST_COLUMNS, line)

    def test_the_version_is_cited(self):
        version = re.search('<version>(.+)</version>', (PACKAGE / 'package.xml').read_text()).group(1)
        for name, line in ('CITATION.cff', f'\nversion: {version}\n'), ('README.md', f'version = {{{version}}}'):
            self.assertIn(line, (PACKAGE / name).read_text(), name)

    def test_links_lead_somewhere(self):
        for document in DOCUMENTS:
            for target in links(document):
                if '://' not in target:
                    with self.subTest(f'{document.relative_to(PACKAGE)}: {target}'):
                        self.follow(document, *target.partition('#')[::2])

    def follow(self, document, name, anchor):
        to = document.parent / name if name else document
        self.assertTrue(to.exists(), 'no such file')
        if anchor:
            self.assertIn(anchor, anchors(to))


if __name__ == '__main__':
    unittest.main()

#!/usr/bin/python3
"""Runs the commands of the documents as they are written, and sees that the programs, options, files and keys
of a scene that they name are there.

Usage: documents_test.py DEVEL_SPACE [Documents | PagesWithRviz | PagesWithAnswers]; needs the groups base, rviz, optimise, tests and all of scripts/packages.txt.
"""

import re
import shutil
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from functools import lru_cache
from pathlib import Path

import yaml
from commands import DOCUMENTS, PACKAGE, blocks, code_spans, commands, simple_commands
from plan import BEFORE, GOES_ON, NOT_RUN, SAVED, SHORTENED
from session import Session, lookup

FOLDERS = 'benchmark|config|docs|examples|include|launch|msg|python|rviz|scripts|src|srv|studies|test'
SECTIONS = 'base|boundary|gravity|species|pairs|density|contact|pour|feed|initial|accuracy|duration|settle|seed'
# Files of the user, or created by the commands.
MADE = {'controller.py', 'fig9.yaml', 'statistics.csv'}
FRAMES = ['sieve_mount', 'sieve_base', 'sieve_world']
OPTIONS_OF_OTHERS = {'--skip-keys'}
WITH_RVIZ = {'node.md'}
WITH_ANSWERS = {'README.md', 'calibrate.md', 'separate.md', 'tutorial.md'}  # searches of a minute


class InSession(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        scratch = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, scratch, ignore_errors=True)
        cls.session = Session(scratch, DEVEL)
        cls.addClassCleanup(cls.session.close)
        cls.session.start()

    # Commands that are run.

    def go_through(self, document):
        self.session.here = self.session.checkout
        for block in blocks(document):
            with self.subTest(block.place):
                self.run_block(block)
        self.session.end_terminals()

    def run_block(self, block):
        if block.language == 'sh':
            self.session.end_terminals()
            for command in commands(block):
                if lookup(NOT_RUN, command):
                    self.see_what_is_named(command)
                else:
                    self.session.run(shortened(command))
        elif block.language == 'yaml':
            start = lookup(SAVED, block.text)
            self.assertIsNotNone(start, f'{block.place}: plan.py does not say where it is saved')
            path = self.session.checkout / SAVED[start]
            path.write_text(block.text)
            if 'scene' in yaml.safe_load(block.text):  # a sweep; a scene is run by the commands below it
                self.session.run(f'rosrun ratchet_sieve sieve_sweep run "{path}" --dry-run')
        elif block.language == 'python':
            (self.session.here / 'script.py').write_text(shortened(block.text))
            self.session.run('/usr/bin/python3 script.py')
        else:
            self.assertEqual(block.language, 'text', block.place)

    # Commands that are not run.

    def see_what_is_named(self, command):
        for words in simple_commands(command):
            if words[0] == 'rosrun' and words[1] == 'ratchet_sieve':
                words = words[2:]
            if words[:2] == ['python3', '-m']:
                words = [' '.join(words[:3]), *words[3:]]
            if words[0] == 'roslaunch':
                arguments = {word.split(':=')[0] for word in words if ':=' in word}
                self.assertLessEqual(arguments, self.launch_arguments(words[2]))
                continue
            for word in words:
                if re.match(rf'(\./)?({FOLDERS})/[^.]+\.', word):
                    self.see_file(word)
            if words[0].startswith(('sieve_', './', 'benchmark/', 'python3 -m ', 'scripts/', 'studies/', 'test/')):
                options = {word.split('=')[0].strip('[]….') for word in words if re.match(r'\[?--[a-z]', word)}
                known = self.options(words[0], words[1] if words[0] == 'sieve_sweep' and len(words) > 1 else '')
                self.assertLessEqual(options, known, f'{words[0]} has no such option')

    def see_file(self, name):
        self.assertTrue(list(PACKAGE.glob(name.replace('NAME', '*'))), f'{name}: no such file')

    # Existing programs, options, files and keys.

    @classmethod
    @lru_cache(maxsize=None)
    def options(cls, program, subcommand=''):
        if not program.startswith(('./', *FOLDERS.split('|'))):
            program = f'{DEVEL}/lib/ratchet_sieve/{program}'
        return cls.session.words(f'{program} {subcommand} --help')

    @staticmethod
    @lru_cache(maxsize=None)
    def programs():
        scripts = [str(path.relative_to(PACKAGE)) for folder in ('scripts', 'benchmark', 'studies', 'test/stability')
                   for path in sorted((PACKAGE / folder).iterdir())
                   if path.is_file() and re.search('--help|argparse', path.read_text()) and path.stat().st_mode & 0o100]
        return scripts + [path.name for path in sorted((DEVEL / 'lib/ratchet_sieve').glob('sieve_*'))
                          if not path.name.endswith('_test')]

    @staticmethod
    def launch_arguments(launch):
        path = next(path for path in (PACKAGE / 'launch' / launch, PACKAGE / 'examples/my_feeder/launch' / launch)
                    if path.exists())
        return {arg.get('name') for arg in xml.etree.ElementTree.parse(path).iter('arg') if arg.get('name')}


class PagesWithRviz(InSession):
    def test_commands_work_as_written(self):
        for document in DOCUMENTS:
            if document.name in WITH_RVIZ:
                self.go_through(document)


class PagesWithAnswers(InSession):
    def test_commands_work_as_written(self):
        for document in DOCUMENTS:
            if document.name in WITH_ANSWERS:
                self.go_through(document)


class Documents(InSession):
    def test_commands_work_as_written(self):
        for document in DOCUMENTS:
            if document.name not in WITH_RVIZ | WITH_ANSWERS:
                self.go_through(document)

    def test_pages_with_rviz_are_known(self):
        for document in DOCUMENTS:
            opens = any('rviz:=true' in block.text for block in blocks(document))
            self.assertEqual(opens, document.name in WITH_RVIZ, document.name)

    def test_each_entry_of_the_plan_is_of_a_command(self):
        found = [block for document in DOCUMENTS for block in blocks(document)]
        used = {lookup(SAVED, block.text) for block in found if block.language == 'yaml'}
        for command in (command for block in found if block.language == 'sh' for command in commands(block)):
            used |= {lookup(table, command) for table in (NOT_RUN, GOES_ON, BEFORE)}
        self.assertEqual(used - {None}, {*NOT_RUN, *GOES_ON, *BEFORE, *SAVED})
        code = ''.join(block.text for block in found)
        self.assertEqual([text for text in SHORTENED if text not in code], [])

    def spans(self):
        for document in DOCUMENTS:
            for span in code_spans(document):
                yield document.name, span

    def test_programs_and_options_are_there(self):
        for name, span in self.spans():
            if re.match(rf'(\./|rosrun |roslaunch |python3 -m )?(sieve_\w+ |ratchet_sieve[ .]|({FOLDERS})/)', span) and ' ' in span:
                with self.subTest(f'{name}: {span}'):
                    self.see_what_is_named(span)
            elif re.fullmatch(r'sieve_[a-z]+', span):
                with self.subTest(f'{name}: {span}'):
                    self.assertIn(span, [*self.programs(), *FRAMES])

    def test_bare_options_are_there(self):
        known = {option for program in self.programs() for option in self.options(program)}
        known |= {option for command in ('run', 'status', 'report', 'export', 'merge')
                  for option in self.options('sieve_sweep', command)}
        for name, span in self.spans():
            if span.startswith('--'):
                with self.subTest(f'{name}: {span}'):
                    self.assertIn(re.match(r'--[a-z-]*', span).group(), known | OPTIONS_OF_OTHERS)

    def test_launch_arguments_are_there(self):
        known = {name for path in PACKAGE.glob('launch/*.launch') for name in self.launch_arguments(path.name)}
        for name, span in self.spans():
            found = re.match(r'([a-z]\w*):=', span)
            if found:
                self.assertIn(found.group(1), known, f'{name}: {span}')

    def test_the_help_of_the_node_has_its_parameters(self):
        known = {*re.findall(r'\w+', self.session.output('rosrun ratchet_sieve sieve_node --help'))}
        table = (PACKAGE / 'docs/node.md').read_text().partition('| Parameter |')[2].partition('\n\n')[0]
        names = [name for row in table.splitlines()[2:] for name in re.findall(r'`~?([\w/]+)`', row.split('|')[1])]
        self.assertGreater(len(names), 30)
        for name in names:
            self.assertLessEqual({*name.split('/')}, known, name)

    def test_files_are_there(self):
        for name, span in self.spans():
            with self.subTest(f'{name}: {span}'):
                if re.fullmatch(rf'(\./)?({FOLDERS})/[\w./*-]*', span):
                    self.see_file(span.rstrip('/'))
                elif re.fullmatch(r'[\w/]+\.(launch|yaml|py|cpp|h|msg|srv)', span) and span not in MADE:
                    self.see_file('**/' + span)

    def test_keys_of_a_scene_are_known(self):
        columns = self.session.output(
            'printf "scene: config/paper_fig8.yaml\\nset: {duration: 0, settle: 0}\\n" > one.yaml\n'
            'rosrun ratchet_sieve sieve_sweep run one.yaml > one.log 2>&1\n'
            'rosrun ratchet_sieve sieve_sweep export one.yaml'
        ).splitlines()[0].split(',')
        named = {setting: f'{name}: {span}' for name, span in self.spans() for setting in assignments(span)}
        self.assertGreater(len(named), 30)
        for (key, value), place in named.items():
            if key not in columns:
                with self.subTest(place):
                    answer = self.session.output(
                        'devel/lib/ratchet_sieve/sieve_run config/paper_fig8.yaml --duration 0 --set settle=0 '
                        f"--set '{key}={value}'")
                    self.assertNotIn('unknown key', answer)


def shortened(text):
    for long, short in SHORTENED.items():
        text = text.replace(long, short)
    return text


def assignments(span):
    """The scene keys in a code span, with values: a dotted key, KEY=VALUE, or YAML."""
    found = re.fullmatch(rf'(?:--set )?((?:{SECTIONS})(?:\.[\w.]+)?)(?:=(.*))?', span)
    if found and not span.endswith(('.h', '.cpp')):
        return [(found.group(1), found.group(2) or 'x')]
    if re.match(rf'({SECTIONS}): \{{', span) and '…' not in span:
        return [(key, yaml.safe_dump(value, default_flow_style=True).strip())
                for key, value in yaml.safe_load(span).items()]
    return []


if __name__ == '__main__':
    DEVEL = Path(sys.argv.pop(1)).resolve()
    unittest.main()

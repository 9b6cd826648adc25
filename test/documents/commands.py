"""Extracts commands and code from the documents."""

import re
import shlex
import subprocess
from dataclasses import dataclass
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2]
DOCUMENTS = [PACKAGE / 'README.md', PACKAGE / 'CONTRIBUTING.md', *sorted((PACKAGE / 'docs').rglob('*.md'))]


@dataclass
class Block:
    """A fenced block, or an indented one, which counts as commands."""
    document: Path
    line: int
    language: str
    text: str

    @property
    def place(self):
        return f'{self.document.relative_to(PACKAGE)}:{self.line}'


def blocks(document):
    """The blocks of a document, in order."""
    found, fence, indented, before = [], None, None, ''
    for number, line in enumerate(document.read_text().splitlines(), 1):
        if fence and line.startswith('```'):
            fence = None
        elif fence:
            fence.text += line + '\n'
        elif line.startswith('```'):
            fence = Block(document, number + 1, line[3:].strip(), '')
            found.append(fence)
        elif indented and line.startswith('    '):
            indented.text += line[4:] + '\n'
        elif line.startswith('    ') and not before.strip():
            indented = Block(document, number, 'sh', line[4:] + '\n')
            found.append(indented)
        else:
            indented = None
        before = line
    return found


def commands(block):
    """The commands of a block: lines, or as many of them as bash takes for one."""
    command = ''
    for line in block.text.splitlines():
        command += line + '\n'
        bash = subprocess.run(['bash', '-n'], input=command, text=True, capture_output=True)
        if command.strip() and bash.returncode == 0:
            yield command.strip()
            command = ''
    if command.strip():
        raise ValueError(f'{block.place}: not a command: {command}')


def code_spans(document):
    """The texts in backquotes, each on one line."""
    text = re.sub(r'^```.*?^```$', '', document.read_text(), flags=re.MULTILINE | re.DOTALL)
    return [' '.join(span.replace('\\|', '|').split()) for span in re.findall(r'`([^`]+)`', text)]


def simple_commands(command):
    """The programs of a command with their arguments; options in its comment are taken for the last one's."""
    found = [[]]
    lexer = shlex.shlex(command, posix=True, punctuation_chars='|&;\n')
    lexer.whitespace_split, lexer.commenters, lexer.whitespace = True, '#', ' \t\r'
    for token in lexer:
        if set(token) <= set('|&;\n'):
            found.append([])
        elif found[-1] or not re.fullmatch(r'[A-Z_]+=.*|do|then', token):
            found[-1].append(token)
    found = [words for words in found if words and words[0] not in ('for', 'done')]
    comment = re.search(r'\s#\s(.*)$', command)
    if found and comment:
        found[-1] += re.findall(r'--[a-z][a-z-]*', comment.group(1))
    return found

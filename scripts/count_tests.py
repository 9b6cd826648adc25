#!/usr/bin/python3
"""Counts test cases after a run of ctest: `N passed, N failed` on the last line.

Usage: count_tests.py CTEST_LOG RESULTS_DIRECTORY

A test that leaves an XML report (gtest, rosunit) counts with each case in it, any other one as one
case; a skipped one does not count. Exit status: 0 if all passed, 1 if one failed or none ran.
"""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

# A line of ctest such as: " 3/12 Test  #3: scene_test .........   Passed    0.41 sec"
CTEST_LINE = re.compile(r'^\s*\d+/\d+ Test\s+#\d+: (\S+) \.*\s*(.*?)\s+[\d.]+ sec', re.MULTILINE)


def report_counts(report):
    """Passed and failed cases of one XML report; a report that cannot be read is one failure."""
    try:
        cases = list(ElementTree.parse(report).iter('testcase'))
    except ElementTree.ParseError:
        return 0, 1
    ran = [c for c in cases if c.get('status') != 'notrun' and c.find('skipped') is None]
    failed = [c for c in ran if c.find('failure') is not None or c.find('error') is not None]
    return len(ran) - len(failed), len(failed)


def main(log, results):
    """Prints the counts; returns the exit status."""
    lines = CTEST_LINE.findall(Path(log).read_text(errors='replace'))
    skipped = [name for name, outcome in lines if outcome == '***Skipped']
    outcomes = {name: outcome for name, outcome in lines if name not in skipped}
    passed = failed = 0
    reported = set()
    for report in sorted(Path(results).rglob('*.xml')):
        # The report of rostest repeats those of its tests.
        counts = report_counts(report)
        is_summary = report.name.startswith('rostest-')
        passed += 0 if is_summary else counts[0]
        failed += counts[1]
        reported.add(report.stem)
    for name, outcome in outcomes.items():
        if name in reported or (name.startswith('_ctest_') and outcome == 'Passed'):
            continue
        passed += outcome == 'Passed'
        failed += outcome != 'Passed'
    if not failed and any(outcome != 'Passed' for outcome in outcomes.values()):
        failed = 1
    if skipped:
        print('\nnot possible here:', *skipped)
    print(f'\n{passed} passed, {failed} failed')
    return 1 if failed or not passed else 0


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))

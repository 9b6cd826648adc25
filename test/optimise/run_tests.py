#!/usr/bin/python3
"""All tests of this directory."""
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent))

if __name__ == "__main__":
    found = unittest.defaultTestLoader.discover(str(HERE), pattern="*_test.py")
    sys.exit(not unittest.TextTestRunner().run(found).wasSuccessful())

"""Runs the tests of this folder in freecadcmd, which ends with 0 whatever a script raises."""
import os
import sys
import traceback
import unittest
from pathlib import Path


def main():
    suite = unittest.defaultTestLoader.discover(str(Path(__file__).parent))
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    return 0 if result.testsRun and result.wasSuccessful() else 1


try:
    code = main()
except BaseException:
    traceback.print_exc(file=sys.stdout)
    code = 1
sys.stdout.flush()
os._exit(code)

"""Runs the tests named in OSCULATE_GUI_TESTS inside FreeCAD's event loop, then ends FreeCAD."""

import os
import sys
import traceback
import unittest

#: FreeCAD's own sys.stdout goes through buffers that os._exit does not empty.
OUTPUT = sys.__stdout__


def main():
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    names = os.environ["OSCULATE_GUI_TESTS"].split()
    print("--- begin ---", file=OUTPUT)
    suite = unittest.defaultTestLoader.loadTestsFromNames(names)
    result = unittest.TextTestRunner(stream=OUTPUT, verbosity=2).run(suite)
    return 0 if result.wasSuccessful() and result.testsRun else 1


STATUS = 1
try:
    STATUS = main()
except BaseException:
    traceback.print_exc(file=OUTPUT)
OUTPUT.flush()
os._exit(STATUS)  # an exception or a question about unsaved changes would leave FreeCAD open

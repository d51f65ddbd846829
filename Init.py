"""Makes the package `osculate` importable in FreeCAD and FreeCADCmd.

FreeCAD exec's this file without __file__, with the add-on's folder on sys.path.
"""

import os
import sys

import FreeCAD


def _add_package_folder():
    for folder in sys.path:
        packages = os.path.join(folder, "workbench")
        if os.path.isfile(os.path.join(packages, "osculate", "__init__.py")):
            if packages not in sys.path:
                sys.path.insert(0, packages)
            return


_add_package_folder()
FreeCAD.__unit_test__ += ["osculate.features.selftest"]

"""Loads the compiled module `osculate._core`; where that fails, ImportError says what to do."""

import sys
import sysconfig
from importlib import import_module
from pathlib import Path


def _advice(error):
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    python = "Python {}.{} ({})".format(*sys.version_info[:2], sys.executable)
    found = sorted(path.name for path in Path(__file__).parent.glob("_core*.so"))
    if not found:
        problem = "osculate is not compiled yet"
    elif f"_core{suffix}" not in found:
        problem = f"osculate was compiled for another Python ({', '.join(found)})"
    else:
        problem = (f"_core{suffix} does not load, perhaps because it was compiled for another "
                   f"OpenCASCADE ({error})")
    return f"{problem}; run `make build` in the folder of the add-on, for {python}"


try:
    import_module("osculate._core")
except ImportError as failure:
    raise ImportError(_advice(failure), name="osculate._core") from failure

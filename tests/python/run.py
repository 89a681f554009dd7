"""run.py MODULE [--without-numpy | --needs-numpy]: runs the unit tests of one module."""

import argparse
import importlib.util
import sys
import unittest


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("module")
    parser.add_argument("--without-numpy", action="store_true")
    parser.add_argument("--needs-numpy", action="store_true")
    arguments = parser.parse_args()
    if arguments.without_numpy:
        # Importing it now fails as if it were not installed.
        sys.modules["numpy"] = None
    elif importlib.util.find_spec("numpy") is None:
        print("Python with numpy: skipped: numpy is not installed" if arguments.needs_numpy else
              "numpy is not installed: tested without")
        if arguments.needs_numpy:
            return
    result = unittest.main(module=arguments.module, argv=["run.py"], verbosity=2, exit=False).result
    failed, skipped = len(result.failures) + len(result.errors), len(result.skipped)
    flavour = "Python without numpy" if arguments.without_numpy else "Python"
    print(f"{flavour}: {result.testsRun - failed - skipped} passed, {failed} failed")
    for test, why in result.skipped:
        print(f"{flavour}, {test.id()}: skipped: {why}")
    sys.exit(not result.wasSuccessful())


if __name__ == "__main__":
    main()

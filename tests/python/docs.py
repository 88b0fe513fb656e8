# SPDX-License-Identifier: GPL-3.0-or-later
"""Every example in the client's docstrings, its README and docs/python.md."""

import doctest
import importlib
import os
import pkgutil
import sys
import unittest
from pathlib import Path

import shortfall

ROOT = Path(__file__).resolve().parents[2]


class Documents(unittest.TestCase):
    def test_every_example_of_every_docstring_holds(self):
        tried = 0
        for name in ["shortfall", *(f"shortfall.{m.name}" for m in pkgutil.iter_modules(shortfall.__path__))]:
            result = doctest.testmod(importlib.import_module(name))
            self.assertEqual(result.failed, 0, name)
            tried += result.attempted
        self.assertGreater(tried, 30)

    def test_every_example_of_the_documents_holds(self):
        os.chdir(ROOT)
        for name in ("python/README.md", "docs/python.md"):
            result = doctest.testfile(str(ROOT / name), module_relative=False)
            self.assertEqual(result.failed, 0, name)
            self.assertGreater(result.attempted, 3, name)

    def test_nothing_but_the_standard_library_is_loaded(self):
        for module in ("numpy", "pandas"):
            self.assertNotIn(module, sys.modules)


if __name__ == "__main__":
    unittest.main()

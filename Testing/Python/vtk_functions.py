# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the package, with plain VTK."""

from function_tools import Limits, Matrices, Meshes, Options, Package, PyVista  # noqa: F401

import unittest

if __name__ == "__main__":
    unittest.main()

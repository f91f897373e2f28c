# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the package, in pvpython."""

from array_tools import Cells, Chosen, Results, Values  # noqa: F401
from function_tools import Limits, Matrices, Meshes, Options  # noqa: F401
from image_tools import Images  # noqa: F401
from input_tools import Blocks, Digits, Forms, Messages, Rows, Texts  # noqa: F401
from package_tools import Measures, Package, PyVista  # noqa: F401
from series_tools import Progress, Series  # noqa: F401
from task_tools import Help, Saved, Tasks, Types  # noqa: F401

import tools

if __name__ == "__main__":
    tools.main()

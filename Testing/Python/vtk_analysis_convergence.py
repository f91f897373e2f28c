# SPDX-License-Identifier: BSD-3-Clause
"""All rows of the page of Documentation/Analysis on the convergence of a solver are what is computed."""

import importlib.util
import sys

import analysis_rows

if __name__ == "__main__":
    if not importlib.util.find_spec("scipy"):
        print("skipped: there is no scipy")
        sys.exit(77)
    analysis_rows.main("convergence")

# SPDX-License-Identifier: BSD-3-Clause
"""All rows of the page of Documentation/Analysis on the scheme that keeps the types of cells are what is computed."""

import analysis_rows

if __name__ == "__main__":
    analysis_rows.main("hybrid")

# SPDX-License-Identifier: BSD-3-Clause
"""All rows of the pages of Documentation/Analysis on the schemes for solids are what is computed."""

import analysis_rows

if __name__ == "__main__":
    analysis_rows.main("solids")

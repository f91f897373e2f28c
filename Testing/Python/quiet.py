# SPDX-License-Identifier: BSD-3-Clause
"""Silence, with the plugin and with plain VTK."""

import contextlib

from vtkmodules.vtkCommonCore import vtkObject


@contextlib.contextmanager
def quiet():
    """Without the messages that a test provokes on purpose."""
    vtkObject.GlobalWarningDisplayOff()
    try:
        yield
    finally:
        vtkObject.GlobalWarningDisplayOn()

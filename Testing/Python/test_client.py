# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's client, with its windows on a virtual display, does what client_session.py says, without an error or a
warning. Needs the client, and PyQt of the Qt that the client has."""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CLIENT = shutil.which("paraview")
SESSION = pathlib.Path(__file__).with_name("client_session.py")
if not CLIENT or not os.environ.get("DISPLAY") or not any(map(importlib.util.find_spec, ("PyQt5", "PyQt6"))):
    print("skipped: there is no ParaView client, no display, or no PyQt")
    sys.exit(77)


class Client(unittest.TestCase):
    def test_session(self):
        log = pathlib.Path("client.log")
        log.unlink(missing_ok=True)
        # pvpython, which runs this, is an MPI process by itself.
        environment = {key: value for key, value in os.environ.items() if not key.startswith(("OMPI_", "PMIX_", "ORTE_"))}
        with tempfile.TemporaryDirectory() as home:  # settings of its own
            path = os.pathsep.join([str(SESSION.parent), *filter(None, [environment.get("PYTHONPATH")])])
            environment.update(HOME=home, XDG_CONFIG_HOME=home, XDG_RUNTIME_DIR=home, PYTHONPATH=path)
            client = subprocess.run([CLIENT, "--dr", f"--script={SESSION}"], env=environment, text=True, timeout=800,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        report = log.read_text(encoding="utf-8") if log.exists() else "no report\n"
        print(report)
        self.assertEqual(report.splitlines()[-1], "passed", client.stdout)
        self.assertEqual(client.returncode, 0, client.stdout)
        for word in ("ERR|", "WARN|", "Traceback", "Warning:"):
            self.assertNotIn(word, client.stdout)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: BSD-3-Clause
"""The Python lines of README for plain VTK are run as they stand there."""

import unittest

import readme


class ReadmeTest(unittest.TestCase):
    def test_vtk(self):
        blocks = readme.blocks("python", after="## In Python, without ParaView")
        self.assertEqual(len(blocks), 1)
        names = {}
        exec(compile(blocks[0], "README.md", "exec"), names)
        self.assertGreater(names["smooth"].GetNumberOfCells(), names["ship"].GetNumberOfCells())
        self.assertEqual(names["tetrahedra"].shape, (512, 4))


if __name__ == "__main__":
    unittest.main()

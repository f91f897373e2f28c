// SPDX-License-Identifier: BSD-3-Clause
// Messages of VTK become lines of the program.
#include "Precompiled.h"

#include "Messages.h"

#include "vtkOutputWindow.h"

using namespace subdivide;

namespace
{

std::string Told(bool quiet, const std::function<void(vtkOutputWindow*)>& tell)
{
  testing::internal::CaptureStderr();
  CatchMessages(quiet);
  tell(vtkOutputWindow::GetInstance());
  vtkOutputWindow::SetInstance(nullptr);
  return testing::internal::GetCapturedStderr();
}

}

TEST(ProgramMessages, EachIsALine)
{
  const auto tell = [](vtkOutputWindow* window)
  {
    window->DisplayText("a text without an end");
    window->DisplayErrorText("one (of two): lines\nand its second");
    window->DisplayErrorText("ERROR: In /a/b.cxx, line 7\nvtkClass (0x55aa): what is wrong\n\n");
    window->DisplayGenericWarningText("Generic Warning: In /a/b.cxx, line 7\nwhat (else): is\n");
    window->DisplayWarningText("last");
  };
  const std::string errors = "subdivide: error: one (of two): lines\nand its second\n"
                             "subdivide: error: what is wrong\n";
  EXPECT_EQ(Told(false, tell),
    "subdivide: note: a text without an end\n" + errors +
      "subdivide: warning: what (else): is\nsubdivide: warning: last\n");
  EXPECT_EQ(Told(true, tell), errors);
}

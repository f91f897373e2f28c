// SPDX-License-Identifier: BSD-3-Clause
// The program: subdivide INPUT OUTPUT [OPTION...]
#include "Files.h"
#include "Help.h"
#include "Info.h"
#include "Messages.h"
#include "Names.h"
#include "Pipeline.h"
#include "Slices.h"
#include "Tables.h"

#include "vtkTable.h"
#include "vtkVersion.h"

#include <iostream>

#ifndef _WIN32
#include <cerrno>
#include <fcntl.h>
#endif

namespace
{

/// Without this a file would take the place of a standard stream that is closed, and get its text.
void OpenStandardStreams()
{
#ifndef _WIN32
  for (int stream = 0; stream < 3; ++stream)
  {
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF)
    {
      open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY); // so that its use is an error
    }
  }
#endif
}

int End(int code)
{
  std::cout << std::flush;
  if (!std::cout)
  {
    subdivide::Tell("error", "cannot write to the standard output");
    return 1;
  }
  return code;
}

int Run(const std::vector<std::string>& arguments)
{
  using namespace subdivide;
  if (arguments.empty())
  {
    PrintHelp();
    return 2;
  }
  Command command = ReadCommandLine(arguments);
  if (command.Help && command.NamesFilter)
  {
    PrintHelp(*command.Stages.back().What);
  }
  else if (command.Help)
  {
    PrintHelp();
  }
  else if (command.Version)
  {
    std::cout << "subdivide " SUBDIVISIONOBJECTS_VERSION ", VTK " << vtkVersion::GetVTKVersion()
              << "\n";
  }
  else
  {
    CatchMessages(command.Quiet);
    if (!command.Output.empty() && !command.Info)
    {
      CheckPlace(command.Output);
    }
    if (!command.Slices.empty() && !command.Info)
    {
      CheckSlices(command.Slices);
    }
    Connect(command);
    if (command.Info)
    {
      PrintInfo(command);
    }
    else if (command.Output.empty() && command.Slices.empty())
    {
      PrintTable(vtkTable::SafeDownCast(Update(command)), std::cout);
    }
    else
    {
      vtkDataObject* const made = Update(command);
      if (!command.Output.empty())
      {
        WriteFile(made, command.Output);
      }
      if (!command.Slices.empty())
      {
        WriteSlices(made, command.Slices, command.Dither);
      }
    }
  }
  return 0;
}

}

int main(int argc, char* argv[])
{
  try
  {
    OpenStandardStreams();
    return End(Run(std::vector<std::string>(argv + 1, argv + argc)));
  }
  catch (const subdivide::UsageError& error)
  {
    subdivide::Tell("error", error.what());
    return 2;
  }
  catch (const std::exception& error)
  {
    subdivide::Tell("error", error.what());
    return 1;
  }
}

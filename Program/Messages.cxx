// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"
#include "Options.h"
#include "Words.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <atomic>
#include <iostream>
#include <set>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace subdivide
{
namespace
{

std::atomic<int> Errors{ 0 };
bool Quiet = false;
bool ShowsBar = false;

bool IsTerminal()
{
#ifdef _WIN32
  return _isatty(2) != 0;
#else
  return isatty(2) != 0;
#endif
}

/// The text of a message of VTK, without "ERROR: In FILE, line N", class and address where they
/// are.
std::string Strip(const std::string& text)
{
  std::size_t at = text.find(": In ") < text.find('\n') ? text.find('\n') : 0;
  const std::size_t address = text.find("): ", at);
  at = text.find(" (0x", at) < address && address != std::string::npos ? address + 2 : at;
  const std::size_t first = text.find_first_not_of(" \n", at);
  const std::size_t last = text.find_last_not_of(" \n");
  return first == std::string::npos ? text : text.substr(first, last + 1 - first);
}

class Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    ++Errors;
    // The pipeline says once more that an algorithm failed.
    if (std::string(text).find("returned failure for request") == std::string::npos)
    {
      this->TellOnce("error", Strip(text));
    }
  }
  void DisplayWarningText(const char* text) override
  {
    // Readers warn of files that end too early.
    if (std::string(text).find("Error reading") != std::string::npos)
    {
      this->DisplayErrorText(text);
    }
    else
    {
      this->TellOnce("warning", Strip(text));
    }
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayText(const char* text) override
  {
    if (!Quiet)
    {
      this->TellOnce("note", Strip(text));
    }
  }

private:
  void TellOnce(const char* kind, const std::string& text)
  {
    if (this->Told.insert(text).second)
    {
      Tell(kind, text);
    }
  }

  std::set<std::string> Told;
};
vtkStandardNewMacro(Window);

void OnProgress(vtkObject* caller, unsigned long, void* name, void*)
{
  constexpr int width = 40;
  const double done = static_cast<vtkAlgorithm*>(caller)->GetProgress();
  const int filled = static_cast<int>(done * width);
  std::cerr << "\r" << *static_cast<std::string*>(name) << " [" << std::string(filled, '#')
            << std::string(width - filled, '.') << "] " << static_cast<int>(100. * done) << " %"
            << std::flush;
  ShowsBar = true;
}

}

void CatchMessages(bool quiet)
{
  Quiet = quiet;
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Window> window;
  vtkOutputWindow::SetInstance(window);
  for (const Filter& filter : GetFilters())
  {
    subdivision::AddWords(filter.Class, filter.Words);
  }
}

int GetNumberOfErrors()
{
  return Errors;
}

void Tell(const std::string& kind, const std::string& text)
{
  if (Quiet && kind == "warning")
  {
    return;
  }
  EndProgress();
  std::cerr << "subdivide: " << kind << ": " << text << std::endl;
}

WithoutWarnings::WithoutWarnings()
  : WasQuiet(Quiet)
{
  Quiet = true;
}

WithoutWarnings::~WithoutWarnings()
{
  Quiet = this->WasQuiet;
}

void ShowProgress(vtkAlgorithm* algorithm, const std::string& name)
{
  if (Quiet || !IsTerminal())
  {
    return;
  }
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnProgress);
  command->SetClientData(new std::string(name));
  command->SetClientDataDeleteCallback([](void* data) { delete static_cast<std::string*>(data); });
  algorithm->AddObserver(vtkCommand::ProgressEvent, command);
}

void EndProgress()
{
  if (ShowsBar)
  {
    std::cerr << "\r\033[K" << std::flush;
    ShowsBar = false;
  }
}

}

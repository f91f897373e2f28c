// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportGaps.cxx
 * How long filters work between two reports of progress, at which a user can stop them.
 *
 *   SubdivisionObjectsGaps [--threads N] [--scale S] [--limit SECONDS] [--every SECONDS] [PART...]
 *
 * Runs the cases whose name has one of the parts, on meshes S times as large (1: about 5 to 20
 * million cells come out), and prints for each the longest time between two reports, of the wall
 * clock and of all threads together: on a machine that other programs use, too, the work took at
 * most the smaller one. Where that is above the limit (0.2) the functions follow in which the
 * thread of the pipeline then was. --every 0: each occasion to report counts, not only those that
 * reports come at.
 */
#include "GapCases.h"

#include "Core/Memory/Loops.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

#ifdef __GLIBC__
#include <csignal>
#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <pthread.h>
#endif

namespace
{

using namespace benchmarks;

struct Moment
{
  double Wall = 0.;
  double Work = 0.; ///< of all threads

  static Moment Now()
  {
    Moment now;
    now.Wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    now.Work = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    return now;
  }
  Moment operator-(const Moment& other) const
  {
    return { this->Wall - other.Wall, this->Work - other.Work };
  }
  double GetLeast() const { return std::min(this->Wall, this->Work); }
};

/// Looks, about 100 times a second, at which functions the thread that made it is in.
class Sampler
{
public:
#ifdef __GLIBC__
  Sampler()
    : Watched(pthread_self())
  {
    std::signal(SIGUSR1, TakeSample);
    void* warm[1];
    backtrace(warm, 1); // loads what it needs, which a signal must not
    this->Watcher = std::thread(
      [this]
      {
        while (!this->IsOver)
        {
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
          pthread_kill(this->Watched, SIGUSR1);
        }
      });
  }
  ~Sampler()
  {
    this->IsOver = true;
    this->Watcher.join();
  }

  /// Forgets what was seen.
  static void Start() { NumberOfSamples = 0; }

  /// The functions of this project and of VTK that were seen in the middle, the innermost first.
  static std::vector<std::string> GetFunctions()
  {
    std::vector<std::string> functions;
    const int taken = NumberOfSamples;
    const Sample& sample = Samples[taken / 2 % MostSamples];
    for (int i = 0; taken > 0 && i < sample.Size && functions.size() < 8; ++i)
    {
      Dl_info found;
      if (dladdr(sample.Frames[i], &found) == 0 || !found.dli_sname)
      {
        continue;
      }
      int status = 0;
      char* plain = abi::__cxa_demangle(found.dli_sname, nullptr, nullptr, &status);
      std::string name = status == 0 ? plain : found.dli_sname;
      std::free(plain);
      if (name.find("Sampler") == std::string::npos)
      {
        functions.push_back(name.substr(0, 160));
      }
    }
    return functions;
  }

private:
  static constexpr int MostSamples = 1024;
  struct Sample
  {
    void* Frames[40];
    int Size;
  };
  static void TakeSample(int)
  {
    const int at = NumberOfSamples;
    Sample& sample = Samples[at % MostSamples];
    sample.Size = backtrace(sample.Frames, 40);
    NumberOfSamples = at + 1;
  }

  static inline Sample Samples[MostSamples];
  static inline std::atomic<int> NumberOfSamples{ 0 };
  pthread_t Watched;
  std::thread Watcher;
  std::atomic<bool> IsOver{ false };
#else
  static void Start() {}
  static std::vector<std::string> GetFunctions() { return {}; }
#endif
};

/// Finds the longest time between two reports of an algorithm.
class GapFinder : public vtkCommand
{
public:
  static GapFinder* New() { return new GapFinder; }
  vtkTypeMacro(GapFinder, vtkCommand);
  void Start()
  {
    this->Last = Moment::Now();
    Sampler::Start();
  }
  void Execute(vtkObject*, unsigned long, void* data) override
  {
    this->End(*static_cast<double*>(data));
  }
  void End(double progress)
  {
    const Moment now = Moment::Now();
    const Moment gap = now - this->Last;
    if (gap.GetLeast() > this->Longest.GetLeast())
    {
      this->Longest = gap;
      this->Progress = progress;
      this->Functions =
        gap.GetLeast() > this->Limit ? Sampler::GetFunctions() : std::vector<std::string>();
    }
    ++this->Reports;
    this->Start();
  }

  double Limit = 0.2;
  Moment Last;
  Moment Longest;
  double Progress = 0.;
  int Reports = 0;
  std::vector<std::string> Functions;
};

vtkIdType CountCells(vtkDataObject* data)
{
  return data ? data->GetNumberOfElements(vtkDataObject::CELL) : 0;
}

/// Returns whether the longest gap is below the limit.
bool RunCase(const GapCase& which, double scale, double limit)
{
  const vtkSmartPointer<vtkAlgorithm> algorithm = which.Make(scale);
  if (which.Change)
  {
    algorithm->Update();
    which.Change(algorithm);
  }
  vtkNew<GapFinder> finder;
  finder->Limit = limit;
  algorithm->AddObserver(vtkCommand::ProgressEvent, finder);
  const Moment begin = Moment::Now();
  finder->Start();
  algorithm->Update();
  finder->End(1.);
  const Moment taken = Moment::Now() - begin;
  std::printf("| %-44s | %10lld | %6.1f | %6.1f | %6d | %5.2f | %5.2f | %4.2f |\n",
    which.Name.c_str(), static_cast<long long>(CountCells(algorithm->GetOutputDataObject(0))),
    taken.Wall, taken.Work, finder->Reports, finder->Longest.Wall, finder->Longest.Work,
    finder->Progress);
  for (const std::string& name : finder->Functions)
  {
    std::printf("    %s\n", name.c_str());
  }
  std::fflush(stdout);
  return finder->Longest.GetLeast() <= limit;
}

}

int main(int argc, char** argv)
{
  double scale = 1.;
  double limit = 0.2;
  std::vector<std::string> parts;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const double value = i + 1 < argc ? std::atof(argv[i + 1]) : 0.;
    if (argument == "--threads")
    {
      vtkSMPTools::Initialize(static_cast<int>(value));
    }
    else if (argument == "--scale")
    {
      scale = value;
    }
    else if (argument == "--limit")
    {
      limit = value;
    }
    else if (argument == "--every")
    {
      subdivision::BetweenLoops::SecondsBetween = value;
    }
    else
    {
      parts.push_back(argument);
      continue;
    }
    ++i;
  }
  std::printf(
    "| case | cells | seconds | of work | reports | longest gap | of work | progress |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  const Sampler sampler;
  int tooLong = 0;
  for (const GapCase& which : GetGapCases())
  {
    if (parts.empty() ||
      std::any_of(parts.begin(), parts.end(),
        [&](const std::string& part) { return which.Name.find(part) != std::string::npos; }))
    {
      tooLong += RunCase(which, scale, limit) ? 0 : 1;
    }
  }
  std::printf("%d gaps above %g s\n", tooLong, limit);
  return tooLong > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}

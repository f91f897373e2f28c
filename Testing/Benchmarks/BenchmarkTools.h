// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkTools.h
 * Registering and timing. Every measurement is one iteration, timed by hand, so that nothing but
 * the work itself counts; repetitions come from the command line, in random order.
 */
#ifndef SubdivisionObjects_BenchmarkTools_h
#define SubdivisionObjects_BenchmarkTools_h

#include "vtkSMPTools.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace benchmarks
{

/// Sums up the time between Start and Stop.
class Stopwatch
{
public:
  void Start() { this->Begin = Clock::now(); }
  void Stop()
  {
    this->Seconds += std::chrono::duration<double>(Clock::now() - this->Begin).count();
  }
  template <typename Work>
  void Time(const Work& work)
  {
    this->Start();
    work();
    this->Stop();
  }
  double GetSeconds() const { return this->Seconds; }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point Begin;
  double Seconds = 0.;
};

/// Gives the system back what earlier measurements freed, so that none of them finds warm memory.
void ReturnFreeMemory();
/// Keeps it in the process, so that all later measurements do.
void KeepFreeMemory();

/// Bytes of memory that are free.
double GetAvailableMemory();

/// Writes to memory of that size, at most half of what is free, and gives it back, and leaves
/// nothing of it in the caches. A virtual machine may return memory to its host a second after it
/// was freed, and then its pages take 4 to 16 times as long: what is measured next gets none of
/// these, which else is chance.
void TouchFreeMemory(double bytes);

/// Whether this process measures the peers, or all the rest.
bool IsForPeers();

/// What a measurement tells beside its time.
struct Produced
{
  double Cells = 0.;
  double Bytes = 0.;
  bool IsRefused = false; ///< It does not fit into memory, so its time tells nothing.
};

/// Registers `work`, which runs once per repetition. A name is family/what/case/levels:n/threads:n.
/// `repetitions` > 0: that many, whatever the command line says (for what takes very long).
inline void Register(const std::string& name, int threads,
  const std::function<Produced(Stopwatch&)>& work, int repetitions = 0)
{
  if ((name.compare(0, 5, "peer/") == 0) != IsForPeers())
  {
    return;
  }
  auto* registered =
    benchmark::RegisterBenchmark((name + "/threads:" + std::to_string(threads)).c_str(),
      [threads, work, size = std::make_shared<double>(0.)](benchmark::State& state)
      {
        Produced produced;
        for (auto _ : state)
        {
          vtkSMPTools::Initialize(threads);
          TouchFreeMemory(2. * *size); // a first repetition does not know it
          Stopwatch watch;
          produced = work(watch);
          *size = produced.Bytes;
          state.SetIterationTime(watch.GetSeconds());
          if (produced.IsRefused)
          {
            state.SkipWithError("There is no output; the filter says why.");
            break;
          }
        }
        state.counters["cells"] = produced.Cells;
        state.counters["bytes"] = produced.Bytes;
      });
  registered->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);
  if (repetitions > 0)
  {
    registered->Repetitions(repetitions);
  }
}

constexpr int ThreadCounts[3] = { 1, 2, 4 };

/// What each translation unit registers; the peers that are not there are not linked.
using RegisterFunction = void (*)();
void AddRegistration(RegisterFunction function);
struct Registration
{
  explicit Registration(RegisterFunction function) { AddRegistration(function); }
};

/// Whether the run is to take little time.
bool IsQuick();

}

#endif

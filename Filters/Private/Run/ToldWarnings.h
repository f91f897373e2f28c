// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ToldWarnings.h
 * Which warnings a filter has given, so that an animation does not give them once for each step.
 */
#ifndef SubdivisionObjects_ToldWarnings_h
#define SubdivisionObjects_ToldWarnings_h

#include "vtkType.h"

#include <algorithm>
#include <cctype>
#include <mutex>
#include <set>
#include <string>

namespace subdivision
{

class ToldWarnings
{
public:
  /// Begins an execution. Warnings of earlier ones stay told if only the time is another one.
  /// `options`: when the filter was modified; `time`: NaN if there are no time steps.
  void Begin(vtkMTimeType options, double time)
  {
    const bool isNextStep = options == this->Options && (time < this->Time || time > this->Time);
    isNextStep ? this->Earlier.merge(this->Now) : this->Earlier.clear();
    this->Now.clear();
    this->Options = options;
    this->Time = time;
  }
  /// Goes on with an execution: its warnings stay told.
  void GoOn()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Earlier.insert(this->Now.begin(), this->Now.end());
  }
  /// Whether no earlier execution told a warning: the same text, with any numbers.
  bool IsNew(std::string warning)
  {
    warning.erase(std::remove_if(warning.begin(), warning.end(),
                    [](unsigned char letter) { return std::isdigit(letter) != 0; }),
      warning.end());
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Now.insert(warning);
    return this->Earlier.count(warning) == 0;
  }

private:
  std::mutex Mutex; ///< partitions work in threads
  std::set<std::string> Earlier;
  std::set<std::string> Now;
  vtkMTimeType Options = 0;
  double Time = 0.;
};

}

#endif

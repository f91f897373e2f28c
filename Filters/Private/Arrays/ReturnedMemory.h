// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReturnedMemory.h
 * The memory of an output for the next one.
 *
 * A pipeline forgets an output just before the next one is made. Memory of that size goes back to
 * the system and comes back as pages of zeros, which takes as long as writing it. So who makes
 * outputs may wait for freed memory. Memory is freed when nobody has it any more, neither an array
 * nor a copy of one that shares its memory: others never see a change.
 */
#ifndef SubdivisionObjects_ReturnedMemory_h
#define SubdivisionObjects_ReturnedMemory_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <cstddef>

namespace subdivision
{

class ReturnedMemory
{
public:
  ReturnedMemory();
  ~ReturnedMemory();
  ReturnedMemory(const ReturnedMemory&) = delete;
  ReturnedMemory& operator=(const ReturnedMemory&) = delete;

  /// From here on arrays that were made here leave their memory here.
  void Await();
  /// Gives the system the memory that they left and nobody took; ends Await.
  void Release();

  /// The same as MakeArray in Arrays.h, in memory that came back if there is some of that size.
  vtkSmartPointer<vtkDataArray> MakeArray(int valueType, int components, vtkIdType tuples);

  /// Smaller arrays are no concern of this.
  static constexpr std::size_t LeastBytes = std::size_t(1) << 20;

private:
  void* Take(std::size_t bytes);

  const std::size_t Owner; ///< a number of its own
};

}

#endif

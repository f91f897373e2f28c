// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GrowingBuffer.h
 * A Buffer that grows at its end, for lists whose length is not known before.
 */
#ifndef SubdivisionObjects_GrowingBuffer_h
#define SubdivisionObjects_GrowingBuffer_h

#include "Core/Memory/Buffer.h"

namespace subdivision
{

template <typename T>
class GrowingBuffer
{
public:
  vtkIdType size() const { return this->Size; }
  bool empty() const { return this->Size == 0; }
  T& operator[](vtkIdType i) { return this->Values[i]; }
  const T& operator[](vtkIdType i) const { return this->Values[i]; }
  T& back() { return this->Values[this->Size - 1]; }
  void push_back(T value)
  {
    if (this->Size == this->Values.size())
    {
      this->Reserve(std::max<vtkIdType>(256, 2 * this->Size));
    }
    this->Values[this->Size++] = value;
  }
  /// Makes room for `size` elements in all.
  void Reserve(vtkIdType size)
  {
    if (size <= this->Values.size())
    {
      return;
    }
    Buffer<T> larger(size);
    CopyInThreads(this->Values.data(), this->Size, larger.data());
    this->Values = std::move(larger);
  }
  /// Appends `count` elements without initialising them, and returns the first.
  T* Extend(vtkIdType count)
  {
    if (this->Size + count > this->Values.size())
    {
      this->Reserve(std::max(this->Size + count, 2 * this->Size));
    }
    this->Size += count;
    return this->Values.data() + this->Size - count;
  }
  void pop_back() { --this->Size; }
  /// A copy of the elements in a buffer of exactly their size.
  Buffer<T> Copy() const
  {
    Buffer<T> copy(this->Size);
    CopyInThreads(this->Values.data(), this->Size, copy.data());
    return copy;
  }
  T* data() { return this->Values.data(); }
  const T* data() const { return this->Values.data(); }
  std::size_t GetMemorySize() const { return this->Values.GetMemorySize(); }

private:
  Buffer<T> Values;
  vtkIdType Size = 0;
};

}

#endif

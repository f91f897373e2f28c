// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Arrays/Fingerprint.h"

namespace subdivision
{
namespace
{

constexpr auto NoWork = [](vtkIdType, vtkIdType) {};

}

Fingerprint ComputeFingerprint(vtkDataArray* array)
{
  return ComputeFingerprint(array, NoWork);
}

bool BeginsAs(vtkDataArray* array, const Fingerprint& print)
{
  const vtkIdType bytes = array->GetNumberOfValues() * array->GetDataTypeSize();
  const vtkIdType first = std::min(bytes / 8, FingerprintHashes::Block);
  if (first == 0 || print.size() < FingerprintHashes::Lanes + 3 ||
    print[print.size() - 2] != static_cast<std::uint64_t>(bytes) ||
    print.back() != static_cast<std::uint64_t>(array->GetDataType()))
  {
    return false;
  }
  const FingerprintHashes hashes =
    ComputeHashes(static_cast<const char*>(array->GetVoidPointer(0)), 0, first, NoWork);
  return std::equal(hashes.begin(), hashes.end(), print.begin());
}

}

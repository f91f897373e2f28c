// SPDX-License-Identifier: BSD-3-Clause
#include "StoredValues.h"

#include "vtkType.h"

#include <cstring>
#include <limits>
#include <type_traits>

namespace coretest
{
namespace
{

std::size_t GetSize(int type)
{
  return type == VTK_DOUBLE || type == VTK_LONG_LONG ? 8 : type == VTK_FLOAT ? 4 : 1;
}

template <typename T>
void Fill(std::vector<unsigned char>& bytes, std::mt19937& random, bool wild)
{
  for (std::size_t i = 0; i < bytes.size() / sizeof(T); ++i)
  {
    double value = std::uniform_real_distribution<double>(0., 200.)(random);
    if (wild && std::is_floating_point<T>::value)
    {
      const unsigned int kind = random() % 40;
      value = kind == 0 ? std::numeric_limits<double>::infinity()
        : kind == 1     ? std::numeric_limits<double>::quiet_NaN()
        : kind == 2     ? static_cast<double>(std::numeric_limits<T>::max())
        : kind == 3     ? -0.
                        : value;
    }
    const T stored = static_cast<T>(value);
    std::memcpy(bytes.data() + i * sizeof(T), &stored, sizeof(T));
  }
}

template <typename T>
int CountDifferencesOf(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  int differences = 0;
  for (std::size_t i = 0; i < a.size(); i += sizeof(T))
  {
    T values[2];
    std::memcpy(values, a.data() + i, sizeof(T));
    std::memcpy(values + 1, b.data() + i, sizeof(T));
    const bool areNone = values[0] != values[0] && values[1] != values[1];
    differences += !areNone && std::memcmp(values, values + 1, sizeof(T)) != 0 ? 1 : 0;
  }
  return differences;
}

}

void StoredValues::Resize(vtkIdType rows)
{
  this->Out.resize(static_cast<std::size_t>(rows * this->Components) * GetSize(this->OutType));
}

StoredValues MakeStoredValues(
  int inType, int outType, int components, vtkIdType tuples, std::mt19937& random, bool wild)
{
  StoredValues values{ inType, outType, components, tuples, {}, {} };
  values.In.resize(static_cast<std::size_t>(tuples * components) * GetSize(inType));
  switch (inType)
  {
    case VTK_DOUBLE:
      Fill<double>(values.In, random, wild);
      break;
    case VTK_FLOAT:
      Fill<float>(values.In, random, wild);
      break;
    case VTK_LONG_LONG:
      Fill<long long>(values.In, random, wild);
      break;
    default:
      Fill<unsigned char>(values.In, random, wild);
  }
  return values;
}

int CountDifferences(const StoredValues& a, const StoredValues& b)
{
  const auto count = a.OutType == VTK_DOUBLE ? CountDifferencesOf<double>
    : a.OutType == VTK_FLOAT                 ? CountDifferencesOf<float>
                                             : CountDifferencesOf<unsigned char>;
  return count(a.Out, b.Out);
}

}

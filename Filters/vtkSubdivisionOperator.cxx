// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionOperator.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/MatrixArrays.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkSubdivisionOperator);

vtkSubdivisionOperator::vtkSubdivisionOperator()
  : Factors(std::make_unique<subdivision::MatrixFactors>())
{
}

vtkSubdivisionOperator::~vtkSubdivisionOperator() = default;

vtkIdType vtkSubdivisionOperator::GetNumberOfRows() const
{
  return this->Factors->GetNumberOfRows();
}

vtkIdType vtkSubdivisionOperator::GetNumberOfColumns() const
{
  return this->Factors->GetNumberOfColumns();
}

int vtkSubdivisionOperator::GetNumberOfFactors() const
{
  return static_cast<int>(this->Factors->Get().size());
}

void vtkSubdivisionOperator::GetRows(
  vtkIdTypeArray* offsets, vtkIdTypeArray* ids, vtkDoubleArray* weights) const
{
  if (this->GetNumberOfFactors() > 0)
  {
    subdivision::WriteMatrix(this->Factors->Multiply(), offsets, ids, weights);
  }
}

void vtkSubdivisionOperator::GetFactor(
  int factor, vtkIdTypeArray* offsets, vtkIdTypeArray* ids, vtkDoubleArray* weights) const
{
  if (factor < 0 || factor >= this->GetNumberOfFactors())
  {
    vtkErrorMacro(
      "There is no factor " << factor << ": there are " << this->GetNumberOfFactors() << ".");
    return;
  }
  subdivision::WriteMatrix(this->Factors->Get()[factor], offsets, ids, weights);
}

bool vtkSubdivisionOperator::MultiplyTransposed(vtkDoubleArray* values) const
{
  if (values->GetNumberOfTuples() != this->GetNumberOfRows())
  {
    return false;
  }
  const int components = values->GetNumberOfComponents();
  std::vector<double> outer(
    values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfValues());
  const auto& factors = this->Factors->Get();
  for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor)
  {
    std::vector<double> inner(factor->GetNumberOfColumns() * components, 0.);
    for (const vtkIdType row : subdivision::InTurn(factor->GetNumberOfRows()))
    {
      for (auto k = factor->Offsets[row]; k < factor->Offsets[row + 1]; ++k)
      {
        for (int c = 0; c < components; ++c)
        {
          inner[factor->Columns[k] * components + c] +=
            factor->Weights[k] * outer[row * components + c];
        }
      }
    }
    outer.swap(inner);
  }
  values->SetNumberOfTuples(this->GetNumberOfColumns());
  std::copy(outer.begin(), outer.end(), values->GetPointer(0));
  return true;
}

void vtkSubdivisionOperator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfRows: " << this->GetNumberOfRows() << "\n";
  os << indent << "NumberOfColumns: " << this->GetNumberOfColumns() << "\n";
  os << indent << "NumberOfFactors: " << this->GetNumberOfFactors() << "\n";
}

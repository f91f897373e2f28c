// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionOperator.h"

#include "Private/Arrays/MatrixArrays.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"

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

void vtkSubdivisionOperator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfRows: " << this->GetNumberOfRows() << "\n";
  os << indent << "NumberOfColumns: " << this->GetNumberOfColumns() << "\n";
  os << indent << "NumberOfFactors: " << this->GetNumberOfFactors() << "\n";
}

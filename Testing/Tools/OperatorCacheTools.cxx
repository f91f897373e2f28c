// SPDX-License-Identifier: BSD-3-Clause
#include "OperatorCacheTools.h"

#include <sstream>

namespace operator_cache_tools
{

Kept::Kept(const Configure& configure)
{
  this->Heard->Watch(this->Cached);
  this->Cached->SetNumberOfLevels(2);
  this->Cached->SetVolumeSchemeToBoxSpline();
  if (configure)
  {
    configure(this->Cached);
  }
}

Kept::~Kept()
{
  EXPECT_TRUE(this->Heard->Errors.empty());
  EXPECT_TRUE(this->Heard->Warnings.empty());
}

Grid Kept::Update(vtkDataObject* input)
{
  this->Cached->SetInputDataObject(input);
  this->Cached->Modified();
  this->Cached->Update();
  const auto output = Grid::New();
  output->ShallowCopy(this->Cached->GetOutputDataObject(0));
  return output;
}

Grid Fresh(vtkDataObject* input, const Configure& configure)
{
  return Execute(input, 2,
    [&](Filter* filter)
    {
      filter->CacheOperatorOff();
      if (configure)
      {
        configure(filter);
      }
    });
}

bool SharesCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  return a->GetCells()->GetConnectivityArray() == b->GetCells()->GetConnectivityArray() &&
    a->GetCells()->GetOffsetsArray() == b->GetCells()->GetOffsetsArray() &&
    subdivision::GetCellTypes(a) == subdivision::GetCellTypes(b);
}

Grid MakeInput(unsigned seed)
{
  const Grid grid = MakeKuhnBox(2, 0.2, seed);
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("scalar", 1, grid->GetNumberOfPoints(), 0., 1., seed));
  return grid;
}

std::string Print(Filter* filter)
{
  std::ostringstream text;
  filter->Print(text);
  return text.str();
}

}

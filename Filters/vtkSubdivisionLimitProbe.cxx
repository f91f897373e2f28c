// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionLimitProbe.h"

#include "Private/Distribution/Blocks.h"
#include "Private/Places/PlaceOutput.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"
#include "Private/Surface/SurfaceSubdivision.h"
#include "Private/Uniform/HybridInput.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSubdivisionLimitProbe);

namespace
{
constexpr int PlacesPort = 3;
}

vtkSubdivisionLimitProbe::vtkSubdivisionLimitProbe()
{
  this->SetNumberOfInputPorts(PlacesPort + 1);
}

vtkSubdivisionLimitProbe::~vtkSubdivisionLimitProbe() = default;

void vtkSubdivisionLimitProbe::SetPlacesConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(PlacesPort, output);
}

int vtkSubdivisionLimitProbe::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == PlacesPort // RequestData says what is missing
    ? subdivision::TakeTypes(info, { "vtkDataSet" }, true)
    : this->Superclass::FillInputPortInformation(port, info);
}

int vtkSubdivisionLimitProbe::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return subdivision::MakeOutput<vtkPolyData>(outputVector);
}

int vtkSubdivisionLimitProbe::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (vtkCompositeDataSet::SafeDownCast(vtkDataObject::GetData(inputVector[0])) ||
    this->SharesRanks())
  {
    subdivision::Fail(this,
      "The control mesh consists of blocks, or is shared by several ranks. Merge it to one data "
      "set first.");
    return 0;
  }
  subdivision::PlaceRequest request;
  request.Targets = vtkDataSet::GetData(inputVector[PlacesPort]);
  if (!request.Targets)
  {
    subdivision::Fail(this,
      "Places (input port 3) are missing: the points for which the nearest places are wanted.");
    return 0;
  }
  const std::string memory =
    "the search for nearest places. Use fewer points, or a part of the control mesh.";
  const auto run = [&](auto& options, const auto& work)
  {
    options.Levels = 0;
    options.ProjectToLimit = true;
    options.Places = &request;
    return this->Run(inputVector, outputVector, options, nullptr, memory,
      [&](vtkPointSet* input, vtkPointSet* output)
      {
        request.Output = vtkPolyData::SafeDownCast(output);
        const bool isDone = work(input);
        for (vtkDataSet* from : { request.Targets, static_cast<vtkDataSet*>(input) })
        {
          subdivision::AddFieldData(from->GetFieldData(), false, output->GetFieldData());
        }
        return isDone;
      });
  };
  if (this->IsOfSurfaces())
  {
    subdivision::SurfaceOptions options;
    options.Scheme = this->Scheme == CATMULL_CLARK ? subdivision::SurfaceSchemeKind::CatmullClark
                                                   : subdivision::SurfaceSchemeKind::Loop;
    return run(options,
      [&](vtkPointSet* input)
      {
        if (options.OutputPointsPrecision == DEFAULT_PRECISION)
        {
          options.OutputPointsPrecision = DOUBLE_PRECISION;
        }
        return subdivision::SubdivideSurface(
          vtkPolyData::SafeDownCast(input), options, request.Output);
      });
  }
  subdivision::UniformOptions options;
  options.KeepCellTypes = this->Scheme == HYBRID;
  options.KeepsTypesIfPossible = this->Scheme == AUTOMATIC;
  if (this->Scheme <= LINEAR)
  {
    options.Scheme = subdivision::GetVolumeScheme(this->Scheme);
  }
  return run(options,
    [&](vtkPointSet* input)
    {
      if (this->Scheme == BOX_SPLINE && subdivision::HasUncutCells(input))
      {
        options.Warn("The mesh has hexahedra, wedges, pyramids or quads, which Scheme BoxSpline "
                     "cuts. The default of vtkMultiDimensionalSubdivision keeps them: for places "
                     "of its limit set Scheme to Automatic, which takes much longer.");
      }
      return subdivision::SubdivideUniformly(input, options, nullptr);
    });
}

void vtkSubdivisionLimitProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Scheme << "\n";
}

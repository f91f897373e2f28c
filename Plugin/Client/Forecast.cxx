// SPDX-License-Identifier: BSD-3-Clause
#include "Forecast.h"

#include "vtkAbstractArray.h"
#include "vtkClientServerStream.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVSession.h"
#include "vtkSMInputProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <algorithm>
#include <string>

namespace
{

constexpr double MostCells = 1e6;

vtkPVDataInformation* GetInputInformation(vtkSMProxy* filter)
{
  vtkSMPropertyHelper input(filter, "Input", true);
  auto* source =
    input.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy(0)) : nullptr;
  return source ? source->GetDataInformation(input.GetOutputPort(0)) : nullptr;
}

/// The cells of the input before the first level, of all ranks if all have as many of each kind.
ControlCounts CountOnServer(vtkSMProxy* filter, double cells)
{
  filter->UpdateVTKObjects();
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(filter) << "GetControlCounts"
         << vtkClientServerStream::End;
  auto* session = filter->GetSession();
  session->ExecuteStream(filter->GetLocation(), stream, true);
  const vtkClientServerStream& answer = session->GetLastResult(vtkPVSession::DATA_SERVER_ROOT);
  ControlCounts found{};
  ControlCounts counts{};
  if (answer.GetArgument(0, 0, found.data(), static_cast<vtkTypeUInt32>(found.size())) &&
    found[5] > 0.)
  {
    std::transform(found.begin(), found.end(), counts.begin(),
      [&](double count) { return count * cells / found[5]; });
  }
  return counts;
}

int GetShown(vtkSMProxy* filter, const char* name, int missing = 0)
{
  return filter->GetProperty(name) ? vtkSMUncheckedPropertyHelper(filter, name).GetAsInt(0)
                                   : missing;
}

double GetBytesPerTuple(vtkPVDataSetAttributesInformation* arrays)
{
  double bytes = 0.;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    auto* array = arrays->GetArrayInformation(i);
    bytes += array->GetNumberOfComponents() *
      static_cast<double>(vtkAbstractArray::GetDataTypeSize(array->GetDataType()));
  }
  return bytes;
}

/// By the class of the filter, which panels share.
int GetKind(vtkSMProxy* filter)
{
  const std::string name = filter->GetXMLName();
  return name == "SurfaceSubdivision"      ? ForecastOptions::OfSurfaces
    : name == "RedGreenRefinement"         ? ForecastOptions::RedGreen
    : name == "AdaptiveSurfaceSubdivision" ? ForecastOptions::Adaptive
    : name == "SubdivisionLabelSolid"      ? ForecastOptions::OfLabels
                                           : ForecastOptions::OfAllDimensions;
}

/// Whether SmoothShading adds normals, as far as one can know before: creases and joints show
/// later.
bool IsShaded(vtkSMProxy* filter, const ForecastOptions& options, const ControlCounts& counts)
{
  constexpr int Loop = 0;
  constexpr int CatmullClark = 2;
  constexpr int Automatic = 8;
  const bool isCheap = options.Kind != ForecastOptions::OfSurfaces || options.Scheme == Loop ||
    options.Scheme == CatmullClark || options.Scheme == Automatic;
  const bool isWhole = counts[0] + counts[1] == 0. && (counts[2] == 0. || counts[3] == 0.);
  return GetShown(filter, "SmoothShading") != 0 && isCheap && isWhole && options.Levels > 0 &&
    options.OutputCells == 0;
}

ForecastOptions ReadOptions(
  vtkSMProxy* filter, int levels, vtkPVDataInformation* information, const ControlCounts& counts)
{
  ForecastOptions options;
  options.Kind = GetKind(filter);
  options.Levels =
    levels >= 0 ? levels : GetShown(filter, "NumberOfLevels", GetShown(filter, "MaximumLevel"));
  options.Scheme = GetShown(filter, "Scheme");
  options.VolumeScheme = GetShown(filter, "VolumeScheme");
  options.KeepCellTypes = GetShown(filter, "KeepCellTypes") != 0;
  options.OutputCells = GetShown(filter, "OutputCells");
  options.CellOrder = GetShown(filter, "CellOrder", 2);
  options.AddsTangents = GetShown(filter, "GenerateTangents") != 0;
  options.AddsBounds = GetShown(filter, "GenerateErrorBounds") != 0;
  options.AddsClasses = GetShown(filter, "GenerateClassification") != 0;
  options.AddsNormals =
    GetShown(filter, "GenerateLimitNormals") != 0 || IsShaded(filter, options, counts);
  options.ReadsLimit =
    options.AddsNormals || options.AddsTangents || GetShown(filter, "ProjectToLimit") != 0;
  if (filter->GetProperty("OutputDimensions"))
  {
    options.Dimensions.fill(false);
    vtkSMUncheckedPropertyHelper chosen(filter, "OutputDimensions");
    for (unsigned int i = 0; i < chosen.GetNumberOfElements(); ++i)
    {
      options.Dimensions.at(static_cast<std::size_t>(std::clamp(chosen.GetAsInt(i), 0, 3))) = true;
    }
  }
  if (options.Kind == ForecastOptions::OfLabels)
  {
    options.MaximumNumberOfVoxels = GetShown(filter, "NumberOfControlCells");
    options.OutputCells += options.OutputCells > 0 ? 1 : 0; // there are no Bezier cells
    options.VolumeScheme = GetShown(filter, "CellType") != 0 ? 3 : options.VolumeScheme;
    options.BytesPerPoint = 24.;
    options.BytesPerCell = GetBytesPerTuple(information->GetPointDataInformation()) +
      GetBytesPerTuple(information->GetCellDataInformation());
    return options;
  }
  options.MaximumNumberOfCells =
    vtkSMUncheckedPropertyHelper(filter, "MaximumNumberOfCells").GetAsDouble(0);
  auto* points = information->GetPointArrayInformation(); // images have none, and get double ones
  options.BytesPerPoint = (points && points->GetDataType() == VTK_FLOAT ? 12. : 24.) +
    GetBytesPerTuple(information->GetPointDataInformation());
  options.BytesPerCell = GetBytesPerTuple(information->GetCellDataInformation());
  return options;
}

}

const std::vector<std::string>& GetForetellingProperties()
{
  static const std::vector<std::string> names{ "NumberOfLevels", "MaximumLevel", "Scheme",
    "VolumeScheme", "KeepCellTypes", "OutputDimensions", "OutputCells", "CellOrder",
    "ProjectToLimit", "SmoothShading", "GenerateLimitNormals", "GenerateTangents",
    "GenerateErrorBounds", "GenerateClassification", "MaximumNumberOfCells", "NumberOfControlCells",
    "CellType", "Input" };
  return names;
}

Forecast Foretell(vtkSMProxy* filter, int levels)
{
  auto* information = GetInputInformation(filter);
  if (!information || information->GetNumberOfCells() == 0)
  {
    return {};
  }
  const auto cells = static_cast<double>(information->GetNumberOfCells());
  if (std::string(filter->GetXMLName()) == "SubdivisionDeformation") // which keeps the cells
  {
    return { cells, 1024. * static_cast<double>(information->GetMemorySize()), 0., 0., false };
  }
  ControlCounts counts{};
  if (GetKind(filter) == ForecastOptions::OfLabels)
  {
    counts[5] = static_cast<double>(information->GetNumberOfPoints()); // or cells, which are fewer
  }
  else
  {
    counts = CountOnServer(filter, cells);
  }
  return Foretell(counts, ReadOptions(filter, levels, information, counts));
}

void SetFirstLevels(vtkSMProxy* filter)
{
  const double cells = Foretell(filter, 2).Cells;
  if (cells > 0. && cells < MostCells)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", filter);
    vtkSMPropertyHelper(filter, "NumberOfLevels").Set(2);
  }
}

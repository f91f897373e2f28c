// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceInterfaces.cxx
 * PreserveInterfaces and InterfaceValues of the surface filters.
 */
#include "MaterialTools.h"
#include "SurfaceTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"

using namespace multi_dimensional_subdivision_tools;
using surfacetools::MakeInput;
using surfacetools::MakeZoo;

namespace
{

using Surface = vtkSmartPointer<vtkPolyData>;

constexpr const char* IdsName = "MaterialPointIds";

double GetConstant(double material)
{
  return 2.3 * material - 1.;
}

/// The models of the zoo with a material for each face, a value that is constant in each, and
/// values at points.
std::map<std::string, Surface> MakeSurfaces(bool triangles)
{
  std::map<std::string, Surface> surfaces;
  for (const auto& model : MakeZoo(triangles))
  {
    const Surface surface = MakeInput(model.second);
    vtkNew<vtkIntArray> materials;
    materials->SetName("MaterialId");
    vtkNew<vtkDoubleArray> constants;
    constants->SetName("Constant");
    const vtkIdType others = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
    for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
    {
      const int material = static_cast<int>((c < others ? 0 : c - others) / 3 % 3);
      materials->InsertNextValue(material);
      constants->InsertNextValue(GetConstant(material));
    }
    surface->GetCellData()->AddArray(materials);
    surface->GetCellData()->AddArray(constants);
    surface->GetPointData()->AddArray(
      MakeArray<vtkDoubleArray>("Value", 1, surface->GetNumberOfPoints(), -1., 1., 3));
    surfaces[model.first] = surface;
  }
  return surfaces;
}

Surface Subdivide(vtkPolyData* input, int scheme, int levels, bool jump, bool toLimit = false)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(levels);
  filter->SetProjectToLimit(toLimit);
  filter->PreserveInterfacesOn();
  filter->SetInterfaceValues(jump);
  if (jump && !input->GetPointData()->HasArray("Constant"))
  {
    filter->AddFieldOfCells("Constant");
  }
  return UpdateWithoutErrors<vtkPolyData>(filter.Get(), input);
}

std::vector<vtkIdType> GetCorners(vtkPolyData* surface, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  return { ids->begin(), ids->end() };
}

void ExpectConstants(vtkPolyData* torn)
{
  vtkDataArray* constants = torn->GetPointData()->GetArray("Constant");
  vtkDataArray* materials = torn->GetCellData()->GetArray("MaterialId");
  ASSERT_TRUE(constants && materials);
  for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
  {
    for (const vtkIdType id : GetCorners(torn, c))
    {
      ASSERT_TRUE(torn->GetCell(c)->GetCellDimension() < 2 ||
        std::abs(GetConstant(materials->GetComponent(c, 0)) - constants->GetComponent(id, 0)) <
          1e-13)
        << "cell " << c << ", point " << id;
    }
  }
}

std::vector<int> GetSchemes(bool triangles)
{
  using Filter = vtkSurfaceSubdivision;
  return triangles ? std::vector<int>{ Filter::LOOP, Filter::MODIFIED_BUTTERFLY, Filter::SQRT_THREE,
    Filter::LINEAR }
                   : std::vector<int>{ Filter::CATMULL_CLARK, Filter::FOUR_EIGHT };
}

}

// Interfaces are the creases that the same edges are if lines on them are flagged.
TEST(SurfaceInterfaces, AreFlaggedLines)
{
  for (const bool triangles : { true, false })
  {
    for (const auto& surface : MakeSurfaces(triangles))
    {
      std::map<std::pair<vtkIdType, vtkIdType>, std::vector<double>> materialsAt;
      vtkDataArray* materials = surface.second->GetCellData()->GetArray("MaterialId");
      const Surface flagged = Surface::New();
      flagged->SetPoints(surface.second->GetPoints());
      flagged->SetPolys(surface.second->GetPolys());
      flagged->SetVerts(surface.second->GetVerts());
      vtkNew<vtkCellArray> lines;
      lines->DeepCopy(surface.second->GetLines());
      const vtkIdType given = lines->GetNumberOfCells();
      for (vtkIdType c = 0; c < surface.second->GetNumberOfCells(); ++c)
      {
        const std::vector<vtkIdType> corners = GetCorners(surface.second, c);
        for (std::size_t i = 0; corners.size() > 2 && i < corners.size(); ++i)
        {
          const vtkIdType next = corners[(i + 1) % corners.size()];
          materialsAt[std::minmax(corners[i], next)].push_back(materials->GetComponent(c, 0));
        }
      }
      for (const auto& edge : materialsAt)
      {
        if (edge.second.size() == 2 && edge.second[0] != edge.second[1])
        {
          lines->InsertNextCell({ edge.first.first, edge.first.second });
        }
      }
      flagged->SetLines(lines);
      vtkNew<vtkIntArray> flags;
      flags->SetName("Singular");
      const vtkIdType first = flagged->GetNumberOfVerts() + given;
      for (vtkIdType c = 0; c < flagged->GetNumberOfCells(); ++c)
      {
        flags->InsertNextValue(
          c >= first && c < flagged->GetNumberOfVerts() + lines->GetNumberOfCells());
      }
      flagged->GetCellData()->AddArray(flags);
      for (const int scheme : GetSchemes(triangles))
      {
        SCOPED_TRACE(surface.first + ", scheme " + std::to_string(scheme));
        vtkNew<vtkSurfaceSubdivision> filter;
        filter->SetScheme(scheme);
        filter->SetNumberOfLevels(2);
        const Surface expected = UpdateWithoutErrors<vtkPolyData>(filter.Get(), flagged);
        const Surface found = Subdivide(surface.second, scheme, 2, false);
        EXPECT_EQ(
          "", CompareValues(expected->GetPoints()->GetData(), found->GetPoints()->GetData()));
      }
    }
  }
}

TEST(SurfaceInterfaces, ConstantsStayConstantAndGeometryIsTheSame)
{
  vtkIdType copies = 0;
  for (const bool triangles : { true, false })
  {
    for (const auto& surface : MakeSurfaces(triangles))
    {
      for (const int scheme : GetSchemes(triangles))
      {
        for (const bool toLimit : { false, true })
        {
          SCOPED_TRACE(surface.first + ", scheme " + std::to_string(scheme));
          const Surface torn = Subdivide(surface.second, scheme, 2, true, toLimit);
          const Surface whole = Subdivide(surface.second, scheme, 2, false, toLimit);
          ExpectConstants(torn);
          vtkDataArray* ids = torn->GetPointData()->GetArray(IdsName);
          ASSERT_TRUE(ids);
          copies += torn->GetNumberOfPoints() - whole->GetNumberOfPoints();
          ASSERT_EQ(whole->GetNumberOfCells(), torn->GetNumberOfCells());
          for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c)
          {
            std::vector<vtkIdType> corners = GetCorners(torn, c);
            for (vtkIdType& corner : corners)
            {
              const auto id = static_cast<vtkIdType>(ids->GetComponent(corner, 0));
              ASSERT_EQ(GetPoint(whole, id), GetPoint(torn, corner));
              corner = id;
            }
            ASSERT_EQ(GetCorners(whole, c), corners);
          }
        }
      }
    }
  }
  EXPECT_GT(copies, 500);
}

TEST(SurfaceInterfaces, FiltersInARow)
{
  for (const bool triangles : { true, false })
  {
    for (const auto& surface : MakeSurfaces(triangles))
    {
      for (const int scheme : GetSchemes(triangles))
      {
        SCOPED_TRACE(surface.first + ", scheme " + std::to_string(scheme));
        const Surface once = Subdivide(surface.second, scheme, 2, true);
        const Surface row = Subdivide(Subdivide(surface.second, scheme, 1, true), scheme, 1, true);
        EXPECT_EQ("", CompareValues(once->GetPoints()->GetData(), row->GetPoints()->GetData()));
        EXPECT_EQ("", CompareArrays(once->GetPointData(), row->GetPointData(), "points"));
        EXPECT_EQ("", CompareArrays(once->GetCellData(), row->GetCellData(), "cells"));
      }
    }
  }
}

// With InterpolateArrays the limit of each material's values passes through those of its faces.
TEST(SurfaceInterfaces, ValuesThatAreInterpolated)
{
  for (const bool triangles : { true, false })
  {
    for (const auto& surface : MakeSurfaces(triangles))
    {
      using Filter = vtkSurfaceSubdivision; // whose other schemes have no limits, or stay
      const int scheme = triangles ? Filter::LOOP : Filter::CATMULL_CLARK;
      for (const int levels : { 0, 2 })
      {
        SCOPED_TRACE(surface.first + ", scheme " + std::to_string(scheme) + ", levels " +
          std::to_string(levels));
        vtkNew<vtkSurfaceSubdivision> filter;
        filter->SetScheme(scheme);
        filter->SetNumberOfLevels(levels);
        filter->ProjectToLimitOn();
        filter->PreserveInterfacesOn();
        filter->SetInterfaceValuesToDiscontinuous();
        filter->AddFieldOfCells("Constant");
        filter->InterpolateArraysOn();
        vtkNew<Messages> messages;
        messages->Watch(filter);
        filter->SetInputData(surface.second);
        filter->Update();
        EXPECT_TRUE(messages->Errors.empty());
        vtkPolyData* torn = filter->GetOutput();
        ExpectConstants(torn);
        if (messages->CountWarnings("does not pass") > 0)
        {
          continue; // a mesh without control values, see Mathematics 8
        }
        vtkDataArray* ids = torn->GetPointData()->GetArray(IdsName);
        vtkDataArray* values = torn->GetPointData()->GetArray("Value");
        vtkDataArray* given = surface.second->GetPointData()->GetArray("Value");
        std::set<vtkIdType> different;
        for (vtkIdType c = 0; c < torn->GetNumberOfCells(); ++c)
        {
          for (const vtkIdType p : GetCorners(torn, c))
          {
            const auto id = static_cast<vtkIdType>(ids->GetComponent(p, 0));
            if (torn->GetCell(c)->GetCellDimension() == 2 && id < given->GetNumberOfTuples() &&
              std::abs(values->GetComponent(p, 0) - given->GetComponent(id, 0)) > 1e-9)
            {
              different.insert(p);
            }
          }
        }
        EXPECT_EQ(
          material_tools::GetNumberOfMisses(messages), static_cast<vtkIdType>(different.size()));
        EXPECT_TRUE(different.empty() || levels > 0);
      }
    }
  }
}

TEST(SurfaceInterfaces, OfAdaptiveSurfaces)
{
  for (const auto& surface : MakeSurfaces(true))
  {
    SCOPED_TRACE(surface.first);
    vtkNew<vtkAdaptiveSurfaceSubdivision> filter;
    filter->PreserveInterfacesOn();
    filter->SetInterfaceValuesToDiscontinuous();
    filter->AddFieldOfCells("Constant");
    filter->SetMaximumLevel(3);
    filter->SetRefineByAttributeError(true);
    filter->RefineByGeometricErrorOff();
    filter->SetAttributeTolerance(0.2);
    filter->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Value");
    const Surface torn = UpdateWithoutErrors<vtkPolyData>(filter.Get(), surface.second);
    EXPECT_GE(torn->GetNumberOfCells(), surface.second->GetNumberOfCells());
    ExpectConstants(torn);
  }
}

// Dual schemes have no creases, so no interfaces either.
TEST(SurfaceInterfaces, DualSchemesTellThatTheyIgnoreThem)
{
  const Surface surface = MakeSurfaces(false).begin()->second;
  for (const int scheme : { vtkSurfaceSubdivision::DOO_SABIN, vtkSurfaceSubdivision::MIDEDGE })
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetScheme(scheme);
    filter->PreserveInterfacesOn();
    filter->SetInterfaceValuesToDiscontinuous();
    filter->SetInputDataObject(surface);
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->Update();
    EXPECT_EQ(1, messages->CountWarnings("PreserveInterfaces"));
    EXPECT_EQ(1, messages->CountWarnings("ignores InterfaceValues"));
    EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray(IdsName));
    EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

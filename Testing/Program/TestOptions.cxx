// SPDX-License-Identifier: BSD-3-Clause
// Every option of every filter reaches the filter from the command line.
#include "Precompiled.h"

#include "CommandLine.h"
#include "Names.h"
#include "Settings.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"

#include <sstream>

using namespace subdivide;

namespace
{

std::string Print(const Stage& stage)
{
  std::ostringstream text;
  stage.Algorithm->Print(text);
  // Addresses and times are others in each algorithm.
  std::string kept;
  std::istringstream lines(text.str());
  for (std::string line; std::getline(lines, line);)
  {
    if (line.find("0x") == std::string::npos && line.find("Modified Time") == std::string::npos)
    {
      kept += line + "\n";
    }
  }
  return kept;
}

Command Read(const Filter& filter, const std::vector<std::string>& more)
{
  std::vector<std::string> arguments{ "--filter", filter.Name };
  arguments.insert(arguments.end(), more.begin(), more.end());
  if (filter.HasInput)
  {
    arguments.emplace_back("in.vtu");
  }
  arguments.emplace_back("out.vtk"); // for meshes and tables
  return ReadCommandLine(arguments);
}

std::string Repeat(const std::string& number, int count)
{
  return count == 1 ? number : number + "," + Repeat(number, count - 1);
}

/// Texts of which at least one is not the default and in the range.
std::vector<std::string> Others(const Option& option)
{
  switch (option.Type)
  {
    case Kind::Switch:
      return { std::string(option.Default) == "on" ? "off" : "on" };
    case Kind::Choice:
    case Kind::Choices:
      for (const auto& entry : option.Entries)
      {
        if (option.Default != std::string(entry.first))
        {
          return { entry.first };
        }
      }
      return {};
    case Kind::Whole:
      return { Repeat("7", option.Count), Repeat("3", option.Count) };
    case Kind::Real:
      return { Repeat("0.25", option.Count), Repeat("7.5", option.Count),
        Repeat("0.05", option.Count) };
    case Kind::Function:
      return { "sphere=1,2,3,4" };
    case Kind::Selection:
      return { "points=1,2" };
    case Kind::Mesh:
      return { "other.vtu" };
    case Kind::Table:
      return { "other.vtt" };
    default:
      return { "SomeName" };
  }
}

/// Whether the option changed what it is for.
bool Reaches(const Filter& filter, const Option& option, const std::string& text)
{
  const Command before = Read(filter, {});
  const Command command = Read(filter, { std::string("--") + option.Name + "=" + text });
  const Stage& stage = command.Stages.front();
  switch (option.Type)
  {
    case Kind::Array:
    {
      vtkInformation* array = stage.Algorithm->GetInputArrayInformation(option.Index);
      return array->Get(vtkDataObject::FIELD_NAME()) == text &&
        array->Get(vtkAlgorithm::INPUT_PORT()) == option.Port;
    }
    case Kind::Selection:
      return stage.Algorithm->GetInputDataObject(option.Port, 0)->IsA("vtkSelection") != 0;
    case Kind::Mesh:
    case Kind::Table:
      return stage.Files.size() == 1 && stage.Files.front().second == text &&
        option.Port < stage.Algorithm->GetNumberOfInputPorts();
    default:
      return Print(before.Stages.front()) != Print(stage);
  }
}

bool ReachesWithOneOf(const Filter& filter, const Option& option)
{
  for (const std::string& text : Others(option))
  {
    try
    {
      if (Reaches(filter, option, text))
      {
        return true;
      }
    }
    catch (const UsageError&) // out of range
    {
    }
  }
  return false;
}

std::string MessageOf(const std::vector<std::string>& arguments)
{
  try
  {
    ReadCommandLine(arguments);
  }
  catch (const UsageError& error)
  {
    return error.what();
  }
  return "";
}

}

TEST(ProgramOptions, AllReachTheirFilters)
{
  int count = 0;
  for (const Filter& filter : GetFilters())
  {
    for (const Option& option : filter.Options)
    {
      EXPECT_TRUE(ReachesWithOneOf(filter, option)) << filter.Name << " --" << option.Name;
      ++count;
    }
  }
  EXPECT_GT(count, 250);
}

TEST(ProgramOptions, DefaultsAreThoseOfTheClasses)
{
  for (const Filter& filter : GetFilters())
  {
    for (const Option& option : filter.Options)
    {
      if (option.Get && *option.Default)
      {
        const Command before = Read(filter, {});
        const Command set =
          Read(filter, { std::string("--") + option.Name + "=" + option.Default });
        EXPECT_EQ(option.Get(before.Stages.front().Algorithm, 0),
          option.Get(set.Stages.front().Algorithm, 0))
          << filter.Name << " --" << option.Name;
      }
    }
  }
}

TEST(ProgramOptions, NamesAreUnique)
{
  for (const Filter& filter : GetFilters())
  {
    std::set<std::string> names;
    for (const std::string& name : GetOptionNames(filter))
    {
      EXPECT_TRUE(names.insert(Plain(name)).second) << filter.Name << " " << name;
    }
    for (const Option& option : filter.Options)
    {
      const Option* found = FindOption(filter, option.Label);
      EXPECT_TRUE(!found || found == &option) << filter.Name << " " << option.Label;
    }
    EXPECT_EQ(&FindFilter(filter.Label), &filter);
    EXPECT_EQ(&FindFilter(filter.Name), &filter);
  }
}

TEST(ProgramOptions, ShortNamesAndSpellings)
{
  for (const char* name : { "--levels", "--number-of-levels", "--NumberOfLevels" })
  {
    const Command command = ReadCommandLine({ "in.vtu", name, "4", "out.vtp" });
    const Stage& stage = command.Stages.front();
    EXPECT_EQ(FindOption(*stage.What, "levels")->Get(stage.Algorithm, 0), 4.) << name;
    EXPECT_EQ(command.Input, "in.vtu");
    EXPECT_EQ(command.Output, "out.vtp");
  }
  // The name of the class, and what the panel shows.
  for (const char* name : { "--type1-rule", "--where-dimensions-meet" })
  {
    const Stage stage = ReadCommandLine({ "a.vtu", "b.vtu", name, "sharp" }).Stages.front();
    EXPECT_EQ(FindOption(*stage.What, "Type1Rule")->Get(stage.Algorithm, 0), 1.) << name;
  }
  const Command off = ReadCommandLine({ "a.vtu", "b.vtu", "--no-cache-operator" });
  EXPECT_EQ(
    FindOption(*off.Stages.front().What, "CacheOperator")->Get(off.Stages.front().Algorithm, 0),
    0.);
}

TEST(ProgramOptions, CriteriaTakeThePlaceOfTheDefault)
{
  const Command command = ReadCommandLine({ "a.vtu", "b.vtu", "--filter", "red-green", "--refine",
    "curvature=25", "--refine=edge-length=0.5" });
  const Stage& stage = command.Stages.front();
  auto get = [&](const char* name)
  { return FindOption(*stage.What, name)->Get(stage.Algorithm, 0); };
  EXPECT_EQ(get("RefineByCurvature"), 1.);
  EXPECT_EQ(get("MaximumAngle"), 25.);
  EXPECT_EQ(get("RefineByEdgeLength"), 1.);
  EXPECT_EQ(get("MaximumEdgeLength"), 0.5);
  EXPECT_EQ(get("RefineByAttributeError"), 0.);
  EXPECT_EQ(get("RefineByGeometricError"), 0.);
}

TEST(ProgramOptions, SwitchesHaveValues)
{
  const auto read = [](const char* argument)
  { return ReadCommandLine({ "a.vtu", "b.vtu", argument }); };
  for (const char* on : { "--info", "--info=on", "--info=1", "--info=yes" })
  {
    EXPECT_TRUE(read(on).Info) << on;
  }
  for (const char* off : { "--info=off", "--info=0", "--no-info" })
  {
    EXPECT_FALSE(read(off).Info) << off;
  }
  EXPECT_TRUE(read("--quiet").Quiet);
  EXPECT_FALSE(read("--quiet=false").Quiet);
  EXPECT_FALSE(read("--help=off").Help);
  EXPECT_FALSE(read("--version=no").Version);
  for (const char* wrong : { "--info=", "--info=maybe", "--quiet=2", "--no-info=off" })
  {
    EXPECT_NE(MessageOf({ "a.vtu", "b.vtu", wrong }), "") << wrong;
  }
}

TEST(ProgramOptions, OptionsBeginWithTwoDashes)
{
  for (const char* wrong : { "-levels", "-levels=2", "-level" })
  {
    const std::string message = MessageOf({ "a.vtu", "b.vtu", wrong, "2" });
    EXPECT_NE(message.find("did you mean --levels?"), std::string::npos) << message;
  }
  EXPECT_NE(MessageOf({ "a.vtu", "-b.vtu" }).find("./-b.vtu"), std::string::npos);
  EXPECT_EQ(MessageOf({ "a.vtu", "./-b.vtu" }), "");
  EXPECT_NE(MessageOf({ "a.vtu", "-" }), "");
  EXPECT_NE(MessageOf({ "a.vtu", "" }), "");
}

TEST(ProgramOptions, FiltersInARow)
{
  const Command command = ReadCommandLine(
    { "out.vtu", "--filter", "model", "--model", "ship", "--filter", "Multi", "--levels=2" });
  ASSERT_EQ(command.Stages.size(), 2u);
  EXPECT_EQ(command.Input, "");
  EXPECT_STREQ(command.Stages[1].What->Name, "multi-dimensional-subdivision");
}

TEST(ProgramOptions, NamesWithoutLetters)
{
  for (const char* name : { "--", "--no-", "--=x", "--=", "---", "--\xc3\xa9=1", "--<>=on" })
  {
    EXPECT_NE(
      MessageOf({ "a.vtu", "b.vtu", name, "c.vtu" }).find("has no option --"), std::string::npos)
      << name;
  }
  for (const char* name : { "", "<>", "-" })
  {
    EXPECT_NE(MessageOf({ "a.vtu", "b.vtu", "--filter", name }).find("is no name of a filter"),
      std::string::npos)
      << name;
    EXPECT_NE(MessageOf({ "a.vtu", "b.vtu", "--filter", "red-green", "--refine", name })
                .find("there is no criterion"),
      std::string::npos)
      << name;
    EXPECT_NE(MessageOf({ "a.vtu", "b.vtu", "--scheme", name }).find("--volume-scheme takes"),
      std::string::npos)
      << name;
  }
}

TEST(ProgramOptions, EachNumberHasItsRange)
{
  const std::vector<std::string> cage{ "x.vtu", "--filter", "cage", "--number-of-cells" };
  for (const char* wrong : { "0,-2,2", "2,0,2", "2,2,-2147483648", "2,2,1e10", "-1e300,2,2" })
  {
    std::vector<std::string> arguments = cage;
    arguments.emplace_back(wrong);
    const std::string message = MessageOf(arguments);
    EXPECT_NE(message.find("--number-of-cells takes whole numbers"), std::string::npos) << message;
    EXPECT_NE(message.find("the nearest is"), std::string::npos) << message;
  }
  for (const char* wrong : { "2,2", "2,2,2,2", "2,2,2,", ",2,2", "2,,2", "2,2,x" })
  {
    std::vector<std::string> arguments = cage;
    arguments.emplace_back(wrong);
    EXPECT_NE(MessageOf(arguments).find("--number-of-cells takes"), std::string::npos) << wrong;
  }
  const auto expect = [](const std::vector<std::string>& more, const char* text)
  {
    std::vector<std::string> arguments{ "a.vtu", "b.vtu" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_NE(MessageOf(arguments).find(text), std::string::npos)
      << MessageOf(arguments) << ", not " << text;
  };
  const char* levels =
    "--number-of-levels takes whole numbers from 0 to 20, not 10000000000; the nearest is 20";
  expect({ "--levels", "1e10" }, levels);
  expect({ "--dimensions", "" }, "--output-dimensions takes Vertices,Lines");
  expect({ "--dimensions", "Lines," }, "--output-dimensions takes Vertices,Lines");
  expect({ "--fields-of-cells", "a,,b" }, "takes names");
  expect({ "--levels", "-3" }, "from 0 to 20, not -3; the nearest is 0");
  expect({ "--maximum-cells", "0" }, "takes whole numbers 1 or more, not 0; the nearest is 1");
  expect({ "--maximum-cells", "1e30" }, "the nearest is 9007199254740992");
  expect({ "--filter", "red-green", "--refine", "curvature=-1" }, "takes numbers");
  expect({ "--mark-selection", "points=1,-1" }, "whole numbers 0 or more, not -1");
  expect({ "--mark-selection", "points=1.5" }, "whole numbers, not \"1.5\"");
  expect({ "--mark-selection", "cells=1e300" }, "the nearest is 9007199254740992");
}

TEST(ProgramOptions, FunctionsThatContainNothing)
{
  for (const char* wrong : { "sphere=0,0,0,-1", "sphere=0,0,0,0", "box=1,0,0,1,0,1",
         "plane=0,0,0,0,0,0", "cylinder=0,0,0,0,0,0,1", "cylinder=0,0,0,0,0,1,0" })
  {
    EXPECT_NE(
      MessageOf({ "a.vtu", "b.vtu", "--mark-function", wrong }).find("--mark-function takes"),
      std::string::npos)
      << wrong;
  }
  EXPECT_EQ(MessageOf({ "a.vtu", "b.vtu", "--mark-function", "box=0,0,0,1,0,1" }), "");
}

TEST(ProgramOptions, WrongOnes)
{
  EXPECT_EQ(
    MessageOf({ "--filter", "qwertz" }), "there is no filter \"qwertz\", --help lists them");
  EXPECT_NE(MessageOf({ "a.vtu", "b.vtu", "--levles", "3" }).find("did you mean --levels?"),
    std::string::npos);
  EXPECT_NE(MessageOf({ "a.vtu", "b.vtu", "--scheme", "tetoc" }).find("did you mean Tet/Oct?"),
    std::string::npos);
  EXPECT_NE(
    MessageOf({ "a.vtu", "b.vtu", "--levels", "21" }).find("the nearest is 20"), std::string::npos);
  EXPECT_NE(
    MessageOf({ "a.vtu", "b.vtu", "--levels", "2.5" }).find("whole number"), std::string::npos);
  EXPECT_NE(MessageOf({ "a.vtu", "b.vtu", "--levels" }).find("needs a value"), std::string::npos);
  EXPECT_NE(
    MessageOf({ "a.vtu", "b.vtu", "--filter", "s" }).find("several filters"), std::string::npos);
  EXPECT_NE(MessageOf({ "a.vtu", "b.vtu", "--filter", "redgren" }).find("did you mean red-green"),
    std::string::npos);
  EXPECT_NE(MessageOf({ "a.vtu", "b.vtu", "--refine", "curvature=1" }).find("no criteria"),
    std::string::npos);
  EXPECT_NE(MessageOf({ "a.vtu", "--levels", "1" }).find("names 1"), std::string::npos);
  EXPECT_NE(
    MessageOf({ "a.vti", "b.vtu", "--filter", "label-solid", "--materials", "c.vtu" }).find(".vtt"),
    std::string::npos);
  EXPECT_NE(MessageOf({ "a.vtt", "b.vtu" }).find("cannot read \"a.vtt\""), std::string::npos);
  EXPECT_NE(MessageOf({ "a.vtu", "b.foo" }).find("cannot write \"b.foo\""), std::string::npos);
  EXPECT_NE(
    MessageOf({ "a.vtu", "b.vtu", "--filter", "multi", "--filter", "model" }).find("is a source"),
    std::string::npos);
}

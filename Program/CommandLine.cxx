// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"
#include "Files.h"
#include "Names.h"
#include "Settings.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace subdivide
{
namespace
{

const char* const DefaultFilter = "multi-dimensional-subdivision";

/// The class of what the last filter makes.
std::string MakesType(const Command& command)
{
  const char* const type = command.Stages.back().Algorithm->GetOutputPortInformation(0)->Get(
    vtkDataObject::DATA_TYPE_NAME());
  return type ? type : "";
}

/// The arguments, one after another.
class Reader
{
public:
  explicit Reader(const std::vector<std::string>& arguments)
    : Arguments(arguments)
  {
  }

  Command Read()
  {
    for (; this->At < this->Arguments.size(); ++this->At)
    {
      const std::string& argument = this->Arguments[this->At];
      if (argument.compare(0, 2, "--") == 0)
      {
        this->ReadOption(argument.substr(2));
      }
      else if (argument == "-h")
      {
        this->Result.Help = true;
      }
      else if (argument[0] == '-')
      {
        throw UsageError("\"" + argument + "\" is neither an option nor a file" +
          DidYouMean(argument.substr(0, argument.find('=')), this->GetNames()) +
          "; options begin with --, and a file of this name is ./" + argument);
      }
      else if (this->At > 0 || !this->TakeFilter(argument))
      {
        this->Names.push_back(argument);
      }
    }
    this->GetStage();
    if (!this->Result.Help && !this->Result.Version)
    {
      this->TakeFiles();
    }
    return this->Result;
  }

private:
  /// Takes a word that no file could be for the name of a filter. Returns whether it is one.
  bool TakeFilter(const std::string& word)
  {
    if (word.find_first_of("./\\") != std::string::npos ||
      std::filesystem::exists(std::filesystem::u8path(word)))
    {
      return false;
    }
    try
    {
      this->AddStage(FindFilter(word));
    }
    catch (const UsageError&) // it is taken for a file
    {
      return false;
    }
    return this->Result.NamesFilter = true;
  }

  void ReadOption(const std::string& argument)
  {
    const std::size_t at = argument.find('=');
    const std::string name = argument.substr(0, at);
    const bool given = at != std::string::npos;
    const std::string text = given ? argument.substr(at + 1) : std::string();
    const std::pair<const char*, bool*> switches[] = { { "help", &this->Result.Help },
      { "version", &this->Result.Version }, { "info", &this->Result.Info },
      { "quiet", &this->Result.Quiet }, { "dither", &this->Result.Dither } };
    for (const auto& one : switches)
    {
      if (name == one.first || (!given && name == std::string("no-") + one.first))
      {
        *one.second = name == one.first && (!given || IsOn("--" + name, text));
        return;
      }
    }
    if (name == "filter")
    {
      this->Result.NamesFilter = true;
      this->AddStage(FindFilter(given ? text : this->Next("--filter")));
    }
    else if (name == "slices")
    {
      this->Result.Slices = given ? text : this->Next("--slices");
      if (this->Result.Slices.empty())
      {
        throw UsageError("--slices needs a value");
      }
    }
    else if (name == "refine")
    {
      this->ReadCriterion(given ? text : this->Next("--refine"));
    }
    else
    {
      this->ReadFilterOption(name, given, text);
    }
  }

  void ReadFilterOption(const std::string& name, bool given, const std::string& given_text)
  {
    Stage& stage = this->GetStage();
    const Option* option = FindOption(*stage.What, name);
    std::string text = given_text;
    if (!option && name.compare(0, 3, "no-") == 0)
    {
      option = FindOption(*stage.What, name.substr(3));
      option = option && option->Type == Kind::Switch && !given ? option : nullptr;
      text = "off";
    }
    else if (option && !given)
    {
      text = option->Type == Kind::Switch ? "on" : this->Next("--" + name);
    }
    if (!option)
    {
      throw UsageError("the filter " + std::string(stage.What->Name) + " has no option --" + name +
        DidYouMean(name, this->GetNames()));
    }
    this->Set(stage, *option, text);
  }

  /// All options that can be given now.
  std::vector<std::string> GetNames()
  {
    std::vector<std::string> names = GetOptionNames(*this->GetStage().What);
    names.insert(names.end(),
      { "--filter", "--refine", "--slices", "--dither", "--info", "--help", "--version",
        "--quiet" });
    return names;
  }

  void Set(Stage& stage, const Option& option, const std::string& text)
  {
    if (option.Type == Kind::Mesh || option.Type == Kind::Table)
    {
      option.Type == Kind::Table ? CheckReadableTable(text) : CheckReadable(text);
      stage.Files.emplace_back(&option, text);
      return;
    }
    ApplySetting(stage.Algorithm, option, text);
    if (option.Type == Kind::Array)
    {
      stage.Arrays.emplace_back(&option, text);
    }
  }

  void ReadCriterion(const std::string& text)
  {
    Stage& stage = this->GetStage();
    const std::size_t at = text.find('=');
    const std::string name = text.substr(0, at);
    std::vector<std::string> names;
    for (const Criterion& criterion : stage.What->Criteria)
    {
      names.emplace_back(criterion.Name);
      if (Plain(criterion.Name) != Plain(name))
      {
        continue;
      }
      this->SwitchOthersOff(stage);
      this->Set(stage, *FindOption(*stage.What, criterion.Switch), "on");
      if (at != std::string::npos)
      {
        if (!*criterion.Number)
        {
          throw UsageError("--refine " + name + " takes no number");
        }
        this->Set(stage, *FindOption(*stage.What, criterion.Number), text.substr(at + 1));
      }
      return;
    }
    throw UsageError(names.empty()
        ? "the filter " + std::string(stage.What->Name) +
          " has no criteria for --refine; --filter red-green and --filter adaptive have"
        : "there is no criterion \"" + name + "\"" + DidYouMean(name, names));
  }

  /// The first --refine of a filter takes the place of what it would do by itself.
  void SwitchOthersOff(Stage& stage)
  {
    if (this->Refining == stage.Algorithm)
    {
      return;
    }
    this->Refining = stage.Algorithm;
    for (const Criterion& criterion : stage.What->Criteria)
    {
      this->Set(stage, *FindOption(*stage.What, criterion.Switch), "off");
    }
  }

  const std::string& Next(const std::string& option)
  {
    if (this->At + 1 >= this->Arguments.size())
    {
      throw UsageError(option + " needs a value");
    }
    return this->Arguments[++this->At];
  }

  void AddStage(const Filter& filter)
  {
    if (!filter.HasInput && !this->Result.Stages.empty())
    {
      throw UsageError(std::string(filter.Name) + " is a source: it has to be the first --filter");
    }
    this->Result.Stages.push_back(
      { &filter, vtkSmartPointer<vtkAlgorithm>::Take(filter.New()), {}, {} });
  }

  Stage& GetStage()
  {
    if (this->Result.Stages.empty())
    {
      this->AddStage(FindFilter(DefaultFilter));
    }
    return this->Result.Stages.back();
  }

  void TakeFiles()
  {
    const bool hasInput = this->Result.Stages.front().What->HasInput;
    const bool makesTable = MakesTable(this->Result);
    if (makesTable && this->Result.Info)
    {
      throw UsageError("--info tells of meshes that come out, but the last filter makes a table");
    }
    const bool makesSlices = !this->Result.Slices.empty();
    if (makesSlices && MakesType(this->Result) != "vtkImageData")
    {
      throw UsageError("--slices is for an image: let sample be the last filter");
    }
    if (this->Result.Dither && !makesSlices)
    {
      throw UsageError("--dither is for --slices: name a folder for them");
    }
    const std::size_t wanted = (hasInput ? 1 : 0) + 1;
    const bool mayHaveNone = this->Result.Info || makesTable || makesSlices;
    const std::size_t least = mayHaveNone ? wanted - 1 : wanted;
    if (this->Names.size() < least || this->Names.size() > wanted)
    {
      throw UsageError(std::string("the command line has to name ") +
        (hasInput ? "an input file and an output file" : "one file, for the output") +
        ", but names " + std::to_string(this->Names.size()) + "; --help tells more");
    }
    if (hasInput)
    {
      this->Result.Input = this->Names.front();
      CheckReadable(this->Result.Input);
    }
    if (this->Names.size() == wanted)
    {
      this->Result.Output = this->Names.back();
      CheckWritable(this->Result.Output, makesTable);
      this->CheckOther(this->Result.Input);
      for (const Stage& stage : this->Result.Stages)
      {
        for (const auto& file : stage.Files)
        {
          this->CheckOther(file.second);
        }
      }
    }
  }

  /// Whoever mistypes a name does not lose the only copy of a mesh.
  void CheckOther(const std::string& input) const
  {
    std::error_code none;
    const auto read = std::filesystem::u8path(input);
    if (std::filesystem::equivalent(read, std::filesystem::u8path(this->Result.Output), none) &&
      std::filesystem::is_regular_file(read, none))
    {
      throw UsageError(
        "the output would be written over the input " + input + ": name another file for it");
    }
  }

  const std::vector<std::string>& Arguments;
  std::size_t At = 0;
  Command Result;
  std::vector<std::string> Names;
  vtkAlgorithm* Refining = nullptr;
};

}

bool MakesTable(const Command& command)
{
  return MakesType(command) == "vtkTable";
}

Command ReadCommandLine(const std::vector<std::string>& arguments)
{
  return Reader(arguments).Read();
}

}

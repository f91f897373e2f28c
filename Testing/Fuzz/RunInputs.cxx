// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunInputs.cxx
 * Takes the place of libFuzzer, with any compiler: runs each file of the given folders, then random
 * changes of them for some seconds: RunInputs [--seconds N] FOLDER... N is for random tests of a
 * minute; SUBDIVISIONOBJECTS_RANDOM_SECONDS makes it shorter or longer, as those.
 */
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <unistd.h>

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using Input = std::vector<std::uint8_t>;

Input ReadInput(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// Some bytes changed, removed or added.
void Change(Input& input, std::mt19937& chance)
{
  const auto draw = [&](std::size_t n) { return static_cast<std::size_t>(chance() % n); };
  for (std::size_t i = 1 + draw(8); i > 0; --i)
  {
    const std::size_t at = draw(input.size() + 1);
    const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
    const auto byte = static_cast<std::uint8_t>(chance());
    if (at == input.size() || draw(8) == 0)
    {
      input.insert(place, 1 + draw(8), byte);
    }
    else if (draw(8) == 0)
    {
      input.erase(place);
    }
    else
    {
      *place = byte;
    }
  }
}

Input Current;

/// Seconds after which an input counts as one that does not come to an end.
constexpr unsigned Patience = 240;

/// Prints the input at a crash, or when patience is over, as `xxd -r -p` reads it, so that the log
/// of a test is enough to repeat it.
extern "C" void PrintInput(int signal)
{
  std::fprintf(stderr, "the input:\n");
  for (const std::uint8_t byte : Current)
  {
    std::fprintf(stderr, "%02x", byte);
  }
  std::fprintf(stderr, "\n");
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Writes an input before it is run, so that it is there after a crash.
void Run(const Input& input)
{
  Current = input;
  std::ofstream("last-input", std::ios::binary)
    .write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
  alarm(Patience);
  LLVMFuzzerTestOneInput(input.data(), input.size());
  alarm(0);
}

}

int main(int argc, char** argv)
{
  LLVMFuzzerInitialize(&argc, &argv);
  for (const int signal : { SIGABRT, SIGSEGV, SIGALRM })
  {
    std::signal(signal, PrintInput);
  }
  double seconds = 0.;
  std::vector<Input> corpus;
  for (int i = 1; i < argc; ++i)
  {
    if (std::string(argv[i]) == "--seconds" && i + 1 < argc)
    {
      const char* ofMinute = std::getenv("SUBDIVISIONOBJECTS_RANDOM_SECONDS");
      seconds = std::atof(argv[++i]) * (ofMinute ? std::atof(ofMinute) / 60. : 1.);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
    {
      corpus.push_back(ReadInput(entry.path()));
      std::cout << entry.path().filename().string() << std::endl;
      Run(corpus.back());
    }
  }
  if (corpus.empty())
  {
    std::cerr << "no inputs\n";
    return 1;
  }
  const unsigned seed = std::random_device()();
  std::mt19937 chance(seed);
  const auto start = std::chrono::steady_clock::now();
  std::size_t runs = corpus.size();
  while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < seconds)
  {
    Input input = corpus[chance() % corpus.size()];
    Change(input, chance);
    Run(input);
    ++runs;
  }
  std::cout << runs << " inputs, seed " << seed << "\n";
  return 0;
}

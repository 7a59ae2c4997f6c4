#include "core/file/same_file.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/file/atomic_file.h"

namespace swaplight {

void checkEnding(const std::filesystem::path& target, std::span<const char* const> endings,
                 const char* what) {
  const std::string ending = lowerExtension(target);
  if (target.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end()) return;
  throw InputError("{}: {} is written as {}. Name it {}.", target.string(), what, endings.front() + 1,
                   std::filesystem::path(target).replace_extension(endings.front()).string());
}

void checkOutput(const std::filesystem::path& target, std::span<const std::filesystem::path> inputs) {
  for (const std::filesystem::path& input : inputs) {
    std::error_code error;  // what is not there is no other file
    if (!input.empty() && std::filesystem::equivalent(target, input, error) && !error)
      throw InputError("{}: is read here, as {}, and would be replaced. Name another output.",
                       target.string(), input.string());
  }
  checkWritable(target);
}

void checkOutputs(std::span<const std::filesystem::path> targets,
                  std::span<const std::filesystem::path> inputs) {
  std::set<std::filesystem::path> written;
  for (const std::filesystem::path& target : targets) {
    if (target.empty()) continue;
    checkOutput(target, inputs);
    std::error_code error;  // a folder that cannot be looked into: its name will do
    const std::filesystem::path whole =
        std::filesystem::weakly_canonical(std::filesystem::absolute(target), error);
    if (!written.insert(error ? target : whole).second)
      throw InputError("{}: would be written twice. Name another file for one of them.", target.string());
  }
}

}  // namespace swaplight

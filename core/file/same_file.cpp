#include "core/file/same_file.h"

#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/file/atomic_file.h"

namespace swaplight {

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

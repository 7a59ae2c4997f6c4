#include "core/file/same_file.h"

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

}  // namespace swaplight

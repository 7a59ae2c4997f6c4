#pragma once

#include <filesystem>
#include <span>

namespace swaplight {

/// Throws InputError where the target's name does not end in one of `endings` (".json"), so that no program
/// takes `what` ("a rig") for something else; an empty target is not written.
void checkEnding(const std::filesystem::path& target, std::span<const char* const> endings, const char* what);

/// What checkWritable says, and that the target is none of the files that the work reads, under whatever name
/// (links): the photograph would be gone. Throws InputError.
void checkOutput(const std::filesystem::path& target, std::span<const std::filesystem::path> inputs);

/// The same of several, of which empty ones are not written; and that no two are the same file.
void checkOutputs(std::span<const std::filesystem::path> targets,
                  std::span<const std::filesystem::path> inputs);

}  // namespace swaplight

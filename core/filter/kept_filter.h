#pragma once

#include <filesystem>
#include <string>

#include "core/filter/filter_library.h"

namespace swaplight {

/// Writes a filter with a stage's parameters as its defaults into a folder of filters, under a name; its
/// vertex shader goes along. Everything else of the file stays as its author wrote it. Pictures are not kept,
/// since ISF knows no default for them. An empty name: "my-NAME", or the next one that is free, so that looks
/// that use the filter stay as they are. Gives the file. Throws InputError: the name is no file's or is
/// taken, the filter imports pictures that lie beside its file, the file cannot be written.
std::filesystem::path keepFilter(const ResolvedStage& stage, const std::filesystem::path& folder,
                                 const std::string& name = {});

}  // namespace swaplight

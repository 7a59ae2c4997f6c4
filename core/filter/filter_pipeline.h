#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/kept_json.h"
#include "core/filter/filter_value.h"

namespace swaplight {

/// A filter at its place in a pipeline.
struct FilterStage {
  std::string filter;  ///< a name of the library, or a file (ends in .fs)
  bool on = true;
  std::map<std::string, FilterValue> parameters;  ///< those that differ from the defaults
  KeptJson kept;                                  ///< keys that this program does not know
  bool operator==(const FilterStage&) const = default;
};

/// The newest version of a .swaplook file that this program knows.
inline constexpr int kPipelineVersion = 1;

/// A camera look: filters in the order of their working, under a name. What a .swaplook file holds:
///
///   {"format": "swaplight-look", "version": 1, "name": "Night vision",
///    "filters": [{"filter": "night-vision", "on": true, "parameters": {"gain": 2, "tint": [0.2, 1, 0.3,
///    1]}}]}
struct FilterPipeline {
  std::string name;
  std::vector<FilterStage> stages;
  std::filesystem::path folder;  ///< files are named from here; not saved
  KeptJson kept;                 ///< keys that this program does not know
  bool operator==(const FilterPipeline&) const = default;
};

[[nodiscard]] Json jsonFromPipeline(const FilterPipeline& pipeline);
/// Throws InputError, one line beginning with `where`: not a look, of a newer version, without a name or a
/// filter, a parameter that is no value.
[[nodiscard]] FilterPipeline pipelineFromJson(const Json& json, const std::string& where);

/// Every file that the look may read, so that none is overwritten: filters of their own and pictures. Which
/// texts are pictures only the filters know: others are among them, as names of files that nobody has.
[[nodiscard]] std::vector<std::filesystem::path> filesOfPipeline(const FilterPipeline& pipeline);

/// Reads and writes a .swaplook file. Throw InputError that names the file.
[[nodiscard]] FilterPipeline readPipeline(const std::filesystem::path& file);
void writePipeline(const FilterPipeline& pipeline, const std::filesystem::path& file);

/// A stage as typed: "NAME", "NAME,parameter=value,..." . Values are texts until the filter is known. Throws
/// InputError.
[[nodiscard]] FilterStage stageFromText(const std::string& text);

}  // namespace swaplight

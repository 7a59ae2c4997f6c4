#include "core/export/provenance.h"

#include <array>

#include "core/file/file_hash.h"
#include "core/session/open_source.h"

namespace swaplight {
namespace {

Json solverSummary(const Json& report) {
  constexpr std::array<const char*, 8> kKept = {"message",      "model", "solver", "residual_median",
                                                "sigma_median", "noise", "pixels", "warnings"};
  Json summary = Json::object();
  for (const char* key : kKept)
    if (report.contains(key)) summary[key] = report[key];
  return summary;
}

Json sourcesOf(const SolvedSet& set, const std::filesystem::path& source) {
  Json files = Json::array();
  const auto add = [&](const std::filesystem::path& file) {
    const std::string hash = sha256OfFile(file);
    files.push_back({{"file", file.filename().string()}, {"sha256", hash.empty() ? Json() : Json(hash)}});
  };
  if (sourceKind(source) == SourceKind::SolvedSet) {
    add(source);
    return files;
  }
  for (const Shot& shot : set.capture.shots) add(set.capture.folder / shot.image);
  return files;
}

}  // namespace

std::map<std::string, std::string> provenanceOf(const SolvedSet& set, const Rig& rig,
                                                const std::filesystem::path& source) {
  return {{"swaplight/capture", jsonFromCapture(set.capture).dump()},
          {"swaplight/rig", jsonFromRig(rig).dump()},
          {"swaplight/solver", solverSummary(set.report).dump()},
          {"swaplight/source", sourcesOf(set, source).dump()}};
}

}  // namespace swaplight

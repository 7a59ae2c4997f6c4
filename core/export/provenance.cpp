#include "core/export/provenance.h"

#include "core/base/json.h"
#include "core/file/file_hash.h"
#include "core/file/json_file.h"
#include "core/session/open_source.h"

namespace swaplight {
namespace {

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
  return {{"swaplight/capture", jsonText(jsonFromCapture(set.capture))},
          {"swaplight/rig", jsonText(jsonFromRig(rig))},
          {"swaplight/solver", jsonText(set.report ? jsonFromSolveSummary(*set.report) : Json::object())},
          {"swaplight/source", jsonText(sourcesOf(set, source))}};
}

}  // namespace swaplight

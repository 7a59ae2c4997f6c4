#include "core/setups/other_set.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/session/open_source.h"
#include "core/set/solved_file.h"
#include "core/setups/place_free_edits.h"

namespace swaplight {
namespace {

std::vector<std::string> namesOf(const Capture& capture) {
  std::vector<std::string> names;
  for (const Light& light : capture.lights) names.push_back(light.name);
  return names;
}

/// A lighting and its edits for the other set's lights, one after the other; remembers what was left out.
class Conversion {
 public:
  explicit Conversion(const Capture& capture) : m_capture(capture), m_names(namesOf(capture)) {}

  /// `where`: "" for what is there now, else the version's name.
  void convert(const std::string& where, Rig& rig, EditStack& edits) {
    PlaceFreeEdits fitted = placeFreeEdits(edits, m_names);
    if (!fitted.leftOut.empty())
      m_notes.push_back(fmt::format("{}light edits of the other picture are left out: {}",
                                    where.empty() ? "" : where + ": ", fmt::join(fitted.leftOut, ", ")));
    convert(rig, edits.newLights, fitted.edits);
    edits = std::move(fitted.edits);
  }
  /// A lighting alone, of the set's lights and those that the edits add to it. `painted`: those that were
  /// added there; a lamp that has the name of one is as it was captured.
  void convert(Rig& rig, const std::vector<std::string>& painted, const EditStack& edits) {
    std::erase_if(rig.lights, [&](const LightSetting& light) {
      return std::find(painted.begin(), painted.end(), light.light) != painted.end() &&
             m_capture.lightIndex(light.light) >= 0;
    });
    const Capture all = withNewLights(m_capture, edits);
    for (const LightSetting& light : rig.lights) {
      (all.lightIndex(light.light) < 0 ? m_missing : m_told).insert(light.light);
    }
    rig = fitRig(rig, all);
  }

  [[nodiscard]] bool complete() const { return m_missing.empty() && m_notes.empty(); }
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    if (!m_missing.empty())
      notes.push_back(fmt::format("not in this set, left out: {}", fmt::join(m_missing, ", ")));
    std::vector<std::string> captured;
    for (const std::string& name : m_names)
      if (m_told.count(name) == 0) captured.push_back(name);
    if (!captured.empty())
      notes.push_back(fmt::format("only in this set, as captured: {}", fmt::join(captured, ", ")));
    notes.insert(notes.end(), m_notes.begin(), m_notes.end());
    return notes;
  }

 private:
  const Capture& m_capture;
  std::vector<std::string> m_names;
  std::set<std::string> m_missing, m_told;
  std::vector<std::string> m_notes;
};

void checkCommonLight(const Document& from, const std::filesystem::path& source, const Capture& capture) {
  std::vector<std::string> here;
  for (const LightSetting& light : from.rig.lights) {
    if (capture.lightIndex(light.light) >= 0) return;
    here.push_back(light.light);
  }
  if (here.empty()) return;
  throw InputError("{}: its lights are {}, none of which is among {}. Choose a set of the same lights.",
                   source.string(), fmt::join(namesOf(capture), ", "), fmt::join(here, ", "));
}

}  // namespace

OtherSetDocument documentForSet(const Document& from, const std::filesystem::path& source,
                                const Capture& capture) {
  checkCommonLight(from, source, capture);
  OtherSetDocument result{from, {}};
  Document& document = result.document;
  document.source = source;
  document.selection.clear();
  Conversion conversion(capture);
  conversion.convert("", document.rig, document.edits);
  for (SavedLook& look : document.looks) {
    if (look.scene)
      conversion.convert(look.name, look.rig, look.scene->edits);
    else
      conversion.convert(look.rig, from.edits.newLights, document.edits);
  }
  result.notes = conversion.notes();
  result.complete = conversion.complete();
  return result;
}

Capture captureOfSource(const ColorConfig& config, const std::filesystem::path& source) {
  if (!std::filesystem::exists(source)) throw InputError("{}: there is no such file", source.string());
  if (sourceKind(source) == SourceKind::SolvedSet) return readSolvedHeader(source).capture;
  if (sourceKind(source) == SourceKind::Capture) return readCapture(config, sourceFile(source));
  throw InputError("{}: neither a capture nor a solved set", source.string());
}

}  // namespace swaplight

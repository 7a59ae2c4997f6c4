#include "app/arguments/edit_arguments.h"

#include <algorithm>
#include <iterator>

#include "core/base/error.h"
#include "core/edit/stack/edit_file.h"
#include "core/session/open_source.h"

namespace swaplight {

void EditArguments::addTo(CLI::App& verb) {
  verb.add_option("--edits", file, "Apply light edits first: a JSON file of edits")->type_name("FILE");
}

std::vector<std::filesystem::path> EditArguments::inputs() const {
  if (file.empty()) return {};
  // The size is that of painted strokes, and says nothing of files.
  std::vector<std::filesystem::path> files = filesOfEdits(readEdits(file, 1, 1));
  files.emplace_back(file);
  return files;
}

SolvedSet EditArguments::applyTo(SolvedSet set, const EditStack& session,
                                 const std::string& sessionFile) const {
  if (leavesAlone(session)) return set;
  return edited(std::make_shared<const SolvedSet>(std::move(set)), session, sessionFile);
}

std::shared_ptr<const SolvedSet> EditArguments::applyTo(const std::shared_ptr<const SolvedSet>& set,
                                                        const EditStack& session,
                                                        const std::string& sessionFile) const {
  if (leavesAlone(session)) return set;
  return std::make_shared<const SolvedSet>(edited(set, session, sessionFile));
}

SolvedSet EditArguments::edited(const std::shared_ptr<const SolvedSet>& set, const EditStack& session,
                                const std::string& sessionFile) const {
  EditStack stack = session;
  std::vector<std::string> warnings;
  if (!file.empty()) {
    const EditStack added = readEdits(file, set->width(), set->height(), &warnings);
    stack.edits.insert(stack.edits.end(), added.edits.begin(), added.edits.end());
    stack.newLights.insert(stack.newLights.end(), added.newLights.begin(), added.newLights.end());
    for (const auto& [light, threshold] : added.shadowThresholds) stack.shadowThresholds[light] = threshold;
    for (const auto& [light, marks] : added.shadowMarks) {
      ShadowMarks& all = stack.shadowMarks[light];
      all.insert(all.end(), marks.begin(), marks.end());
    }
    for (const auto& [light, place] : added.lampPlaces) stack.lampPlaces[light] = place;
  }
  try {
    SolvedSet changed = withEdits(set, stack);
    std::copy(warnings.begin(), warnings.end(), std::back_inserter(changed.capture.warnings));
    return changed;
  } catch (const InputError& error) {
    throw InputError("{}: {}", file.empty() ? sessionFile : file, error.what());
  }
}

}  // namespace swaplight

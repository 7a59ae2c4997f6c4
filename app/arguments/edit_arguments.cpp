#include "app/arguments/edit_arguments.h"

#include "core/base/error.h"
#include "core/edit/stack/edit_file.h"
#include "core/session/open_source.h"

namespace swaplight {

void EditArguments::addTo(CLI::App& verb) {
  verb.add_option("--edits", file, "Apply light edits first: a JSON file of edits")->type_name("FILE");
}

SolvedSet EditArguments::applyTo(SolvedSet set, const EditStack& session,
                                 const std::string& sessionFile) const {
  if (file.empty() && session == EditStack{}) return set;
  const auto original = std::make_shared<const SolvedSet>(std::move(set));
  EditStack stack = session;
  if (!file.empty()) {
    const EditStack added = readEdits(file, original->width(), original->height());
    stack.edits.insert(stack.edits.end(), added.edits.begin(), added.edits.end());
    stack.newLights.insert(stack.newLights.end(), added.newLights.begin(), added.newLights.end());
    for (const auto& [light, threshold] : added.shadowThresholds) stack.shadowThresholds[light] = threshold;
    for (const auto& [light, marks] : added.shadowMarks) {
      ShadowMarks& all = stack.shadowMarks[light];
      all.insert(all.end(), marks.begin(), marks.end());
    }
  }
  try {
    return withEdits(original, stack);
  } catch (const InputError& error) {
    throw InputError("{}: {}", file.empty() ? sessionFile : file, error.what());
  }
}

}  // namespace swaplight

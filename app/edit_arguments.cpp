#include "app/edit_arguments.h"

#include "core/edit/edit_file.h"
#include "core/edit/edited_set.h"
#include "core/error.h"
#include "core/shadow/detect_shadows.h"

namespace swaplight {

void EditArguments::addTo(CLI::App& verb) {
  verb.add_option("--edits", file, "Edit the lights first: a file of edits (JSON)")->type_name("FILE");
}

SolvedSet EditArguments::applyTo(SolvedSet set) const {
  if (file.empty()) return set;
  const auto original = std::make_shared<const SolvedSet>(std::move(set));
  const EditStack stack = readEdits(file, original->width(), original->height());
  try {
    return applyEdits(*original, stack, shadowSource(original));
  } catch (const InputError& error) {
    throw InputError("{}: {}", file, error.what());
  }
}

}  // namespace swaplight

#include "ui/tools/new_light.h"

#include <algorithm>

#include "core/base/lower_case.h"
#include "core/session/document.h"

namespace swaplight {

std::string addNewLight(EditingContext& studio, const std::string& word, Document& document) {
  std::string name = word;
  const auto taken = [&] {
    const auto& lights = document.rig.lights;
    return std::any_of(lights.begin(), lights.end(),
                       [&](const auto& light) { return lowerCase(light.light) == lowerCase(name); });
  };
  for (int number = 2; taken(); ++number) name = word + std::to_string(number);
  document.edits.newLights.push_back(name);
  document.rig = fitRig(document.rig, withNewLights(studio.set()->original->capture, document.edits));
  studio.view.selectedLight = static_cast<int>(document.rig.lights.size()) - 1;
  studio.view.selectedLights.clear();
  return name;
}

}  // namespace swaplight

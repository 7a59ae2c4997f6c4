#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/balance/neutral_rig.h"
#include "ui/control/light_edit.h"
#include "ui/mixer/lamp_reader.h"
#include "ui/mixer/mixer_actions.h"

namespace swaplight {
namespace {

/// Every light that is chosen, or every one that is not.
std::vector<size_t> lightsOf(const LightsContext& studio, bool chosen) {
  const std::vector<size_t> named = lightsFor(studio, shownLight(studio));
  std::vector<size_t> lights;
  for (size_t i = 0; i < studio.document().rig.lights.size(); ++i)
    if ((std::find(named.begin(), named.end(), i) != named.end()) == chosen) lights.push_back(i);
  return lights;
}

void neutralize(LightsContext& studio, const std::string& what, const std::vector<size_t>& lights,
                const WhitePoint& white) {
  editRig(studio, fmt::format("Neutralise {} to {}", what, textFromWhitePoint(white)),
          neutralized(studio.document().rig, lights, white));
}

void askForPhotograph(LightsContext& studio, LampReader& lamps, FileChooser& chooser) {
  FileChooser::Question question;
  question.title = "Another photograph of this set, by the same camera at the same place";
  question.button = "Read lamps";
  question.extensions = photographExtensions();
  question.folder = studio.document().source.parent_path();
  question.answer = [&studio, &lamps](const std::filesystem::path& file) {
    if (studio.set()) lamps.start(studio.colors.config(), studio.set()->original, file);
  };
  chooser.ask(std::move(question));
}

}  // namespace

void addBalanceActions(ActionTable& actions, LightsContext& studio, LampReader& lamps, FileChooser& chooser) {
  const auto white = std::make_shared<WhitePoint>();  // what lights become; lasts as long as the studio
  const auto hasLights = [&studio] { return !studio.document().rig.lights.empty(); };
  actions.add({"light.neutralize", "Neutralise", "",
               "Set the selected lights to the white point and keep their luminance.",
               [&studio, white] { neutralize(studio, "lights", lightsOf(studio, true), *white); },
               hasLights});
  actions.add({"mixer.neutralize_all", "Neutralise all lights", "",
               "White balance under many lamps: set every light to the white point and keep its luminance.",
               [&studio, white] {
                 std::vector<size_t> all(studio.document().rig.lights.size());
                 for (size_t i = 0; i < all.size(); ++i) all[i] = i;
                 neutralize(studio, "all", all, *white);
               },
               hasLights});
  actions.add({"mixer.neutralize_others", "Neutralise all others", "",
               "Set every light but the selected ones to the white point and keep its luminance.",
               [&studio, white] { neutralize(studio, "others", lightsOf(studio, false), *white); },
               hasLights});
  for (const NamedWhite& named : namedWhites())
    actions.add({std::string("white.") + named.name,
                 fmt::format("{}: {}", named.name, named.description),
                 "",
                 "The white point that Neutralise sets lights to.",
                 [white, named] { *white = named.white; },
                 {},
                 [white, named] { return *white == named.white; }});
  actions.add({"mixer.read_photograph", "Read lamps from a photograph \u2026", "",
               "Set every light's colour and level as the lamps were when another photograph of this set was "
               "taken.",
               [&studio, &lamps, &chooser] { askForPhotograph(studio, lamps, chooser); },
               [&studio, &lamps] { return studio.set() != nullptr && !lamps.busy(); }});
}

}  // namespace swaplight

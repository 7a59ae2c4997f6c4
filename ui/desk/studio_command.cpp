#include "ui/desk/studio_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/base/number_text.h"
#include "core/look/look.h"
#include "core/look/look_place.h"
#include "core/look/rig_blend.h"
#include "core/relight/light_command.h"
#include "core/relight/light_command_words.h"
#include "core/session/version.h"
#include "ui/control/light_edit.h"
#include "ui/control/look_edit.h"
#include "ui/desk/cue_edit.h"

namespace swaplight {
namespace {

constexpr size_t kMostEnds = 12;

std::string trimmedLine(const std::string& line) {
  const size_t from = line.find_first_not_of(" \t"), to = line.find_last_not_of(" \t");
  return from == std::string::npos ? "" : line.substr(from, to - from + 1);
}

/// What stands after a first word; nothing where the line begins otherwise.
std::optional<std::string> after(const std::string& line, const std::string& word) {
  const bool begins =
      lowerCase(line).starts_with(word) && (line.size() == word.size() || line[word.size()] == ' ');
  return begins ? std::optional(trimmedLine(line.substr(word.size()))) : std::nullopt;
}

std::string runLook(const LightsContext& studio, const std::string& text) {
  if (text.empty()) throw InputError("after look write its number or name, as look 2 or look moonlight:60%");
  const LookRequest request = lookRequestFromText(text);
  const std::vector<SavedLook>& looks = studio.document().looks;
  if (const auto place = placeOfLook(looks, request.name)) {
    const SavedLook saved = looks[*place];
    studio.editor.edit(saved.name, recalled(studio.document(), saved, request.amount));
    return saved.name;
  }
  if (numberFromText(request.name))
    throw InputError("there is no look {}: the gallery has {}", request.name, looks.size());
  const Rig before = studio.document().rig;
  const Look& preset = findLook(request.name, looks);
  editRig(studio, preset.name,
          blendRigs(before, applyLook(before, preset, lightRatios(studio)), request.amount));
  return preset.name;
}

std::string runRecord(const LightsContext& studio, CuePlayer& cues, const std::string& text) {
  const int number = recordCueLine(studio, text);
  cues.stand(number);
  return "Recorded cue " + cueNumberText(number);
}

std::string runAction(const LightsContext& studio, const Action& action) {
  if (!studio.actions.run(action.id)) throw InputError("{}: cannot be done now", action.name);
  return action.name;
}

std::vector<size_t> chosenLights(const LightsContext& studio) {
  return lightsFor(studio, shownLight(studio));
}

void choose(const LightsContext& studio, const std::vector<size_t>& lights) {
  studio.view.selectedLight = static_cast<int>(lights.front());
  studio.view.selectedLights.clear();
  if (lights.size() > 1) studio.view.selectedLights.insert(lights.begin(), lights.end());
}

std::string runOnLights(const LightsContext& studio, const std::string& line) {
  const Rig& rig = studio.document().rig;
  if (rig.lights.empty()) throw InputError("open a set first: there are no lights");
  const LightCommand command = lightCommand(rig, line, chosenLights(studio));
  choose(studio, command.lights);
  if (command.changes) editRig(studio, line, command.rig);
  std::vector<std::string> names;
  for (const size_t i : command.lights) names.push_back(rig.lights[i].title());
  return fmt::format("{}{}", fmt::join(names, ", "), command.changes ? "" : " selected");
}

void addEnd(StudioCommandEnds& ends, const std::string& beginning, const std::string& word) {
  if (lowerCase(word).starts_with(lowerCase(beginning)) && ends.words.size() < kMostEnds)
    ends.words.push_back(word);
}

StudioCommandEnds lookEnds(const LightsContext& studio, const std::string& line,
                           const std::string& beginning) {
  StudioCommandEnds ends{line.size() - beginning.size(), {}};
  for (const SavedLook& look : studio.document().looks) addEnd(ends, beginning, look.name);
  for (const Look& look : presetLooks()) addEnd(ends, beginning, look.name);
  return ends;
}

StudioCommandEnds cueEnds(const std::string& line) {
  StudioCommandEnds ends{line.rfind(' ') + 1, {}};
  for (const char* word : {"time", "follow", "look", "number", "remove", "thru", "off"})
    addEnd(ends, line.substr(ends.from), word);
  return ends;
}

}  // namespace

std::string runStudioCommand(const LightsContext& studio, CuePlayer& cues, const std::string& line) {
  const std::string command = trimmedLine(line);
  if (const auto where = after(command, "go")) return cues.go(studio, *where);
  // Many sets have a light called back: then the word means that light, and "go back" goes back.
  if (const auto in = after(command, "back"); in && !lightsOfWord(studio.document().rig, {"back"}))
    return cues.go(studio, trimmedLine("back " + *in));
  if (const auto cue = after(command, "cue")) return runCueLine(studio, *cue);
  if (const auto words = after(command, "record")) return runRecord(studio, cues, *words);
  if (const auto look = after(command, "look")) return runLook(studio, *look);
  for (const char* word : {"undo", "redo"})
    if (lowerCase(command) == word)
      return runAction(studio, *studio.actions.find(std::string("edit.") + word));
  if (const Action* action = studio.actions.find(command)) return runAction(studio, *action);
  return runOnLights(studio, command);
}

StudioCommandEnds studioCommandEnds(const LightsContext& studio, const std::string& line) {
  if (after(line, "cue") && line.size() > 3) return cueEnds(line);
  if (const auto look = after(line, "look"); look && line.size() > 4) return lookEnds(studio, line, *look);
  LightCommandEnds lights = lightCommandEnds(studio.document().rig, line);
  if (lights.words.size() > kMostEnds) lights.words.resize(kMostEnds);
  StudioCommandEnds ends{lights.from, std::move(lights.words)};
  if (ends.from != 0 || line.empty()) return ends;
  for (const char* word : {"go", "back", "cue", "record", "look", "undo", "redo"}) addEnd(ends, line, word);
  if (ends.words.empty())  // an action's id is the rarest of all that begins so
    for (const Action& action : studio.actions.actions()) addEnd(ends, line, action.id);
  return ends;
}

}  // namespace swaplight

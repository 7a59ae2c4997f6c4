#include "core/relight/light_command.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/lamp/gel.h"
#include "core/relight/level.h"
#include "core/relight/light_command_words.h"
#include "core/relight/rig_edit.h"
#include "core/relight/setting.h"

namespace swaplight {
namespace {

constexpr std::array kActions = {"@",      "gel",  "on",  "off",   "mute",  "unmute", "solo",
                                 "unsolo", "full", "out", "reset", "white", "green"};
constexpr std::array kBetweenLights = {"thru", "+", "-"};
constexpr std::array kLevels = {"full", "out", "10", "25", "50", "75", "-1st", "+1st"};

template <typename Change>
void changeEach(LightCommand& command, const Change& change) {
  for (const size_t i : command.lights) change(command.rig.lights[i]);
}

std::string wordAfter(LightWordReader& words, const char* what, const char* example) {
  if (words.atEnd()) throw InputError("after {} write what, as {}", what, example);
  return words.take().text;
}

void setLevelOf(LightCommand& command, LightWordReader& words) {
  std::string level = wordAfter(words, "@", "@ 50, @ full or @ -1st");
  for (const char* unit : {"st", "stop", "stops", "%"})
    if (words.takeIf({unit})) level += unit;
  command.rig = withLevel(std::move(command.rig), command.lights, wantedLevel(level, LevelUnit::Percent));
}

void setPart(LightCommand& command, const std::string& setting) {
  LightSetting tried;  // a wrong word is said even where there are no lights for it
  applySetting(tried, setting);
  changeEach(command, [&](LightSetting& light) { applySetting(light, setting); });
}

/// What is wrong with a word that is no setting, as the person meant it.
[[noreturn]] void refuse(const Rig& rig, const LightWord& word, bool first, const InputError& error) {
  if (numberFromText(word.text)) throw InputError("'{}': write @ {} for per cent", word.text, word.text);
  const bool letters = std::all_of(word.text.begin(), word.text.end(),
                                   [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (first && (letters || word.quoted))
    throw InputError("'{}' is no light and no setting: lights are {}; write as {}", word.text,
                     numberedLights(rig), kLightCommandExamples);
  throw error;
}

void applyWord(const Rig& before, LightCommand& command, LightWordReader& words, bool first) {
  const auto sets = [&](std::initializer_list<std::string_view> any) { return words.takeIf(any); };
  if (sets({"@", "at"})) {
    setLevelOf(command, words);
  } else if (sets({"gel"})) {
    setPart(command, "gel:" + wordAfter(words, "gel", "gel L201 or gel none"));
  } else if (sets({"green"})) {
    setPart(command, "green:" + wordAfter(words, "green", "green +0.25"));
  } else if (sets({"mute"})) {
    changeEach(command, [](LightSetting& light) { light.mute = true; });
  } else if (sets({"unmute"})) {
    changeEach(command, [](LightSetting& light) { light.mute = false; });
  } else if (sets({"solo"})) {
    changeEach(command, [](LightSetting& light) { light.solo = true; });
  } else if (sets({"unsolo"})) {
    changeEach(command, [](LightSetting& light) { light.solo = false; });
  } else if (sets({"reset"})) {
    changeEach(command, [](LightSetting& light) { light = resetLight(light); });
  } else {
    const LightWord word = words.take();
    try {
      setPart(command, word.text);
    } catch (const InputError& error) {
      refuse(before, word, first, error);
    }
  }
}

bool beginsWith(std::string_view word, std::string_view beginning) {
  return word.size() >= beginning.size() && sameWord(word.substr(0, beginning.size()), beginning);
}

void addFitting(std::vector<std::string>& ends, std::string_view beginning, std::string_view word) {
  const bool known =
      std::any_of(ends.begin(), ends.end(), [&](const auto& end) { return sameWord(end, word); });
  if (!word.empty() && !known && beginsWith(word, beginning)) ends.emplace_back(word);
}

void addLights(std::vector<std::string>& ends, std::string_view beginning, const Rig& rig) {
  const auto add = [&](const std::string& name) {
    const bool plain =
        std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::isspace(c); });
    addFitting(ends, beginning, plain ? name : '"' + name + '"');
  };
  for (const LightSetting& light : rig.lights) add(light.light);
  for (const LightSetting& light : rig.lights) add(light.label);
  for (const LightGroup& group : rig.groups) add(group.name);
  add("all");
}

}  // namespace

LightCommand lightCommand(const Rig& rig, std::string_view line, std::span<const size_t> chosen) {
  LightWordReader words(lightWords(line));
  LightCommand command{{}, rig, false};
  if (words.atEnd())
    throw InputError("write which lights and what becomes of them: {}", kLightCommandExamples);
  const auto named = takeLights(rig, words);
  command.lights = named ? *named : std::vector<size_t>(chosen.begin(), chosen.end());
  bool first = !named;
  while (!words.atEnd()) {
    applyWord(rig, command, words, std::exchange(first, false));
    command.changes = true;
  }
  if (command.lights.empty())
    throw InputError("name the lights first, as in {}; lights are {}", kLightCommandExamples,
                     numberedLights(rig));
  return command;
}

LightCommandEnds lightCommandEnds(const Rig& rig, std::string_view line) {
  LightCommandEnds ends;
  const size_t last = line.find_last_of(" ,@+\t");
  ends.from = last == std::string_view::npos ? 0 : last + 1;
  const std::string_view beginning = line.substr(ends.from);
  std::vector<LightWord> before;
  try {
    before = lightWords(line.substr(0, ends.from));
  } catch (const InputError&) {
    return ends;  // within quotes
  }
  const auto add = [&](const auto& words) {
    for (const auto& word : words) addFitting(ends.words, beginning, word);
  };
  if (!before.empty() && sameWord(before.back().text, "gel")) {
    addFitting(ends.words, beginning, "none");
    for (const Gel& gel : allGels()) addFitting(ends.words, beginning, gel.id);
    return ends;
  }
  if (!before.empty() && (before.back().text == "@" || sameWord(before.back().text, "at"))) {
    add(kLevels);
    return ends;
  }
  LightWordReader words(before);
  bool named = false, open = true;  // open: a light may follow
  try {
    named = before.empty() ? false : takeLights(rig, words).has_value();
    open = words.atEnd();
  } catch (const InputError&) {
    named = false;  // ends with an operator, after which a light comes
  }
  if (open) addLights(ends.words, beginning, rig);
  if (named && open) add(kBetweenLights);
  add(kActions);
  return ends;
}

}  // namespace swaplight

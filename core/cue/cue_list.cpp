#include "core/cue/cue_list.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"
#include "core/look/look.h"

namespace swaplight {
namespace {

constexpr size_t kMostCues = 1000;
constexpr double kHundred = 100;

std::optional<int> hundredths(double number) {
  const double all = std::round(number * kHundred);
  const bool whole = std::abs(number * kHundred - all) < 0.1;  // float's error at the largest number: 0.05
  return whole && all >= 1 && all <= kMostCueNumber ? std::optional(static_cast<int>(all)) : std::nullopt;
}

CueList::iterator placeOf(CueList& cues, int number) {
  return std::lower_bound(cues.begin(), cues.end(), number,
                          [](const Cue& cue, int wanted) { return cue.number < wanted; });
}

Cue cueFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  const auto id = fields.number("id", 0, kMostCueNumber / kHundred);
  const auto number = id ? hundredths(*id) : std::nullopt;
  const auto look = fields.text("look");
  if (!number || !look)
    throw InputError("{}: give {{\"id\": 1, \"look\": \"a look of the gallery\"}}; ids are 0.01 to 9999",
                     where);
  Cue cue{*number, *look};
  if (const auto fade = fields.number("fade", 0, kMostCueSeconds))
    cue.fadeSeconds = static_cast<float>(*fade);
  if (const auto follow = fields.number("follow", 0, kMostCueSeconds))
    cue.followSeconds = static_cast<float>(*follow);
  return cue;
}

}  // namespace

const Cue* findCue(const CueList& cues, int number) {
  const auto found =
      std::find_if(cues.begin(), cues.end(), [&](const Cue& cue) { return cue.number == number; });
  return found == cues.end() ? nullptr : &*found;
}

const Cue* cueAfter(const CueList& cues, std::optional<int> number) {
  const auto found =
      std::find_if(cues.begin(), cues.end(), [&](const Cue& cue) { return !number || cue.number > *number; });
  return found == cues.end() ? nullptr : &*found;
}

const Cue* cueBefore(const CueList& cues, std::optional<int> number) {
  const Cue* before = nullptr;
  for (const Cue& cue : cues)
    if (number && cue.number < *number) before = &cue;
  return before;
}

int freeCueNumber(const CueList& cues) {
  constexpr int kWhole = 100;
  if (cues.empty()) return kWhole;
  int number = std::min((cues.back().number / kWhole + 1) * kWhole, kMostCueNumber);
  while (findCue(cues, number)) --number;  // behind the last number there is none
  return number;
}

CueList withCue(CueList cues, Cue cue) {
  const auto place = placeOf(cues, cue.number);
  if (place != cues.end() && place->number == cue.number)
    *place = std::move(cue);
  else
    cues.insert(place, std::move(cue));
  return cues;
}

CueList withoutCue(CueList cues, int number) {
  std::erase_if(cues, [&](const Cue& cue) { return cue.number == number; });
  return cues;
}

CueList withLookRenamed(CueList cues, const std::string& name, const std::string& next) {
  for (Cue& cue : cues)
    if (sameLookName(cue.look, name)) cue.look = next;
  return cues;
}

CueList withoutLook(CueList cues, const std::string& name) {
  std::erase_if(cues, [&](const Cue& cue) { return sameLookName(cue.look, name); });
  return cues;
}

const SavedLook& lookOf(const Cue& cue, const std::vector<SavedLook>& looks) {
  if (const SavedLook* look = findSavedLook(looks, cue.look)) return *look;
  throw InputError("cue {}: the gallery has no look \"{}\" (any more): give the cue another one",
                   cueNumberText(cue.number), cue.look);
}

std::string cueNumberText(int number) {
  return fmt::format("{}", number / kHundred);
}

std::optional<int> cueNumberFromText(const std::string& text) {
  const auto number = numberFromText(text);
  return number ? hundredths(*number) : std::nullopt;
}

std::string cueNumbersText(const CueList& cues) {
  std::vector<std::string> numbers;
  for (const Cue& cue : cues) numbers.push_back(cueNumberText(cue.number));
  return numbers.empty() ? "none" : fmt::format("{}", fmt::join(numbers, ", "));
}

Json jsonFromCues(const CueList& cues) {
  Json json = Json::array();
  for (const Cue& cue : cues) {
    json.push_back(
        {{"id", cue.number / kHundred}, {"look", cue.look}, {"fade", jsonNumber(cue.fadeSeconds)}});
    if (cue.followSeconds) json.back()["follow"] = jsonNumber(*cue.followSeconds);
  }
  return json;
}

CueList cuesFromJson(const Json& json, const std::string& where) {
  if (!json.is_array()) throw InputError("{}s: must be a list of cues", where);
  if (json.size() > kMostCues)
    throw InputError("{}s: are {}, expected at most {}", where, json.size(), kMostCues);
  CueList cues;
  for (const Json& entry : json) {
    Cue cue = cueFromJson(entry, fmt::format("{} {}", where, cues.size() + 1));
    if (findCue(cues, cue.number))
      throw InputError("{}s: there are two with the id {}", where, cueNumberText(cue.number));
    cues = withCue(std::move(cues), std::move(cue));
  }
  return cues;
}

}  // namespace swaplight

#include "core/cue/cue_command.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/look/look_place.h"
#include "core/relight/light_command_words.h"

namespace swaplight {
namespace {

float secondsFromWord(std::string text, const char* what, const char* example) {
  if (text.ends_with('s')) text.pop_back();
  const std::optional<float> seconds = numberFromText(text);
  if (!seconds || *seconds < 0 || *seconds > kMostCueSeconds)
    throw InputError("'{}' is no {}: write seconds from 0 to {:.0f}, as {}", text, what, kMostCueSeconds,
                     example);
  return *seconds;
}

std::string nextWord(LightWordReader& words, const char* after, const char* example) {
  if (words.atEnd()) throw InputError("after {} write what, as {}", after, example);
  return words.take().text;
}

int takeNumber(LightWordReader& words) {
  const std::string text = nextWord(words, "cue", kCueExamples);
  const auto number = cueNumberFromText(text);
  if (!number) throw InputError("'{}' is no number of a cue: write as {}", text, kCueExamples);
  return *number;
}

/// The cues that the line is about; one that is not there yet where it names only that.
std::vector<int> takeCues(const CueList& cues, LightWordReader& words) {
  const int first = takeNumber(words);
  if (!words.takeIf({"thru", "through", ">"})) return {first};
  const int last = takeNumber(words);
  std::vector<int> numbers;
  for (const Cue& cue : cues)
    if (cue.number >= std::min(first, last) && cue.number <= std::max(first, last))
      numbers.push_back(cue.number);
  if (numbers.empty())
    throw InputError("there is no cue from {} to {}: cues are {}", cueNumberText(first), cueNumberText(last),
                     cueNumbersText(cues));
  return numbers;
}

/// By its name, of several words where the gallery has such a one, or its place.
const SavedLook& takeLook(const std::vector<SavedLook>& looks, LightWordReader& words) {
  const std::string first = nextWord(words, "look", "cue 3 look 2 or cue 3 look Night");
  std::string name = first;
  for (;;) {
    if (const auto place = placeOfLook(looks, name)) return looks[*place];
    if (words.atEnd() || numberFromText(name)) break;
    name += ' ';
    name += words.take().text;
  }
  throw InputError("'{}' is no look of the gallery, which has {}: its number or its name", name,
                   looks.size());
}

/// Changes of a list, one word of the line after the other.
class CueChange {
 public:
  CueChange(CueList cues, const std::vector<SavedLook>& looks, std::vector<int> numbers)
      : m_cues(std::move(cues)), m_looks(looks), m_numbers(std::move(numbers)) {}

  void apply(LightWordReader& words) {
    if (words.takeIf({"look", "version"})) {
      setLook(takeLook(m_looks, words));
    } else if (words.takeIf({"time", "fade", "in"})) {
      const float seconds = secondsFromWord(nextWord(words, "time", "cue 3 time 4"), "time", "cue 3 time 4");
      each([&](Cue& cue) { cue.fadeSeconds = seconds; });
    } else if (words.takeIf({"follow"})) {
      setFollow(words);
    } else if (words.takeIf({"number"})) {
      move(takeNumber(words));
    } else if (words.takeIf({"remove", "delete"})) {
      each([](Cue&) {});
      for (const int number : m_numbers) m_cues = withoutCue(std::move(m_cues), number);
    } else {
      throw InputError("'{}' is nothing that a cue has: write {}", words.peek().text, kCueExamples);
    }
  }

  CueList m_cues;

 private:
  template <typename Change>
  void each(const Change& change) {
    for (const int number : m_numbers) {
      const Cue* cue = findCue(m_cues, number);
      if (!cue)
        throw InputError("there is no cue {}: cues are {}; cue {} look 1 adds it", cueNumberText(number),
                         cueNumbersText(m_cues), cueNumberText(number));
      Cue changed = *cue;
      change(changed);
      m_cues = withCue(std::move(m_cues), std::move(changed));
    }
  }

  void setLook(const SavedLook& look) {
    for (const int number : m_numbers) {
      const Cue* known = findCue(m_cues, number);
      Cue cue = known ? *known : Cue{number, {}};
      cue.look = look.name;
      m_cues = withCue(std::move(m_cues), std::move(cue));
    }
  }

  void setFollow(LightWordReader& words) {
    std::optional<float> seconds;
    if (!words.takeIf({"off", "none"}))
      seconds = secondsFromWord(nextWord(words, "follow", "cue 3 follow 2"), "wait",
                                "cue 3 follow 2 or follow off");
    each([&](Cue& cue) { cue.followSeconds = seconds; });
  }

  void move(int number) {
    if (m_numbers.size() > 1) throw InputError("number is of one cue: cue 3 number 2.5");
    if (number != m_numbers.front() && findCue(m_cues, number))
      throw InputError("there is a cue {} already: cues are {}", cueNumberText(number),
                       cueNumbersText(m_cues));
    Cue moved;
    each([&](Cue& cue) { moved = cue; });
    m_cues = withoutCue(std::move(m_cues), m_numbers.front());
    moved.number = number;
    m_cues = withCue(std::move(m_cues), std::move(moved));
    m_numbers = {number};
  }

  const std::vector<SavedLook>& m_looks;
  std::vector<int> m_numbers;
};

}  // namespace

GoRequest goRequestFromText(const std::string& text) {
  GoRequest request;
  std::string name = " " + text;
  if (const size_t in = name.rfind(" in "); in != std::string::npos) {
    std::string seconds = name.substr(in + 4);
    while (!seconds.empty() && seconds.back() == ' ') seconds.pop_back();
    request.seconds = secondsFromWord(std::move(seconds), "fade time", "go 3 in 2.5");
    name.resize(in);
  }
  name.erase(0, name.find_first_not_of(' '));
  while (!name.empty() && name.back() == ' ') name.pop_back();
  if (name.empty() || name == "next") return request;
  request.where = name == "back" ? GoRequest::Where::Back : GoRequest::Where::Named;
  request.name = name;
  return request;
}

const Cue& cueOfRequest(const CueList& cues, const GoRequest& request, std::optional<int> current,
                        std::optional<int> loaded) {
  if (cues.empty()) throw InputError("the cue list is empty: record makes a cue of what is there");
  const Cue* cue = nullptr;
  switch (request.where) {
    case GoRequest::Where::Next:
      cue = loaded ? findCue(cues, *loaded) : nullptr;
      if (!cue) cue = cueAfter(cues, current);
      if (!cue) throw InputError("cue {} is the last one: go 1 begins again", cueNumberText(*current));
      break;
    case GoRequest::Where::Back:
      cue = cueBefore(cues, current);
      if (!cue) throw InputError("there is no cue before: cues are {}", cueNumbersText(cues));
      break;
    case GoRequest::Where::Named: {
      const auto number = cueNumberFromText(request.name);
      cue = number ? findCue(cues, *number) : nullptr;
      for (const Cue& other : cues)
        if (!cue && sameWord(other.look, request.name)) cue = &other;
      if (!cue) throw InputError("there is no cue {}: cues are {}", request.name, cueNumbersText(cues));
      break;
    }
  }
  return *cue;
}

CueCommand cueCommand(const CueList& cues, const std::vector<SavedLook>& looks, std::string_view line) {
  LightWordReader words(lightWords(line));
  const std::vector<int> numbers = takeCues(cues, words);
  if (words.atEnd())
    throw InputError("say what becomes of cue {}: {}; go {} goes to it", cueNumberText(numbers.front()),
                     kCueExamples, cueNumberText(numbers.front()));
  CueChange change(cues, looks, numbers);
  while (!words.atEnd()) change.apply(words);
  std::vector<std::string> named;
  for (const int number : numbers) named.push_back(cueNumberText(number));
  return {std::move(change.m_cues),
          fmt::format("{} {}", named.size() == 1 ? "Cue" : "Cues", fmt::join(named, ", "))};
}

}  // namespace swaplight

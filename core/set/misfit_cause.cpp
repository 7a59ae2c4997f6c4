#include "core/set/misfit_cause.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/json.h"

namespace swaplight {
namespace {

/// A cause in a file, and in words.
struct CauseText {
  Cause cause;
  const char* name;
  const char* found;   ///< "{}": how large
  const char* remedy;  ///< what to do
};

/// Of two channels at the picture's edges, over the RMS of all three over the picture, of a drift across it.
constexpr double kEdgeOfDrift = 2.1;

constexpr std::array<CauseText, 5> kTexts = {{
    {Cause::Colors, "colors", "lights of other colours than told (by about {:.0f} %)",
     "check which lamp had which gel, and the gels' colours"},
    {Cause::Ambient, "ambient", "ambient light, about {:.1f} % of the lamps' light",
     "take a picture with all lamps off, or one more photograph under other light and solve for ambient "
     "light (--solve-ambient)"},
    {Cause::Tone, "tone", "a tone curve that was not told (light to the power of about {:.2f})",
     "let the solve take the curve off (--tone auto), or photograph raw"},
    {Cause::Moved, "moved", "a camera that moved (by {:.1f} pixels or more)",
     "align the photographs (--align on)"},
    {Cause::Field, "field", "lamps whose colour is not the same over the picture (by about {:.0f} %)",
     "even them in the solve (--field), or photograph a grey card under each lamp (--flat)"},
}};

const CauseText& textOf(Cause cause) {
  return *std::find_if(kTexts.begin(), kTexts.end(),
                       [&](const CauseText& text) { return text.cause == cause; });
}

/// No curve is taken off where ambient light may be what looks like one.
const char* remedyOf(Cause cause, const MisfitCauses& causes, const TriedRemedies& tried) {
  if (cause == Cause::Moved && tried.aligned)
    return "registering them has not ended it: take them again, or leave out the one that moved";
  if (cause == Cause::Tone && tried.toneTaken) return "one was taken off, and that is left: photograph raw";
  const bool ambient =
      std::find(causes.likely.begin(), causes.likely.end(), Cause::Ambient) != causes.likely.end();
  return cause == Cause::Tone && ambient ? "photograph raw" : textOf(cause).remedy;
}

/// As it is said.
double spokenSize(const CauseEvidence& evidence) {
  switch (evidence.cause) {
    case Cause::Tone:
      return 1 + evidence.size;
    case Cause::Moved:
      return evidence.size;
    case Cause::Colors:
    case Cause::Ambient:
    case Cause::Field:
      break;
  }
  return 100 * evidence.size;
}

std::string foundWords(const CauseEvidence& evidence) {
  // An S about the middle leaves it no power of light to speak of.
  if (evidence.cause == Cause::Tone && std::abs(evidence.size) < .005)
    return "a tone curve that was not told (more or less contrast)";
  return fmt::format(fmt::runtime(textOf(evidence.cause).found), spokenSize(evidence));
}

/// What of a cause goes unseen, rounded up.
std::string unseenOf(const CauseSight& sight) {
  const double from = sight.from.value_or(0);
  const double percent = std::ceil(100 * from);
  switch (sight.cause) {
    case Cause::Colors:
      return "wrong colours of the lights";
    case Cause::Ambient:
      return sight.from ? fmt::format("ambient light below {:.0f} % of the lamps' light", percent)
                        : "ambient light, even if it is strong";
    case Cause::Tone:
      return sight.from ? fmt::format("a tone curve (light to the power of {:.2f} to {:.2f})",
                                      1 - percent / 100, 1 + percent / 100)
                        : "a tone curve, even a strong one";
    case Cause::Field:
      return sight.from ? fmt::format("lamps whose colour drifts over the picture by less than ±{:.0f} %",
                                      std::ceil(kEdgeOfDrift * 100 * from))
                        : "lamps whose colour drifts over the picture, even by much";
    case Cause::Moved:
      break;
  }
  return "";
}

std::optional<Cause> causeFromName(const std::string& name) {
  for (const CauseText& text : kTexts)
    if (name == text.name) return text.cause;
  return std::nullopt;
}

/// Above 0, and at most 1.
bool isPart(const Json& json) {
  return json.is_number() && json.get<double>() > 0 && json.get<double>() <= 1;
}

/// Nothing where it is not as this program writes it.
std::optional<CauseEvidence> evidenceFromJson(const Json& json) {
  if (!json.is_object() || !json.contains("cause") || !json["cause"].is_string()) return std::nullopt;
  const std::optional<Cause> cause = causeFromName(json["cause"].get<std::string>());
  if (!cause) return std::nullopt;
  const auto number = [&](const char* key) {
    return json.contains(key) && json[key].is_number() ? json[key].get<double>() : 0.0;
  };
  return CauseEvidence{*cause,           number("explained"), number("gain"), number("certainty"),
                       number("behind"), number("size")};
}

}  // namespace

Json jsonFromMisfitCauses(const MisfitCauses& causes) {
  Json all = Json::array();
  Json likely = Json::array();
  for (const CauseEvidence& one : causes.all)
    all.push_back({{"cause", causeName(one.cause)},
                   {"explained", one.explained},
                   {"gain", one.gain},
                   {"certainty", one.certainty},
                   {"behind", one.behind},
                   {"size", one.size}});
  for (const Cause cause : causes.likely) likely.push_back(causeName(cause));
  Json json = {{"likely", likely}, {"unnamed", causes.unnamed}, {"all", all}};
  for (const CauseSight& one : causes.sight)
    json["seen_from"][causeName(one.cause)] = one.from ? Json(*one.from) : Json();
  return json;
}

MisfitCauses misfitCausesFromJson(const Json& json) {
  MisfitCauses causes;
  if (!json.is_object()) return causes;
  if (json.contains("all") && json["all"].is_array())
    for (const Json& one : json["all"])
      if (const auto evidence = evidenceFromJson(one)) causes.all.push_back(*evidence);
  if (json.contains("likely") && json["likely"].is_array())
    for (const Json& name : json["likely"])
      if (const auto cause = name.is_string() ? causeFromName(name.get<std::string>()) : std::nullopt)
        causes.likely.push_back(*cause);
  causes.unnamed = json.contains("unnamed") && json["unnamed"] == true;
  if (json.contains("seen_from") && json["seen_from"].is_object())
    for (const auto& [name, from] : json["seen_from"].items())
      if (const auto cause = causeFromName(name); cause && (from.is_null() || isPart(from)))
        causes.sight.push_back({*cause, from.is_null() ? std::nullopt : std::optional(from.get<double>())});
  return causes;
}

const char* causeName(Cause cause) {
  return textOf(cause).name;
}

std::string wordsFor(const MisfitCauses& causes, const TriedRemedies& tried) {
  std::vector<std::string> found, remedies;
  for (const Cause cause : causes.likely) {
    const auto evidence = std::find_if(causes.all.begin(), causes.all.end(),
                                       [&](const CauseEvidence& one) { return one.cause == cause; });
    if (evidence == causes.all.end()) continue;
    found.push_back(foundWords(*evidence));
    remedies.emplace_back(remedyOf(cause, causes, tried));
  }
  if (found.empty() && causes.unnamed)
    return "the photographs do not go together as told, and it cannot be told why: a tone curve of the "
           "camera, other colours of the lights or ambient light. Photograph raw, check which lamp had which "
           "gel, or take one more photograph under other light";
  if (found.empty()) return "";
  if (found.size() == 1)
    return fmt::format("the photographs look as under {}: {}", found.front(), remedies.front());
  return fmt::format("the photographs look as under {}, it cannot be told which: {}",
                     fmt::join(found, " or "), fmt::join(remedies, "; or "));
}

std::string unseenWords(const MisfitCauses& causes) {
  std::vector<std::string> unseen;
  for (const CauseSight& one : causes.sight)
    if (std::string words = unseenOf(one); !words.empty()) unseen.push_back(std::move(words));
  if (unseen.empty()) return "";
  return fmt::format("Might go unseen in these photographs: {}.", fmt::join(unseen, "; "));
}

}  // namespace swaplight

#include "ui/state/compare_state.h"

#include <algorithm>

#include "core/base/json.h"
#include "ui/state/enum_names.h"

namespace swaplight {
namespace {

constexpr std::array<const char*, 5> kModeNames = {"off", "wipe", "split", "difference", "b"};

}  // namespace

Json jsonFromCompareState(const CompareState& state) {
  Json json{{"mode", nameOfEnum(kModeNames, state.mode)},
            {"subject", nameOfEnum(kSubjectNames, state.subject.kind)},
            {"index", state.subject.index},
            {"line", {state.x, state.y, state.angleDegrees}}};
  if (state.rig) json["rig"] = jsonFromRig(*state.rig);
  return json;
}

CompareState compareStateFromJson(const Json& json) {
  CompareState state;
  state.mode = enumOfName(kModeNames, json.value("mode", ""), CompareState::Mode::Off);
  state.subject.kind = enumOfName(kSubjectNames, json.value("subject", ""), ViewSubject::Kind::Relit);
  state.subject.index = std::max(0, json.value("index", 0));
  if (json.contains("line")) {
    state.x = json["line"].at(0);
    state.y = json["line"].at(1);
    state.angleDegrees = json["line"].at(2);
  }
  if (json.contains("rig")) state.rig = rigFromJson(json["rig"]);
  return state;
}

}  // namespace swaplight

#include "core/edit/apply/prepared_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/edit/stack/curve.h"

namespace swaplight {
namespace {

constexpr int kCurveSteps = 1025;

std::vector<int> chosenLights(const Edit& edit, const EditedLights& lights) {
  std::vector<int> chosen;
  const int count = static_cast<int>(lights.names.size());
  for (int i = 0; i < count; ++i)
    if (edit.lights.empty() ||
        std::count(edit.lights.begin(), edit.lights.end(), lights.names[static_cast<size_t>(i)]))
      chosen.push_back(i);
  for (const std::string& name : edit.lights)
    if (!std::count(lights.names.begin(), lights.names.end(), name))
      throw InputError("edit \"{}\" is for the light \"{}\", which the set does not have: its lights are {}.",
                       edit.name, name, fmt::join(lights.names, ", "));
  return chosen;
}

int zoneOf(const Operation& operation, int width) {
  const auto* shadow = std::get_if<ShadowOperation>(&operation);
  return shadow ? shadowZone(*shadow, width) : 0;
}

}  // namespace

int PreparedEdit::reach() const {
  if (!isActive()) return 0;
  if (const auto* blur = std::get_if<BlurOperation>(&edit->operation)) return blur->radius;
  if (const auto* sharpen = std::get_if<SharpenOperation>(&edit->operation)) return sharpen->radius;
  return 0;
}

std::optional<BetaRequest> betaRequest(const Edit& edit, const EditedLights& lights) {
  const auto* picture = std::get_if<PictureOperation>(&edit.operation);
  if (!picture) return std::nullopt;
  BetaRequest request{*picture, {}, lights.width, lights.height};
  for (const int i : chosenLights(edit, lights))
    request.lights.push_back(lights.names[static_cast<size_t>(i)]);
  return request;
}

void checkBeta(const Edit& edit, const EditedLights& lights, const BetaMaps& beta) {
  const auto& picture = std::get<PictureOperation>(edit.operation);
  if (edit.meaning == Meaning::Share)
    checkProportions(beta, beta.maps.size() == lights.names.size(), picture.file);
}

PreparedEdit prepareEdit(std::shared_ptr<const Edit> edit, const EditedLights& lights, MaskGround& ground,
                         BetaFiles& files, const PreparedEdit* earlier) {
  const ShadowSource& shadows = ground.shadows();
  PreparedEdit prepared;
  prepared.lights = chosenLights(*edit, lights);
  const int zone = zoneOf(edit->operation, lights.width);
  if (earlier && earlier->edit->mask == edit->mask && zoneOf(earlier->edit->operation, lights.width) == zone)
    prepared.mask = earlier->mask;
  else
    prepared.mask = std::make_shared<PreparedMask>(edit->mask, ground, zone);
  if (const auto* curve = std::get_if<CurveOperation>(&edit->operation)) {
    prepared.curve = curveTable(curve->points, kCurveSteps);
  } else if (const auto request = betaRequest(*edit, lights)) {
    prepared.beta = files.maps(*request);
    checkBeta(*edit, lights, *prepared.beta);
  } else if (const auto* shadow = std::get_if<ShadowOperation>(&edit->operation)) {
    if (!shadows) throw InputError("the edit \"{}\" uses shadows, which are not at hand here.", edit->name);
    const auto* before = earlier ? std::get_if<ShadowOperation>(&earlier->edit->operation) : nullptr;
    if (before && earlier->lights == prepared.lights && sameShadowChange(*before, *shadow))
      prepared.shadows = earlier->shadows;
    else
      for (const int i : prepared.lights)
        prepared.shadows.push_back(shadowChange(*shadow, shadows(lights.names[static_cast<size_t>(i)])));
  }
  prepared.edit = std::move(edit);
  return prepared;
}

}  // namespace swaplight

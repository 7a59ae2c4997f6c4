#include "core/intake/capture_draft.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/capture/flat_fields.h"
#include "core/capture/left_out.h"
#include "core/capture/light_name.h"
#include "core/intake/kept_description.h"

namespace swaplight {
namespace {

std::vector<Light> lightsOf(const CaptureDraft& draft) {
  std::vector<Light> lights;
  bool anyRole = false;
  for (const std::string& name : draft.lights) {
    Light light;
    light.name = name;
    for (const Role role :
         {Role::Key, Role::Fill, Role::Back, Role::Practical, Role::Kicker, Role::Background})
      if (roleName(role) == name) light.role = role;
    anyRole = anyRole || light.role != Role::Other;
    lights.push_back(std::move(light));
  }
  if (anyRole) return lights;
  const Role roles[] = {Role::Key, Role::Fill, Role::Back};
  for (size_t i = 0; i < std::min<size_t>(lights.size(), 3); ++i) lights[i].role = roles[i];
  return lights;
}

}  // namespace

std::vector<float> exposuresOf(const CaptureDraft& draft) {
  if (!draft.brackets.stops.empty()) return draft.brackets.stops;
  const ShotFolder& folder = draft.folder;
  std::vector<float> stops(folder.shots.size(), 0);
  for (const FoundShot& shot : folder.shots)
    if (!shot.exposureStops) return stops;
  for (size_t k = 0; k < stops.size(); ++k)
    stops[k] = static_cast<float>(
        std::round(20 * (*folder.shots[k].exposureStops - *folder.shots[0].exposureStops)) / 20);
  return stops;
}

CaptureDraft draftOf(const ShotFolder& folder, const std::vector<std::string>& lights) {
  checkLightNames(lights, "the lights");
  if (lights.empty()) throw InputError("name at least one light");
  CaptureDraft draft{folder, lights, {}, colorSpaceOf(folder), {}, {}, {}, {}, {}, {}};
  if (folder.response && draft.colorSpace == "srgb") draft.colorSpace = *folder.response;
  for (const auto& [light, name] : folder.flats)
    if (std::find(lights.begin(), lights.end(), light) != lights.end()) draft.flats[light] = name;
  draft.vignetting = folder.vignetting.value_or("");
  draft.crossed = crossedIn(folder.folder / "capture.json");
  for (const std::string& file : folder.leftOut) {
    Shot shot;
    shot.image = file;
    shot.lightColors.resize(lights.size());
    draft.leftOut.push_back(std::move(shot));
  }
  draft.colors.assign(folder.shots.size(), std::vector<ShotColor>(lights.size(), ShotColor{"unknown", {}}));
  return draft;
}

void setBrackets(CaptureDraft& draft, Brackets brackets) {
  draft.brackets = std::move(brackets);
  for (size_t lighting = 0; lighting < draft.lightings(); ++lighting)
    setLighting(draft, lighting, std::vector<ShotColor>(draft.lights.size(), ShotColor{"unknown", {}}));
}

void setLighting(CaptureDraft& draft, size_t lighting, std::vector<ShotColor> colors) {
  const auto length = static_cast<size_t>(draft.brackets.length);
  if (length > 1)
    for (size_t i = 0; i < colors.size(); ++i)
      if (!colors[i].color && colors[i].name().empty())
        colors[i].text = fmt::format("?{}_{}", draft.lights[i], lighting + 1);
  for (size_t k = lighting * length; k < (lighting + 1) * length; ++k) draft.colors[k] = colors;
}

ShotColor colorOfCard(const CaptureDraft& draft, const CapturePixels& pixels, size_t lighting, int x, int y) {
  const auto length = static_cast<size_t>(draft.brackets.length);
  const std::vector<float> exposures = exposuresOf(draft);
  std::vector<size_t> longestFirst(length);
  std::iota(longestFirst.begin(), longestFirst.end(), lighting * length);
  std::sort(longestFirst.begin(), longestFirst.end(),
            [&](size_t a, size_t b) { return exposures[a] > exposures[b]; });
  ShotColor card;
  for (const size_t k : longestFirst) {
    card = colorOfCard(pixels.shots[k], x, y);
    const Rgb seen = *card.color;
    if (exposures[k] != 0) card = shotColorFromRgb(seen * std::exp2(-exposures[k]));
    // A mean this near to the clip level has clipped pixels in it.
    if (constexpr float kSafe = 0.9F; std::max({seen.r, seen.g, seen.b}) < kSafe * pixels.clipLevel[k]) break;
  }
  return card;
}

Capture captureOf(const CaptureDraft& draft) {
  Capture capture;
  capture.folder = draft.folder.folder;
  capture.name = capture.folder.filename().string();
  capture.colorSpace = draft.colorSpace;
  capture.lights = lightsOf(draft);
  capture.ambient = draft.folder.ambient;
  capture.dark = draft.folder.dark;
  capture.frame = draft.frame;
  const std::vector<float> exposures = exposuresOf(draft);
  for (size_t k = 0; k < draft.folder.shots.size(); ++k) {
    Shot shot;
    shot.image = draft.folder.shots[k].file;
    bool anyName = false;
    for (const ShotColor& color : draft.colors[k]) {
      shot.lightColors.push_back(color.color);
      shot.colorNames.push_back(color.name());
      anyName = anyName || !color.name().empty();
    }
    if (!anyName) shot.colorNames.clear();
    shot.exposureStops = exposures[k];
    shot.crossed = draft.crossed.contains(shot.image);
    capture.shots.push_back(std::move(shot));
  }
  if (!draft.leftOut.empty()) capture = withLeftOut(std::move(capture), draft.leftOut);
  return withFlats(std::move(capture), draft.flats, draft.vignetting);
}

std::filesystem::path writeDraft(const CaptureDraft& draft, bool replace) {
  std::filesystem::path file = draft.folder.folder / "capture.json";
  if (!replace && std::filesystem::exists(file))
    throw InputError("{}: is there already. Open it, or replace it with --force.", file.string());
  writeCapture(withKept(captureOf(draft), file), file);
  return file;
}

}  // namespace swaplight

#include "app/verbs/balance_work.h"

#include <algorithm>
#include <glm/common.hpp>
#include <optional>
#include <sstream>

#include "core/balance/illuminant.h"
#include "core/base/error.h"
#include "core/chart/chart_finder.h"
#include "core/chart/chart_fit.h"
#include "core/intake/shot_color.h"
#include "core/ocio/convert_color.h"
#include "core/ocio/luminance.h"

namespace swaplight {

Json jsonFromRgb(const Rgb& color) {
  return {color.r, color.g, color.b};
}

void BalanceWork::setWhite(const WhitePoint& point) {
  const std::string& space = picture.spec().colorSpace;
  white = glm::max(convertColor(*config, colorOfWhite(point), "lin_rec709", space), Rgb(0));
  weights = luminanceWeights(space);
  white /= white.r * weights.r + white.g * weights.g + white.b * weights.b;
  json["white"] = textFromWhitePoint(point);
}

void balanceByCard(BalanceWork& work, const std::string& place) {
  std::istringstream text(place);
  int x = 0, y = 0, side = 9;
  char comma = 0, second = ',';
  const bool two = bool(text >> x >> comma >> y) && comma == ',';
  const bool three = two && (text >> std::ws).eof() ? true : bool(text >> second >> side) && second == ',';
  if (!two || !three || !(text >> std::ws).eof() || side < 1 || side > 4096)
    throw InputError("--grey {}: write X,Y or X,Y,SIDE, the pixel and size of a grey card", place);
  const ShotColor card = colorOfCard(work.picture, x, y, side);
  work.picture = balanceByColor(work.picture, *card.color, work.white, work.weights);
  work.json["card"] = jsonFromRgb(*card.color);
}

void balanceByChart(BalanceWork& work, const WhitePoint& white, const Progress& progress) {
  const std::optional<ChartCorners> corners = findChart(work.picture, work.clip, progress);
  if (!corners)
    throw InputError(
        "{}: no chart found: all of a Macbeth chart of 24 patches must be seen, sharp, and its patches some "
        "15 pixels wide; or give a grey place (--grey X,Y)",
        work.photograph);
  const ChartFit fit = fitChart(readChart(work.picture, work.clip, *corners));
  work.picture = balanceByColor(work.picture, fit.light, work.white, work.weights);
  for (const std::string& warning : fit.warnings) work.warnings.push_back("the chart: " + warning);
  work.json["chart"] = jsonFromChartFit(fit);
  if (!fit.matrix) return;
  const CameraFile camera{*fit.matrix, work.picture.spec().colorSpace};
  checkWhiteFor(camera, *work.config, white);
  camera.apply(work.picture, work.white, colorOfWhite(white));
}

void checkWhiteFor(const CameraFile& camera, const ColorConfig& config, const WhitePoint& white) {
  constexpr float kLeastOfWhite = 1e-3F;  // of a channel
  const Rgb color = convertColor(config, colorOfWhite(white), "lin_rec709", camera.from);
  if (std::min({color.r, color.g, color.b}) < kLeastOfWhite)
    throw InputError(
        "--white {}: has nothing of one of the camera's channels, which its matrix divides by: name one that "
        "is less far from D65",
        textFromWhitePoint(white));
}

void correctCamera(BalanceWork& work, const CameraFile& camera, const std::string& file,
                   const WhitePoint& white) {
  const std::string& space = work.picture.spec().colorSpace;
  if (space != camera.from)
    throw InputError("--camera {}: is for photographs in {}, {} is in {}", file, camera.from, work.photograph,
                     space);
  camera.apply(work.picture, work.white, colorOfWhite(white));
  work.json["camera"] = file;
}

}  // namespace swaplight

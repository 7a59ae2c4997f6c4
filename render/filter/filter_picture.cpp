#include "render/filter/filter_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/color/srgb.h"
#include "core/file/atomic_file.h"
#include "core/image/io/image_io.h"
#include "core/image/rgb_image.h"
#include "core/ocio/color_config.h"
#include "render/filter/map_colors.h"

namespace swaplight {
namespace {

constexpr size_t kLargestCube = 256 << 20;

/// Only tables of 0..1 are drawn, and no 1-D table before them.
void checkCubeKeyword(const std::string& keyword, std::istream& values, const std::string& place) {
  if (keyword == "LUT_1D_SIZE" || keyword == "LUT_1D_INPUT_RANGE")
    throw InputError("{}: {}: a 1-D table is not drawn: write a 3-D table alone", place, keyword);
  const bool from = keyword == "DOMAIN_MIN", to = keyword == "DOMAIN_MAX";
  const bool range = keyword == "LUT_3D_INPUT_RANGE";
  if (!from && !to && !range) return;
  bool usual = true;
  float value = 0;
  for (int i = 0; values >> value; ++i) usual = usual && value == (to || (range && i == 1) ? 1 : 0);
  if (!usual)
    throw InputError("{}: {}: only a table of values from 0 to 1 is drawn: write it for those", place,
                     keyword);
}

/// A table as Adobe's "Cube LUT Specification 1.0" has it: LUT_3D_SIZE N, then N^3 lines of R G B, red
/// fastest.
Image cubeImage(const std::filesystem::path& file) {
  std::istringstream in(readFile(file, kLargestCube));
  int side = 0, lineNumber = 0;
  size_t row = 0;
  Image image;
  for (std::string line; std::getline(in, line);) {
    ++lineNumber;
    std::istringstream words(line);
    std::string first;
    if (!(words >> first) || first[0] == '#') continue;
    if (first == "LUT_3D_SIZE") {
      if (!(words >> side) || side < 2 || side > 128)
        throw InputError("{}:{}: LUT_3D_SIZE has to be 2 to 128", file.string(), lineNumber);
      image = Image(ImageSpec::rgb(side * side, side), 0);
    }
    checkCubeKeyword(first, words, fmt::format("{}:{}", file.string(), lineNumber));
    if ((first[0] >= 'A' && first[0] <= 'Z') || first[0] == '"') continue;  // TITLE, DOMAIN_MIN ...
    std::istringstream numbers(line);
    float r = 0, g = 0, b = 0;
    if (side == 0 || !(numbers >> r >> g >> b) || row >= image.pixelCount())
      throw InputError(
          "{}:{}: is \"{}\", expected {}", file.string(), lineNumber, line.substr(0, 40),
          side == 0 ? "LUT_3D_SIZE before the colours (a 3-D table)" : "three numbers, or the end");
    const int red = static_cast<int>(row) % side, green = static_cast<int>(row) / side % side;
    const int blue = static_cast<int>(row) / side / side;
    const int x = green * side + red, y = side - 1 - blue;  // the shader counts rows from below
    image.span().at(0, x, y) = r;
    image.span().at(1, x, y) = g;
    image.span().at(2, x, y) = b;
    ++row;
  }
  if (side == 0 || row != image.pixelCount())
    throw InputError("{}: holds {} colours of {}: the table is not complete", file.string(), row,
                     side == 0 ? 0 : image.pixelCount());
  return image;
}

/// R G B of the picture, and its alpha as a fourth plane.
Image withAlpha(Image&& image, const std::filesystem::path& file) {
  const int alpha = image.channelIndex("A");
  std::vector<float> plane;
  if (alpha >= 0) plane.assign(image.plane(alpha), image.plane(alpha) + image.pixelCount());
  Image rgb = rgbImage(std::move(image), file);
  if (plane.empty()) return rgb;
  ImageSpec spec = rgb.spec();
  spec.channels.emplace_back("A");
  Image all(spec);
  for (int c = 0; c < 3; ++c) std::copy_n(rgb.plane(c), rgb.pixelCount(), all.plane(c));
  std::copy(plane.begin(), plane.end(), all.plane(3));
  return all;
}

}  // namespace

Image readFilterPicture(const std::filesystem::path& file, FilterSpace space, const std::string& primaries) {
  if (lowerExtension(file) == ".cube") return cubeImage(file);
  ImageFile read = readImage(file);
  const bool light = read.info.isFloat || read.info.format == "raw";
  const bool named = light && read.info.format != "raw";
  const std::string from = named ? read.image.spec().colorSpace : "lin_rec709";
  Image image = withAlpha(std::move(read.image), file);
  if (space == FilterSpace::Any) return image;
  const bool wantsLight = space == FilterSpace::SceneLinear;
  if (!light && wantsLight) mapColors(image.span(), [](float code) { return linearFromSrgb(code); });
  const std::string to = wantsLight ? primaries : "lin_rec709";
  if ((light || wantsLight) && from != to) ColorConfig("").convert(image.span(), from, to);
  if (light && !wantsLight)
    mapColors(image.span(), [](float value) { return std::clamp(srgbFromLinear(value), 0.0F, 1.0F); });
  return image;
}

}  // namespace swaplight

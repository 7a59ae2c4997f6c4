#include "core/measure/compared_pictures.h"

#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/image/io/image_io.h"
#include "core/image/rgb_image.h"
#include "core/ocio/color_config.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

bool holds(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A picture of one channel is grey, but a map (beta.key, Z) of floating point is numbers.
bool isColor(const ImageFile& file) {
  const Names& names = file.image.spec().channels;
  if (names.size() == 1 && file.info.isFloat) return holds({"Y", "L", "I", "R", "grey", "gray"}, names[0]);
  try {
    static_cast<void>(rgbChannels(file.image, {}));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// The channels that were asked for, in the file's order.
Names chosenChannels(const Names& has, const Names& asked, const fs::path& file) {
  Names chosen;
  for (const std::string& pattern : asked)
    if (std::none_of(has.begin(), has.end(),
                     [&](const std::string& name) { return fnmatch(pattern.c_str(), name.c_str(), 0) == 0; }))
      throw InputError("{}: no channel is called {}; it has {}", file.string(), pattern,
                       fmt::join(has, ", "));
  for (const std::string& name : has)
    if (std::any_of(asked.begin(), asked.end(), [&](const std::string& pattern) {
          return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
        }))
      chosen.push_back(name);
  return chosen;
}

Image channelsOf(const Image& image, const Names& names) {
  Image some(ImageSpec{image.width(), image.height(), names, "data"});
  for (size_t i = 0; i < names.size(); ++i)
    std::copy_n(image.plane(image.channelIndex(names[i])), image.pixelCount(), some.plane(int(i)));
  return some;
}

/// What is compared as numbers: what was asked for, or all that both have.
Names commonChannels(const Image& test, const fs::path& testFile, const Image& reference,
                     const fs::path& referenceFile, const Names& asked) {
  const Names& has = test.spec().channels;
  const Names& wanted = reference.spec().channels;
  if (!asked.empty()) {
    Names chosen = chosenChannels(has, asked, testFile);
    for (const std::string& name : chosen)
      if (!holds(wanted, name))
        throw InputError("{}: has no channel {}, which {} has; it has {}", referenceFile.string(), name,
                         testFile.string(), fmt::join(wanted, ", "));
    return chosen;
  }
  Names both;
  std::copy_if(has.begin(), has.end(), std::back_inserter(both),
               [&](const std::string& name) { return holds(wanted, name); });
  if (both.empty())
    throw InputError("{} has the channels {}, {} has {}: there is none that both have. Give them one name.",
                     testFile.string(), fmt::join(has, ", "), referenceFile.string(),
                     fmt::join(wanted, ", "));
  return both;
}

/// Linear light of any primaries to those of Rec.709, for which the differences are.
void bringToRec709(Image& image) {
  const std::string from = image.spec().colorSpace;
  if (from != "lin_rec709" && from != "raw") ColorConfig("").convert(image.span(), from, "lin_rec709");
  image.setColorSpace("lin_rec709");
}

void bringTogether(PicturePair& pair, bool testEncoded, bool referenceEncoded, std::optional<float> scale) {
  pair.encoded = testEncoded && referenceEncoded;
  if (testEncoded && !referenceEncoded) linearize(pair.test);
  if (referenceEncoded && !testEncoded) linearize(pair.reference);
  if (!testEncoded) bringToRec709(pair.test);
  if (!referenceEncoded) bringToRec709(pair.reference);
  if (!testEncoded && !referenceEncoded) pair.scale = scale.value_or(displayScale(pair.reference.view()));
}

/// Primaries that are none of colorSpaceOf's.
void warnOfColors(const ImageFile& file, const fs::path& path, ComparedPictures& compared) {
  const std::string& stated = file.info.statedColors;
  if (stated.empty() || stated == file.image.spec().colorSpace) return;
  compared.warnings.push_back(fmt::format("{}: states {}, which is not known: it is compared as {}",
                                          path.string(), stated, file.info.isFloat ? "lin_rec709" : "sRGB"));
}

/// Nothing is known there.
void blankOutside(const PixelRect& window, Image& image) {
  for (int c = 0; c < image.channelCount(); ++c)
    for (int y = 0; y < image.height(); ++y) {
      float* row = image.span().row(c, y);
      const bool inside = y >= window.y && y < window.bottom();
      std::fill(row, row + (inside ? window.x : image.width()), NAN);
      if (inside) std::fill(row + window.right(), row + image.width(), NAN);
    }
}

}  // namespace

ComparedPictures readCompared(const fs::path& test, const fs::path& reference, const Names& channels,
                              std::optional<float> scale) {
  if (scale && !(std::isfinite(*scale) && *scale > 0))
    throw InputError("scale {}: give a number above 0, as the factor that linear light is shown with",
                     *scale);
  ImageFile a = readImage(test);
  ImageFile b = readImage(reference);
  if (a.image.width() != b.image.width() || a.image.height() != b.image.height())
    throw InputError("{} is {}x{}, {} is {}x{}: only pictures of one size can be compared", test.string(),
                     a.image.width(), a.image.height(), reference.string(), b.image.width(),
                     b.image.height());
  if (a.info.dataWindow && b.info.dataWindow) {
    const PixelRect whole{0, 0, a.image.width(), a.image.height()};
    const PixelRect window = intersection(enclosing(*a.info.dataWindow, *b.info.dataWindow), whole);
    blankOutside(window, a.image);
    blankOutside(window, b.image);
  }
  ComparedPictures compared;
  compared.numbers = !channels.empty() || !isColor(a) || !isColor(b);
  if (compared.numbers) {
    const Names names = commonChannels(a.image, test, b.image, reference, channels);
    compared.pair = {channelsOf(a.image, names), channelsOf(b.image, names)};
  } else {
    warnOfColors(a, test, compared);
    warnOfColors(b, reference, compared);
    compared.pair = {rgbImage(std::move(a.image), test), rgbImage(std::move(b.image), reference)};
    bringTogether(compared.pair, !a.info.isFloat, !b.info.isFloat, scale);
  }
  return compared;
}

}  // namespace swaplight

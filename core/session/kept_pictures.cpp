#include "core/session/kept_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/image/io/image_io.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr int kMostSmallPixels = 1 << 22;  ///< of a picture that is to be shown small

/// FNV-1a, 64 bits: the same in every run (http://www.isthe.com/chongo/tech/comp/fnv).
uint64_t fingerprint(const std::string& text) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3;
  return hash;
}

Image codesOf(const SmallPicture& picture) {
  Image codes(ImageSpec::rgb(picture.width, picture.height));
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < codes.pixelCount(); ++p)
      codes.plane(c)[p] = static_cast<float>(picture.rgba[4 * p + static_cast<size_t>(c)]) / 255;
  return codes;
}

}  // namespace

SmallPicture readSmallPicture(const fs::path& file) try {
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  const ImageSpec spec = readImageSpec(file);
  if (spec.pixelCount() > kMostSmallPixels || spec.channels.size() < 3) return {};
  const Image codes = readImage(file).image;
  SmallPicture picture{codes.width(), codes.height(), std::vector<uint8_t>(4 * codes.pixelCount(), 255)};
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < codes.pixelCount(); ++p)
      picture.rgba[4 * p + static_cast<size_t>(c)] =
          static_cast<uint8_t>(std::lround(255 * std::clamp(codes.plane(c)[p], 0.0F, 1.0F)));
  return picture;
} catch (const std::exception&) {
  return {};
}

fs::path KeptPictures::pictureOf(const fs::path& file) const {
  return m_folder / fmt::format("{:016x}.png", fingerprint(fs::absolute(file).lexically_normal().string()));
}

void KeptPictures::keep(const fs::path& file, const SmallPicture& picture) const try {
  if (picture.empty()) return;
  fs::create_directories(m_folder);
  writeImage(codesOf(picture), pictureOf(file));
} catch (const std::exception&) {
  return;
}

void KeptPictures::keepOnly(const std::vector<fs::path>& files) const {
  std::set<fs::path> wanted;
  for (const fs::path& file : files) wanted.insert(pictureOf(file));
  std::error_code error;
  std::vector<fs::path> others;
  for (const fs::directory_entry& entry : fs::directory_iterator(m_folder, error))
    if (entry.path().extension() == ".png" && !wanted.contains(entry.path())) others.push_back(entry.path());
  for (const fs::path& other : others) fs::remove(other, error);
}

}  // namespace swaplight

#include <gtest/gtest.h>

#include <random>

#include "core/base/json.h"
#include "core/capture/capture.h"
#include "core/file/json_file.h"
#include "core/image/io/image_io.h"
#include "core/set/solved_file.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dng.h"

namespace swaplight {
namespace {

using test::TemporaryFolder;

Image noise(int width, int height, std::vector<std::string> channels = {"R", "G", "B"}) {
  Image image({width, height, std::move(channels), "lin_rec709"});
  std::mt19937 random(7);
  for (int c = 0; c < image.channelCount(); ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p)
      image.plane(c)[p] = static_cast<float>(random() % 256) / 255;
  return image;
}

/// Cuts and damages `bytes` in many places; reading each must succeed or throw InputError.
template <typename Read>
void tryDamaged(const std::filesystem::path& file, const std::string& bytes, int rounds, const Read& read) {
  std::mt19937 random(1);
  int refused = 0;
  for (int round = 0; round < rounds; ++round) {
    std::string damaged = bytes;
    // The head of a file is where its structure is.
    const auto anywhere = [&] {
      const size_t end = random() % 2 == 0 ? std::min<size_t>(bytes.size(), 600) : bytes.size();
      return static_cast<size_t>(random()) % end;
    };
    if (round % 3 == 0) {
      damaged.resize(anywhere());
    } else {
      const int count = 1 + static_cast<int>(random() % 8);
      for (int i = 0; i < count; ++i) damaged[anywhere()] = static_cast<char>(random());
    }
    test::writeBytes(file, damaged);
    try {
      read(file);
    } catch (const InputError& error) {
      ++refused;
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(refused, rounds / 5) << "cut files cannot all be readable";
}

class DamagedPicture : public ::testing::TestWithParam<const char*> {};

TEST_P(DamagedPicture, IsReadOrRefusedButNeverCrashes) {
  const TemporaryFolder folder;
  const auto file = folder / GetParam();
  writeImage(noise(19, 13), file);
  tryDamaged(file, test::readBytes(file), 200, [](const auto& path) { (void)readImage(path); });
}

INSTANTIATE_TEST_SUITE_P(FileFuzz, DamagedPicture,
                         ::testing::Values("a.exr", "a.png", "a.tif", "a.jpg", "a.hdr"));

TEST(FileFuzz, DamagedCameraRawNeverCrashes) {
  const TemporaryFolder folder;
  const std::string bytes =
      test::tinyDng(32, 32, [](int x, int y) { return static_cast<uint16_t>(x * 100 + y * 7); });
  tryDamaged(folder / "a.dng", bytes, 60, [](const auto& path) { (void)readImage(path); });
}

TEST(FileFuzz, DamagedSolvedSetsNeverCrash) {
  const TemporaryFolder folder;
  writeImage(noise(9, 7,
                   {"R", "G", "B", "key.R", "key.G", "key.B", "beta.key", "quality.residual", "quality.sigma",
                    "quality.flags"}),
             folder / "a.exr");
  tryDamaged(folder / "a.exr", test::readBytes(folder / "a.exr"), 150, [](const auto& path) {
    (void)isSolvedSet(path);
    (void)readSolvedSet(path);
  });
}

TEST(FileFuzz, DamagedManifestsNeverCrash) {
  const TemporaryFolder folder;
  const std::string text =
      R"({"format": "swaplight-capture", "version": 1, "name": "a", "color_space": "srgb",
    "lights": [{"name": "key", "role": "key"}, {"name": "fill"}],
    "shots": [{"image": "a.png", "light_colors": [[0.9, 0.2, 0.15], null], "exposure_stops": 1e0}],
    "noise": {"read": 0.002, "full_well": 20000}, "truth": {"key": "k.exr"}, "other": [[{}], true, null]})";
  tryDamaged(folder / "capture.json", text, 800, [](const auto& path) {
    (void)jsonFromCapture(readCapture(test::builtinColors(), path)).dump();
  });
}

}  // namespace
}  // namespace swaplight

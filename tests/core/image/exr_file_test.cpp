#include "core/image/exr/exr_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/image/exr/exr_zip.h"
#include "core/image/half.h"
#include "core/image/io/image_io.h"
#include "core/image/io/image_write.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::TemporaryFolder;

Image randomImage(int width, int height, std::vector<std::string> channels) {
  Image image({width, height, std::move(channels), "lin_rec709"});
  std::mt19937 random(5);
  for (int c = 0; c < image.channelCount(); ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p)
      image.plane(c)[p] = static_cast<float>(p) * 1e-3F + static_cast<float>(random() % 7);
  return image;
}

TEST(ExrZip, PackedBytesComeBackWhateverTheirNumber) {
  std::mt19937 random(1);
  for (const size_t size : {1, 2, 3, 100, 101, 65537}) {
    std::vector<std::byte> raw(size);
    for (std::byte& byte : raw) byte = static_cast<std::byte>(random() % 3);
    std::vector<std::byte> packed;
    packExrZip(raw, packed);
    if (packed.empty()) continue;  // a few bytes do not get fewer
    EXPECT_LT(packed.size(), raw.size());
    std::vector<std::byte> back(size);
    ASSERT_TRUE(unpackExrZip(packed, back));
    EXPECT_EQ(back, raw);
    packed.resize(packed.size() / 2);
    EXPECT_FALSE(unpackExrZip(packed, back));
  }
}

TEST(ExrZip, NoiseIsLeftAsItIs) {
  std::mt19937 random(1);
  std::vector<std::byte> raw(1000);
  for (std::byte& byte : raw) byte = static_cast<std::byte>(random());
  std::vector<std::byte> packed(7);
  packExrZip(raw, packed);
  EXPECT_TRUE(packed.empty());
}

TEST(ExrFile, OtherReadersSeeWhatWasWritten) {
  const TemporaryFolder folder;
  const Image image = randomImage(67, 45, {"R", "G", "B", "Z", "a_light_with_quite_a_long_name_indeed.R"});
  WriteOptions options;
  options.channelTypes = {"half", "half", "half", "float", "half"};
  for (const char* compression : {"zip", "zips"}) {
    options.compression = compression;
    writeImage(image, folder / "a.exr", options);
    const auto in = OIIO::ImageInput::open((folder / "a.exr").string());
    ASSERT_TRUE(in) << OIIO::geterror();
    const OIIO::ImageSpec spec = in->spec();
    EXPECT_EQ(spec.get_string_attribute("compression"), compression);
    std::vector<float> pixels(image.pixelCount() * 5);
    ASSERT_TRUE(in->read_image(0, 0, 0, 5, OIIO::TypeFloat, pixels.data())) << in->geterror();
    for (size_t c = 0; c < 5; ++c) {
      const int plane = image.channelIndex(spec.channelnames[c]);
      ASSERT_GE(plane, 0) << spec.channelnames[c];
      for (size_t p = 0; p < image.pixelCount(); ++p) {
        const float value = image.plane(plane)[p];
        ASSERT_EQ(pixels[p * 5 + c], plane == 3 ? value : roundedToHalf(value)) << compression;
      }
    }
  }
}

TEST(ExrFile, WritingAPartOfThePictureIsDoneAtTheEnd) {
  const TemporaryFolder folder;
  const Image image = randomImage(67, 45, {"Y"});
  for (const char* compression : {"zip", "zips", "piz"}) {
    FileToWrite contents{67,           45,          {{"", {{"Y", image.plane(0), PixelType::Half}}}},
                         "lin_rec709", compression, {}};
    contents.dataWindow = PixelRect{3, 20, 40, 10};
    std::vector<float> said;
    writeChannels(contents, folder / "a.exr",
                  {[&](float fraction, std::string_view) { said.push_back(fraction); }});
    ASSERT_FALSE(said.empty()) << compression;
    EXPECT_EQ(said.back(), 1) << compression;
    EXPECT_TRUE(std::is_sorted(said.begin(), said.end())) << compression;
  }
}

TEST(ExrFile, ReadsWhatOthersWriteInEveryCompression) {
  const TemporaryFolder folder;
  const Image image = randomImage(67, 45, {"R", "G", "B"});
  std::vector<float> pixels;
  for (size_t p = 0; p < image.pixelCount(); ++p)
    for (int c = 0; c < 3; ++c) pixels.push_back(image.plane(c)[p]);
  for (const char* compression : {"none", "rle", "zip", "zips", "piz"}) {
    OIIO::ImageSpec spec(67, 45, 3, OIIO::TypeFloat);
    spec.attribute("compression", compression);
    const auto out = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(out->open((folder / "a.exr").string(), spec));
    ASSERT_TRUE(out->write_image(OIIO::TypeFloat, pixels.data()));
    ASSERT_TRUE(out->close());
    const Image back = readImage(folder / "a.exr").image;
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p)
        ASSERT_EQ(back.plane(c)[p], image.plane(c)[p]) << compression;
  }
}

TEST(ExrFile, TheSamePictureGivesTheSameBytes) {
  const TemporaryFolder folder;
  const Image image = randomImage(300, 200, {"R", "G", "B"});
  writeImage(image, folder / "a.exr");
  writeImage(image, folder / "b.exr");
  EXPECT_EQ(test::readBytes(folder / "a.exr"), test::readBytes(folder / "b.exr"));
}

}  // namespace
}  // namespace swaplight

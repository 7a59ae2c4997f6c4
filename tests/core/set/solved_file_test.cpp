#include "core/set/solved_file.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/base/json.h"
#include "core/image/half.h"
#include "core/image/io/image_io.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Random contributions over many magnitudes: the worst for rounding. Up to 2^brightest.
Image randomPicture(unsigned seed, float brightest = -0.1F, int width = 61, int height = 43) {
  Image image(ImageSpec::rgb(width, height));
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> stops(-14, brightest);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p) image.plane(c)[p] = std::exp2(stops(random));
  return image;
}

SolvedSet threeLights() {
  SolvedSet set;
  set.capture = captureFromJson(Json::parse(R"({
    "format": "swaplight-capture", "version": 1, "name": "set", "color_space": "acescg",
    "lights": [{"name": "key", "role": "key"}, {"name": "fill", "role": "fill", "gel": "L201"}, {"name": "rim", "role": "back"}],
    "shots": [{"image": "shot_01.exr", "light_colors": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}]})"),
                                "sets/night", "sets/night/capture.json");
  for (unsigned i = 0; i < 3; ++i) {
    set.contributions.push_back(randomPicture(i + 1));
    set.contributions.back().setColorSpace("acescg");
  }
  set.ambient = randomPicture(9);
  updateBeta(set);
  set.quality = Image(ImageSpec{61, 43, {"residual", "sigma", "flags", "model"}, "data"}, 0.1F);
  for (size_t p = 0; p < set.quality.pixelCount(); ++p)
    set.quality.plane(kFlags)[p] = static_cast<float>(p % 32);
  set.report.emplace();
  set.report->message = "Three lights.";
  set.report->model = "auto";
  set.report->sigmaMedian = 0.125;
  return set;
}

class SolvedFile : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(SinglePartAndMultiPart, SolvedFile, ::testing::Bool());

TEST_P(SolvedFile, ComesBackAsItWasToHalfPrecision) {
  const TemporaryFolder folder;
  const SolvedSet set = threeLights();
  writeSolvedSet(set, folder / "solved.exr", {GetParam()});
  EXPECT_TRUE(isSolvedSet(folder / "solved.exr"));
  const SolvedSet back = readSolvedSet(folder / "solved.exr");
  ASSERT_EQ(back.lightCount(), 3);
  EXPECT_EQ(jsonFromCapture(back.capture), jsonFromCapture(set.capture));
  EXPECT_EQ(jsonFromSolveReport(back.report.value()), jsonFromSolveReport(*set.report));
  EXPECT_EQ(back.colorSpace(), "acescg");
  ASSERT_TRUE(back.ambient);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
      for (size_t i = 0; i < 3; ++i)
        ASSERT_EQ(back.contributions[i].plane(c)[p], roundedToHalf(set.contributions[i].plane(c)[p]));
      ASSERT_EQ(back.ambient->plane(c)[p], roundedToHalf(set.ambient->plane(c)[p]));
      ASSERT_EQ(back.beta.plane(c)[p], set.beta.plane(c)[p]);
      ASSERT_EQ(back.quality.plane(c)[p], set.quality.plane(c)[p]);
    }
  EXPECT_EQ(back.quality.spec(), set.quality.spec());
}

TEST_P(SolvedFile, TheLayersAddUpToTheBeautyToTheLastBit) {
  const TemporaryFolder folder;
  writeSolvedSet(threeLights(), folder / "solved.exr", {GetParam()});
  const Image all = readImage(folder / "solved.exr").image;
  for (const char* c : {"R", "G", "B"})
    for (size_t p = 0; p < all.pixelCount(); ++p) {
      float sum = 0;
      for (const char* layer : {"key.", "fill.", "rim.", "ambient."})
        sum += all.plane(all.channelIndex(std::string(layer) + c))[p];
      ASSERT_EQ(all.plane(all.channelIndex(c))[p], sum);
    }
}

TEST_P(SolvedFile, HighlightsComeBackWithinTheirLights) {
  const TemporaryFolder folder;
  SolvedSet set = threeLights();
  for (const Image& light : set.contributions) {
    Image& highlight = set.highlights.emplace_back(light.clone());
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < highlight.pixelCount(); ++p) highlight.plane(c)[p] *= float(p % 4) / 3;
  }
  writeSolvedSet(set, folder / "solved.exr", {GetParam()});
  const SolvedSet back = readSolvedSet(folder / "solved.exr");
  ASSERT_EQ(back.highlights.size(), 3U);
  for (size_t i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
        ASSERT_EQ(back.highlights[i].plane(c)[p], roundedToHalf(set.highlights[i].plane(c)[p]));
        ASSERT_LE(back.highlights[i].plane(c)[p], back.contributions[i].plane(c)[p]);
      }
  EXPECT_TRUE(!back.carried || back.carried->channels.empty()) << "none is left over";
}

TEST_P(SolvedFile, IsReadWithoutItsHighlightsForThoseWhoDoNotLook) {
  const TemporaryFolder folder;
  SolvedSet set = threeLights();
  for (const Image& light : set.contributions) set.highlights.push_back(light.clone());
  writeSolvedSet(set, folder / "solved.exr", {GetParam()});
  const SolvedSet all = readSolvedSet(folder / "solved.exr");
  const SolvedSet lights = readSolvedSet(folder / "solved.exr", {}, HighlightReading::None);
  EXPECT_TRUE(lights.highlights.empty());
  EXPECT_TRUE(!lights.carried || lights.carried->channels.empty()) << "nor are they carried along";
  for (size_t i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p)
        ASSERT_EQ(lights.contributions[i].plane(c)[p], all.contributions[i].plane(c)[p]);
}

TEST_P(SolvedFile, WithoutHighlightsHasNoChannelsForThem) {
  const TemporaryFolder folder;
  writeSolvedSet(threeLights(), folder / "solved.exr", {GetParam()});
  for (const std::string& channel : readImageSpec(folder / "solved.exr").channels)
    EXPECT_EQ(channel.find(".spec"), std::string::npos) << channel;
  EXPECT_TRUE(readSolvedSet(folder / "solved.exr").highlights.empty());
}

TEST(SolvedFileHeader, IncompleteHighlightsAreOnlyCarriedAlong) {
  const TemporaryFolder folder;
  const Image image({4,
                     4,
                     {"R", "G", "B", "key.R", "key.G", "key.B", "key.spec.R", "beta.key", "quality.residual",
                      "quality.sigma", "quality.flags"},
                     "lin_rec709"},
                    0.5F);
  writeImage(image, folder / "shuffled.exr");
  EXPECT_FALSE(holdsHighlights(readImageSpec(folder / "shuffled.exr"), "key"));
  const SolvedSet set = readSolvedSet(folder / "shuffled.exr");
  EXPECT_TRUE(set.highlights.empty());
  EXPECT_THAT(set.carried->channels.spec().channels, ElementsAre("key.spec.R"));
}

TEST(SolvedFileHeader, HoldsWhatTheContractSays) {
  const TemporaryFolder folder;
  writeSolvedSet(threeLights(), folder / "solved.exr");
  const auto in = OIIO::ImageInput::open((folder / "solved.exr").string());
  ASSERT_TRUE(in);
  const OIIO::ImageSpec& spec = in->spec();
  EXPECT_THAT(spec.channelnames,
              ::testing::IsSupersetOf({"R", "G", "B", "key.R", "rim.B", "ambient.G", "beta.fill",
                                       "quality.residual", "quality.sigma", "quality.flags"}));
  for (int c = 0; c < spec.nchannels; ++c) {
    const std::string& name = spec.channelnames[static_cast<size_t>(c)];
    const bool isLight =
        name.find('.') != std::string::npos && !name.starts_with("beta.") && !name.starts_with("quality.");
    EXPECT_EQ(spec.channelformat(c), isLight ? OIIO::TypeHalf : OIIO::TypeFloat) << name;
  }
  EXPECT_THAT(spec.get_string_attribute("Software"), HasSubstr("swaplight "));
  EXPECT_EQ(Json::parse(spec.get_string_attribute("swaplight/capture").c_str())["name"], "set");
  EXPECT_EQ(Json::parse(spec.get_string_attribute("swaplight/report").c_str())["model"], "auto");
  const auto* xy = spec.find_attribute("chromaticities");
  ASSERT_TRUE(xy);
  EXPECT_FLOAT_EQ(static_cast<const float*>(xy->data())[0], 0.713F) << "ACEScg";
}

TEST(SolvedFileHeader, TheSumIsHalfWhereThatIsAskedFor) {
  const TemporaryFolder folder;
  writeSolvedSet(threeLights(), folder / "solved.exr", {.halfSum = true});
  const auto in = OIIO::ImageInput::open((folder / "solved.exr").string());
  ASSERT_TRUE(in);
  EXPECT_EQ(in->spec().channelformat(in->spec().channelindex("R")), OIIO::TypeHalf);
  const Image all = readImage(folder / "solved.exr").image;
  for (size_t p = 0; p < all.pixelCount(); ++p) {
    float sum = 0;
    for (const char* layer : {"key.G", "fill.G", "rim.G", "ambient.G"})
      sum += all.plane(all.channelIndex(layer))[p];
    ASSERT_EQ(all.plane(all.channelIndex("G"))[p], roundedToHalf(sum));
  }
}

TEST(SolvedFileHeader, ASumThatHalfCannotHoldIsFloatAllTheSame) {
  const TemporaryFolder folder;
  SolvedSet set = threeLights();
  set.contributions[0] = randomPicture(4, 6);
  writeSolvedSet(set, folder / "solved.exr", {.halfSum = true});
  const auto in = OIIO::ImageInput::open((folder / "solved.exr").string());
  ASSERT_TRUE(in);
  EXPECT_EQ(in->spec().channelformat(in->spec().channelindex("R")), OIIO::TypeFloat);
  EXPECT_EQ(in->spec().channelformat(in->spec().channelindex("key.R")), OIIO::TypeHalf);
  const Image all = readImage(folder / "solved.exr").image;
  for (size_t p = 0; p < all.pixelCount(); ++p) {
    float sum = 0;
    for (const char* layer : {"key.G", "fill.G", "rim.G", "ambient.G"})
      sum += all.plane(all.channelIndex(layer))[p];
    ASSERT_EQ(all.plane(all.channelIndex("G"))[p], sum);
  }
}

TEST(SolvedFileHeader, MultiPartHasOnePartALight) {
  const TemporaryFolder folder;
  writeSolvedSet(threeLights(), folder / "solved.exr", {true});
  const auto in = OIIO::ImageInput::open((folder / "solved.exr").string());
  ASSERT_TRUE(in);
  std::vector<std::string> parts;
  for (int i = 0; in->seek_subimage(i, 0); ++i) {
    parts.push_back(in->spec().get_string_attribute("oiio:subimagename"));
    if (parts.back() == "key") {
      EXPECT_THAT(in->spec().channelnames, ElementsAre("R", "G", "B"));
    }
  }
  (void)in->geterror();
  EXPECT_THAT(parts, ElementsAre("rgb", "key", "fill", "rim", "ambient", "beta", "quality"));
}

TEST(SolvedFileHeader, TheCaptureIsFoundAgainFromTheSolvedFile) {
  const TemporaryFolder folder;
  SolvedSet set = threeLights();
  set.capture.file = folder / "sets/night/capture.json";
  std::filesystem::create_directories(folder / "out");
  writeSolvedSet(set, folder / "out/solved.exr");
  EXPECT_EQ(readSolvedSet(folder / "out/solved.exr").capture.file, set.capture.file);
}

TEST(SolvedFileErrors, FloatPicturesKeepEveryBit) {
  const TemporaryFolder folder;
  const SolvedSet set = threeLights();
  SolvedFileOptions options;
  options.floatPictures = true;
  options.compression = "none";
  writeSolvedSet(set, folder / "solved.exr", options);
  const SolvedSet back = readSolvedSet(folder / "solved.exr");
  EXPECT_EQ(back.contributions[2].plane(1)[77], set.contributions[2].plane(1)[77]);
}

TEST(SolvedFileErrors, AreSaid) {
  const TemporaryFolder folder;
  SolvedSet set = threeLights();
  EXPECT_THAT(inputError([&] { writeSolvedSet(set, folder / "solved.png"); }), HasSubstr("Name it"));
  EXPECT_THAT(inputError([&] { writeSolvedSet(set, folder / "none/solved.exr"); }),
              HasSubstr("does not exist"));
  EXPECT_THAT(inputError([&] {
                writeSolvedSet(set, folder / "s.exr", {false, "lzma", false});
              }),
              HasSubstr("\"lzma\" is not known. Known: none, rle, zips, zip"));
  writeImage(randomPicture(1), folder / "plain.exr");
  EXPECT_FALSE(isSolvedSet(folder / "plain.exr"));
  EXPECT_FALSE(isSolvedSet(folder / "none.exr"));
  EXPECT_THAT(inputError([&] { (void)readSolvedSet(folder / "plain.exr"); }),
              HasSubstr("plain.exr: is no solved set"));
  writeImage(randomPicture(1), folder / "plain.png");
  EXPECT_THAT(inputError([&] { (void)readSolvedSet(folder / "plain.png"); }),
              HasSubstr("is an OpenEXR file"));

  Image partial(ImageSpec{4, 4, {"R", "G", "B", "key.R", "key.G", "beta.key"}, "lin_rec709"}, 0.5F);
  writeImage(partial, folder / "partial.exr");
  EXPECT_THAT(inputError([&] { (void)readSolvedSet(folder / "partial.exr"); }),
              HasSubstr("the channel key.B is missing"));
}

TEST(SolvedFileErrors, ACancelledWriteLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::atomic<bool> stop = true;
  EXPECT_THROW(writeSolvedSet(threeLights(), folder / "solved.exr", {}, {{}, &stop}), Stopped);
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(SolvedFileErrors, WithoutAHeaderTheLightsAreThoseWithABeta) {
  const TemporaryFolder folder;
  Image image(ImageSpec{4,
                        4,
                        {"R", "G", "B", "key.R", "key.G", "key.B", "beta.key", "quality.residual",
                         "quality.sigma", "quality.flags"},
                        "lin_rec709"},
              0.5F);
  writeImage(image, folder / "rewritten.exr");
  const SolvedSet set = readSolvedSet(folder / "rewritten.exr");
  ASSERT_EQ(set.lightCount(), 1);
  EXPECT_EQ(set.capture.lights[0].name, "key");
  EXPECT_EQ(set.capture.warnings.size(), 1U);
}

}  // namespace
}  // namespace swaplight

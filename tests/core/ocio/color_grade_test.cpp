#include "core/ocio/color_grade.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/ocio/color_config.h"
#include "core/ocio/grade_file.h"
#include "core/ocio/grade_transform.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;
using ::testing::HasSubstr;

constexpr const char* kHandMadeConfig = SWAPLIGHT_TEST_DATA "/color/config.ocio";

ColorGrade teal() {
  ColorGrade grade = withLiftGammaGain({}, {{.02, .01, -.015}, {1.05, .98, 1.1}, {1.08, 1, .94}});
  grade.saturation = .85;
  return grade;
}

/// From deep black to far above white, in three hues.
Image light() {
  Image image(ImageSpec::rgb(41, 3), 0.0F);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 41; ++x)
      for (int c = 0; c < 3; ++c)
        image.span().at(c, x, y) = std::exp2(.5F * static_cast<float>(x) - 12) * (c == y ? 1.F : .6F);
  return image;
}

/// The largest difference, relative where light is brighter than 1.
double difference(const Image& a, const Image& b) {
  double worst = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p)
      worst = std::max<double>(
          worst, std::abs(a.plane(c)[p] - b.plane(c)[p]) / std::max(1.F, std::abs(b.plane(c)[p])));
  return worst;
}

/// What another program makes of the light by the file: to the space, the file's CDL, and back.
Image gradedByFile(Image image, const ColorConfig& config, const std::filesystem::path& file) {
  config.convert(image.span(), "lin_rec709", config.gradingSpace());
  const auto transform = OCIO::FileTransform::Create();
  transform->setSrc(file.c_str());
  const auto cpu = OCIO::Config::CreateRaw()->getProcessor(transform)->getDefaultCPUProcessor();
  for (size_t p = 0; p < image.pixelCount(); ++p) {
    std::array<float, 3> rgb{image.plane(0)[p], image.plane(1)[p], image.plane(2)[p]};
    cpu->applyRGB(rgb.data());
    for (int c = 0; c < 3; ++c) image.plane(c)[p] = rgb.at(static_cast<size_t>(c));
  }
  config.convert(image.span(), config.gradingSpace(), "lin_rec709");
  return image;
}

TEST(ColorGrade, TheFileAppliedByOpenColorIOIsOurGrade) {
  const TemporaryFolder folder;
  for (const char* ocio : {"", kHandMadeConfig}) {
    const ColorConfig config(ocio);
    for (const char* name : {"grade.cc", "grade.ccc", "grade.cdl"}) {
      writeGrade(teal(), folder / name, "a grade");
      Image ours = light();
      config.applyGrade(ours.span(), "lin_rec709", teal());
      if (std::string(name) != "grade.cc") continue;  // OpenColorIO wants an id for the others
      const Image theirs = gradedByFile(light(), config, folder / name);
      EXPECT_LT(difference(ours, theirs), 1e-4) << ocio << " " << name;
      EXPECT_GT(difference(ours, light()), .05) << "it does something";
    }
  }
}

TEST(ColorGrade, WorksWhereTheConfigurationSays) {
  EXPECT_EQ(ColorConfig("").gradingSpace(), "acescct");
  EXPECT_EQ(ColorConfig(kHandMadeConfig).gradingSpace(), "log_camera");
}

TEST(ColorGrade, GoesThroughFilesUnchanged) {
  const TemporaryFolder folder;
  for (const char* name : {"a.cc", "a.ccc", "a.cdl"}) {
    writeGrade(teal(), folder / name, "a grade");
    const ColorGrade back = readGrade(folder / name);
    for (size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(back.slope[c], teal().slope[c], 1e-6);
      EXPECT_NEAR(back.offset[c], teal().offset[c], 1e-6);
      EXPECT_NEAR(back.power[c], teal().power[c], 1e-6);
    }
    EXPECT_NEAR(back.saturation, teal().saturation, 1e-6);
  }
}

TEST(ColorGrade, IsSeenThroughAViewAsTheGradedLightIs) {
  for (const char* ocio : {"", kHandMadeConfig}) {
    const ColorConfig config(ocio);
    DisplayChoice choice = namedDisplay(config, {});
    Image graded = light();
    config.applyGrade(graded.span(), "lin_rec709", teal());
    config.applyView(graded.span(), "lin_rec709", choice);
    choice.grade = teal();
    Image seen = light();
    config.applyView(seen.span(), "lin_rec709", choice);
    EXPECT_LT(difference(seen, graded), 2e-5) << ocio;
  }
}

TEST(ColorGrade, NothingChangesWhileItIsOffOrNeutral) {
  const ColorConfig config("");
  ColorGrade off = teal();
  off.on = false;
  for (const ColorGrade& grade : {off, ColorGrade{}}) {
    Image image = light();
    config.applyGrade(image.span(), "lin_rec709", grade);
    EXPECT_EQ(difference(image, light()), 0);
    DisplayChoice choice;
    choice.grade = grade;
    EXPECT_TRUE(choice.empty());
    EXPECT_EQ(choice.actingGrade(), nullptr);
  }
}

TEST(ColorGrade, NoLightBecomesInfinite) {
  for (const char* ocio : {"", kHandMadeConfig}) {
    const ColorConfig config(ocio);
    for (const double saturation : {0.0, kMostGrade})
      for (const double most : {-kMostGrade, kMostGrade}) {
        const ColorGrade grade{true,
                               {kMostGrade, kMostGrade, 0},
                               {most, -most, most},
                               {kMostGrade, 1 / kMostGrade, kMostGrade},
                               saturation};
        Image image = light();
        image.plane(0)[0] = 65504;
        image.plane(1)[1] = std::numeric_limits<float>::max();
        image.plane(2)[2] = -65504;
        config.applyGrade(image.span(), "lin_rec709", grade);
        for (int c = 0; c < 3; ++c)
          for (size_t p = 0; p < image.pixelCount(); ++p)
            ASSERT_TRUE(std::isfinite(image.plane(c)[p])) << ocio << p << " " << saturation << " " << most;
      }
  }
}

TEST(ColorGrade, LiftLeavesWhiteAndGainLeavesBlack) {
  LiftGammaGain wheels;
  wheels.lift = {.1, .1, .1};
  const ColorGrade lifted = withLiftGammaGain({}, wheels);
  EXPECT_NEAR(lifted.slope[0] + lifted.offset[0], 1, 1e-12);
  EXPECT_NEAR(lifted.offset[0], .1, 1e-12);
  wheels = {};
  wheels.gain = {2, 2, 2};
  EXPECT_EQ(withLiftGammaGain({}, wheels).offset[0], 0);
  const LiftGammaGain back = liftGammaGainOf(teal());
  EXPECT_NEAR(back.lift[2], -.015, 1e-12);
  EXPECT_NEAR(back.gamma[2], 1.1, 1e-12);
  EXPECT_NEAR(back.gain[2], .94, 1e-12);
}

TEST(ColorGrade, AChannelWithoutGainIsNoNumberBeyondNumbers) {
  ColorGrade grade;
  grade.slope = {0, 0, 0};
  EXPECT_EQ(liftGammaGainOf(grade).lift[0], 0);
  EXPECT_EQ(liftGammaGainOf(grade).gain[0], 0);
}

TEST(ColorGrade, AChoiceOnTheCommandLineTakesTheSessionsGradeOrItsOwn) {
  DisplayChoice session{"sRGB", "Log", {}};
  session.grade = teal();
  EXPECT_EQ(DisplayChoice{}.over(session).grade, teal());
  EXPECT_EQ((DisplayChoice{"sRGB", "Raw", {}}.over(session).grade), teal());
  DisplayChoice none;
  none.grade = ColorGrade{};
  EXPECT_EQ(none.over(session).view, "Log");
  EXPECT_EQ(none.over(session).actingGrade(), nullptr);
}

TEST(GradeFile, OfACollectionTheOneThatIsNamed) {
  const TemporaryFolder folder;
  const auto correction = [](const std::string& id, const std::string& slope) {
    return "<ColorCorrection id=\"" + id + "\"><SOPNode><Slope>" + slope +
           "</Slope><Offset>0 0 0</Offset><Power>1 1 1</Power></SOPNode></ColorCorrection>\n";
  };
  writeBytes(folder / "all.ccc", "<ColorCorrectionCollection xmlns=\"urn:ASC:CDL:v1.2\">\n" +
                                     correction("day", "1 1 1.5") + correction("night", "0.5 0.5 1") +
                                     "</ColorCorrectionCollection>\n");
  EXPECT_EQ(readGrade(folder / "all.ccc").slope[2], 1.5);
  EXPECT_EQ(readGrade(folder / "all.ccc", "night").slope[0], .5);
  EXPECT_THAT(inputError([&] { static_cast<void>(readGrade(folder / "all.ccc", "dusk")); }),
              HasSubstr("all.ccc"));
}

TEST(GradeFile, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const auto wrong = [&](const std::string& name) {
    return inputError([&] { static_cast<void>(readGrade(folder / name)); });
  };
  EXPECT_THAT(wrong("none.cc"), HasSubstr("no such file"));
  EXPECT_THAT(wrong("none.exr"), HasSubstr(".cc, .ccc or .cdl"));
  writeBytes(folder / "broken.cc", "<ColorCorrection><SOPNode><Slope>1 1");
  EXPECT_THAT(wrong("broken.cc"), HasSubstr("broken.cc"));
  writeBytes(folder / "empty.cc", "");
  EXPECT_THAT(wrong("empty.cc"), HasSubstr("empty.cc"));
  writeBytes(folder / "wild.cc",
             "<ColorCorrection id=\"x\"><SOPNode><Slope>900 1 1</Slope><Offset>0 0 0</Offset>"
             "<Power>1 1 1</Power></SOPNode></ColorCorrection>");
  EXPECT_THAT(wrong("wild.cc"), HasSubstr("the slope is 900, expected 0 to 16"));
}

TEST(GradeFile, AChangedFileIsReadAnew) {
  const TemporaryFolder folder;
  writeGrade(teal(), folder / "a.cc", "one");
  static_cast<void>(readGrade(folder / "a.cc"));
  ColorGrade other = teal();
  other.saturation = 2;
  writeGrade(other, folder / "a.cc", "two");
  EXPECT_NEAR(readGrade(folder / "a.cc").saturation, 2, 1e-9);
  EXPECT_THAT(readBytes(folder / "a.cc"), HasSubstr("two"));
}

}  // namespace
}  // namespace swaplight

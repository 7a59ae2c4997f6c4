#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <thread>
#include <vector>

#include "core/ocio/chosen_config.h"
#include "core/ocio/color_config.h"
#include "core/ocio/luminance.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A foreign configuration.
constexpr const char* kHandMade = SWAPLIGHT_TEST_DATA "/color/config.ocio";

/// Red in the first pixel, green, blue, white, grey, and a ramp to 2 in the rest.
Image colours() {
  Image image(ImageSpec::rgb(64, 3), 0.0F);
  for (int c = 0; c < 3; ++c) {
    image.plane(c)[c] = 1;
    image.plane(c)[3] = 1;
    image.plane(c)[4] = 0.18F;
    for (size_t p = 5; p < image.pixelCount(); ++p) image.plane(c)[p] = static_cast<float>(p - 5) / 93.0F;
  }
  return image;
}

double encodeSrgb(double x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

TEST(ColorConfig, ThePlainViewIsThePiecewiseSrgbCurve) {
  const ColorConfig config("");
  EXPECT_EQ(config.defaultDisplay(), "sRGB");
  EXPECT_EQ(config.defaultView("sRGB"), "sRGB");
  Image image = colours();
  config.applyView(image.span(), "lin_rec709", {"sRGB", "sRGB"});
  const Image in = colours();
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < in.pixelCount(); ++p)
      ASSERT_NEAR(image.plane(c)[p], std::min(1.0, encodeSrgb(in.plane(c)[p])), 1e-5) << in.plane(c)[p];
}

TEST(ColorConfig, PublishedNumbersOfTheColourSpaces) {
  const ColorConfig config("");
  Image image = colours();
  config.convert(image.span(), "lin_rec709", "acescg");  // the columns of the Bradford-adapted matrix
  EXPECT_NEAR(image.plane(0)[0], 0.613097F, 1e-4F);
  EXPECT_NEAR(image.plane(1)[0], 0.070194F, 1e-4F);
  EXPECT_NEAR(image.plane(2)[2], 0.869815F, 1e-4F);
  EXPECT_NEAR(image.plane(0)[3], 1, 1e-5F) << "white stays white";
  image = colours();
  config.convert(image.span(), "lin_rec709", "aces2065_1");
  EXPECT_NEAR(image.plane(0)[0], 0.439633F, 1e-4F);
  EXPECT_NEAR(image.plane(1)[1], 0.813439F, 1e-4F);
  image = Image(ImageSpec::rgb(1, 1), 0.5F);
  config.convert(image.span(), "srgb", "lin_rec709");
  EXPECT_NEAR(image.plane(1)[0], 0.21404114F, 1e-6F);
  image = Image(ImageSpec::rgb(1, 1), 0.18F);
  config.applyView(image.span(), "lin_rec709", {"Rec.709", "Rec.709"});
  EXPECT_NEAR(image.plane(0)[0], std::pow(0.18F, 1 / 2.4F), 1e-5F) << "BT.1886";
}

TEST(ColorConfig, TheAcesOutputOfMiddleGreyIsATenthOfWhiteBeforeTheDimSurround) {
  const ColorConfig config("");
  Image image(ImageSpec::rgb(1, 1), 0.18F);
  config.applyView(image.span(), "lin_rec709", {"sRGB", "ACES SDR"});
  // ACES 1.x: 4.8 nits of 48, black 0.02; then the gamma of a dim surround.
  const double linear = std::pow((4.8 - 0.02) / (48 - 0.02), 0.9811);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.plane(c)[0], encodeSrgb(linear), 1e-3);
}

TEST(ColorConfig, EveryConversionAndViewWorksAndConversionsComeBack) {
  const ColorConfig config("");
  for (const std::string& space : config.colorSpaces()) {
    Image image = colours();
    config.convert(image.span(), "lin_rec709", space);
    config.convert(image.span(), space, "lin_rec709");
    const Image in = colours();
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < in.pixelCount(); ++p)
        ASSERT_NEAR(image.plane(c)[p], in.plane(c)[p], 2e-4F) << space;
  }
  EXPECT_THAT(config.displays(), ElementsAre("sRGB", "Rec.709", "P3-D65", "Rec.2100 PQ", "Rec.2100 HLG"));
  for (const std::string& display : config.displays())
    for (const std::string& view : config.views(display)) {
      Image image = colours();
      image.plane(1)[7] = std::numeric_limits<float>::quiet_NaN();
      image.plane(2)[8] = std::numeric_limits<float>::infinity();
      image.plane(0)[9] = -3;
      config.applyView(image.span(), "acescg", {display, view});
      for (int c = 0; c < 3; ++c)
        for (size_t p = 0; p < image.pixelCount(); ++p)
          ASSERT_TRUE(image.plane(c)[p] >= 0 && image.plane(c)[p] <= 1) << display << " " << view << " " << p;
    }
}

TEST(ColorConfig, LightIsKnownFromCodesAndData) {
  const ColorConfig builtin(""), handMade(kHandMade);
  for (const char* space : {"lin_rec709", "acescg", "aces2065_1", "lin_rec2020", "lin_p3d65"})
    EXPECT_NO_THROW(builtin.checkLinear(space)) << space;
  for (const char* space : {"lin_rec709", "acescg", "work", "aces"})
    EXPECT_NO_THROW(handMade.checkLinear(space)) << space;
  for (const char* space : {"srgb", "acescct", "arri_logc_ei800_awg", "raw"})
    EXPECT_THAT(inputError([&] { builtin.checkLinear(space); }), HasSubstr("not scene-linear light"))
        << space;
  for (const char* space : {"srgb", "log_camera", "monitor", "film", "raw"})
    EXPECT_THAT(inputError([&] { handMade.checkLinear(space); }), HasSubstr("not scene-linear light"))
        << space;
  EXPECT_THAT(inputError([&] { builtin.checkLinear("film"); }), HasSubstr("\"film\" is not known"));
}

TEST(ColorConfig, PrimariesOfALinearSpaceAreWhatItsMatrixSays) {
  const ColorConfig builtin(""), handMade(kHandMade);
  const auto expect = [](const std::optional<Chromaticities>& found, const Chromaticities& expected) {
    ASSERT_TRUE(found);
    for (size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR((*found)[i], expected[i], 2e-4) << i;
  };
  expect(chromaticitiesIn(builtin, "lin_rec2020"),
         {.708F, .292F, .170F, .797F, .131F, .046F, .3127F, .3290F});
  expect(chromaticitiesIn(builtin, "lin_p3d65"), {.680F, .320F, .265F, .690F, .150F, .060F, .3127F, .3290F});
  for (const char* space : {"lin_rec709", "acescg", "aces2065_1"})
    EXPECT_EQ(chromaticitiesIn(builtin, space), chromaticitiesOf(space));
  EXPECT_EQ(chromaticitiesIn(handMade, "work"), chromaticitiesOf("acescg"));
  EXPECT_EQ(chromaticitiesIn(handMade, "aces"), chromaticitiesOf("aces2065_1"));
}

TEST(ColorConfig, UnknownNamesAreListed) {
  const ColorConfig config("");
  Image image = colours();
  EXPECT_THAT(
      inputError([&] { config.convert(image.span(), "rec2020", "srgb"); }),
      AllOf(HasSubstr("\"rec2020\" is not known"), HasSubstr("lin_rec709, srgb, acescg, aces2065_1")));
  EXPECT_THAT(inputError([&] {
                config.applyView(image.span(), "srgb", {"TV", "Raw"});
              }),
              HasSubstr("sRGB, Rec.709"));
  EXPECT_THAT(inputError([&] {
                config.applyView(image.span(), "srgb", {"sRGB", "Film"});
              }),
              HasSubstr("has no view 'Film'; built-in has sRGB, AgX, ACES SDR"));
}

TEST(ColorConfig, ThePublishedCodesOfDiffuseWhiteOnHdrDisplays) {
  const ColorConfig config("");
  for (const auto& [display, code] : {std::pair("Rec.2100 PQ", 0.5807), std::pair("Rec.2100 HLG", 0.75)}) {
    Image image(ImageSpec::rgb(1, 1), 1);
    config.applyView(image.span(), "lin_rec709", {display, "203 nit white"});
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(image.plane(c)[0], code, 2e-3) << display << ", BT.2408: 58 %, 75 %";
  }
}

constexpr const char* kForeign = R"(ocio_profile_version: 2
roles:
  default: plate
  scene_linear: work
  aces_interchange: interchange
displays:
  Monitor:
    - !<View> {name: Film, colorspace: halved}
    - !<View> {name: None, colorspace: work}
colorspaces:
  - !<ColorSpace>
    name: interchange
  - !<ColorSpace>
    name: work
    to_scene_reference: !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
  - !<ColorSpace>
    name: halved
    from_scene_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}
  - !<ColorSpace>
    name: plate
    isdata: true
)";

TEST(ColorConfig, AForeignConfigurationIsGivenTheNamesThatCapturesUse) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "config.ocio", kForeign);
  const ColorConfig config((folder / "config.ocio").string());
  EXPECT_THAT(config.colorSpaces(), AllOf(Contains("work"), Contains("lin_rec709"), Contains("srgb")));
  Image image = colours();
  config.convert(image.span(), "lin_rec709", "work");
  EXPECT_NEAR(image.plane(0)[0], 0.613097F, 1e-4F) << "work is ACEScg";
  config.convert(image.span(), "work", "srgb");
  EXPECT_NEAR(image.plane(1)[4], encodeSrgb(0.18), 1e-4);
  image = Image(ImageSpec::rgb(1, 1), 0.5F);
  config.applyView(image.span(), "lin_rec709", {"Monitor", "Film"});
  EXPECT_NEAR(image.plane(0)[0], 0.25F, 1e-4F);
}

TEST(ColorConfig, AKnownSpaceIsKnownByAnyName) {
  const ColorConfig builtin("");
  EXPECT_EQ(builtin.knownName("ACEScg"), "acescg");
  EXPECT_EQ(builtin.knownName("ACES2065-1"), "aces2065_1");
  EXPECT_EQ(builtin.knownName("linear"), "lin_rec709");
  for (const char* other : {"srgb", "acescct", "raw", "lin_rec2020", "lin_p3d65", "gone", "response.json"})
    EXPECT_EQ(builtin.knownName(other), other);
  const TemporaryFolder folder;
  test::writeBytes(folder / "config.ocio", kForeign);
  const ColorConfig config((folder / "config.ocio").string());
  EXPECT_EQ(config.knownName("work"), "acescg");
  EXPECT_EQ(config.knownName("plate"), "plate") << "data";
}

TEST(ColorConfig, TheBuiltInOneKeepsItsDisplaysWhateverTheEnvironmentMakesActive) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a program of its own: the built-in one is made once
  const auto build = [] {
    setenv("OCIO_ACTIVE_DISPLAYS", "projector of the house", 1);
    const ColorConfig config("");
    Image image(ImageSpec::rgb(1, 1), 0.18F);
    config.applyView(image.span(), "acescg", {});
    const bool kept = std::string(getenv("OCIO_ACTIVE_DISPLAYS")) == "projector of the house";
    std::exit(kept && config.displays().size() > 3 ? 0 : 1);
  };
  EXPECT_EXIT(build(), ::testing::ExitedWithCode(0), "");
}

TEST(ColorConfig, ActiveDisplaysAndViewsAndFileRulesAreHonoured) {
  const ColorConfig config(kHandMade);
  EXPECT_EQ(config.title(), "hand-made");
  EXPECT_THAT(config.displays(), ElementsAre("Projector", "Monitor"));
  EXPECT_THAT(config.views("Monitor"), ElementsAre("Film", "Warm film", "Print", "Plain", "Log"));
  EXPECT_EQ(config.colorSpaceOfFile("wall.png"), "monitor");
  EXPECT_EQ(config.colorSpaceOfFile("/shots/plate_0101.exr"), "log_camera");
  EXPECT_EQ(config.colorSpaceOfFile("/shots/shot_01.exr"), "") << "only the default rule";
  EXPECT_EQ(ColorConfig("").colorSpaceOfFile("wall.png"), "");
}

TEST(ColorConfig, AViewsLookIsApplied) {
  const ColorConfig config(kHandMade);
  Image plain = colours(), warm = colours();
  config.applyView(plain.span(), "lin_rec709", {"Monitor", "Film"});
  config.applyView(warm.span(), "lin_rec709", {"Monitor", "Warm film"});
  EXPECT_GT(warm.plane(0)[4], plain.plane(0)[4] + 0.005F);
  EXPECT_LT(warm.plane(2)[4], plain.plane(2)[4] - 0.005F);
}

/// The largest difference of two pictures.
float apart(const Image& a, const Image& b) {
  float worst = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p)
      worst = std::max(worst, std::abs(a.plane(c)[p] - b.plane(c)[p]));
  return worst;
}

TEST(ColorConfig, AChosenLookTakesThePlaceOfTheViewsOwn) {
  const ColorConfig config(kHandMade);
  EXPECT_THAT(config.looks(), ElementsAre("warm", "bleach"));
  EXPECT_EQ(config.viewLook("Monitor", "Warm film"), "warm");
  EXPECT_EQ(config.viewLook("Monitor", "Film"), "");
  EXPECT_THAT(config.lookDescription("bleach"), HasSubstr("silver"));
  const auto shown = [&](const std::string& view, std::optional<std::string> look) {
    Image image = colours();
    config.applyView(image.span(), "lin_rec709", {"Monitor", view, std::move(look)});
    return image;
  };
  const Image film = shown("Film", {}), warm = shown("Warm film", {});
  EXPECT_EQ(apart(shown("Film", "warm"), warm), 0);
  EXPECT_EQ(apart(shown("Warm film", ""), film), 0);
  EXPECT_GT(apart(shown("Warm film", "bleach"), warm), 0.05F) << "not on top of the view's own";
  EXPECT_EQ(apart(shown("Warm film", "bleach"), shown("Film", "+bleach")), 0);
  EXPECT_LT(apart(shown("Film", "+warm, -warm"), film), 2e-4F);
  EXPECT_GT(apart(shown("Film", "+warm, bleach"), shown("Film", "bleach")), 0.02F);
}

TEST(ColorConfig, ALookThatTheConfigurationLacksIsListedAndLeftOut) {
  const ColorConfig config(kHandMade);
  EXPECT_THAT(inputError([&] {
                config.checkView({"Monitor", "Film", "+warm, -cold"});
              }),
              AllOf(HasSubstr("no look 'cold'"), HasSubstr("warm, bleach")));
  EXPECT_EQ(displayWithin(config, {"Monitor", "Film", "cold"}), (DisplayChoice{"Monitor", "Film"}));
  EXPECT_EQ(displayWithin(config, {"TV", "Film", "-warm"}), (DisplayChoice{"", "", "-warm"}));
  EXPECT_EQ(displayWords({"Monitor", "Film", ""}), "Monitor \u00b7 Film \u00b7 no look");
  EXPECT_EQ((DisplayChoice{"", "", "bleach"}).over({"Monitor", "Film", "warm"}),
            (DisplayChoice{"Monitor", "Film", "bleach"}));
  EXPECT_EQ((DisplayChoice{"", "Log"}).over({"Monitor", "Film", "warm"}), (DisplayChoice{"", "Log"}));
}

TEST(ColorConfig, TheBuiltInGamutCompressionKeepsGreysAndBringsPureColoursNearer) {
  const ColorConfig config("");
  ASSERT_THAT(config.looks(), ElementsAre("Gamut compression", "Blue light fix"));
  Image image(ImageSpec::rgb(2, 1), 0);
  for (int c = 0; c < 3; ++c) image.plane(c)[0] = 0.18F;
  const std::array<float, 3> neon{0, 0.1F, 0.9F};  // a blue LED
  for (int c = 0; c < 3; ++c) image.plane(c)[1] = neon[static_cast<size_t>(c)];
  Image plain = image.clone();
  config.applyView(plain.span(), "lin_rec709", {"sRGB", "sRGB"});
  config.applyView(image.span(), "lin_rec709", {"sRGB", "sRGB", "Gamut compression"});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.plane(c)[0], plain.plane(c)[0], 2e-4F);
  EXPECT_EQ(plain.plane(0)[1], 0);
  EXPECT_GT(image.plane(0)[1], 0.05F);
}

TEST(ColorConfig, AViewWhoseTableIsMissingIsSaid) {
  const TemporaryFolder folder;
  std::filesystem::copy(kHandMade, folder / "config.ocio");
  const ColorConfig config((folder / "config.ocio").string());
  config.checkView({"Monitor", "Plain"});
  EXPECT_THAT(inputError([&] {
                config.checkView({"Monitor", "Film"});
              }),
              AllOf(HasSubstr("config.ocio"), HasSubstr("film.spi1d")));
}

/// Sets $OCIO for as long as it lives.
class OcioVariable {
 public:
  explicit OcioVariable(const std::string& file) { ::setenv("OCIO", file.c_str(), 1); }
  OcioVariable(const OcioVariable&) = delete;
  OcioVariable& operator=(const OcioVariable&) = delete;
  ~OcioVariable() { ::unsetenv("OCIO"); }
};

TEST(ChosenConfig, ASessionsFileElseTheBuiltIn) {
  EXPECT_EQ(environmentConfig(), nullptr);
  EXPECT_EQ(programConfig()->name(), "built-in");
  EXPECT_EQ(programConfig(kHandMade)->title(), "hand-made");
  EXPECT_THAT(inputError([] { static_cast<void>(programConfig("/nowhere/none.ocio")); }),
              AllOf(HasSubstr("/nowhere/none.ocio"), HasSubstr("color_config")));
}

TEST(ChosenConfig, TheEnvironmentGoesBeforeASession) {
  const OcioVariable good(kHandMade);
  EXPECT_EQ(environmentConfig()->title(), "hand-made");
  EXPECT_EQ(programConfig("/nowhere/none.ocio")->title(), "hand-made");
  const OcioVariable bad("/nowhere/mine.ocio");
  EXPECT_THAT(inputError([] { static_cast<void>(programConfig()); }),
              AllOf(HasSubstr("/nowhere/mine.ocio"), HasSubstr("$OCIO")));
}

/// What a configuration makes of one colour: into another space, and through a view.
std::vector<float> converted(const ColorConfig& config, const std::string& to, const std::string& view) {
  Image image(ImageSpec::rgb(3, 2), .18F);
  image.plane(0)[1] = .9F;
  Image seen = image.clone();
  config.convert(image.span(), "acescg", to);
  config.applyView(seen.span(), "acescg", {"Projector", view});
  std::vector<float> values;
  for (const Image* made : {&image, &seen})
    for (int c = 0; c < 3; ++c)
      values.insert(values.end(), made->plane(c), made->plane(c) + made->pixelCount());
  return values;
}

TEST(ColorConfig, ThreadsThatAskForTheSameAtOnceGetTheSame) {
  const std::vector<std::string> spaces = {"lin_rec709", "srgb", "log_camera", "work", "aces"};
  const std::vector<std::string> views = {"Film", "Plain"};
  std::vector<std::vector<float>> alone;
  for (size_t i = 0; i < 10; ++i)
    alone.push_back(converted(ColorConfig(kHandMade), spaces[i % 5], views[i % 2]));
  const ColorConfig shared(kHandMade);
  std::vector<std::vector<float>> together(40);
  {
    std::vector<std::jthread> threads;
    for (size_t i = 0; i < together.size(); ++i)
      threads.emplace_back([&, i] { together[i] = converted(shared, spaces[i % 5], views[i % 2]); });
  }
  for (size_t i = 0; i < together.size(); ++i) EXPECT_EQ(together[i], alone[i % 10]) << i;
}

TEST(ColorConfig, OpenedAgainReadsATableThatHasChanged) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "config.ocio", R"(ocio_profile_version: 2
search_path: .
roles: {default: lin, scene_linear: lin}
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  d:
    - !<View> {name: v, colorspace: table}
colorspaces:
  - !<ColorSpace> {name: lin, isdata: false}
  - !<ColorSpace>
      name: table
      isdata: false
      from_scene_reference: !<FileTransform> {src: gain.spi1d, interpolation: linear}
)");
  const auto white = [&](const char* last) {
    test::writeBytes(folder / "gain.spi1d",
                     std::string("Version 1\nFrom 0 1\nLength 2\nComponents 1\n{\n0\n") + last + "\n}\n");
    Image pixel(ImageSpec::rgb(1, 1), 1.0F);
    ColorConfig((folder / "config.ocio").string()).convert(pixel.span(), "lin", "table");
    return pixel.plane(0)[0];
  };
  EXPECT_FLOAT_EQ(white("0.5"), 0.5F);
  EXPECT_FLOAT_EQ(white("0.25"), 0.25F);
}

TEST(ColorConfig, ABrokenConfigurationIsSaidInOneLine) {
  const TemporaryFolder folder;
  EXPECT_THAT(inputError([&] { const ColorConfig config((folder / "none.ocio").string()); }),
              HasSubstr("none.ocio"));
  test::writeBytes(folder / "bad.ocio", "ocio_profile_version: 2\nroles: [\n");
  EXPECT_THAT(inputError([&] { const ColorConfig config((folder / "bad.ocio").string()); }),
              HasSubstr("bad.ocio"));
}

}  // namespace
}  // namespace swaplight

#include "core/measure/evaluate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/base/json.h"
#include "core/image/io/image_io.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

class Evaluate : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return m_folder / name; }
  std::filesystem::path write(const std::string& name, const Image& image,
                              const std::string& type = "") const {
    WriteOptions options;
    options.pixelType = type;
    writeImage(image, file(name), options);
    return file(name);
  }
  static Image ramp(int width, int height, float gain) {
    Image image(ImageSpec::rgb(width, height));
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p)
        image.plane(c)[p] = gain * static_cast<float>(p % 50) / 50.f * (1.f - .2f * static_cast<float>(c));
    return image;
  }

 private:
  test::TemporaryFolder m_folder;
};

TEST_F(Evaluate, ExposesTheReferencesBrightPartToNineTenths) {
  const auto test = write("a.exr", ramp(50, 20, 8.2f), "float");
  const auto reference = write("b.exr", ramp(50, 20, 8.f), "float");
  const Evaluation bright = evaluate(test, reference);
  EXPECT_FALSE(bright.encoded);
  EXPECT_NEAR(bright.scale, .9 / (8 * .98), 1e-3);
  // The same pair, dimmer by 8: the same colour difference.
  const Evaluation dim =
      evaluate(write("c.exr", ramp(50, 20, 1.025f), "float"), write("d.exr", ramp(50, 20, 1), "float"));
  EXPECT_NEAR(dim.differences[0].value, bright.differences[0].value, 1e-3);
  EXPECT_NEAR(dim.differences[1].value, bright.differences[1].value / 8, 1e-5);
  EXPECT_GT(bright.differences[0].value, .3);

  EvaluateOptions options;
  options.scale = 1.f;
  EXPECT_EQ(evaluate(test, reference, options).scale, 1);
  options.scale = -1.f;
  EXPECT_THAT(test::inputError([&] { (void)evaluate(test, reference, options); }), HasSubstr("above 0"));
}

TEST_F(Evaluate, ComparesCodeValuesOfEncodedFilesAndLinearLightOfMixedOnes) {
  const auto png = write("a.png", Image(ImageSpec::rgb(8, 8), .6f));
  const auto other = write("b.png", Image(ImageSpec::rgb(8, 8), .4f));
  const Evaluation coded = evaluate(png, other);
  EXPECT_TRUE(coded.encoded);
  EXPECT_EQ(coded.scale, 1);
  EXPECT_NEAR(coded.differences[1].value, .2, 1e-6);
  const float linear = static_cast<float>(std::pow((.6 + .055) / 1.055, 2.4));
  const Evaluation mixed = evaluate(png, write("c.exr", Image(ImageSpec::rgb(8, 8), linear), "float"));
  EXPECT_FALSE(mixed.encoded);
  EXPECT_NEAR(mixed.differences[0].value, 0, 1e-3);
}

TEST_F(Evaluate, TakesTheBeautyOutOfManyChannels) {
  Image layers(ImageSpec{4, 4, {"R", "G", "B", "key.R", "key.G", "key.B"}, "lin_rec709"}, .5f);
  std::fill_n(layers.plane(3), 16, 9.f);
  EXPECT_EQ(
      evaluate(write("a.exr", layers), write("b.exr", Image(ImageSpec::rgb(4, 4), .5f))).differences[1].value,
      0);
  const auto none = write("none.exr", Image(ImageSpec{4, 4, {"u", "v", "w"}, "data"}, 0.f));
  EXPECT_THAT(test::inputError([&] { (void)evaluate(none, file("b.exr")); }),
              testing::AllOf(HasSubstr("none.exr"), HasSubstr("u, v, w"), HasSubstr("R, G, B")));
}

TEST_F(Evaluate, ComparesNumbersChannelByChannel) {
  Image beta(ImageSpec{4, 4, {"beta.fill", "beta.key"}, "data"}, .5f);
  const auto reference = write("b.exr", beta, "float");
  std::fill_n(beta.plane(1), 16, .7f);
  const auto test = write("a.exr", beta, "float");
  const Evaluation e = evaluate(test, reference);
  EXPECT_THAT(e.channels, testing::ElementsAre("beta.fill", "beta.key"));
  EXPECT_EQ(e.scale, 1);
  ASSERT_EQ(e.differences.size(), 3u);  // of all but de2000
  EXPECT_NEAR(e.differences[0].value, .1, 1e-6);
  ASSERT_EQ(e.parts.size(), 2u);
  EXPECT_EQ(e.parts[0].differences[0].value, 0);
  EXPECT_NEAR(e.parts[1].differences[0].value, .2, 1e-6);
  EXPECT_NEAR(e.parts[1].differences[2].value, -20 * std::log10(.2), 1e-4);

  EvaluateOptions options;
  options.channels = {"*.key"};
  const Evaluation key = evaluate(test, reference, options);
  EXPECT_THAT(key.channels, testing::ElementsAre("beta.key"));
  EXPECT_NEAR(key.differences[0].value, .2, 1e-6);
  EXPECT_TRUE(key.parts.empty());
  options.channels = {"beta.back"};
  EXPECT_THAT(test::inputError([&] { (void)evaluate(test, reference, options); }),
              testing::AllOf(HasSubstr("beta.back"), HasSubstr("beta.fill, beta.key")));
  options.channels.clear();
  options.metrics = {Metric::DeltaE2000};
  EXPECT_THAT(test::inputError([&] { (void)evaluate(test, reference, options); }), HasSubstr("absdiff"));
}

TEST_F(Evaluate, MeasuresRegionsAtTheExposureOfTheWhole) {
  Image changed = ramp(50, 20, 1);
  for (int x = 10; x < 20; ++x) changed.span().at(1, x, 3) += .3f;
  EvaluateOptions options;
  options.regions = {regionFromText("line=10,3,10,1"), regionFromText("0,5,50,15")};
  const auto test = write("a.exr", changed, "float");
  const auto reference = write("b.exr", ramp(50, 20, 1), "float");
  const Evaluation e = evaluate(test, reference, options);
  ASSERT_EQ(e.parts.size(), 2u);
  EXPECT_EQ(e.parts[0].name, "line");
  EXPECT_NEAR(e.parts[0].differences[1].value, .1, 1e-6);
  EXPECT_EQ(e.parts[1].name, "0,5,50,15");
  EXPECT_EQ(e.parts[1].differences[0].value, 0);
  // All that differs lies in the line: the mean over the picture is the line's over its share.
  EXPECT_NEAR(e.differences[0].statistics.mean, e.parts[0].differences[0].statistics.mean * 10 / 1000, 1e-6);
  options.regions = {{"outside", {45, 0, 6, 1}}};
  EXPECT_THAT(test::inputError([&] { (void)evaluate(test, reference, options); }),
              testing::AllOf(HasSubstr("a.exr"), HasSubstr("outside"), HasSubstr("50 x 20")));
  for (const char* wrong : {"=1,1,2,2", "a=1,1,2", "1,1,0,2", ""})
    EXPECT_THAT(test::inputError([&] { (void)regionFromText(wrong); }), HasSubstr("X,Y,WIDTH,HEIGHT"));
}

TEST_F(Evaluate, SaysBothSizesWhereTheyDiffer) {
  const auto a = write("a.exr", ramp(5, 4, 1));
  const auto b = write("b.exr", ramp(4, 5, 1));
  EXPECT_THAT(test::inputError([&] { (void)evaluate(a, b); }),
              testing::AllOf(HasSubstr("5x4"), HasSubstr("4x5")));
}

TEST_F(Evaluate, WritesPlotAndMapAndBothKindsOfReport) {
  EvaluateOptions options;
  options.plot = file("box.png");
  options.map = file("map.png");
  const Evaluation e = evaluate(write("a.exr", ramp(50, 20, 1.1f)), write("b.exr", ramp(50, 20, 1)), options);
  EXPECT_GT(readImageSpec(options.plot).width, 500);
  EXPECT_GT(readImageSpec(options.map).width, 50);

  const Json json = jsonFromEvaluation(e);
  for (const char* metric : {"de2000", "absdiff", "rmse", "psnr"})
    for (const char* key : {"value", "mean", "median", "p95", "p99", "max", "std", "q1", "q3", "whisker_low",
                            "whisker_high", "outliers"})
      EXPECT_TRUE(json.at(metric).at(key).is_number()) << metric << " " << key;
  const std::string text = textFromEvaluation(e);
  EXPECT_THAT(text, HasSubstr("50 x 20 pixels"));
  EXPECT_THAT(text, HasSubstr("outliers"));
}

}  // namespace
}  // namespace swaplight

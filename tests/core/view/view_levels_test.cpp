#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/view/display/display_table.h"
#include "core/view/display/exact_view.h"
#include "core/view/window_pixels.h"
#include "tests/support/processor_levels.h"

namespace swaplight {
namespace {

Image randomPicture(int width, int height) {
  Image image(ImageSpec::rgb(width, height));
  std::mt19937 random(8);
  std::uniform_real_distribution<float> stops(-9, 3), level(0, 1);
  for (size_t p = 0; p < image.pixelCount(); ++p) {
    const float strength = std::exp2(stops(random));
    for (int c = 0; c < 3; ++c) image.plane(c)[p] = strength * level(random);
  }
  return image;
}

std::vector<uint8_t> codesOf(const DisplayTable& table, const Image& image) {
  std::vector<uint8_t> codes(image.pixelCount() * 4);
  table.apply(image.plane(0), image.plane(1), image.plane(2), int(image.pixelCount()), codes.data());
  return codes;
}

/// The codes of a table made and used at each level, against those of the plainest.
void expectSameCodes(const DisplayChoice& display, const ViewSettings& settings) {
  const ColorConfig config("");
  const Image image = randomPicture(301, 70);
  std::vector<uint8_t> plain;
  ViewSettings shown = settings;
  shown.display = display;
  test::atEveryLevel([&] {
    const std::vector<uint8_t> codes = codesOf(DisplayTable(config, "lin_rec709", shown), image);
    if (plain.empty()) plain = codes;
    size_t other = 0;
    for (size_t i = 0; i < codes.size(); ++i) {
      ASSERT_LE(std::abs(int(codes[i]) - int(plain[i])), 1) << display.view << ", value " << i;
      other += codes[i] != plain[i];
    }
    EXPECT_LT(double(other), .005 * double(codes.size())) << display.view;
  });
}

TEST(ViewLevels, EveryViewOfTheBuiltInConfigurationShowsTheSameAtEveryLevel) {
  const ColorConfig config("");
  for (const std::string& display : config.displays())
    for (const std::string& view : config.views(display)) expectSameCodes({display, view}, {});
}

TEST(ViewLevels, SettingsOfTheViewerShowTheSameAtEveryLevel) {
  const ColorConfig config("");
  const std::string display = config.displays().front();
  const std::string view = config.views(display).front();
  for (const ViewChannel channel : {ViewChannel::Red, ViewChannel::Luminance}) {
    ViewSettings settings;
    settings.exposureStops = 1.5F;
    settings.channel = channel;
    expectSameCodes({display, view}, settings);
  }
}

TEST(ViewLevels, AWindowIsTheSameAtEveryLevel) {
  const Image picture = randomPicture(257, 131);
  const Pyramid pyramid(picture.view());
  const ViewLayer layers[] = {{&pyramid, {1, 2, .5F}}, {&pyramid, {.25F, 0, 1}}, {&pyramid, {.1F, .2F, .3F}}};
  for (const double zoom : {.3, .8, 1.0, 1.7, 5.0}) {
    const ViewWindow window{3, 2, zoom, 60, 30};
    Image plain(ImageSpec::rgb(60, 30)), out(ImageSpec::rgb(60, 30));
    {
      const test::AtLevel first(1);
      windowLinear(layers, window, plain.span());
    }
    test::atEveryLevel([&] {
      windowLinear(layers, window, out.span());
      for (int c = 0; c < 3; ++c)
        for (size_t p = 0; p < out.pixelCount(); ++p)
          ASSERT_NEAR(out.plane(c)[p], plain.plane(c)[p], 2e-6F * (1 + plain.plane(c)[p])) << zoom;
    });
  }
}

}  // namespace
}  // namespace swaplight

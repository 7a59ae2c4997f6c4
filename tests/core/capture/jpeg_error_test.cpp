#include "core/capture/jpeg/jpeg_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/capture/capture_pixels.h"
#include "core/image/io/image_bytes.h"
#include "core/image/io/image_io.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::TemporaryFolder;

constexpr int kWidth = 192, kHeight = 128;

/// As much contrast in every octave from pixels of `finest` on, in brightness and, half as much, in colour.
Image texture(int finest, float contrast) {
  Image image(ImageSpec::rgb(kWidth, kHeight), .5F);
  std::mt19937 random(3);
  std::normal_distribution<float> gauss;
  for (int size = finest; size <= 32; size *= 2) {
    const int columns = kWidth / size + 2;
    std::vector<float> knots[4];
    for (auto& plane : knots)
      for (int j = 0; j < columns * (kHeight / size + 2); ++j) plane.push_back(contrast * gauss(random));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const float u = float(x % size) / float(size), v = float(y % size) / float(size);
        const auto at = [&](int plane) {
          const float* knot = &knots[plane][size_t(y / size * columns + x / size)];
          return std::lerp(std::lerp(knot[0], knot[1], u), std::lerp(knot[columns], knot[columns + 1], u), v);
        };
        for (int c = 0; c < 3; ++c) image.span().row(c, y)[x] += at(3) + .5F * at(c);
      }
  }
  return image;
}

double meanSquaredDifference(const Image& a, const Image& b) {
  double sum = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p) sum += std::pow(double(a.plane(c)[p] - b.plane(c)[p]), 2);
  return sum / (3 * double(a.pixelCount()));
}

double meanVariance(const std::vector<ValueVariance>& points) {
  double sum = 0;
  for (const ValueVariance& point : points) sum += double(point.variance);
  return sum / double(points.size());
}

WriteOptions ofQuality(int quality) {
  WriteOptions options;
  options.jpegQuality = quality;
  return options;
}

/// Colour stored once for 2 x 2 pixels.
void writeSubsampled(const Image& image, const std::filesystem::path& file, int quality) {
  test::writeBytes(file, jpegBytes(image, quality));
}

TEST(JpegError, IsFoundFromTheFileAlone) {
  const TemporaryFolder folder;
  const auto file = folder / "shot.jpg";
  for (const bool subsampled : {false, true})
    for (const int quality : {75, 90, 97})
      for (const float contrast : {.01F, .04F}) {
        SCOPED_TRACE(testing::Message() << quality << (subsampled ? " 4:2:0 " : " 4:4:4 ") << contrast);
        const Image exact = texture(2, contrast);  // no lens resolves single pixels
        if (subsampled)
          writeSubsampled(exact, file, quality);
        else
          writeImage(exact, file, ofQuality(quality));
        const auto coding = readJpegCoding(file);
        ASSERT_TRUE(coding);
        EXPECT_EQ(coding->chromaX, subsampled ? 2 : 1);
        EXPECT_EQ(coding->chromaY, subsampled ? 2 : 1);
        const Image decoded = readImage(file).image;
        const double real = meanSquaredDifference(exact, decoded);
        const double found = meanVariance(jpegError(decoded.view(), *coding));
        EXPECT_GT(found, .6 * real);
        EXPECT_LT(found, 1.7 * real);
      }
}

TEST(JpegError, OfASmoothPictureIsFarLessThanHalfASteps) {
  const TemporaryFolder folder;
  const Image exact = texture(16, .05F);
  writeImage(exact, folder / "shot.jpg", ofQuality(75));
  const auto coding = readJpegCoding(folder / "shot.jpg");
  ASSERT_TRUE(coding);
  double most = 0;
  for (const uint16_t step : coding->steps[0]) most += step * step / 12.0 / 64 / 255 / 255;
  const Image decoded = readImage(folder / "shot.jpg").image;
  const double found = meanVariance(jpegError(decoded.view(), *coding));
  EXPECT_LT(found, .25 * most);
  EXPECT_GT(found, .6 * meanSquaredDifference(exact, decoded));
}

TEST(JpegCoding, HasTheStepsOfTheStandardAtItsQuality) {
  const TemporaryFolder folder;
  writeImage(texture(8, .05F), folder / "shot.jpg", ofQuality(50));
  const auto coding = readJpegCoding(folder / "shot.jpg");
  ASSERT_TRUE(coding);
  // T.81, tables K.1 and K.2: quality 50 are the tables as printed.
  EXPECT_EQ(coding->steps[0][0], 16);
  EXPECT_EQ(coding->steps[0][1], 11);
  EXPECT_EQ(coding->steps[0][8], 12);
  EXPECT_EQ(coding->steps[0][8 * 2 + 5], 57) << "row 2, column 5";
  EXPECT_EQ(coding->steps[0][63], 99);
  EXPECT_EQ(coding->steps[1][0], 17);
  EXPECT_EQ(coding->steps[1][2], 24);
  EXPECT_EQ(coding->steps[2], coding->steps[1]);
}

TEST(JpegCoding, IsNothingOfOtherAndOfBrokenFiles) {
  const TemporaryFolder folder;
  EXPECT_FALSE(readJpegCoding(folder / "missing.jpg"));
  const Image image = texture(8, .05F);
  writeImage(image, folder / "shot.png");
  EXPECT_FALSE(readJpegCoding(folder / "shot.png"));
  writeImage(image, folder / "shot.jpg");
  const std::string whole = test::readBytes(folder / "shot.jpg");
  const size_t header = whole.find("\xFF\xDA");
  ASSERT_NE(header, std::string::npos);
  for (size_t length = 0; length < header + 2; length += 7) {
    test::writeBytes(folder / "cut.jpg", whole.substr(0, length));
    EXPECT_FALSE(readJpegCoding(folder / "cut.jpg")) << length;
  }
}

TEST(JpegError, IsOfLinearLightInACapture) {
  const TemporaryFolder folder;
  Capture capture;
  capture.folder = folder.path();
  capture.lights = {{"key", Role::Key, {}}};
  capture.shots = {{"one.jpg", {Rgb(1)}, {}, 0, false, {}}};
  capture.colorSpace = "srgb";
  const Image codes = texture(2, .08F);
  writeSubsampled(codes, folder / "one.jpg", 90);
  const CapturePixels pixels = loadCapturePixels(test::builtinColors(), capture);
  ASSERT_GT(pixels.codingError.size(), 3U);
  for (const ValueVariance& at : pixels.codingError) {
    EXPECT_GT(at.value, 0);
    EXPECT_LE(at.value, 1);
  }
  // The slope of the curve at half the code is a third of that at white.
  EXPECT_LT(pixels.codingError.front().variance, .5F * pixels.codingError.back().variance);
  capture.frame.scale = .5;
  const CapturePixels half = loadCapturePixels(test::builtinColors(), capture);
  EXPECT_FLOAT_EQ(half.codingError.front().variance, .5F * pixels.codingError.front().variance);
}

}  // namespace
}  // namespace swaplight

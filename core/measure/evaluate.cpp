#include "core/measure/evaluate.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/color/srgb.h"
#include "core/image/io/image_io.h"
#include "core/image/rgb_image.h"
#include "core/measure/difference_picture.h"
#include "core/plot/plot.h"

namespace swaplight {
namespace {

void linearize(Image& image) {
  for (int c = 0; c < 3; ++c)
    for (float& v : std::span(image.plane(c), image.pixelCount())) v = linearFromSrgb(v);
}

}  // namespace

Evaluation evaluate(const std::filesystem::path& test, const std::filesystem::path& reference,
                    const EvaluateOptions& options) {
  ImageFile testFile = readImage(test);
  ImageFile referenceFile = readImage(reference);
  PicturePair pair{rgbImage(std::move(testFile.image), test),
                   rgbImage(std::move(referenceFile.image), reference)};
  if (pair.test.width() != pair.reference.width() || pair.test.height() != pair.reference.height())
    throw InputError("{} is {}x{}, {} is {}x{}: only pictures of one size can be compared", test.string(),
                     pair.test.width(), pair.test.height(), reference.string(), pair.reference.width(),
                     pair.reference.height());

  // Bring both to one encoding and exposure.
  const bool testEncoded = !testFile.info.isFloat;
  const bool referenceEncoded = !referenceFile.info.isFloat;
  pair.encoded = testEncoded && referenceEncoded;
  if (testEncoded && !referenceEncoded) linearize(pair.test);
  if (referenceEncoded && !testEncoded) linearize(pair.reference);
  if (options.scale && !(std::isfinite(*options.scale) && *options.scale > 0))
    throw InputError("scale {}: give a number above 0, as the factor that linear light is shown with",
                     *options.scale);
  if (!testEncoded && !referenceEncoded)
    pair.scale = options.scale.value_or(displayScale(pair.reference.view()));

  Evaluation result{
      test.string(), reference.string(), pair.test.width(), pair.test.height(), pair.encoded, pair.scale, {}};
  for (const Metric metric : options.metrics) result.differences.push_back(difference(pair, metric));

  if (options.luminance || !options.histogram.empty()) {
    for (Image* image : {&pair.test, &pair.reference}) {
      if (pair.encoded) linearize(*image);
      image->setColorSpace("lin_rec709");
    }
    result.testLuminance = luminanceHistogram(pair.test);
    result.referenceLuminance = luminanceHistogram(pair.reference);
  }
  if (!options.histogram.empty())
    writeImage(
        drawLuminanceHistograms({{"test", *result.testLuminance}, {"reference", *result.referenceLuminance}}),
        options.histogram);
  if (!options.plot.empty()) writeImage(drawDifferencePlot(result.differences), options.plot);
  if (!options.map.empty())
    writeImage(drawDifferenceMap(result.differences.front(), options.mapMaximum), options.map);
  return result;
}

Json jsonFromEvaluation(const Evaluation& e) {
  Json json = {{"test", e.test},
               {"reference", e.reference},
               {"width", e.width},
               {"height", e.height},
               {"encoding", e.encoded ? "srgb" : "linear"},
               {"scale", e.scale}};
  for (const Difference& d : e.differences) {
    Json& metric = json[metricName(d.metric)];
    metric["value"] = d.value;
    metric.update(jsonFromStatistics(d.statistics));
  }
  if (e.testLuminance)
    json["luminance"] = {{"test", jsonFromHistogram(*e.testLuminance)},
                         {"reference", jsonFromHistogram(*e.referenceLuminance)}};
  return json;
}

std::string textFromEvaluation(const Evaluation& e) {
  std::string text =
      fmt::format("{} against {}\n{} x {} pixels, {}\n", e.test, e.reference, e.width, e.height,
                  e.encoded ? std::string("sRGB code values 0..1")
                            : fmt::format("linear light, shown times {:.4g}", e.scale));
  if (const size_t lost = e.differences.front().statistics.notFinite)
    text += fmt::format("{} pixels are not finite in both pictures and were left out\n", lost);
  text += fmt::format("{:8}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n",
                      "metric", "value", "mean", "median", "p95", "p99", "max", "std", "q1", "q3", "whisker-",
                      "whisker+", "outliers");
  for (const Difference& d : e.differences) {
    const Statistics& s = d.statistics;
    text += fmt::format("{:8}", metricName(d.metric));
    for (const double v :
         {d.value, s.mean, s.median, s.p95, s.p99, s.max, s.std, s.q1, s.q3, s.whiskerLow, s.whiskerHigh})
      text += fmt::format("{:>10.4g}", v);
    text += fmt::format("{:>10}\n", s.outliers);
  }
  return text;
}

}  // namespace swaplight

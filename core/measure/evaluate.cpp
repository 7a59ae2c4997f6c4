#include "core/measure/evaluate.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/image/cropped_image.h"
#include "core/image/io/image_io.h"
#include "core/measure/compared_pictures.h"
#include "core/measure/difference_picture.h"
#include "core/plot/plot.h"

namespace swaplight {
namespace {

std::vector<Metric> metricsOf(const std::vector<Metric>& asked, bool numbers) {
  const bool colors = std::find(asked.begin(), asked.end(), Metric::DeltaE2000) != asked.end();
  if (numbers && colors)
    throw InputError(
        "de2000 is a difference of colours, and these channels are compared as numbers: give "
        "--metric absdiff, rmse or psnr");
  if (!asked.empty()) return asked;
  if (numbers) return {Metric::AbsDiff, Metric::Rmse, Metric::Psnr};
  return {Metric::DeltaE2000, Metric::AbsDiff, Metric::Rmse, Metric::Psnr};
}

Image channelOf(const Image& image, int channel) {
  Image one(ImageSpec{image.width(), image.height(), {image.spec().channels[size_t(channel)]}, "data"});
  std::copy_n(image.plane(channel), image.pixelCount(), one.plane(0));
  return one;
}

PicturePair croppedPair(const PicturePair& pair, const EvaluatedRegion& region, const std::string& file) {
  const std::string name = file + ", region " + region.name;
  return {croppedImage(pair.test, region.pixels, name), croppedImage(pair.reference, region.pixels, name),
          pair.encoded, pair.scale};
}

Image plotOf(const Evaluation& e) {
  std::vector<PlottedDifferences> parts{{e.parts.empty() ? "all pixels" : "all", &e.differences}};
  for (const Evaluation::Part& part : e.parts) parts.push_back({part.name, &part.differences});
  return drawDifferencePlot(parts);
}

Json jsonFromDifferences(const std::vector<Difference>& differences) {
  Json json = Json::object();
  for (const Difference& d : differences) {
    Json& metric = json[metricName(d.metric)];
    metric["value"] = d.value;
    metric.update(jsonFromStatistics(d.statistics));
    if (d.shareAbove) metric["share_above"] = *d.shareAbove;
  }
  return json;
}

std::string encodingText(const Evaluation& e) {
  if (!e.channels.empty()) return fmt::format("as numbers: {}", fmt::join(e.channels, ", "));
  if (e.encoded) return "sRGB code values 0..1";
  return fmt::format("linear light, shown times {:.4g}", e.scale);
}

std::string rowsOf(const std::vector<Difference>& differences) {
  std::string text;
  for (const Difference& d : differences) {
    const Statistics& s = d.statistics;
    text += fmt::format("{:8}", metricName(d.metric));
    for (const double v :
         {d.value, s.mean, s.median, s.p95, s.p99, s.max, s.std, s.q1, s.q3, s.whiskerLow, s.whiskerHigh})
      text += fmt::format("{:>10.4g}", v);
    text += fmt::format("{:>10}", s.outliers);
    if (d.shareAbove) text += fmt::format("{:>9.2f}%", 100 * *d.shareAbove);
    text += '\n';
  }
  return text;
}

}  // namespace

EvaluatedRegion regionFromText(const std::string& text) {
  const size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const std::optional<PixelRect> rect =
      rectFromText(equals == std::string::npos ? text : text.substr(equals + 1));
  if (!rect || rect->empty() || name.empty())
    throw InputError("--region {}: give X,Y,WIDTH,HEIGHT in pixels, or NAME=X,Y,WIDTH,HEIGHT", text);
  return {name, *rect};
}

Evaluation evaluate(const std::filesystem::path& test, const std::filesystem::path& reference,
                    const EvaluateOptions& options) {
  ComparedPictures compared = readCompared(test, reference, options.channels, options.scale);
  PicturePair& pair = compared.pair;
  const std::vector<Metric> metrics = metricsOf(options.metrics, compared.numbers);
  const auto differencesOf = [&](const PicturePair& pictures, const std::string& name) {
    std::vector<Difference> differences;
    try {
      for (const Metric metric : metrics)
        differences.push_back(difference(pictures, metric, options.difference));
    } catch (const InputError& error) {
      throw InputError("{}: {}", name, error.what());
    }
    return differences;
  };
  const auto addPart = [&](std::vector<Evaluation::Part>& parts, const std::string& name,
                           const std::optional<PixelRect>& pixels, const PicturePair& pictures) {
    Evaluation::Part& part = parts.emplace_back(
        Evaluation::Part{name, pixels, differencesOf(pictures, test.string() + ", " + name)});
    for (Difference& d : part.differences) d.map = Image();  // which nobody looks at
  };

  Evaluation result;
  result.test = test.string();
  result.reference = reference.string();
  result.width = pair.test.width();
  result.height = pair.test.height();
  result.encoded = pair.encoded;
  result.warnings = compared.warnings;
  result.scale = pair.scale;
  if (compared.numbers) result.channels = pair.test.spec().channels;
  result.differences = differencesOf(pair, test.string());
  if (result.channels.size() > 1)
    for (size_t c = 0; c < result.channels.size(); ++c)
      addPart(result.parts, result.channels[c], {},
              {channelOf(pair.test, int(c)), channelOf(pair.reference, int(c))});
  for (const EvaluatedRegion& region : options.regions)
    addPart(result.parts, region.name, region.pixels, croppedPair(pair, region, test.string()));

  if (compared.numbers && !options.histogram.empty())
    throw InputError("{}: numbers have no luminance; leave the histogram out", options.histogram.string());
  if (!compared.numbers && (options.luminance || !options.histogram.empty())) {
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
  if (!options.plot.empty()) writeImage(plotOf(result), options.plot);
  if (!options.map.empty())
    writeImage(drawDifferenceMap(result.differences.front(), options.mapMaximum), options.map);
  return result;
}

Json jsonFromEvaluation(const Evaluation& e) {
  const char* linearOrCodes = e.encoded ? "srgb" : "linear";
  Json json = {{"test", e.test},
               {"reference", e.reference},
               {"width", e.width},
               {"height", e.height},
               {"encoding", e.channels.empty() ? linearOrCodes : "numbers"},
               {"scale", e.scale}};
  json.update(jsonFromDifferences(e.differences));
  if (!e.channels.empty()) json["compared"] = e.channels;
  for (const Evaluation::Part& part : e.parts) {
    Json figures = jsonFromDifferences(part.differences);
    if (part.pixels)
      figures["pixels"] = {part.pixels->x, part.pixels->y, part.pixels->width, part.pixels->height};
    json[part.pixels ? "regions" : "channels"][part.name] = std::move(figures);
  }
  if (e.testLuminance)
    json["luminance"] = {{"test", jsonFromHistogram(*e.testLuminance)},
                         {"reference", jsonFromHistogram(*e.referenceLuminance)}};
  if (!e.warnings.empty()) json["warnings"] = e.warnings;
  return json;
}

std::string textFromEvaluation(const Evaluation& e) {
  std::string text = fmt::format("{} against {}\n{} x {} pixels, {}\n", e.test, e.reference, e.width,
                                 e.height, encodingText(e));
  if (const size_t lost = e.differences.front().statistics.notFinite)
    text += fmt::format(
        "{} pixels are not finite in both pictures, or outside of their data windows, and were left out\n",
        lost);
  text += fmt::format("{:8}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}",
                      "metric", "value", "mean", "median", "p95", "p99", "max", "std", "q1", "q3", "whisker-",
                      "whisker+", "outliers");
  const bool above = std::any_of(e.differences.begin(), e.differences.end(),
                                 [](const Difference& d) { return d.shareAbove.has_value(); });
  text += fmt::format("{}\n{}", above ? "     above" : "", rowsOf(e.differences));
  for (const Evaluation::Part& part : e.parts) text += part.name + ":\n" + rowsOf(part.differences);
  return text;
}

}  // namespace swaplight

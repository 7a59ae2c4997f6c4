#include "core/report/session_report.h"

#include <OpenImageIO/strutil.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/json.h"
#include "core/base/quantile.h"
#include "core/color/srgb.h"
#include "core/image/io/image_bytes.h"
#include "core/image/shrunk_image.h"
#include "core/lamp/kelvin.h"
#include "core/measure/luminance_histogram.h"
#include "core/plot/color_map.h"
#include "core/relight/relight.h"
#include "core/relight/setting.h"
#include "core/set/dynamic_range.h"

namespace swaplight {
namespace {

constexpr int kPictureWidth = 900;
constexpr int kMapWidth = 600;

constexpr const char* kStyle = R"(
@page { size: A4 portrait; margin: 14mm }
body { font: 15px/1.45 Inter, system-ui, sans-serif; color: #1d1f23; background: #fff; margin: 2em auto; max-width: 1000px; padding: 0 1em }
h1 { font-size: 26px; margin: 0 } h2 { font-size: 18px; margin: 1.6em 0 .5em } p { margin: .3em 0 }
.sheet { display: grid; grid-template-columns: 1fr 1fr 1fr; gap: 14px } .sheet strong { color: #1d1f23 }
.quiet { color: #5c6370 } .pair { display: grid; grid-template-columns: 1fr 1fr; gap: 14px }
figure { margin: 0; break-inside: avoid } img { width: 100%; display: block; border-radius: 3px } figcaption { color: #5c6370; font-size: 13px; margin-top: 4px }
table { border-collapse: collapse; width: 100%; break-inside: avoid } td, th { text-align: left; padding: 5px 10px 5px 0; border-bottom: 1px solid #e3e5e8; vertical-align: middle }
th { font-weight: 600; font-size: 13px; color: #5c6370 } td.number { font-variant-numeric: tabular-nums; white-space: nowrap }
.chip { display: inline-block; width: 22px; height: 22px; border-radius: 4px; border: 1px solid #b9bdc4; print-color-adjust: exact; -webkit-print-color-adjust: exact }
.off { color: #9aa0a8 } .scale { height: 10px; border-radius: 2px; margin-top: 6px; print-color-adjust: exact; -webkit-print-color-adjust: exact }
h2 { break-after: avoid }
@media print { body { margin: 0; max-width: none; padding: 0; font-size: 12px } }
@media (max-width: 640px) { .pair { grid-template-columns: 1fr } }
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// At most `width` wide, and no taller than a page is long.
Image shrunk(const Image& image, int width) {
  constexpr int kMostHeights = 8;  // of the width
  const int height = kMostHeights * width;
  const int n = std::max((image.width() + width - 1) / width, (image.height() + height - 1) / height);
  return n <= 1 ? image.clone() : shrunkImage(image, image.width() / n, image.height() / n);
}

std::string inlineImage(const std::string& bytes, const char* type) {
  return fmt::format("data:image/{};base64,{}", type, OIIO::Strutil::base64_encode(bytes));
}

std::string figure(const std::string& source, const std::string& caption) {
  return fmt::format("<figure><img src=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n", source,
                     escaped(caption), escaped(caption));
}

/// A linear picture as the display shows it.
std::string photograph(const ColorConfig& config, const Image& linear, const DisplayChoice& choice,
                       const std::string& caption) {
  const DisplayChoice seen = namedDisplay(config, displayWithin(config, choice));
  Image shown = linear.clone();
  config.applyView(shown.span(), linear.spec().colorSpace, seen);
  return figure(inlineImage(jpegBytes(shown), "jpeg"), fmt::format("{} ({})", caption, displayWords(seen)));
}

double percentile(const float* values, size_t count, double share) {
  std::vector<float> copy(values, values + count);
  return quantile(std::span(copy), share);
}

/// A map in false colour with its scale.
std::string mapFigure(const SolvedSet& set, int channel, const std::string& caption) {
  ImageSpec spec{set.width(), set.height(), {"Y"}, "data"};
  Image plane(spec);
  std::copy_n(set.quality.plane(channel), plane.pixelCount(), plane.plane(0));
  const Image small = shrunk(plane, kMapWidth);
  // Pixels that are nearly black have huge values: the scale is made for the others.
  constexpr double kTopOverMedian = 4;
  const double median = percentile(plane.plane(0), plane.pixelCount(), 0.5);
  const double high = percentile(small.plane(0), small.pixelCount(), 0.99);
  const double top = std::max(1e-6, median > 0 ? std::min(high, kTopOverMedian * median) : high);
  Image colors(ImageSpec::rgb(small.width(), small.height()));
  for (size_t p = 0; p < small.pixelCount(); ++p) {
    const Rgb color = viridis(static_cast<float>(small.plane(0)[p] / top));
    for (int c = 0; c < 3; ++c) colors.plane(c)[p] = color[c];
  }
  std::string gradient;
  for (int i = 0; i <= 8; ++i) {
    const Rgb color = viridis(static_cast<float>(i) / 8) * 255.0F;
    gradient += fmt::format(",rgb({:.0f},{:.0f},{:.0f})", color.x, color.y, color.z);
  }
  return fmt::format(
      "<figure><img src=\"{}\" alt=\"{}\"><div class=\"scale\" "
      "style=\"background:linear-gradient(90deg{})\"></div>"
      "<figcaption>{}: 0 to {:.3g} and above; median {:.3g}</figcaption></figure>\n",
      inlineImage(pngBytes(colors), "png"), escaped(caption), gradient, escaped(caption), top, median);
}

/// Why a light gives nothing, or "on".
std::string stateOf(const Rig& rig, const LightSetting& light) {
  const bool anySolo =
      std::any_of(rig.lights.begin(), rig.lights.end(), [](const auto& l) { return l.solo; });
  if (!light.on) return "off";
  if (light.mute) return "muted";
  return anySolo && !light.solo ? "not solo" : "on";
}

std::string temperatureText(const LightColor& color) {
  const Rgb rgb = colorFactor(color);
  if (std::max({rgb.x, rgb.y, rgb.z}) <= 0) return "";
  const CorrelatedTemperature t = correlatedTemperature(xyFromRec709(rgb));
  if (std::abs(t.duv) > 0.05) return "off the Planckian locus";
  return fmt::format("{:.0f} K, Duv {:+.3f}", t.kelvin, t.duv);
}

std::string lightRow(const Rig& rig, const LightSetting& light, const std::vector<LightRange>& ranges) {
  Rgb color = colorFactor(light.color);
  color /= std::max({color.x, color.y, color.z, 1e-6F});
  const Rgb code = srgbFromLinear(color) * 255.0F;
  const auto range =
      std::find_if(ranges.begin(), ranges.end(), [&](const auto& r) { return r.light == light.light; });
  const double stops = light.stops + (light.multiplier > 0 ? std::log2(light.multiplier) : -INFINITY);
  const std::string state = stateOf(rig, light);
  return fmt::format(
      "<tr{}><td><span class=\"chip\" "
      "style=\"background:rgb({:.0f},{:.0f},{:.0f})\"></span></td><td>{}</td><td>{}</td>"
      "<td class=\"number\">{}</td><td>{}</td><td class=\"number\">{}</td><td>{}</td><td>{}</td>"
      "<td class=\"number\">{}</td></tr>\n",
      state == "on" ? "" : " class=\"off\"", code.x, code.y, code.z, escaped(light.title()),
      roleName(light.role), std::isfinite(stops) ? fmt::format("{:+.2f}", stops) : "dark",
      escaped(colorText(light.color)), temperatureText(light.color), escaped(light.color.gel), state,
      range == ranges.end() ? "" : fmt::format("{:.1f}", range->stops));
}

std::string lightTable(const ReportSubject& subject, const std::vector<LightRange>& ranges) {
  std::string html =
      "<table><tr><th></th><th>Light</th><th>Role</th><th>Stops</th><th>Colour</th><th>Temperature</"
      "th><th>Gel</th>"
      "<th>State</th><th>Range (stops)</th></tr>\n";
  for (const LightSetting& light : subject.rig.lights) html += lightRow(subject.rig, light, ranges);
  if (subject.set.ambient)
    html += fmt::format(
        "<tr><td></td><td>ambient</td><td></td><td class=\"number\">x{:.3g}</td><td colspan=\"5\">what "
        "no light explains</td></tr>\n",
        subject.rig.ambient);
  return html +
         "</table>\n<p class=\"quiet\">Range: from the light's brightest parts (99.9th percentile, unit "
         "white) "
         "down to the noise of the solve.</p>\n";
}

std::string solverSection(const std::optional<SolveReport>& report) {
  std::string html = "<h2>Solve</h2>\n";
  if (!report) return html + "<p>No report in the file.</p>\n";
  html += fmt::format("<p>{}</p>\n", escaped(report->message));
  const std::string error = std::isfinite(report->sigmaMedian)
                                ? fmt::format("{:.1f} % of the pixel", 100 * report->sigmaMedian)
                                : "all of the pixel";
  html += fmt::format(
      "<p class=\"quiet\">Model {}, solver {}; median residual {:.2f} of the expected noise, median "
      "standard error {}.</p>\n",
      escaped(report->model), escaped(report->solver), report->residualMedian, error);
  for (const std::string& warning : report->warnings)
    html += fmt::format("<p>Warning: {}</p>\n", escaped(warning));
  return html;
}

}  // namespace

SessionReport::SessionReport(ReportSubject subject)
    : m_subject(std::move(subject)),
      m_white(taken(sumAtUnitWhite(m_subject.set), "before")),
      m_relit(taken(
          relight(m_subject.set, rigFactors(m_subject.config, m_subject.rig, m_subject.set.colorSpace()),
                  m_subject.rig.ambient),
          "after")),
      m_ranges(dynamicRange(m_subject.set)) {}

Image SessionReport::taken(const Image& picture, const char* name) {
  m_luminance.push_back({name, luminanceHistogram(picture)});
  return shrunk(picture, kPictureWidth);
}

std::string SessionReport::versionSection() const {
  if (m_subject.versions.empty()) return {};
  std::string html = "<h2>Versions</h2>\n<div class=\"sheet\">";
  for (const GalleryPicture& version : m_subject.versions) {
    std::string caption = "<strong>" + escaped(version.name) + "</strong>";
    if (!version.note.empty()) caption += "<br>" + escaped(version.note);
    html += fmt::format("<figure><img src=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
                        inlineImage(jpegBytes(version.codes), "jpeg"), escaped(version.name), caption);
  }
  return html + "</div>\n";
}

std::string SessionReport::html() const {
  const SolvedSet& set = m_subject.set;
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>{0}: lighting report</title><style>{1}</style></head><body>\n"
      "<h1>{0}</h1>\n<p class=\"quiet\">Lighting report. {2}; {3} x {4} pixels, {5} lights, {6} shots.</p>\n",
      escaped(set.capture.name), kStyle, escaped(m_subject.source), set.width(), set.height(),
      set.lightCount(), set.capture.shotCount());
  html += "<h2>Before and after</h2>\n<div class=\"pair\">" +
          photograph(m_subject.config, m_white, m_subject.display, "Every light at unit white") +
          photograph(m_subject.config, m_relit, m_subject.display, "With this rig") + "</div>\n";
  html += versionSection();
  html += "<h2>Lights</h2>\n" + lightTable(m_subject, m_ranges);
  html += solverSection(set.report);
  if (!set.quality.empty())
    html += "<h2>How far to trust it</h2>\n<div class=\"pair\">" +
            mapFigure(set, kResidual, "Residual, in units of its expected noise") +
            mapFigure(set, kSigma, "Standard error, relative to the pixel") + "</div>\n";
  html += "<h2>Luminance</h2>\n" + figure(inlineImage(pngBytes(histogram()), "png"),
                                          "Luminance histogram before (unit white) and after (this rig)");
  return html + "</body></html>\n";
}

Image SessionReport::histogram() const {
  return drawLuminanceHistograms(m_luminance, {1000, 420});
}

Json SessionReport::json() const {
  Json json{{"name", m_subject.set.capture.name},
            {"source", m_subject.source},
            {"rig", jsonFromRig(m_subject.rig)}};
  json["dynamic_range"] = jsonFromRanges(m_ranges);
  json["solver"] = m_subject.set.report ? m_subject.set.report->message : "";
  for (const NamedHistogram& named : m_luminance)
    json["luminance"][named.name] = {{"median_stops", named.histogram.median},
                                     {"below_12_stops", named.histogram.black},
                                     {"above_12_stops", named.histogram.bright}};
  return json;
}

}  // namespace swaplight

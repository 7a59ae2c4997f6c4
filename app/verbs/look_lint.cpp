#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/verbs/look_actions.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/filter/filter_file.h"
#include "render/gl/egl_context.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

/// Files as they are, folders as the .fs files below them.
std::vector<fs::path> filesOf(const std::vector<std::string>& names) {
  std::vector<fs::path> files;
  for (const std::string& name : names) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.emplace_back(name);
      continue;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(name))
      if (entry.path().extension() == ".fs") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool isBuiltIn(const fs::path& file) {
  std::error_code error;
  const fs::path inside = fs::relative(file, builtInFilterFolder(), error);
  return !error && !inside.empty() && *inside.begin() != "..";
}

/// Everything that a frame can hold: dark to bright from left to right, and above it negative, very bright
/// and missing values.
Image hardPicture(FilterSpace space) {
  constexpr int kWidth = 64, kHeight = 36;
  const std::array<float, 6> hard{-1.0F,    -1e-6F, 0.0F,
                                  65504.0F, 1e30F,  std::numeric_limits<float>::quiet_NaN()};
  Image image(ImageSpec::rgb(kWidth, kHeight));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) {
        const float step = static_cast<float>(x + c) / kWidth;
        const bool light = space == FilterSpace::SceneLinear;
        image.span().at(c, x, y) = light && y < 6 ? hard[static_cast<size_t>((x + c + y) % 6)]
                                   : light        ? std::exp2(16 * step - 8)
                                                  : std::min(step, 1.0F);
      }
  return image;
}

/// A picture with detail at every pixel, on which a filter that looks too far is found out.
Image detailedPicture() {
  constexpr int kWidth = 96, kHeight = 64;
  Image image(ImageSpec::rgb(kWidth, kHeight));
  unsigned state = 1;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p) {
      state = state * 1664525U + 1013904223U;  // Numerical Recipes' generator
      const float ramp = static_cast<float>(p % kWidth) / kWidth;
      image.plane(c)[p] = 0.7F * ramp + 0.3F * static_cast<float>(state >> 8) / 16777216.0F;
    }
  return image;
}

size_t notFinite(const Image& image) {
  size_t count = 0;
  for (int c = 0; c < 3; ++c)
    count += static_cast<size_t>(std::count_if(image.plane(c), image.plane(c) + image.pixelCount(),
                                               [](float v) { return !std::isfinite(v); }));
  return count;
}

/// The largest difference of two pictures, relative where they are brighter than 1.
float differenceOf(const Image& a, const Image& b) {
  float most = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p)
      most =
          std::max(most, std::abs(a.plane(c)[p] - b.plane(c)[p]) / std::max(1.0F, std::abs(a.plane(c)[p])));
  return most;
}

/// Loads, compiles and draws a filter; says what is wrong with what it gives.
void drawOnce(const fs::path& file, const LookArguments& arguments, Filter& filter) {
  constexpr float kTileTolerance = 1.0F / 1024;  // interpolation at other coordinates rounds otherwise
  filter = readFilter(file);
  filter.builtIn = isBuiltIn(file);
  ResolvedStage stage{std::make_shared<const Filter>(filter), {}};
  for (const FilterInput& input : filter.inputs) stage.values.push_back(input.standard);
  PipelineOptions options;
  options.mostSecondsPerTile = arguments.mostSeconds;
  options.displayFromScene = [](ImageSpan) {};
  const FilterSpace space = filter.space == FilterSpace::Any ? FilterSpace::SceneLinear : filter.space;
  PipelineRenderer renderer;
  const std::span<const ResolvedStage> stages(&stage, 1);
  if (notFinite(renderer.apply({hardPicture(space), space}, stages, options).image) > 0)
    throw InputError("{}: gives values that are not finite", file.string());
  if (!filter.halo) return;
  const Image whole = renderer.apply({detailedPicture(), space}, stages, options).image;
  options.tileSide = 40;
  const Image parts = renderer.apply({detailedPicture(), space}, stages, options).image;
  if (const float difference = differenceOf(whole, parts); difference > kTileTolerance)
    throw InputError("{}: looks further than its HALO: drawn in parts it differs by {:.3g}", file.string(),
                     difference);
}

}  // namespace

int lintFilters(const LookArguments& arguments, Terminal& terminal) {
  const std::vector<fs::path> files = filesOf(arguments.names);
  if (files.empty()) throw InputError("look lint: name the .fs files to check, or folders of them");
  const EglContext context;
  Json rows = Json::array();
  std::string text;
  size_t bad = 0;
  for (const fs::path& file : files) {
    Filter filter;
    std::string problem;
    try {
      drawOnce(file, arguments, filter);
    } catch (const InputError& error) {
      problem = error.what();
    }
    if (!problem.empty()) ++bad;
    text += (problem.empty() ? file.string() + ": loads, compiles and draws" : problem) + '\n';
    for (const std::string& note : filter.notes) text += fmt::format("{}: note: {}\n", file.string(), note);
    rows.push_back(
        {{"file", file.string()}, {"ok", problem.empty()}, {"problem", problem}, {"notes", filter.notes}});
  }
  text += fmt::format("{} of {} are fine", files.size() - bad, files.size());
  terminal.result(text, {{"files", std::move(rows)}, {"fine", files.size() - bad}, {"broken", bad}});
  return bad == 0 ? 0 : 2;
}

}  // namespace swaplight

#include "core/export/layer_export.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/base/parallel.h"
#include "core/export/filtered_frame.h"
#include "core/export/layer_names.h"
#include "core/file/json_file.h"
#include "core/image/io/image_write.h"
#include "core/image/layer_parts.h"
#include "core/ocio/color_config.h"
#include "core/ocio/luminance.h"
#include "core/relight/relative_light.h"

namespace swaplight {
namespace {

constexpr int kGrain = 64;  // rows
constexpr const char* kViewLayer = "ViewLayer";

/// Every layer, and their sum as it will be read.
struct Layers {
  std::vector<Image> pictures;    ///< of each light, and what no light explains
  std::vector<Image> highlights;  ///< of each light; empty: none are written
  Image sum;
  Image seen;  ///< the sum under the camera look; empty where there is none
};

struct Source {
  const Image* picture;
  Rgb factor;
};

std::vector<Source> sourcesOf(const ColorConfig& config, const SolvedSet& set, const Rig& rig) {
  const std::vector<Rgb> factors = rigFactors(config, rig, set.colorSpace());
  std::vector<Source> sources;
  for (size_t i = 0; i < set.contributions.size(); ++i)
    sources.push_back({&set.contributions[i], factors.at(i)});
  if (set.ambient) sources.push_back({&*set.ambient, Rgb(rig.ambient)});
  return sources;
}

/// Each light's highlights, where the set knows them.
std::vector<Source> highlightSources(const ColorConfig& config, const SolvedSet& set, const Rig& rig) {
  const std::vector<Rgb> factors = rigFactors(config, rig, set.colorSpace());
  std::vector<Source> sources;
  for (size_t i = 0; i < set.highlights.size(); ++i) sources.push_back({&set.highlights[i], factors.at(i)});
  return sources;
}

/// Light as it shines, in the colour space that is asked for.
std::vector<Image> shining(const ColorConfig& config, const SolvedSet& set,
                           const std::vector<Source>& sources, const std::string& colorSpace) {
  std::vector<Image> pictures;
  for (const Source& source : sources) {
    Image& picture = pictures.emplace_back(ImageSpec::rgb(set.width(), set.height()));
    parallelRows(set.height(), kGrain, [&](int begin, int end) {
      const ptrdiff_t first = ptrdiff_t{begin} * set.width();
      const ptrdiff_t last = ptrdiff_t{end} * set.width();
      for (int c = 0; c < 3; ++c) {
        const float* in = source.picture->plane(c);
        float* out = picture.plane(c);
        for (ptrdiff_t p = first; p < last; ++p) out[p] = source.factor[c] * in[p];
      }
    });
    config.convert(picture.span(), set.colorSpace(), colorSpace);
  }
  return pictures;
}

std::vector<const Image*> pointersTo(const std::vector<Image>& images) {
  std::vector<const Image*> pointers;
  for (const Image& image : images) pointers.push_back(&image);
  return pointers;
}

/// The sum as the camera look shows it, as light of this colour space.
Image seenThroughLook(const ColorConfig& config, FilteredImage sum, const std::string& colorSpace,
                      const LayerOptions& options, const Progress& progress) {
  FrameOptions frame;
  frame.seenThrough = options.seenThrough;
  Image seen = lightOf(options.cameraLook->apply(std::move(sum), displayFromScene(config, colorSpace, frame),
                                                 options.frameNumber, progress));
  const std::string space = seen.spec().colorSpace;
  if (space != colorSpace) config.convert(seen.span(), space, colorSpace);
  return seen;
}

std::vector<std::string> lightLayers(const SolvedSet& set) {
  std::vector<std::string> lights;
  for (const Light& light : set.capture.lights) lights.push_back(light.name);
  return layerNames(lights);
}

/// A layer a part; the first is the sum.
std::vector<PartToWrite> partsOf(const SolvedSet& set, const Layers& layers, const LayerOptions& options) {
  const std::array<std::string, 3> quality = {"residual", "sigma", "flags"};
  const bool blender = options.naming == LayerNaming::Blender;
  const std::vector<std::string> names = exportedLayers(set, options);
  std::vector<PartToWrite> parts = {colorPart(blender ? std::string(kViewLayer) + ".Combined" : kSumPart,
                                              layers.sum, typeThatHolds({&layers.sum, 1}, options.pictures))};
  for (size_t i = 0; i < names.size(); ++i)
    parts.push_back(colorPart(names[i], layers.pictures[i], options.pictures));
  const std::vector<std::string> highlights = highlightLayerNames(names, blender ? '_' : '.');
  const PixelType ofHighlights = typeThatHolds(layers.highlights, options.pictures);
  for (size_t i = 0; i < layers.highlights.size(); ++i)
    parts.push_back(colorPart(highlights[i], layers.highlights[i], ofHighlights));
  const std::string prefix = blender ? std::string(kViewLayer) + "." : "";
  if (!layers.seen.empty()) {
    const PixelType type = typeThatHolds({&layers.seen, 1}, options.pictures);
    parts.push_back(colorPart(prefix + "camera_look", layers.seen, type));
  }
  if (options.beta) parts.push_back(imagePart(prefix + "beta", set.beta, lightLayers(set), options.data));
  if (options.quality && !set.quality.empty())
    parts.push_back(imagePart(prefix + "quality", set.quality, quality, options.data));
  return parts;
}

void check(const LayerOptions& options, const std::filesystem::path& file, const PixelRect& window,
           const SolvedSet& set) {
  if (lowerExtension(file) != ".exr")
    throw InputError("{}: layers are written as OpenEXR. Name it {}.", file.string(),
                     std::filesystem::path(file).replace_extension(".exr").string());
  if (options.multipart && options.naming == LayerNaming::Blender)
    throw InputError(
        "{}: Blender reads its light groups from one part: ask for multi-part or Blender's names.",
        file.string());
  const bool inside = !window.empty() && window.x >= 0 && window.y >= 0 && window.right() <= set.width() &&
                      window.bottom() <= set.height();
  if (!inside)
    throw InputError("{}: the data window {},{},{},{} does not lie within the picture of {} x {} pixels.",
                     file.string(), window.x, window.y, window.width, window.height, set.width(),
                     set.height());
}

}  // namespace

std::vector<std::string> exportedLayers(const SolvedSet& set, const LayerOptions& options) {
  std::vector<std::string> names = lightLayers(set);
  if (set.ambient) names.emplace_back("ambient");
  const std::string prefix = std::string(kViewLayer) + ".Combined_";
  if (options.naming == LayerNaming::Blender)
    for (std::string& name : names) name.insert(0, prefix);
  return names;
}

PixelType exportLayers(const ColorConfig& config, const SolvedSet& set, const Rig& rig,
                       const std::filesystem::path& file, const LayerOptions& options,
                       const Progress& progress) {
  check(options, file, options.dataWindow.value_or(PixelRect{0, 0, set.width(), set.height()}), set);
  progress.update(0, "relighting");
  const std::string& colorSpace = options.colorSpace.empty() ? set.colorSpace() : options.colorSpace;
  Layers layers;
  layers.pictures = shining(config, set, sourcesOf(config, set, rig), colorSpace);
  LayerOptions written = options;
  written.pictures = typeThatHolds(layers.pictures, options.pictures);
  const std::vector<const Image*> lights = pointersTo(layers.pictures);
  if (isDarkerThan(kDarkestInHalf, lights)) written.pictures = PixelType::Float;
  layers.sum = sumOfLayers(lights, written.pictures);
  layers.sum.setColorSpace(colorSpace);
  if (options.highlights)
    layers.highlights = shining(config, set, highlightSources(config, set, rig), colorSpace);
  if (options.cameraLook) {
    progress.update(0.2F, "filtering");
    FilteredImage sum{layers.sum.clone(), FilterSpace::SceneLinear};
    if (options.cameraLook->wantsLight())
      sum.light = relativeLight(set, rigFactors(config, rig, set.colorSpace()), rig.ambient);
    layers.seen = seenThroughLook(config, std::move(sum), colorSpace, options, progress.part(0.2F, 0.4F));
    written.text["swaplight/cameraLook"] = jsonText(jsonFromPipeline(options.cameraLook->pipeline()));
  }
  std::vector<PartToWrite> parts = partsOf(set, layers, written);
  if (!options.multipart) parts = {mergedParts(parts)};
  FileToWrite contents{set.width(), set.height(),        std::move(parts),
                       colorSpace,  options.compression, written.text};
  contents.dataWindow = options.dataWindow;
  const auto ofShots = set.carried ? set.carried->dataWindow : std::nullopt;
  if (ofShots && contents.dataWindow.value_or(*ofShots) == *ofShots && !layers.seen.empty())
    contents.dataWindow = windowWithLight(*ofShots, layers.seen);  // filters may put light outside
  contents.chromaticities = chromaticitiesIn(config, colorSpace);
  if (set.carried) addCarried(contents, *set.carried);
  writeChannels(contents, file, progress.part(0.4F, 1));
  return written.pictures;
}

}  // namespace swaplight

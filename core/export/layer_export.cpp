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
#include "core/image/half.h"
#include "core/image/io/image_write.h"
#include "core/ocio/color_config.h"
#include "core/ocio/luminance.h"
#include "core/relight/relative_light.h"

namespace swaplight {
namespace {

constexpr int kGrain = 64;  // rows
constexpr const char* kViewLayer = "ViewLayer";
constexpr std::array<const char*, 3> kColors = {"R", "G", "B"};

/// Every layer as it will be read, and their sum.
struct Layers {
  std::vector<Image> pictures;
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

bool allFitHalf(std::span<const Image> pictures) {
  for (const Image& picture : pictures)
    for (int c = 0; c < 3; ++c)
      if (!fitsHalf(picture.plane(c), picture.pixelCount())) return false;
  return true;
}

Layers layersOf(std::vector<Image> pictures, PixelType type) {
  const ImageSpec spec = pictures.front().spec();
  Layers layers{std::move(pictures), {}, Image(spec, 0), {}};
  const int width = layers.sum.width();
  parallelRows(layers.sum.height(), kGrain, [&](int begin, int end) {
    const ptrdiff_t first = ptrdiff_t{begin} * width;
    const ptrdiff_t last = ptrdiff_t{end} * width;
    for (int c = 0; c < 3; ++c) {
      float* sum = layers.sum.plane(c);
      for (Image& picture : layers.pictures) {
        float* values = picture.plane(c);
        for (ptrdiff_t p = first; p < last; ++p) {
          if (type == PixelType::Half) values[p] = roundedToHalf(values[p]);
          sum[p] += values[p];
        }
      }
    }
  });
  return layers;
}

PartToWrite colorPart(const std::string& name, const Image& picture, PixelType type) {
  PartToWrite part{name, {}};
  for (size_t c = 0; c < kColors.size(); ++c)
    part.channels.push_back({kColors[c], picture.plane(static_cast<int>(c)), type});
  return part;
}

PartToWrite dataPart(const std::string& name, const Image& image, const std::vector<std::string>& channels,
                     PixelType type) {
  PartToWrite part{name, {}};
  for (size_t c = 0; c < channels.size(); ++c)
    part.channels.push_back({channels[c], image.plane(static_cast<int>(c)), type});
  return part;
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
  const bool blender = options.naming == LayerNaming::Blender;
  const std::vector<std::string> names = exportedLayers(set, options);
  std::vector<PartToWrite> parts = {
      colorPart(blender ? std::string(kViewLayer) + ".Combined" : "rgb", layers.sum, options.pictures)};
  for (size_t i = 0; i < names.size(); ++i)
    parts.push_back(colorPart(names[i], layers.pictures[i], options.pictures));
  const std::vector<std::string> highlights = highlightLayerNames(names, blender ? '_' : '.');
  for (size_t i = 0; i < layers.highlights.size(); ++i)
    parts.push_back(colorPart(highlights[i], layers.highlights[i], options.pictures));
  const std::string prefix = blender ? std::string(kViewLayer) + "." : "";
  if (!layers.seen.empty()) {
    const bool fits = allFitHalf({&layers.seen, 1});
    parts.push_back(
        colorPart(prefix + "camera_look", layers.seen, fits ? options.pictures : PixelType::Float));
  }
  if (options.beta) parts.push_back(dataPart(prefix + "beta", set.beta, lightLayers(set), options.data));
  if (options.quality && !set.quality.empty())
    parts.push_back(dataPart(prefix + "quality", set.quality, {"residual", "sigma", "flags"}, options.data));
  return parts;
}

/// One part; the parts' names become layers. The first one's are plain where it is called rgb.
PartToWrite merged(const std::vector<PartToWrite>& parts) {
  PartToWrite all;
  for (const PartToWrite& part : parts)
    for (ChannelToWrite channel : part.channels) {
      if (part.name != "rgb") channel.name = part.name + "." + channel.name;
      all.channels.push_back(std::move(channel));
    }
  return all;
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
  std::vector<Image> pictures = shining(config, set, sourcesOf(config, set, rig), colorSpace);
  LayerOptions written = options;
  if (!allFitHalf(pictures)) written.pictures = PixelType::Float;
  Layers layers = layersOf(std::move(pictures), written.pictures);
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
  if (!options.multipart) parts = {merged(parts)};
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

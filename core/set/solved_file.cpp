#include "core/set/solved_file.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/base/parallel.h"
#include "core/capture/light_name.h"
#include "core/file/json_file.h"
#include "core/image/finite_image.h"
#include "core/image/half.h"
#include "core/image/io/image_io.h"
#include "core/image/io/image_write.h"
#include "core/image/layer_parts.h"
#include "core/set/dynamic_range.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr const char* kCapture = "swaplight/capture";
constexpr const char* kCaptureFile = "swaplight/captureFile";  // relative to the solved file
constexpr const char* kReport = "swaplight/report";
constexpr const char* kColors[] = {"R", "G", "B"};
constexpr const char* kQuality[] = {"residual", "sigma", "flags", "model"};  // the last one is optional
constexpr int kGrain = 64;                                                   // rows

/// The pictures that add up to R G B.
std::vector<const Image*> layersOf(const SolvedSet& set) {
  std::vector<const Image*> layers;
  for (const Image& contribution : set.contributions) layers.push_back(&contribution);
  if (set.ambient) layers.push_back(&*set.ambient);
  return layers;
}

/// Whether half float holds the sum to a thousandth of full scale. Where lamps in the picture are brighter
/// than that allows, R G B is written as float even where half was asked for: it stays the sum of its layers.
bool halfIsEnough(const Image& sum) {
  constexpr float kMostError = 1e-3F;
  std::atomic<bool> enough = true;
  parallelRows(sum.height(), kGrain, [&](int begin, int end) {
    const ptrdiff_t first = ptrdiff_t{begin} * sum.width();
    const ptrdiff_t last = ptrdiff_t{end} * sum.width();
    float worst = 0;
    for (int c = 0; c < sum.channelCount() && enough; ++c)
      for (ptrdiff_t p = first; p < last; ++p)
        worst = std::max(worst, std::abs(roundedToHalf(sum.plane(c)[p]) - sum.plane(c)[p]));
    if (worst > kMostError) enough = false;
  });
  return enough;
}

/// Whether half float holds the lights: none is brighter than it can be (65504), and the set is not so dark
/// that its steps (6e-8) show.
bool lightsFitHalf(const SolvedSet& set) {
  constexpr double kDarkest = 1e-3;  // of the mean: a hundredth of it is still held to 0.3 %
  const auto layers = layersOf(set);
  if (!std::all_of(layers.begin(), layers.end(), [](const Image* layer) { return fitsHalf(*layer); }))
    return false;
  return !isDarkerThan(kDarkest, layers);
}

std::vector<std::string> lightNames(const Capture& capture) {
  std::vector<std::string> names;
  for (const Light& light : capture.lights) names.push_back(light.name);
  return names;
}

std::string highlightLayer(const std::string& light) {
  return light + ".spec";
}

PixelType picturesIn(const SolvedFileOptions& options) {
  return options.floatPictures ? PixelType::Float : PixelType::Half;
}

/// The file as one part a layer.
std::vector<PartToWrite> partsOf(const SolvedSet& set, const Image& sum, const SolvedFileOptions& options) {
  const PixelType pictures = picturesIn(options);
  const PixelType sumType = options.halfSum && halfIsEnough(sum) ? PixelType::Half : PixelType::Float;
  const std::vector<std::string> lights = lightNames(set.capture);
  std::vector<PartToWrite> parts = {colorPart(kSumPart, sum, sumType)};
  for (size_t i = 0; i < lights.size(); ++i)
    parts.push_back(colorPart(lights[i], set.contributions[i], pictures));
  for (size_t i = 0; i < set.highlights.size(); ++i)
    parts.push_back(colorPart(highlightLayer(lights[i]), set.highlights[i], pictures));
  if (set.ambient) parts.push_back(colorPart("ambient", *set.ambient, pictures));
  parts.push_back(imagePart("beta", set.beta, lights, PixelType::Float));
  const std::vector<std::string> quality(kQuality, kQuality + set.quality.channelCount());
  parts.push_back(imagePart("quality", set.quality, quality, PixelType::Float));
  return parts;
}

/// Empty where the set has none, or its primaries are not known here.
std::string rangesText(const SolvedSet& set) {
  try {
    const std::vector<LightRange> ranges = dynamicRange(set);
    return ranges.empty() ? "" : jsonText(jsonFromRanges(ranges));
  } catch (const InputError&) {
    return {};
  }
}

std::map<std::string, std::string> headerOf(const SolvedSet& set, const fs::path& file) {
  std::map<std::string, std::string> text = {{kCapture, jsonText(jsonFromCapture(set.capture))}};
  if (set.report) {
    Json report = jsonFromSolveReport(*set.report);
    report.erase("seconds");  // the same set is the same bytes, so that check sums can compare
    text[kReport] = jsonText(report);
  }
  if (!set.capture.file.empty())
    text[kCaptureFile] =
        fs::proximate(set.capture.file, file.has_parent_path() ? file.parent_path() : ".").string();
  if (const std::string ranges = rangesText(set); !ranges.empty()) text[kSolvedRanges] = ranges;
  return text;
}

/// The manifest in the header; without one (another program rewrote the file) the lights are those with a
/// beta.
Capture captureFrom(const ImageSpec& spec, const ImageFileInfo& info, const fs::path& file) {
  const std::string name = file.string();
  if (const auto json = info.text.find(kCapture); json != info.text.end()) {
    Capture capture =
        captureFromJson(parseJson(json->second, name + " (" + kCapture + ")"), file.parent_path(), file);
    capture.file.clear();
    if (const auto path = info.text.find(kCaptureFile); path != info.text.end()) {
      capture.file = (file.parent_path() / path->second).lexically_normal();
      capture.folder = capture.file.parent_path();
    }
    return capture;
  }
  Capture capture;
  capture.folder = file.parent_path();
  capture.name = file.stem().string();
  capture.colorSpace = spec.colorSpace;
  const std::string beta = "beta.";
  for (const std::string& channel : spec.channels)
    if (channel.starts_with(beta)) capture.lights.push_back({channel.substr(beta.size()), Role::Other, {}});
  if (capture.lights.empty())
    throw InputError("{}: is no solved set: it has no channel beta.<light>. Make one with swaplight solve.",
                     name);
  checkLightNames(lightNames(capture), name);  // they become names of files and of layers
  capture.warnings.push_back(
      fmt::format("{}: \"{}\" is missing in the header: roles and shots are not known", name, kCapture));
  return capture;
}

std::optional<SolveReport> reportFrom(const ImageFileInfo& info, const fs::path& file) {
  const auto text = info.text.find(kReport);
  if (text == info.text.end()) return std::nullopt;
  const std::string where = file.string() + " (" + kReport + ")";
  return solveReportFromJson(parseJson(text->second, where), where);
}

/// Hands out a plane for each channel of the file.
class PlaneFinder {
 public:
  PlaneFinder(const ImageSpec& spec, std::string file)
      : m_spec(spec), m_file(std::move(file)), m_planes(spec.channels.size(), nullptr) {}

  [[nodiscard]] bool has(const std::string& channel) const { return indexOf(channel) < m_planes.size(); }

  /// An image of these channels, to be read.
  Image want(const std::vector<std::string>& channels, std::vector<std::string> names,
             const std::string& colorSpace) {
    Image image({m_spec.width, m_spec.height, std::move(names), colorSpace});
    for (size_t c = 0; c < channels.size(); ++c) {
      const size_t index = indexOf(channels[c]);
      if (index >= m_planes.size())
        throw InputError("{}: is not a complete solved set: the channel {} is missing. Solve again.", m_file,
                         channels[c]);
      m_planes[index] = image.plane(static_cast<int>(c));
    }
    return image;
  }
  Image wantColor(const std::string& layer) {
    return want({layer + ".R", layer + ".G", layer + ".B"}, {"R", "G", "B"}, m_spec.colorSpace);
  }
  /// A channel that follows from others, or that nobody looks at.
  void passOver(const std::string& channel) {
    if (has(channel)) m_passedOver.push_back(indexOf(channel));
  }
  /// The header and the channels that nobody has asked for.
  void wantRest(const ImageFileInfo& info, CarriedData& carried) {
    carried.header = info.header;
    carried.pixelAspect = info.pixelAspect;
    carried.dataWindow = info.dataWindow;
    std::vector<std::string> names;
    for (size_t c = 0; c < m_planes.size(); ++c) {
      if (m_planes[c] || std::find(m_passedOver.begin(), m_passedOver.end(), c) != m_passedOver.end())
        continue;
      names.push_back(m_spec.channels[c]);
      carried.types.push_back(info.channelTypes[c] == PixelType::Half ? PixelType::Half : PixelType::Float);
    }
    if (!names.empty()) carried.channels = want(names, names, "data");
  }
  /// The lights' highlights; empty where the file has none. A light that has none of them, or not in all
  /// three channels, has no light in its.
  std::vector<Image> wantHighlights(const std::vector<std::string>& lights) {
    const auto known = [&](const std::string& light) { return holdsHighlights(m_spec, light); };
    std::vector<Image> highlights;
    if (std::none_of(lights.begin(), lights.end(), known)) return highlights;
    for (const std::string& light : lights)
      if (known(light))
        highlights.push_back(wantColor(highlightLayer(light)));
      else
        highlights.emplace_back(ImageSpec{m_spec.width, m_spec.height, {"R", "G", "B"}, m_spec.colorSpace},
                                0.0F);
    return highlights;
  }
  void passOverHighlights(const std::vector<std::string>& lights) {
    for (const std::string& light : lights)
      for (const char* color : kColors) passOver(highlightLayer(light) + "." + color);
  }
  [[nodiscard]] const std::vector<float*>& planes() const { return m_planes; }

 private:
  [[nodiscard]] size_t indexOf(const std::string& channel) const {
    return static_cast<size_t>(std::find(m_spec.channels.begin(), m_spec.channels.end(), channel) -
                               m_spec.channels.begin());
  }
  const ImageSpec& m_spec;
  std::string m_file;
  std::vector<float*> m_planes;
  std::vector<size_t> m_passedOver;
};

std::vector<std::string> inLayer(const std::string& layer, const std::vector<std::string>& names) {
  std::vector<std::string> channels;
  channels.reserve(names.size());
  for (const std::string& name : names) channels.push_back(fmt::format("{}.{}", layer, name));
  return channels;
}

}  // namespace

bool holdsHighlights(const ImageSpec& spec, const std::string& light) {
  return std::all_of(std::begin(kColors), std::end(kColors), [&](const std::string& color) {
    return std::count(spec.channels.begin(), spec.channels.end(), highlightLayer(light) + "." + color) > 0;
  });
}

void checkSolvedFile(const fs::path& file) {
  if (lowerExtension(file) != ".exr")
    throw InputError("{}: a solved set is written as OpenEXR. Name it {}.", file.string(),
                     fs::path(file).replace_extension(".exr").string());
}

void writeSolvedSet(const SolvedSet& set, const fs::path& file, const SolvedFileOptions& options,
                    const Progress& progress) {
  checkSolvedFile(file);
  SolvedFileOptions written = options;
  if (!lightsFitHalf(set)) written.floatPictures = true;
  const Image sum = sumOfLayers(layersOf(set), picturesIn(written));
  std::vector<PartToWrite> parts = partsOf(set, sum, written);
  if (!options.multipart) parts = {mergedParts(parts)};
  FileToWrite contents{set.width(),      set.height(),        std::move(parts),
                       set.colorSpace(), options.compression, headerOf(set, file)};
  if (set.carried) addCarried(contents, *set.carried);
  writeChannels(contents, file, progress);
}

namespace {

/// Another program's work may hold what is no number: it is said.
void mendBroken(SolvedSet& set, const fs::path& file) {
  size_t broken = makeFinite(set.beta) + makeFinite(set.quality);
  for (Image& contribution : set.contributions) broken += makeFinite(contribution);
  for (Image& highlight : set.highlights) broken += makeFinite(highlight);
  if (set.ambient) broken += makeFinite(*set.ambient);
  if (broken > 0)
    set.capture.warnings.push_back(
        fmt::format("{}: {} values are not finite: taken as 0", file.string(), broken));
}

}  // namespace

SolvedSet readSolvedSet(const fs::path& file, const Progress& progress, HighlightReading highlights) {
  SolvedSet set;
  const auto planes = [&](const ImageSpec& spec, const ImageFileInfo& info) {
    if (info.format != "openexr")
      throw InputError("{}: is no solved set, which is an OpenEXR file.", file.string());
    set.capture = captureFrom(spec, info, file);
    set.report = reportFrom(info, file);
    const std::vector<std::string> lights = lightNames(set.capture);
    PlaneFinder finder(spec, file.string());
    std::vector<std::string> quality(std::begin(kQuality), std::end(kQuality));
    if (!finder.has("quality.model")) quality.pop_back();
    for (const std::string& light : lights) set.contributions.push_back(finder.wantColor(light));
    if (highlights == HighlightReading::All)
      set.highlights = finder.wantHighlights(lights);
    else
      finder.passOverHighlights(lights);
    if (finder.has("ambient.R")) set.ambient = finder.wantColor("ambient");
    set.beta = finder.want(inLayer("beta", lights), inLayer("beta", lights), "data");
    set.quality = finder.want(inLayer("quality", quality), quality, "data");
    for (const char* color : kColors) finder.passOver(color);
    auto carried = std::make_shared<CarriedData>();
    finder.wantRest(info, *carried);
    set.carried = carried;
    return finder.planes();
  };
  readChannels(file, planes, progress);
  mendBroken(set, file);
  keepHighlightsInLights(set);
  return set;
}

SolvedHeader readSolvedHeader(const fs::path& file) {
  SolvedHeader header;
  header.spec = readImageSpec(file, &header.info);
  header.capture = captureFrom(header.spec, header.info, file);
  header.report = reportFrom(header.info, file);
  return header;
}

bool isSolvedSet(const fs::path& file) {
  try {
    ImageFileInfo info;
    const ImageSpec spec = readImageSpec(file, &info);
    return info.format == "openexr" &&
           std::any_of(spec.channels.begin(), spec.channels.end(),
                       [](const auto& name) { return name.starts_with("beta."); });
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace swaplight

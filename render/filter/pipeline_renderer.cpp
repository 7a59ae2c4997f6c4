#include "render/filter/pipeline_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/color/srgb.h"
#include "core/file/user_folders.h"
#include "core/image/shrunk_image.h"
#include "render/filter/filter_picture.h"
#include "render/gl/gl_info.h"
#include "render/gl/shader_source.h"

namespace swaplight {
namespace {

constexpr int kRowsPerBand = 32;

void mapColors(ImageSpan image, float (*function)(float)) {
  parallelRows(image.height, kRowsPerBand, [&](int begin, int end) {
    for (int c = 0; c < std::min(image.channels, 3); ++c)
      for (int y = begin; y < end; ++y)
        for (int x = 0; x < image.width; ++x) image.at(c, x, y) = function(image.at(c, x, y));
  });
}

float clampedCode(float code) {
  return code > 0 ? std::min(code, 1.0F) : 0;  // also what is not a number
}

/// What the picture's values are, on their way through a pipeline.
enum class Encoding { SceneLight, DisplayCodes, DisplayLight };

Encoding wantedBy(const Filter& filter, Encoding now) {
  switch (filter.space) {
    case FilterSpace::SceneLinear:
      return now == Encoding::DisplayCodes ? Encoding::DisplayLight : now;
    case FilterSpace::Display:
      return Encoding::DisplayCodes;
    case FilterSpace::Any:
      return now;
  }
  return now;
}

void convert(Image& image, Encoding from, Encoding to, const PipelineOptions& options) {
  if (from == to) return;
  if (from == Encoding::SceneLight) {
    options.displayFromScene(image.span().channelRange(0, 3));
    mapColors(image.span(), clampedCode);
  } else if (to == Encoding::DisplayCodes) {
    mapColors(image.span(), [](float light) { return clampedCode(srgbFromLinear(light)); });
  } else {
    mapColors(image.span(), [](float code) { return linearFromSrgb(code); });
  }
}

/// The frame's parts, at most `side` pixels a side, counted from the left bottom.
std::vector<FilterWindow> partsOf(const Image& image, int side) {
  std::vector<FilterWindow> parts;
  for (int y = 0; y < image.height(); y += side)
    for (int x = 0; x < image.width(); x += side)
      parts.push_back({x, y, std::min(side, image.width() - x), std::min(side, image.height() - y),
                       image.width(), image.height()});
  return parts;
}

FilterWindow grown(const FilterWindow& part, int halo) {
  FilterWindow window = part;
  window.x = std::max(0, part.x - halo);
  window.y = std::max(0, part.y - halo);
  window.width = std::min(part.wholeWidth, part.x + part.width + halo) - window.x;
  window.height = std::min(part.wholeHeight, part.y + part.height + halo) - window.y;
  return window;
}

/// What keeps a stage from being drawn.
class BrokenStage : public InputError {
 public:
  BrokenStage(size_t stage, const std::string& why) : InputError("{}", why), m_stage(stage) {}
  [[nodiscard]] size_t stage() const { return m_stage; }

 private:
  size_t m_stage;
};

/// Does a stage's part of the work; what is wrong with it says which stage it is.
template <typename Work>
auto ofStage(size_t stage, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw BrokenStage(stage, error.what());
  }
}

}  // namespace

std::filesystem::path builtInFilterFolder() {
  return shaderFolder() / "filters";
}

std::vector<std::filesystem::path> installedLookFolders() {
  return {dataFolder() / "camera-looks", shaderFolder() / "camera-looks"};
}

FilterLibrary installedFilters() {
  std::vector<FilterFolder> folders = personalFilterFolders();
  folders.push_back({builtInFilterFolder(), true});
  return FilterLibrary(folders);
}

const FilterProgram& PipelineRenderer::program(const std::shared_ptr<const Filter>& filter) {
  std::unique_ptr<FilterProgram>& program = m_programs[filter.get()];
  if (!program) {
    m_filters.push_back(filter);
    program = std::make_unique<FilterProgram>(filter);
  }
  return *program;
}

std::shared_ptr<const FilterTexture> PipelineRenderer::pictureFrom(const std::filesystem::path& file,
                                                                   FilterSpace space) {
  std::shared_ptr<const FilterTexture>& picture = m_pictures[filterSpaceName(space) + file.string()];
  if (!picture) {
    const Image image = readFilterPicture(file, space);
    const int most = glInfo().maxTextureSize;
    if (image.width() > most || image.height() > most)
      throw InputError("{}: is {} x {} pixels, the graphics driver takes {} a side; make it smaller",
                       file.string(), image.width(), image.height(), most);
    FilterTexture texture(FilterWindow::whole(image.width(), image.height()));
    texture.upload(image.view());
    picture = std::make_shared<const FilterTexture>(std::move(texture));
  }
  return picture;
}

FilterPictures PipelineRenderer::picturesFromFiles(const ResolvedStage& stage) {
  const Filter& filter = *stage.filter;
  FilterPictures pictures;
  for (size_t i = 0; i < filter.inputs.size(); ++i)
    if (filter.inputs[i].type == FilterInputType::Image)
      if (const auto* file = std::get_if<std::string>(&stage.values[i]); file && !file->empty())
        pictures[filter.inputs[i].name] = pictureFrom(*file, filter.space);
  for (const FilterImport& import : filter.imports)
    pictures[import.name] = pictureFrom(import.file, FilterSpace::Display);
  return pictures;
}

FilterPictures PipelineRenderer::picturesOf(const ResolvedStage& stage, const Image& frame) {
  const Filter& filter = *stage.filter;
  FilterPictures pictures = picturesFromFiles(stage);
  if (!filter.overview.empty()) {
    const float scale = std::min(1.0F, static_cast<float>(kOverviewSide) /
                                           static_cast<float>(std::max(frame.width(), frame.height())));
    const auto side = [&](int whole) {
      return std::max(1, static_cast<int>(std::lround(static_cast<float>(whole) * scale)));
    };
    const Image small = shrunkImage(frame, side(frame.width()), side(frame.height()));
    FilterTexture texture(FilterWindow::whole(small.width(), small.height()));
    texture.upload(small.view());
    pictures[filter.overview] = std::make_shared<const FilterTexture>(std::move(texture));
  }
  return pictures;
}

void PipelineRenderer::drawRun(Image& image, std::span<const ResolvedStage> stages,
                               const PipelineOptions& options, const Progress& progress) {
  int halo = 0;
  bool tiles = true;
  std::vector<FilterPictures> pictures;
  for (size_t i = 0; i < stages.size(); ++i) {
    const FilterProgram& compiled = program(stages[i].filter);
    tiles = tiles && compiled.tiles();
    halo += ofStage(i, [&] { return compiled.halo(stages[i].values, image.width(), image.height()); });
    pictures.push_back(ofStage(i, [&] { return picturesOf(stages[i], image); }));
  }
  const int most = glInfo().maxTextureSize;
  const int longest = std::max(image.width(), image.height());
  if (!tiles && longest > most)  // such a filter is drawn alone
    throw BrokenStage(
        0, fmt::format("{}: sees the whole frame at once, which is {} x {}; the graphics driver takes {} a "
                       "side. Give its file a HALO, or a smaller frame",
                       stages[0].filter->name, image.width(), image.height(), most));
  const std::vector<FilterWindow> parts = partsOf(image, tiles ? options.tileSide : longest);
  const bool inPlace = parts.size() == 1;
  Image result = inPlace ? Image() : Image(image.spec());
  for (size_t p = 0; p < parts.size(); ++p) {
    progress.update(static_cast<float>(p) / static_cast<float>(parts.size()), "Filtering");
    FilterTexture texture(grown(parts[p], halo));
    texture.upload(image.view());
    for (size_t i = 0; i < stages.size(); ++i)
      texture = ofStage(i, [&] {
        return program(stages[i].filter)
            .draw(texture, stages[i].values, pictures[i], options.time, options.limitsPerTile);
      });
    texture.download(parts[p], inPlace ? image.span() : result.span());
  }
  if (!inPlace) image = std::move(result);
}

std::vector<ResolvedStage> PipelineRenderer::usable(std::span<const ResolvedStage> stages,
                                                    const PipelineOptions& options) {
  std::vector<ResolvedStage> fine;
  for (const ResolvedStage& stage : stages) try {
      program(stage.filter);
      static_cast<void>(picturesFromFiles(stage));
      fine.push_back(stage);
    } catch (const InputError& error) {
      if (!options.leftOut) throw;
      options.leftOut(error.what());
    }
  return fine;
}

FilteredImage PipelineRenderer::apply(FilteredImage frame, std::span<const ResolvedStage> asked,
                                      const PipelineOptions& options, const Progress& progress) {
  Encoding encoding = frame.space == FilterSpace::Display ? Encoding::DisplayCodes : Encoding::SceneLight;
  std::vector<ResolvedStage> stages = usable(asked, options);
  for (size_t begin = 0; begin < stages.size();) {
    const Encoding wanted = wantedBy(*stages[begin].filter, encoding);
    convert(frame.image, encoding, wanted, options);
    encoding = wanted;
    // As many filters as work on the same values and can be drawn together, part by part.
    size_t end = begin + 1;
    if (program(stages[begin].filter).tiles())
      while (end < stages.size() && wantedBy(*stages[end].filter, encoding) == encoding &&
             stages[end].filter->overview.empty() && program(stages[end].filter).tiles())
        ++end;
    const auto share = [&](size_t stage) {
      return static_cast<float>(stage) / static_cast<float>(stages.size());
    };
    try {
      drawRun(frame.image, std::span(stages).subspan(begin, end - begin), options,
              progress.part(share(begin), share(end)));
      begin = end;
    } catch (const BrokenStage& broken) {  // the picture is as it was before the run
      if (!options.leftOut) throw;
      options.leftOut(broken.what());
      stages.erase(stages.begin() + static_cast<ptrdiff_t>(begin + broken.stage()));
    }
  }
  if (encoding == Encoding::DisplayLight) {
    convert(frame.image, encoding, Encoding::DisplayCodes, options);
    encoding = Encoding::DisplayCodes;
  }
  frame.space = encoding == Encoding::DisplayCodes ? FilterSpace::Display : FilterSpace::SceneLinear;
  return frame;
}

}  // namespace swaplight

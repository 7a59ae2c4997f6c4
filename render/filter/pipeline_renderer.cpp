#include "render/filter/pipeline_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/file/user_folders.h"
#include "core/image/shrunk_image.h"
#include "render/filter/filter_picture.h"
#include "render/filter/map_colors.h"
#include "render/gl/gl_info.h"
#include "render/gl/shader_source.h"

namespace swaplight {
namespace {

std::shared_ptr<const FilterTexture> wholeTexture(const Image& image) {
  FilterTexture texture(FilterWindow::whole(image.width(), image.height()));
  texture.upload(image.view());
  return std::make_shared<const FilterTexture>(std::move(texture));
}

float clampedCode(float code) {
  return code > 0 ? std::min(code, 1.0F) : 0;  // also what is not a number
}

using Encoding = PictureEncoding;

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

constexpr const char* kDisplayPrimaries = "lin_rec709";

/// Of scene-linear light.
std::string primariesOf(const Image& image) {
  const std::string& space = image.spec().colorSpace;
  return space.empty() || space == "raw" || space == "data" ? kDisplayPrimaries : space;
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

/// The driver takes textures of the group's parts and their halo.
void checkFits(std::span<const PlannedStage> stages, const PartGroup& group, const Image& frame) {
  const int most = glInfo().maxTextureSize;
  const FilterWindow input = largestInput(group, frame.width(), frame.height());
  if (std::max(input.width, input.height) <= most) return;
  size_t widest = group.begin;
  for (size_t i = group.begin; i < group.end; ++i)
    if (stages[i].halo > stages[widest].halo) widest = i;
  const FilterProgram& program = *stages[widest].program;
  throw BrokenStage(
      widest,
      fmt::format("{}: {}, which is {} x {}; the graphics driver takes {} a side. {}, or a smaller frame",
                  program.filter().name,
                  program.tiles() ? fmt::format("looks {} pixels far in the frame", stages[widest].halo)
                                  : "sees the whole frame at once",
                  frame.width(), frame.height(), most,
                  program.tiles() ? "Give it parameters that look less far" : "Give its file a HALO"));
}

}  // namespace

/// Filters that work on the same values, ready to be drawn.
struct PipelineRenderer::Run {
  const PipelineOptions& options;
  TextureKind kind;
  std::vector<PlannedStage> planned;
  std::vector<FilterPictures> pictures;
};

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

const FilterProgram& PipelineRenderer::program(const std::shared_ptr<const Filter>& filter,
                                               TextureKind kind) {
  std::unique_ptr<FilterProgram>& program = m_programs[{filter.get(), kind}];
  if (!program) {
    m_filters.push_back(filter);
    program = std::make_unique<FilterProgram>(filter, kind);
  }
  return *program;
}

std::shared_ptr<const FilterTexture> PipelineRenderer::pictureFrom(const std::filesystem::path& file,
                                                                   FilterSpace space,
                                                                   const std::string& primaries) {
  std::shared_ptr<const FilterTexture>& picture =
      m_pictures[{filterSpaceName(space), primaries, file.string()}];
  if (!picture) {
    const Image image = readFilterPicture(file, space, primaries);
    const int most = glInfo().maxTextureSize;
    if (image.width() > most || image.height() > most)
      throw InputError("{}: is {} x {} pixels, the graphics driver takes {} a side; make it smaller",
                       file.string(), image.width(), image.height(), most);
    picture = wholeTexture(image);
  }
  return picture;
}

FilterPictures PipelineRenderer::picturesFromFiles(const ResolvedStage& stage, const std::string& primaries) {
  const Filter& filter = *stage.filter;
  FilterPictures pictures;
  for (size_t i = 0; i < filter.inputs.size(); ++i)
    if (filter.inputs[i].type == FilterInputType::Image)
      if (const auto* file = std::get_if<std::string>(&stage.values[i]); file && !file->empty())
        pictures[filter.inputs[i].name] = pictureFrom(*file, filter.space, primaries);
  for (const FilterImport& import : filter.imports)
    pictures[import.name] = pictureFrom(import.file, FilterSpace::Display, kDisplayPrimaries);
  return pictures;
}

FilterPictures PipelineRenderer::picturesOf(const ResolvedStage& stage, const Image& frame,
                                            const Image& light, const std::string& primaries) {
  const Filter& filter = *stage.filter;
  FilterPictures pictures = picturesFromFiles(stage, primaries);
  if (!filter.overview.empty()) {
    const float scale = std::min(1.0F, static_cast<float>(kOverviewSide) /
                                           static_cast<float>(std::max(frame.width(), frame.height())));
    const auto side = [&](int whole) {
      return std::max(1, static_cast<int>(std::lround(static_cast<float>(whole) * scale)));
    };
    pictures[filter.overview] = wholeTexture(shrunkImage(frame, side(frame.width()), side(frame.height())));
  }
  if (!filter.light.empty() && light.pixelCount() > 0) pictures[filter.light] = wholeTexture(light);
  return pictures;
}

void PipelineRenderer::drawParts(const Image& from, Image& to, const Run& run, const PartGroup& group,
                                 const Progress& progress) {
  const std::vector<FilterWindow> parts = partsOf(from, group.side);
  for (size_t p = 0; p < parts.size(); ++p) {
    progress.update(static_cast<float>(p) / static_cast<float>(parts.size()), "Filtering");
    int halo = group.halo;
    FilterTexture texture(parts[p].grown(halo), run.kind);
    texture.upload(from.view());
    for (size_t i = group.begin; i < group.end; ++i) {
      const PlannedStage& stage = run.planned[i];
      halo -= stage.halo;
      texture = ofStage(i, [&] {
        return stage.program->draw(texture, parts[p].grown(halo), stage.values, run.pictures[i],
                                   run.options.time, run.options.limitsPerTile);
      });
    }
    texture.download(parts[p], to.span());
  }
}

void PipelineRenderer::drawRun(FilteredImage& frame, std::span<const ResolvedStage> stages,
                               const std::string& primaries, const PipelineOptions& options,
                               const Progress& progress) {
  Image& image = frame.image;
  const bool mixed = std::any_of(stages.begin(), stages.end(), [](const ResolvedStage& stage) {
    return kindFor(*stage.filter) == TextureKind::Coordinates;
  });
  Run run{options, mixed ? TextureKind::Coordinates : TextureKind::Pixels, {}, {}};
  for (size_t i = 0; i < stages.size(); ++i) {
    const FilterProgram& compiled = program(stages[i].filter, run.kind);
    const std::vector<FilterValue>& values = stages[i].values;
    const int halo = ofStage(i, [&] { return compiled.halo(values, image.width(), image.height()); });
    run.planned.push_back({&compiled, values, halo});
    run.pictures.push_back(ofStage(i, [&] { return picturesOf(stages[i], image, frame.light, primaries); }));
  }
  const int longest = std::max(image.width(), image.height());
  std::vector<PartGroup> groups{{0, stages.size(), 0, longest}};  // a filter that sees all is drawn alone
  if (run.planned[0].program->tiles())
    groups = planParts(run.planned, image.width(), image.height(),
                       {options.tileSide, glInfo().maxTextureSize, options.mostTextureBytes});
  for (const PartGroup& group : groups) checkFits(run.planned, group, image);
  if (groups.size() == 1 && groups[0].side >= longest) {
    drawParts(image, image, run, groups[0], progress);
    return;
  }
  Image drawn;
  for (size_t g = 0; g < groups.size(); ++g) {
    ImageSpec spec = image.spec();
    if (g + 1 < groups.size())
      spec.channels = {"R", "G", "B", "A"};  // what one group makes of alpha, the next sees
    Image next(spec);
    const auto share = [&](size_t group) {
      return static_cast<float>(group) / static_cast<float>(groups.size());
    };
    drawParts(g == 0 ? image : drawn, next, run, groups[g], progress.part(share(g), share(g + 1)));
    drawn = std::move(next);
  }
  image = std::move(drawn);
}

std::vector<ResolvedStage> PipelineRenderer::usable(std::span<const ResolvedStage> stages,
                                                    const PipelineOptions& options) {
  std::vector<ResolvedStage> fine;
  for (const ResolvedStage& stage : stages) try {
      program(stage.filter);
      static_cast<void>(picturesFromFiles(stage, kDisplayPrimaries));
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
  const PipelineMemory::Plan plan =
      options.memory ? options.memory->plan(stages, frame.image, encoding) : PipelineMemory::Plan{};
  size_t keepAfter = plan.keepAfter;
  for (size_t begin = plan.begin; begin < stages.size();) {
    const Encoding wanted = wantedBy(*stages[begin].filter, encoding);
    convert(frame.image, encoding, wanted, options);
    encoding = wanted;
    if (keepAfter > 0 && begin == keepAfter) options.memory->keep(begin, frame.image, encoding);
    // As many filters as work on the same values and can be drawn together, part by part.
    size_t end = begin + 1;
    if (program(stages[begin].filter).tiles())
      while (end < stages.size() && end != keepAfter && wantedBy(*stages[end].filter, encoding) == encoding &&
             stages[end].filter->overview.empty() && program(stages[end].filter).tiles())
        ++end;
    const auto share = [&](size_t stage) {
      return static_cast<float>(stage) / static_cast<float>(stages.size());
    };
    try {
      drawRun(frame, std::span(stages).subspan(begin, end - begin),
              encoding == Encoding::SceneLight ? primariesOf(frame.image) : kDisplayPrimaries, options,
              progress.part(share(begin), share(end)));
      begin = end;
    } catch (const BrokenStage& broken) {  // the picture is as it was before the run
      if (options.memory) options.memory->forget();
      keepAfter = 0;
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

#include "ui/camera/look_thumbnails.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/image/shrunk_image.h"
#include "render/filter/filter_engine.h"
#include "ui/camera/lit_frame.h"

namespace swaplight {
namespace {

/// They are drawn larger than they are shown and made smaller, so that lines and dots are seen.
constexpr int kDrawnWidth = 240;
constexpr double kMostThumbnailSeconds = 2;

std::vector<uint8_t> rgbaOf(const Image& codes) {
  std::vector<uint8_t> rgba(codes.pixelCount() * 4, 255);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < codes.pixelCount(); ++p)
      rgba[4 * p + static_cast<size_t>(c)] =
          static_cast<uint8_t>(std::lround(255 * std::clamp(codes.plane(c)[p], 0.0F, 1.0F)));
  return rgba;
}

}  // namespace

/// Made in the thread, by the first picture. Not the viewer's: it must not wait for a small picture.
struct LookThumbnails::Engine {
  std::unique_ptr<FilterEngine> engine;
  FilterEngine& get() {
    if (!engine) engine = std::make_unique<FilterEngine>();
    return *engine;
  }
};

LookThumbnails::LookThumbnails(std::function<void()> wake)
    : m_wake(std::move(wake)), m_engine(std::make_shared<Engine>()) {}

LookThumbnails::~LookThumbnails() = default;

LookThumbnails::Shown LookThumbnails::picture(const std::string& key, const FilterPipeline& look,
                                              int height) {
  Entry& entry = m_entries[key];
  entry.asked = m_frameCount;
  entry.look = look;
  entry.height = height;
  return entry.shown;
}

bool LookThumbnails::isWanted(const Entry& entry) const {
  return entry.asked == m_frameCount && (entry.drawnOf != m_frameNumber || entry.drawnLook != entry.look ||
                                         entry.drawnHeight != entry.height);
}

size_t LookThumbnails::pending() const {
  if (m_failed) return 0;
  return static_cast<size_t>(std::count_if(m_entries.begin(), m_entries.end(),
                                           [this](const auto& entry) { return isWanted(entry.second); }));
}

void LookThumbnails::releaseOtherSet(const std::shared_ptr<const LiveSet>& live) {
  if (m_frame && m_frame->live != live) forget();
}

void LookThumbnails::forget() {
  m_job.drop();
  m_entries.clear();
  m_frame.reset();
  m_light.reset();
}

void LookThumbnails::update(const std::optional<SeenRequest>& frame, bool idle, FilterLibrary& library) {
  take();
  if (!frame || !idle || m_failed || m_job.running()) return;
  if (m_frame != frame) {
    m_frame = frame;
    m_light.reset();
    ++m_frameNumber;
  }
  const auto next = std::find_if(m_entries.begin(), m_entries.end(),
                                 [this](const auto& entry) { return isWanted(entry.second); });
  if (next != m_entries.end()) start(next->first, next->second, library);
}

void LookThumbnails::take() try {
  const std::optional<Drawn> drawn = m_job.take();
  if (!drawn) return;
  if (drawn->frame == m_frameNumber) m_light = drawn->light;
  const auto found = m_entries.find(drawn->key);
  if (found == m_entries.end()) return;
  Entry& entry = found->second;
  entry.drawnOf = drawn->frame;
  entry.drawnLook = drawn->look;
  entry.drawnHeight = drawn->height;
  if (drawn->rgba.empty()) {
    entry.shown = {};
    return;
  }
  entry.texture.update(drawn->width, drawn->height, drawn->rgba.data());
  entry.shown = {entry.texture.id(), drawn->width, drawn->height};
} catch (const Stopped&) {
} catch (const std::exception&) {
  m_failed = true;  // the picture in the viewer says why
}

void LookThumbnails::start(const std::string& key, const Entry& entry, FilterLibrary& library) {
  std::vector<ResolvedStage> stages;
  bool broken = false;
  for (const FilterStage& stage : entry.look.stages) try {
      if (stage.on) stages.push_back(resolveStage(library, stage, entry.look.folder, entry.look.name));
    } catch (const InputError&) {
      broken = true;
    }
  m_job.start(
      [drawn = Drawn{m_light, key, entry.look, m_frameNumber, 0, entry.height, {}}, stages, broken,
       request = *m_frame, engine = m_engine](const Progress& progress) mutable {
        const int whole = request.live->read().pictures().width();
        const float scale = std::min(1.0F, static_cast<float>(kDrawnWidth) / static_cast<float>(whole));
        if (!drawn.light) drawn.light = std::make_shared<const Image>(litFrame(request, scale));
        const Image& light = *drawn.light;
        drawn.width = std::max(1, static_cast<int>(std::lround(static_cast<double>(drawn.height) *
                                                               light.width() / std::max(light.height(), 1))));
        if (broken) return drawn;
        PipelineOptions options;
        options.limitsPerTile.mostSeconds = kMostThumbnailSeconds;
        options.displayFromScene = [&](ImageSpan image) {
          request.config->applyView(image, light.spec().colorSpace,
                                    namedDisplay(*request.config, request.display));
        };
        try {
          FilteredImage frame{light.clone(), FilterSpace::SceneLinear};
          if (wantsLight(stages)) frame.light = relativeLight(request, scale);
          FilteredImage seen = engine->get().apply(std::move(frame), stages, options, progress);
          if (seen.space != FilterSpace::Display)
            options.displayFromScene(seen.image.span().channelRange(0, 3));
          drawn.rgba = rgbaOf(shrunkImage(seen.image, drawn.width, drawn.height));
        } catch (const InputError&) {
          drawn.rgba.clear();
        }
        return drawn;
      },
      m_wake);
}

}  // namespace swaplight

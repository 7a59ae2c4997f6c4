#include "ui/control/scopes_controller.h"

#include <algorithm>
#include <array>
#include <shared_mutex>

#include "core/ocio/luminance.h"
#include "core/relight/rig.h"
#include "ui/camera/seen_frame.h"
#include "ui/jobs/take_or_report.h"

namespace swaplight {
namespace {

constexpr int kPixels = 400000;
constexpr int kPixelsInGesture = 60000;

/// A region of the frame in what is seen of it, which may be a draft. Another set may have been opened since.
PictureRegion within(const PictureRegion& region, const SeenPicture& seen) {
  const auto scaled = [&](int at) { return static_cast<int>(static_cast<float>(at) * seen.scale); };
  const int x = std::min(scaled(region.x), seen.image.width() - 1);
  const int y = std::min(scaled(region.y), seen.image.height() - 1);
  return {x, y, std::clamp(scaled(region.width), 1, seen.image.width() - x),
          std::clamp(scaled(region.height), 1, seen.image.height() - y)};
}

}  // namespace

ScopesController::Request ScopesController::wanted(const OpenSet& set) const {
  const Document& document = m_parts.lights.document();
  Request request;
  request.config = m_parts.colors.config();
  request.factors = rigFactors(*request.config, document.rig, set.solved().colorSpace());
  request.ambient = document.rig.ambient;
  const ScopeOptions& options = m_parts.options;
  if (options.of == ScopeOptions::Of::Light) {
    const auto chosen = static_cast<size_t>(m_parts.lights.view.selectedLight);
    for (size_t i = 0; i < request.factors.size(); ++i)
      if (i != chosen) request.factors[i] = Rgb(0);
    request.ambient = 0;
  }
  request.region = {0, 0, set.pictures().width(), set.pictures().height()};
  if (options.of == ScopeOptions::Of::Region && m_parts.viewer.region)
    request.region = *m_parts.viewer.region;
  request.display = document.display;
  request.pixels = m_parts.lights.editor.inGesture() ? kPixelsInGesture : kPixels;
  request.set = m_parts.session.setRevision();
  request.edits = m_parts.edits.revision();
  if (options.of != ScopeOptions::Of::Light) addSeen(request, set);
  return request;
}

void ScopesController::addSeen(Request& request, const OpenSet& set) const {
  const Document& document = m_parts.lights.document();
  const auto seen =
      seenRequest(request.config, set.live, request.edits, document, m_parts.viewer, document.rig);
  if (!seen) return;
  // Asked for here, too: the viewer may show another picture.
  static_cast<void>(
      m_parts.seen.picture(LookPreview::Side::A, *seen, {.settled = !m_parts.lights.editor.inGesture()}));
  request.seen = m_parts.seen.shown(LookPreview::Side::A, *seen);
  request.seenCount = m_parts.seen.count();
}

/// What counts them in a thread.
std::function<ScopePictures()> ScopesController::counting(const Request& request, const OpenSet& set) {
  const auto table = m_parts.table.table(request.config, set.solved().colorSpace(), request.display);
  const glm::mat3 toXyz = m_parts.table.xyzFromRgb();
  const Rgb weights = m_parts.table.luminanceWeights();
  if (!request.seen)
    return [live = set.live, request, table, toXyz, weights] {
      const LiveSet::Reading reading = live->read();
      const auto layers = reading.pictures().layers({}, request.factors, request.ambient);
      return scopePictures(scopeSample(layers, request.region, *table, request.pixels), toXyz, weights);
    };
  const glm::mat3 xyzOfCodes = xyzFromLinear(*request.config, "lin_rec709");
  return [request, table, toXyz, weights, xyzOfCodes] {
    const SeenPicture& seen = *request.seen;
    const std::shared_lock lock(seen.mutex);
    const PictureRegion region = within(request.region, seen);
    if (seen.colorSpace.empty())
      return scopePictures(scopeSampleOfCodes(seen.image.view(), region, request.pixels), xyzOfCodes,
                           kRec709Luminance);
    const std::array<ViewLayer, 1> layers{ViewLayer{&*seen.pyramid, Rgb(1)}};
    return scopePictures(scopeSample(layers, region, *table, request.pixels), toXyz, weights);
  };
}

void ScopesController::update() {
  takeOrReport(m_job, m_parts.messages, "the scopes", [this](ScopePictures pictures) {
    m_pictures = std::move(pictures);
    ++m_revision;
  });
  const OpenSet* set = m_parts.session.set();
  if (m_job.running() || !set) return;
  Request request = wanted(*set);
  if (m_counted == request) return;
  m_counted = std::move(request);
  m_job.start([count = counting(m_counted.value(), *set)](const Progress&) { return count(); }, m_wake);
}

}  // namespace swaplight

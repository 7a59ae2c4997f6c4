#include "ui/control/scopes_controller.h"

#include "core/relight/rig.h"
#include "ui/jobs/take_or_report.h"

namespace swaplight {
namespace {

constexpr int kPixels = 400000;
constexpr int kPixelsInGesture = 60000;

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
  return request;
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
  m_counted = request;
  const auto table = m_parts.table.table(request.config, set->solved().colorSpace(), request.display);
  m_job.start(
      [live = set->live, request = std::move(request), table, toXyz = m_parts.table.xyzFromRgb(),
       weights = m_parts.table.luminanceWeights()](const Progress&) {
        const LiveSet::Reading seen = live->read();
        const ScopeSample sample = scopeSample(seen.pictures().layers({}, request.factors, request.ambient),
                                               request.region, *table, request.pixels);
        return scopePictures(sample, toXyz, weights);
      },
      m_wake);
}

}  // namespace swaplight

#include "ui/control/scopes_controller.h"

#include <shared_mutex>

#include "core/base/error.h"

namespace swaplight {
namespace {

constexpr int kPixels = 400000;
constexpr int kPixelsInGesture = 60000;

}  // namespace

ScopesController::Request ScopesController::requestOf(const StudioContext& studio) {
  const OpenSet& set = *studio.set();
  const Rig& rig = studio.document().rig;
  Request request;
  request.config = studio.colors.config();
  request.factors = rigFactors(*request.config, rig, set.solved->colorSpace());
  request.ambient = rig.ambient;
  const ScopeOptions& options = studio.layout.scopeOptions;
  if (options.of == ScopeOptions::Of::Light) {
    const auto chosen = static_cast<size_t>(studio.view.selectedLight);
    for (size_t i = 0; i < request.factors.size(); ++i)
      if (i != chosen) request.factors[i] = Rgb(0);
    request.ambient = 0;
  }
  request.region = {0, 0, set.pictures->width(), set.pictures->height()};
  if (options.of == ScopeOptions::Of::Region && studio.viewer.region) request.region = *studio.viewer.region;
  request.display = studio.document().display;
  request.pixels = studio.editor.inGesture() ? kPixelsInGesture : kPixels;
  request.set = studio.session.setRevision();
  request.edits = studio.edits.revision();
  return request;
}

void ScopesController::update(StudioContext& studio) {
  try {
    if (auto pictures = m_job.take()) {
      m_pictures = std::move(*pictures);
      ++m_revision;
    }
  } catch (const std::exception& error) {
    studio.messages.error(error.what());
  }
  if (m_job.running() || !studio.set()) return;
  Request request = requestOf(studio);
  if (m_counted == request) return;
  m_counted = request;
  const std::string& colorSpace = studio.set()->solved->colorSpace();
  const auto table = studio.table.table(request.config, colorSpace, request.display);
  m_job.start(
      [pictures = studio.set()->pictures, request = std::move(request), table,
       toXyz = studio.table.xyzFromRgb(), weights = studio.table.luminanceWeights()](const Progress&) {
        const std::shared_lock lock(pictures->pixels());
        const ScopeSample sample = scopeSample(pictures->layers({}, request.factors, request.ambient),
                                               request.region, *table, request.pixels);
        return scopePictures(sample, toXyz, weights);
      },
      m_wake);
}

}  // namespace swaplight

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/illumination/illumination.h"
#include "core/illumination/light_sinks.h"
#include "core/view/pyramid.h"
#include "ui/jobs/take_or_report.h"
#include "ui/pictures/live_set.h"

namespace swaplight {

/// A light's pools on the set.
struct LightPools {
  std::vector<LightSink> sinks;  ///< pixels of the set
  size_t lamps = 0;              ///< that they tell of
};

/// The light on the open set without its texture, a picture a light, and where its pools lie, found in a
/// thread when it is first looked at, and again after edits: until then the pictures before them stay.
class IlluminationPictures {
 public:
  explicit IlluminationPictures(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// Of each light at unit white, in the set's order; empty until they are found. `still`: nobody is changing
  /// the set right now, so that it is worth while to begin.
  const std::vector<const Pyramid*>& pictures(const std::shared_ptr<const LiveSet>& live, bool still);
  /// Where each light's pools lie, as those pictures show; empty until they are found.
  const std::vector<LightPools>& pools(const std::shared_ptr<const LiveSet>& live, bool still) {
    static_cast<void>(pictures(live, still));
    return m_pools;
  }
  /// To be called often: takes what was found.
  void update(Messages& messages);
  /// The set's pixels have changed, or are going to: what reads them for long gives way.
  void editsChanged() {
    m_stale = true;
    m_job.cancel();
  }
  /// Another set is open.
  void forget();
  [[nodiscard]] bool busy() const { return m_job.running(); }

 private:
  struct Found {
    std::vector<Image> maps;
    std::vector<LightPools> pools;
  };
  void keep(Found found);

  std::function<void()> m_wake;
  Job<Found> m_job;
  std::vector<Image> m_maps;
  std::vector<std::unique_ptr<Pyramid>> m_pyramids;  // of the maps
  std::vector<const Pyramid*> m_pictures;
  std::vector<LightPools> m_pools;
  bool m_stale = true;
  bool m_gone = false;  // what is being found is of a set that has gone
  bool m_failed = false;
};

}  // namespace swaplight

#include "ui/pictures/illumination_pictures.h"

namespace swaplight {

const std::vector<const Pyramid*>& IlluminationPictures::pictures(const std::shared_ptr<const LiveSet>& live,
                                                                  bool still) {
  if (!m_stale || !still || m_failed || m_job.running()) return m_pictures;
  m_stale = false;
  m_job.start(
      [live](const Progress& progress) {
        // Pools are found in the maps: nobody who edits has to wait for that.
        Found found{illuminationMaps(live->read().set(), {}, progress), {}};
        for (const Image& map : found.maps) {
          std::vector<LightSink> sinks = findSinks(map);
          const size_t lamps = lampCount(sinks, map);
          found.pools.push_back({std::move(sinks), lamps});
        }
        return found;
      },
      m_wake);
  return m_pictures;
}

void IlluminationPictures::update(Messages& messages) {
  const Taken taken = takeOrReport(m_job, messages, "the light on the set", [this](Found found) {
    if (!m_gone) keep(std::move(found));
  });
  if (taken == Taken::Nothing) return;
  m_failed = taken == Taken::Failed && !m_gone;
  m_gone = false;
}

void IlluminationPictures::forget() {
  m_job.cancel();
  m_gone = m_job.running();
  m_stale = true;
  m_failed = false;
  keep({});
}

void IlluminationPictures::keep(Found found) {
  m_pictures.clear();
  m_pyramids.clear();
  m_maps = std::move(found.maps);
  m_pools = std::move(found.pools);
  for (const Image& map : m_maps) {
    m_pyramids.push_back(std::make_unique<Pyramid>(map.view()));
    m_pictures.push_back(m_pyramids.back().get());
  }
}

}  // namespace swaplight

#include "ui/pictures/illumination_pictures.h"

namespace swaplight {

const std::vector<const Pyramid*>& IlluminationPictures::pictures(const std::shared_ptr<const LiveSet>& live,
                                                                  bool still) {
  if (!m_stale || !still || m_failed || m_job.running()) return m_pictures;
  m_stale = false;
  m_job.start(
      [live](const Progress& progress) {
        const LiveSet::Reading reading = live->read();
        return illuminationMaps(reading.set(), {}, progress);
      },
      m_wake);
  return m_pictures;
}

bool IlluminationPictures::update(Messages& messages) {
  const Taken taken = takeOrReport(m_job, messages, "the light on the set", [this](std::vector<Image> maps) {
    if (!m_gone) keep(std::move(maps));
  });
  if (taken == Taken::Nothing) return false;
  const bool other = taken == Taken::Value && !m_gone;
  m_failed = taken == Taken::Failed && !m_gone;
  m_gone = false;
  return other;
}

void IlluminationPictures::forget() {
  m_job.cancel();
  m_gone = m_job.running();
  m_stale = true;
  m_failed = false;
  keep({});
}

void IlluminationPictures::keep(std::vector<Image> maps) {
  m_pictures.clear();
  m_pyramids.clear();
  m_maps = std::move(maps);
  for (const Image& map : m_maps) {
    m_pyramids.push_back(std::make_unique<Pyramid>(map.view()));
    m_pictures.push_back(m_pyramids.back().get());
  }
}

}  // namespace swaplight

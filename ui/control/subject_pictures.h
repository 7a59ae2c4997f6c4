#pragma once

#include <functional>
#include <list>
#include <memory>
#include <vector>

#include "ui/control/set_controller.h"
#include "ui/jobs/take_or_report.h"
#include "ui/pictures/illumination_pictures.h"

namespace swaplight {

/// The pictures of the subjects that are no sum of contributions: made, or read in a thread, when they are
/// first looked at. Keeps the last two, so that a comparison has both.
class SubjectPictures {
 public:
  struct Shown {
    ViewSubject subject;
    Image image;
    std::unique_ptr<Pyramid> pyramid;  ///< of the image
  };

  explicit SubjectPictures(std::function<void()> wake) : m_wake(std::move(wake)), m_illumination(m_wake) {}

  /// nullptr while a photograph is being read, or where it could not be.
  const Shown* picture(const std::shared_ptr<const ColorConfig>& config, const OpenSet& set,
                       const ViewSubject& subject);
  /// The light on the set without its texture, of each light at unit white; empty until found. `still`:
  /// nobody is dragging an edit right now.
  const std::vector<const Pyramid*>& illumination(const OpenSet& set, bool still) {
    return m_illumination.pictures(set.live, still);
  }
  /// Where each light's pools lie on the set; empty until found.
  const std::vector<LightPools>& pools(const OpenSet& set, bool still) {
    return m_illumination.pools(set.live, still);
  }
  /// To be called often: takes what was read or found.
  void update(Messages& messages);
  /// Pixels of the set have changed: forgets what was made of them.
  void editsChanged();
  /// Another set is open.
  void forget();
  [[nodiscard]] bool busy() const { return m_job.running() || m_illumination.busy(); }

 private:
  const Shown& keep(const ViewSubject& subject, Image image);

  std::function<void()> m_wake;
  std::list<Shown> m_shown;  ///< the one looked at last at the end
  Job<Image> m_job;
  ViewSubject m_reading;
  bool m_stale = false;  ///< what is being read belongs to a set that has gone
  std::vector<ViewSubject> m_failed;
  IlluminationPictures m_illumination;
};

}  // namespace swaplight

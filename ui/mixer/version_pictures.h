#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/image/small_picture.h"
#include "core/look/saved_look.h"
#include "core/view/display/display_table.h"
#include "ui/control/lights_context.h"
#include "ui/jobs/job.h"

namespace swaplight {

/// Pictures of versions, which have other edits than the set that is shown: made in a thread, one after the
/// other, of a small copy of it. Edits may want shadows found, which no frame of the studio waits for.
class VersionPictures {
 public:
  explicit VersionPictures(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// At most `width` x `height`; nothing as long as it is not drawn: to be asked for in every frame until it
  /// is. There is a set, and the look is a version. Edits that cannot be applied (a file of theirs is gone)
  /// are left out.
  [[nodiscard]] std::optional<SmallPicture> picture(const LightsContext& studio, const SavedLook& version,
                                                    const std::shared_ptr<const DisplayTable>& table,
                                                    int width, int height);
  /// To be called often: takes what was drawn.
  void update(Messages& messages);
  [[nodiscard]] bool busy() const { return m_job.running(); }

 private:
  /// What a picture follows from.
  struct Request {
    std::shared_ptr<const SolvedSet> original;
    std::shared_ptr<const ColorConfig> config;
    std::shared_ptr<const DisplayTable> table;
    Rig rig;
    EditStack edits;
    int width = 0, height = 0;
    bool operator==(const Request&) const = default;
  };
  struct Drawn {
    Request of;
    std::shared_ptr<const SolvedSet> small;  ///< the copy of the original
    SmallPicture picture;
  };
  static Drawn draw(Request request, std::shared_ptr<const SolvedSet> small);

  std::function<void()> m_wake;
  std::optional<Request> m_asked;  ///< what is drawn, or could not be
  std::optional<Drawn> m_drawn;    ///< last; its small copy serves the next one
  Job<Drawn> m_job;
};

}  // namespace swaplight

#include "ui/set_controller.h"

#include "core/session/open_source.h"

namespace swaplight {

void SetController::load(const std::filesystem::path& source, const SolveOptions& options) {
  m_loading = source;
  m_job.start(
      [source, options](const Progress& progress) {
        OpenSet open;
        open.source = source;
        open.solved = std::make_shared<SolvedSet>(openSource(source, options, progress));
        progress.update(1, "preparing the view");
        open.pictures = std::make_shared<ViewPictures>(open.solved);
        return open;
      },
      m_wake);
}

}  // namespace swaplight

#include "ui/control/set_controller.h"

#include "core/session/open_source.h"
#include "core/set/set_color_space.h"

namespace swaplight {

namespace {

/// Makes what is shown out of what was found.
OpenSet prepared(const ColorConfig& config, OpenSet open, const std::string& workingSpace,
                 const Progress& progress) {
  const bool own = workingSpace.empty() || workingSpace == open.found->colorSpace();
  open.original =
      own ? open.found
          : std::make_shared<SolvedSet>(copyInColorSpace(config, *open.found, workingSpace, progress));
  progress.update(1, "preparing the view");
  open.live = std::make_shared<LiveSet>(open.original);
  return open;
}

}  // namespace

void SetController::load(std::shared_ptr<const ColorConfig> config, const std::filesystem::path& source,
                         const SolveOptions& options, const std::string& workingSpace) {
  m_task = "Opening " + source.filename().string();
  m_job.start(
      [config = std::move(config), source, options, workingSpace](const Progress& progress) {
        OpenSet open;
        open.source = source;
        open.found = std::make_shared<SolvedSet>(openSource(*config, source, options, progress));
        return prepared(*config, std::move(open), workingSpace, progress);
      },
      m_wake);
}

void SetController::convert(std::shared_ptr<const ColorConfig> config, const OpenSet& open,
                            const std::string& workingSpace) {
  m_task = "Changing the working space";
  m_job.start([config = std::move(config), open, workingSpace](
                  const Progress& progress) { return prepared(*config, open, workingSpace, progress); },
              m_wake);
}

}  // namespace swaplight

#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/chart/chart_shot.h"
#include "core/ocio/color_config.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

/// The colour space of a photograph's file; "" where it says so itself. Called in threads.
using ColorSpaceOf = std::function<std::string(const std::filesystem::path&)>;

/// The part of the chart dialog that measures a gel: the chart that is read is lit through it, another
/// photograph has the lamp without it.
class GelMeasure {
 public:
  explicit GelMeasure(std::function<void()> wake) : m_wake(std::move(wake)) {}

  void forget();
  [[nodiscard]] bool busy() const { return m_reading.running(); }
  void update(Messages& messages);
  void draw(const std::shared_ptr<const ColorConfig>& config, const ColorSpaceOf& colorSpaceOf,
            const ChartShot& through, Messages& messages, FileChooser& chooser);

 private:
  /// What was read of the photograph without the gel, or why it was not.
  struct Without {
    std::filesystem::path file;
    ChartShot shot;
    std::string wrong;
    int question = 0;  ///< which it answers
  };

  void ask(const std::shared_ptr<const ColorConfig>& config, const ColorSpaceOf& colorSpaceOf,
           const ChartShot& through, FileChooser& chooser);
  void drawName(const Rgb& filter, Messages& messages);

  std::function<void()> m_wake;
  Job<Without> m_reading;
  Without m_without;
  int m_question = 0;  ///< the last one; of another chart it is another
  std::string m_brand, m_number, m_name;
};

}  // namespace swaplight

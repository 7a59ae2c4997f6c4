#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/chart/chart_photograph.h"
#include "core/ocio/color_config.h"
#include "ui/chart/chart_picture.h"
#include "ui/chart/gel_measure.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

/// Reads a colour chart in a photograph: shows where it was found, or lets a person put its corners there;
/// what it says of the light, the camera and a gel.
class ChartDialog {
 public:
  /// Takes the light to where it was asked for.
  using Use = std::function<void(const ChartShot&)>;

  explicit ChartDialog(std::function<void()> wake) : m_wake(wake), m_gel(std::move(wake)) {}

  /// Looks for the chart in a thread. `colorSpaceOf`: none, where files say it. `use`: none, where nothing
  /// asks for the light.
  void start(std::shared_ptr<const ColorConfig> config, const std::filesystem::path& file,
             const ColorSpaceOf& colorSpaceOf, Use use = {});
  [[nodiscard]] bool isOpen() const { return m_config != nullptr; }
  [[nodiscard]] bool busy() const { return m_reading.running() || m_fitting.running() || m_gel.busy(); }
  /// To be called often: takes what the threads have finished.
  void update(Messages& messages);
  void draw(Messages& messages, FileChooser& chooser);

 private:
  /// What a photograph says, or why nothing.
  struct Read {
    std::shared_ptr<const ChartPhotograph> photograph;
    SmallPicture small;
    std::optional<ChartShot> shot;
    std::string wrong;
  };
  struct Fitted {
    std::shared_ptr<const ChartPhotograph> photograph;
    std::optional<ChartShot> shot;
    std::string wrong;
  };

  void close();
  void take(std::optional<ChartShot> shot, std::string wrong);
  /// Reads the chart where its corners were put.
  void fit();
  void drawReading();
  void drawWords();
  void drawLight(const ChartFit& fit);
  void drawCamera(Messages& messages, FileChooser& chooser);
  void drawFooter();

  std::function<void()> m_wake;
  std::shared_ptr<const ColorConfig> m_config;  ///< null: closed
  std::filesystem::path m_file;
  ColorSpaceOf m_colorSpaceOf;
  Use m_use;
  Job<Read> m_reading;
  Job<Fitted> m_fitting;
  std::shared_ptr<const ChartPhotograph> m_photograph;
  ChartPicture m_picture;
  bool m_shown = false;  ///< the photograph was drawn before
  ChartCorners m_corners{};
  std::optional<ChartShot> m_shot;
  std::string m_wrong;  ///< why there is no shot
  GelMeasure m_gel;
};

}  // namespace swaplight

#pragma once

#include <imgui.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/chart/chart_colors.h"
#include "core/intake/capture_draft.h"
#include "core/intake/rotation_guess.h"
#include "core/intake/shot_thumbnail.h"
#include "core/ocio/color_config.h"
#include "core/solve/causes/linearity.h"
#include "core/solve/model/solve_options.h"
#include "render/surface.h"
#include "ui/dialogs/wizard_rows.h"
#include "ui/jobs/take_or_report.h"

namespace swaplight {

/// Brings in a folder of photographs: shows them in order of time, asks for the lights and which colour each
/// had when, guesses how the colours moved, warns at once, and writes capture.json.
class CaptureWizard {
 public:
  static constexpr size_t kMostLights = 8;

  explicit CaptureWizard(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// Looks at the folder in a thread.
  void start(std::shared_ptr<const ColorConfig> config, const std::filesystem::path& folder);
  [[nodiscard]] bool isOpen() const { return m_folder.has_value(); }
  [[nodiscard]] bool busy() const {
    return m_reading.running() || m_guessing.running() || m_checking.running();
  }
  /// To be called often: takes what the threads have finished.
  void update(Messages& messages);
  /// A chart that is to be read for a light of a photograph.
  struct ChartQuestion {
    std::filesystem::path folder;  ///< where its photograph will lie
    std::function<std::string(const std::filesystem::path&)> colorSpaceOf;
    std::function<void(const ChartShot&)> use;
  };
  struct Answers {
    /// Opens the capture that was written.
    std::function<void(const std::filesystem::path&, const SolveOptions&)> solve;
    std::function<void(const ChartQuestion&)> readChart;
  };
  /// Draws the dialog.
  void draw(Messages& messages, const Answers& answers);

 private:
  /// What was found in the folder.
  struct Photographs {
    ShotFolder folder;
    std::shared_ptr<const CapturePixels> pixels;
    std::vector<SmallPicture> thumbnails;
    Brackets brackets;
    std::optional<Capture> told;     ///< by the capture.json that is there
    std::vector<ChartColor> charts;  ///< the lights of colour charts in the folder
    std::vector<std::string> warnings;
  };
  /// What is to be said of the photographs that are used, and their brackets, where those were looked for.
  struct Checked {
    std::filesystem::path folder;
    std::vector<size_t> used;  ///< the photographs that were looked at
    std::optional<Brackets> brackets;
    std::vector<std::string> warnings;
  };
  using Cell = WizardCell;

  static void readCharts(const ColorConfig& config, const CaptureDraft& draft, const Progress& progress,
                         Photographs& found);
  void close();
  /// What was typed for this folder before it was closed without a solve, or before a solve that failed.
  [[nodiscard]] bool restoreTyped();
  /// What the folder's capture.json tells.
  void restoreTold(const Capture& capture);
  void setLights(size_t count);
  /// The shots as other brackets: "0, -3, +2", or "" for none.
  void readExposures(const std::string& text);
  /// The brackets that the text tells; nothing where it is wrong, and why then stands in m_exposuresWrong.
  [[nodiscard]] std::optional<Brackets> typedBrackets();
  /// Leaves a row's photographs out, or takes them in again: their brackets are looked for anew.
  void useRow(size_t row, bool used);
  void setBracketsTo(Brackets brackets);
  /// Looks at the photographs that are used; for their brackets, too, where asked to.
  void check(bool findBrackets);
  /// The rows that are used, each a lighting.
  [[nodiscard]] std::vector<size_t> lightings() const;
  [[nodiscard]] ShotFolder usedFolder() const;
  [[nodiscard]] const std::string& fileOf(size_t row) const {
    return m_found->folder.shots[m_rows[row].first()].file;
  }
  /// One light a photograph, on alone in it (`on`), or off alone.
  void oneLampAShot(bool on);
  void drawPresets();
  [[nodiscard]] std::string mistake() const;
  [[nodiscard]] CaptureDraft draft() const;
  [[nodiscard]] CaptureDraft emptyDraft(const std::vector<std::string>& lights) const;
  [[nodiscard]] std::vector<ShotColor> ring() const;
  void guess();
  /// What a guess is about: the photographs, as which lightings, and the first one's colours.
  [[nodiscard]] std::string guessedAbout() const;
  void drawReading();
  void drawLights();
  void drawExposures();
  void drawTable(float height);
  void drawRow(size_t row);
  void drawUse(size_t row);
  void drawThumbnail(size_t row);
  void takeCard(size_t row, int x, int y);
  void cropOnThumbnail(ImVec2 at, ImVec2 size);
  void drawFrame();
  void drawCell(size_t row, size_t light);
  /// What a click may put there.
  void drawChoices(size_t row, size_t light);
  void drawGuess();
  [[nodiscard]] std::string typedColors() const;
  /// Looks in a thread whether the photographs hold light.
  void testLight();
  void drawLightTest(const std::string& wrong);
  /// Null: not asked for these colours.
  [[nodiscard]] const LinearityEvidence* linearity() const;
  void drawLinearity();
  /// What is to be said about the pictures and the colours.
  [[nodiscard]] std::vector<std::string> warnings() const;
  void drawWarnings(const std::vector<std::string>& warnings, float height);
  void drawFooter(const std::string& wrong, Messages& messages, const Answers& answers);
  [[nodiscard]] ChartQuestion chartQuestion(size_t row, size_t light);

  std::function<void()> m_wake;
  std::shared_ptr<const ColorConfig> m_config;
  std::optional<std::filesystem::path> m_folder;
  Job<Photographs> m_reading;
  Job<RotationGuess> m_guessing;
  std::string m_guessOf;    ///< guessedAbout() when it began
  Job<Checked> m_checking;  ///< the photographs as other brackets, or fewer
  Job<LinearityEvidence> m_testing;
  std::optional<LinearityEvidence> m_linearity;
  std::string m_tested;  ///< the colours that it is of
  std::optional<Photographs> m_found;
  std::vector<SurfaceTexture> m_textures;
  std::vector<std::string> m_lights;
  Brackets m_brackets;
  std::string m_exposures;       ///< as typed; "" where none are told or found
  bool m_exposuresTold = false;  ///< they were typed
  std::string m_exposuresWrong;  ///< what is wrong with them
  std::vector<WizardRow> m_rows;
  std::string m_guess;   ///< in words
  std::string m_filter;  ///< typed into the list of gels
  std::optional<std::pair<size_t, size_t>>
      m_picking;  ///< row, light: the cell whose colour a click takes from its shot
  std::optional<std::pair<size_t, size_t>> m_chartFor;  ///< the cell that wants a chart's light
  std::optional<std::pair<size_t, bool>> m_toUse;       ///< a row that was ticked or unticked
  CaptureFrame m_frame;
  std::optional<std::pair<float, float>> m_cropping;  ///< where a drag over a thumbnail began, 0..1
  bool m_replace = false;
  SolveOptions m_solve;

  struct Typed {
    std::filesystem::path folder;
    std::vector<std::string> lights;
    Brackets brackets;
    std::string exposures;
    bool exposuresTold = false;
    std::vector<WizardRow> rows;
    CaptureFrame frame;
    SolveOptions solve;
  };
  Typed m_typed;
};

}  // namespace swaplight

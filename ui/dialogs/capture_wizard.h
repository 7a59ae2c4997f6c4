#pragma once

#include <imgui.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/intake/capture_draft.h"
#include "core/intake/rotation_guess.h"
#include "core/intake/shot_thumbnail.h"
#include "core/ocio/color_config.h"
#include "core/solve/model/solve_options.h"
#include "render/surface.h"
#include "ui/jobs/take_or_report.h"

namespace swaplight {

/// Brings in a folder of photographs: shows them in order of time, asks for the lights and which colour each
/// had when, guesses how the colours moved, warns at once, and writes capture.json.
class CaptureWizard {
 public:
  explicit CaptureWizard(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// Looks at the folder in a thread.
  void start(std::shared_ptr<const ColorConfig> config, const std::filesystem::path& folder);
  [[nodiscard]] bool isOpen() const { return m_folder.has_value(); }
  [[nodiscard]] bool busy() const {
    return m_reading.running() || m_guessing.running() || m_checking.running();
  }
  /// To be called often: takes what the threads have finished.
  void update(Messages& messages);
  /// Opens the capture that was written.
  using Solve = std::function<void(const std::filesystem::path&, const SolveOptions&)>;
  /// Draws the dialog.
  void draw(Messages& messages, const Solve& solve);

 private:
  /// What was found in the folder.
  struct Photographs {
    ShotFolder folder;
    std::shared_ptr<const CapturePixels> pixels;
    std::vector<SmallPicture> thumbnails;
    Brackets brackets;
    std::vector<std::string> warnings;
  };
  /// A light's colour in a lighting, as it is being typed.
  struct Cell {
    std::string text;
    bool guessed = false;
  };

  void close();
  /// What was typed for this folder before it was closed without a solve, or before a solve that failed.
  void restoreTyped();
  void setLights(size_t count);
  /// The shots as other brackets: "0, -3, +2", or "" for none.
  void readExposures(const std::string& text);
  [[nodiscard]] size_t firstShot(size_t lighting) const {
    return lighting * static_cast<size_t>(m_brackets.length);
  }
  /// One light a photograph, on alone in it (`on`), or off alone.
  void oneLampAShot(bool on);
  void drawPresets();
  [[nodiscard]] std::string mistake() const;
  [[nodiscard]] CaptureDraft draft() const;
  [[nodiscard]] CaptureDraft emptyDraft(const std::vector<std::string>& lights) const;
  [[nodiscard]] std::vector<ShotColor> ring() const;
  void guess();
  void drawReading();
  void drawLights();
  void drawExposures();
  void drawTable(float height);
  void drawLighting(size_t lighting);
  void drawThumbnail(size_t lighting);
  void cropOnThumbnail(ImVec2 at, ImVec2 size);
  void drawFrame();
  void drawCell(size_t lighting, size_t light);
  void drawGuess();
  /// What is to be said about the pictures and the colours.
  [[nodiscard]] std::vector<std::string> warnings() const;
  void drawWarnings(const std::vector<std::string>& warnings, float height);
  void drawFooter(const std::string& wrong, Messages& messages, const Solve& solve);

  std::function<void()> m_wake;
  std::optional<std::filesystem::path> m_folder;
  Job<Photographs> m_reading;
  Job<RotationGuess> m_guessing;
  Job<std::vector<std::string>> m_checking;  ///< the photographs as other brackets
  std::optional<Photographs> m_found;
  std::vector<SurfaceTexture> m_textures;
  std::vector<std::string> m_lights;
  Brackets m_brackets;
  std::string m_exposures;                             ///< as typed; "" where none are told or found
  std::string m_exposuresWrong;                        ///< what is wrong with them
  std::vector<std::vector<Cell>> m_cells;              ///< [lighting][light]
  std::string m_guess;                                 ///< in words
  std::string m_filter;                                ///< typed into the list of gels
  std::optional<std::pair<size_t, size_t>> m_picking;  ///< the cell whose colour a click takes from its shot
  CaptureFrame m_frame;
  std::optional<std::pair<float, float>> m_cropping;  ///< where a drag over a thumbnail began, 0..1
  bool m_replace = false;
  SolveOptions m_solve;

  struct Typed {
    std::filesystem::path folder;
    std::vector<std::string> lights;
    std::string exposures;
    std::vector<std::vector<Cell>> cells;
    CaptureFrame frame;
    SolveOptions solve;
  };
  Typed m_typed;
};

}  // namespace swaplight

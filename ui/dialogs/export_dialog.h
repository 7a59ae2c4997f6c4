#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/ocio/color_config.h"
#include "core/session/document.h"
#include "ui/state/export_choices.h"

namespace swaplight {

/// Asks what is to be written, how and where.
class ExportDialog {
 public:
  explicit ExportDialog(std::filesystem::path memory);

  /// Opens it for a session. `name` stands for it in files' names, `folder` is where they go first. Without a
  /// kind it is that of the last time.
  void open(const std::string& name, const std::filesystem::path& folder, std::optional<ExportKind> kind,
            std::vector<std::filesystem::path> inputs);
  [[nodiscard]] bool isOpen() const { return m_open; }
  /// Somebody else has asked for the file's name.
  void setFile(const std::filesystem::path& file);
  [[nodiscard]] const ExportChoices& choices() const { return m_choices; }
  [[nodiscard]] const std::string& file() const { return m_file; }

  struct Answers {
    std::function<void(const ExportRequest&)> accept;
    std::function<void()> choose;  ///< asks for the file's name elsewhere, then setFile
  };
  /// Draws it while it is open. `document` says which view of the configuration pictures go through.
  void draw(const ColorConfig& config, const Document& document, const Answers& answers);

 private:
  void drawKinds();
  void drawFrame(const ColorConfig& config, const Document& document);
  void drawTiming(const Document& document);
  void drawLayers();
  void drawCameraLook(const Document& document);
  void drawGrade(const Document& document);
  void drawFormats();
  void drawColorSpaces();
  void drawFile(const Answers& answers);
  void drawFooter(const Document& document, const Answers& answers);
  void suggest();
  void take(const std::string& file);
  [[nodiscard]] bool isInput(const std::filesystem::path& file) const;
  [[nodiscard]] std::string mistake() const;
  void accept(const Answers& answers);

  std::filesystem::path m_memory;  ///< the file that remembers
  ExportChoices m_choices;
  bool m_open = false;
  bool m_focus = false;                          ///< the file's name is to be typed
  std::string m_name;                            ///< of the session
  std::vector<std::filesystem::path> m_inputs;   ///< what the session reads: not to be replaced
  std::string m_file;                            ///< as typed
  std::vector<std::filesystem::path> m_written;  ///< what is written under that name
  bool m_galleryEmpty = false;
  std::string m_cueMistake;  ///< why the cue list makes no frames; empty: it does
};

}  // namespace swaplight

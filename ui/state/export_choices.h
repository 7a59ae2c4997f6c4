#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "core/export/document_export.h"

namespace swaplight {

inline constexpr float kMostRate = 1000;  ///< frames a second

/// What was chosen in the export dialog: remembered from one time to the next.
struct ExportChoices {
  ExportKind kind = ExportKind::Frame;
  /// The format of each kind, as its extension.
  std::array<std::string, 7> formats = {".exr", ".exr", ".exr", ".cube", ".html", ".exr", ".png"};
  bool floatFrame = false;     ///< frame, sequence: EXR in float instead of half
  bool sixteenBits = false;    ///< PNG, TIFF: instead of 8
  std::string colorSpace;      ///< frame, layers: primaries of scene-linear light; empty: the set's
  std::string tone;            ///< frame through a view: a tone mapping instead of it
  std::string naming = "one";  ///< layers: one, multi, blender
  bool floatLayers = false;
  std::string compression = "zip";
  bool beta = false, highlights = false, quality = false;
  float framesPerSecond = 24;    ///< sequence
  float holdSeconds = 1;         ///< sequence: of cues that nothing follows
  bool grade = true;             ///< frame, sequence: with the session's grade, where it has one
  bool cameraLook = true;        ///< frame, layers: seen through the session's camera look, where it has one
  std::filesystem::path folder;  ///< where the last file went
  bool operator==(const ExportChoices&) const = default;

  [[nodiscard]] std::string& format() { return formats.at(static_cast<size_t>(kind)); }
  [[nodiscard]] const std::string& format() const { return formats.at(static_cast<size_t>(kind)); }
};

/// The extensions that a kind can have, its usual one first.
[[nodiscard]] const std::vector<std::string>& formatsOf(ExportKind kind);
/// The request that the choices stand for.
[[nodiscard]] ExportRequest requestOf(const ExportChoices& choices, const std::filesystem::path& file);

/// Defaults where there is no file, or none that can be read.
[[nodiscard]] ExportChoices readExportChoices(const std::filesystem::path& file);
void writeExportChoices(const ExportChoices& choices, const std::filesystem::path& file);

}  // namespace swaplight

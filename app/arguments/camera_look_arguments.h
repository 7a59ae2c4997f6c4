#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/program/terminal.h"
#include "core/session/session_file.h"
#include "render/filter/camera_look.h"

namespace swaplight {

/// Filters as the command line names them: a look by its name or file, or filters one by one.
struct FilterRequest {
  std::string look;
  std::vector<std::string> filters;  ///< "NAME,parameter=value"

  [[nodiscard]] bool empty() const { return look.empty() && filters.empty(); }
  /// Throws InputError: both, no such look.
  [[nodiscard]] FilterPipeline pipeline() const;
};

/// Ready to be drawn. Filters of a look that are broken are left out and said in a line; those that were
/// typed one by one (`strict`) have to be right. `where` begins messages. Throws InputError; ResourceError
/// where OpenGL is missing.
[[nodiscard]] std::shared_ptr<CameraLook> readyLook(const FilterPipeline& pipeline, const std::string& where,
                                                    bool strict, CameraLookOptions options,
                                                    Terminal& terminal);

/// What draws the camera looks of a gallery's versions (GalleryOptions::cameraLook). Where one cannot be made
/// ready (no OpenGL) that is said, once a line, and it is drawn without: a small picture is better than none.
[[nodiscard]] std::function<std::shared_ptr<FrameFilter>(const FilterPipeline&)> versionLooks(
    Terminal& terminal);

/// Throws InputError where a filter of the look is not for this place: "shot", "light" or "frame".
void checkPlace(const CameraLook& look, const std::string& place);

/// A still's file: its number in the place for one. Throws InputError where there is a place and no number.
[[nodiscard]] std::string stillName(const std::string& file, std::optional<int> number);

/// 1 where a filter was left out, else `code`.
[[nodiscard]] int codeWithLook(int code, const CameraLook* look);

/// The camera look of verbs that make frames: what the command line asks for, else the session's.
class CameraLookArguments {
 public:
  void addTo(CLI::App& verb);

  /// Null where there is nothing to draw. Throws as readyLook.
  [[nodiscard]] std::shared_ptr<CameraLook> look(const std::optional<Session>& session,
                                                 Terminal& terminal) const;
  /// What it reads: no output may replace it.
  [[nodiscard]] std::vector<std::filesystem::path> inputs(const CameraLook* look) const;

  /// The number of a still.
  [[nodiscard]] int frame() const { return m_frame.value_or(0); }
  [[nodiscard]] std::optional<int> givenFrame() const { return m_frame; }
  /// The longest side of the parts in which large frames are drawn.
  [[nodiscard]] int partSide() const { return m_options.tileSide; }

 private:
  FilterRequest m_request;
  std::optional<int> m_frame;
  CameraLookOptions m_options;
};

}  // namespace swaplight

#pragma once

#include <imgui.h>

#include <array>
#include <span>

#include "ui/control/editing_context.h"

namespace swaplight {

/// The mouse in the viewer, in one frame. The viewer's item was submitted last.
struct ToolInput {
  const ViewWindow& window;
  ImVec2 origin;  ///< the corner of the pane under the mouse
  bool hovered;   ///< nothing lies between mouse and picture
  bool alt;       ///< Alt is held: most tools give way to picking a colour
  bool moves;     ///< a key is held with which the mouse moves the picture or its exposure
  bool grabbed;   ///< the mouse holds the picture, or what belongs to the viewer
};

/// What the mouse does in the picture while a tool is in the hand, and what the tool draws there.
struct PictureTool {
  /// A tool that sets the mouse's cursor itself, or leaves it an arrow.
  static constexpr ImGuiMouseCursor kOwnCursor = -2;

  /// What takes it into the hand: one tool, two that work alike, or none (it is asked whatever is in the
  /// hand).
  std::array<const Tool*, 2> tools;
  /// Whether the mouse is this tool's: it is in the hand, or in the middle of something.
  bool (*wants)(const EditingContext& studio, const ToolInput& input);
  /// False where it finds nothing to do here: the next tool is asked.
  bool (*handle)(EditingContext& studio, const ToolInput& input);
  /// Draws over the picture, in every frame; nullptr: nothing.
  void (*overlay)(EditingContext& studio, const ViewWindow& window, ImVec2 origin) = nullptr;
  ImGuiMouseCursor cursor = kOwnCursor;  ///< over the picture
  bool takesCtrlWheel = false;           ///< Ctrl and the wheel are not the viewer's
};

/// The actions that take the tools into the hand. A tool's button puts it away again, as Escape does; its key
/// does not.
void addToolActions(ActionTable& actions, EditingContext& studio);

/// In the order in which they are asked and draw.
[[nodiscard]] std::span<const PictureTool* const> pictureTools();

}  // namespace swaplight

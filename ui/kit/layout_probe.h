#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace swaplight {

// Where named widgets lie on the screen, written to a JSON file whenever it changes, so that tests can move a
// real mouse to them. Costs nothing where it is not asked for.

/// A rectangle in screen pixels.
struct ItemRect {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};
/// From here on the rectangles of the last frame can be asked for.
void rememberLayout();
/// A widget's rectangle in the last frame; nothing where it was not seen.
[[nodiscard]] std::optional<ItemRect> itemRect(const std::string& name);

/// From here on every frame's rectangles go to this file.
void probeLayout(const std::filesystem::path& file);

/// Names the widget that was submitted last, as "mixer.key.stops".
void markItem(const std::string& name);
/// Names a rectangle in screen pixels.
void markRect(const std::string& name, float x0, float y0, float x1, float y1);
/// A word about the state of things, as "status": "ready".
void markState(const std::string& name, const std::string& value);

/// Writes the frame's rectangles if they differ from the last frame's.
void endLayoutFrame();

}  // namespace swaplight

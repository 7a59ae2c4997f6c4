#pragma once

#include <concepts>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

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

/// A part of a name: text or a number. Text is only looked at during the call.
class NamePart {
 public:
  NamePart(const char* text) : m_text(text) {}         // NOLINT: meant to convert
  NamePart(std::string_view text) : m_text(text) {}    // NOLINT
  NamePart(const std::string& text) : m_text(text) {}  // NOLINT
  template <std::integral Number>
  NamePart(Number number) : m_number(static_cast<long long>(number)) {}  // NOLINT
  void appendTo(std::string& name) const;

 private:
  std::string_view m_text;
  std::optional<long long> m_number;
};

/// Names the widget that was submitted last, as {"mixer.", light, ".stops"}: the parts are put together only
/// where somebody asks.
void markItem(std::initializer_list<NamePart> name);
inline void markItem(const NamePart& name) {
  markItem(std::initializer_list<NamePart>{name});
}
/// The widget that was submitted last has a tooltip.
void markTip();
/// Names a rectangle in screen pixels.
void markRect(std::initializer_list<NamePart> name, float x0, float y0, float x1, float y1);
inline void markRect(const NamePart& name, float x0, float y0, float x1, float y1) {
  markRect(std::initializer_list<NamePart>{name}, x0, y0, x1, y1);
}
/// A word about the state of things, as "status": "ready".
void markState(std::string_view name, std::string_view value);

/// Writes the frame's rectangles if they differ from the last frame's.
void endLayoutFrame();

}  // namespace swaplight

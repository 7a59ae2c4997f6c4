#pragma once

#include <vector>

#include "core/edit/apply/highlight_row.h"
#include "core/edit/apply/prepared_edit.h"
#include "core/edit/operations/operations.h"
#include "core/set/solved_set.h"

namespace swaplight {

constexpr int kTileSize = 256;  ///< pixels: the part of a set that is computed at a time

/// A rectangle of the set while edits are applied to it.
class EditTile {
 public:
  /// The set's contributions in `area` (inside the picture); `lights` - set.lightCount() new lights without
  /// light.
  EditTile(const SolvedSet& set, int lights, const PixelRect& area);

  /// The same with contributions that have been edited already, and the set at unit white as it was solved.
  /// Of a set without highlights.
  EditTile(const SolvedSet& set, const SolvedSet& edited, const PixelRect& area);

  /// A part of another.
  EditTile(const EditTile& whole, const PixelRect& area);

  /// Applies an edit to `part` of the area. Edits that look around (PreparedEdit::reach) read the whole area:
  /// what lies outside counts only where it is outside the picture.
  void apply(const PreparedEdit& edit, const PixelRect& part);

  [[nodiscard]] const PixelRect& area() const { return m_area; }
  [[nodiscard]] size_t bytes() const { return m_data.size() * sizeof(float); }
  /// A contribution's row: x from area().x on.
  [[nodiscard]] const float* row(int light, int channel, int y) const;
  /// The ambient light's, of a set that has it; else nullptr.
  [[nodiscard]] const float* ambientRow(int channel, int y) const;
  /// What part of a contribution is highlight, 0..1, of a set that knows; else nullptr.
  [[nodiscard]] const float* highlightRow(int light, int channel, int y) const;

 private:
  [[nodiscard]] float* writableRow(int light, int channel, int y);
  /// A contribution's row from x on.
  [[nodiscard]] HighlightRow lightRow(int light, int channel, int y, int x);
  [[nodiscard]] const float* whiteRow(int channel, int y) const;
  [[nodiscard]] const float* inverseGreyRow(int y) const;
  void copyAmbient(const Image& ambient);
  void copyHighlights(const SolvedSet& set);
  [[nodiscard]] size_t planes() const;
  void betaRow(int light, int y, int x, int count, float* out) const;
  /// Beta of a light over the whole area, blurred.
  [[nodiscard]] std::vector<float> blurredBeta(int light, int radius) const;
  /// A part of a row in which an edit acts.
  struct Span {
    int x, y, count;
    const float* mask;  ///< times the edit's opacity
  };
  /// Calls body(Span) for each row of the area in which the edit's mask lets something through.
  template <typename Body>
  void forEachSpan(const PreparedEdit& edit, const PixelRect& area, const Body& body);
  void swapLights(const PreparedEdit& edit, const PixelRect& area);
  void applyOperation(const ShadowOperation& operation, const PreparedEdit& edit, const PixelRect& area);
  void applyOperation(const UnknownGelOperation& operation, const PreparedEdit& edit, const PixelRect& area);
  template <LampOperation T>
  void applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area);
  template <HighlightOperation T>
  void applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area);
  template <BetaOperation T>
  void applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area);
  template <SurfaceOperation T>
  void applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area);

  int m_lights;
  bool m_ambient;
  bool m_highlights;
  PixelRect m_area;
  size_t m_plane;  // pixels of a plane
  // Light by light R G B, then white R G B, 1 / grey of white, ambient R G B, and the part of each light's R
  // G B that is highlight.
  std::vector<float> m_data;
};

}  // namespace swaplight

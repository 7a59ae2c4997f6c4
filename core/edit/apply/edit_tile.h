#pragma once

#include <array>
#include <vector>

#include "core/edit/apply/edit_changes.h"
#include "core/edit/apply/highlight_row.h"
#include "core/edit/apply/prepared_edit.h"
#include "core/edit/operations/operations.h"
#include "core/set/solved_set.h"

namespace swaplight {

constexpr int kTileSize = 256;  ///< pixels: the part of a set that is computed at a time

/// A rectangle of some of a set's lights while edits are applied to it.
class EditTile {
 public:
  /// The contributions of `lights` of the set in `area` (inside the picture), which must outlive it; of
  /// lights beyond set.lightCount(), which are new: no light. `count`: of all lights, the new ones too. Where
  /// `lights` are all of them it has the ambient light.
  EditTile(const SolvedSet& set, int count, const LightIndices& lights, const PixelRect& area);

  /// All lights, with contributions that have been edited already. Of a set without highlights; the set at
  /// unit white is as it was solved.
  EditTile(const SolvedSet& set, const SolvedSet& edited, const PixelRect& area);

  /// A part of another, and some of its lights.
  EditTile(const EditTile& whole, const LightIndices& lights, const PixelRect& area);

  /// Applies an edit to `part` of the area. Edits that look around (PreparedEdit::reach) read the whole area:
  /// what lies outside counts only where it is outside the picture. All lights that the edit ties to one that
  /// the tile has (withTiedLights) must be there.
  void apply(const PreparedEdit& edit, const PixelRect& part);

  [[nodiscard]] const PixelRect& area() const { return m_area; }
  [[nodiscard]] size_t bytes() const {
    return (m_data.size() + m_white.size() + m_surfaces.size()) * sizeof(float);
  }
  [[nodiscard]] bool has(int light) const { return m_places[static_cast<size_t>(light)] >= 0; }
  /// A contribution's row, of a light that it has: x from area().x on.
  [[nodiscard]] const float* row(int light, int channel, int y) const {
    return rowOf(m_data, 3 * m_places[static_cast<size_t>(light)] + channel, y);
  }
  /// The ambient light's; nullptr where there is none or it is not here.
  [[nodiscard]] const float* ambientRow(int channel, int y) const;
  /// What part of a contribution is highlight, 0..1, of a set that knows; else nullptr.
  [[nodiscard]] const float* highlightRow(int light, int channel, int y) const;

 private:
  struct Layout {
    const LightIndices& lights;
    int count;
    bool ambient, highlights;
  };
  EditTile(const SolvedSet& set, const Layout& layout, const PixelRect& area);

  [[nodiscard]] const float* rowOf(const std::vector<float>& planes, int plane, int y) const {
    return planes.data() + static_cast<size_t>(plane) * m_plane +
           static_cast<size_t>(y - m_area.y) * static_cast<size_t>(m_area.width);
  }
  [[nodiscard]] float* writableRow(int light, int channel, int y);
  [[nodiscard]] float* writableAmbientRow(int channel, int y);
  [[nodiscard]] float* writableWhiteRow(int channel, int y);
  /// A contribution's row from x on.
  [[nodiscard]] HighlightRow lightRow(int light, int channel, int y, int x);
  /// The rows below are there once an edit has needed them.
  void needWhite();
  [[nodiscard]] const float* whiteRow(int channel, int y) const { return rowOf(m_white, channel, y); }
  [[nodiscard]] const float* inverseGreyRow(int y) const { return rowOf(m_white, kInverseGrey, y); }
  void needSurfaces();
  void copyAmbient(const Image& ambient);
  void copyHighlights();
  void betaRow(int light, int y, int x, int count, float* out) const;
  /// Beta of a light over the whole area, blurred.
  [[nodiscard]] std::vector<float> blurredBeta(int light, int radius) const;
  /// Those of an edit's lights that are here.
  [[nodiscard]] std::vector<int> lightsHere(const PreparedEdit& edit) const;
  /// A part of a row in which an edit acts.
  struct Span {
    int x, y, count;
    const float* mask;  ///< times the edit's opacity
  };
  /// Calls body(Span) for each row of the area in which the edit's mask lets something through.
  template <typename Body>
  void forEachSpan(const PreparedEdit& edit, const PixelRect& area, const Body& body);
  /// What `light` gives to the surfaces as solved (the row's R G B, from the span's first pixel on), on those
  /// that edits have recoloured; `room` is where it is kept.
  [[nodiscard]] std::array<const float*, 3> onSurfaces(const Image& light, const Span& span,
                                                       std::vector<float>& room) const;
  void swapLights(const PreparedEdit& edit, const PixelRect& area);
  void applyOperation(const ShadowOperation& operation, const PreparedEdit& edit, const PixelRect& area);
  void applyOperation(const UnknownGelOperation& operation, const PreparedEdit& edit, const PixelRect& area);
  void applyOperation(const PlaceOperation& operation, const PreparedEdit& edit, const PixelRect& area);
  template <LampOperation T>
  void applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area);
  template <HighlightOperation T>
  void applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area);
  template <BetaOperation T>
  void applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area);
  template <SurfaceOperation T>
  void applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area);

  static constexpr int kInverseGrey = 3;  // the plane of m_white

  const SolvedSet* m_set;
  std::vector<int> m_places;  // of each light among those that are here; -1: it is not
  int m_here = 0;             // lights
  bool m_ambient;
  bool m_highlights;
  PixelRect m_area;
  size_t m_plane;  // pixels of a plane
  // Light by light R G B, the part of each light's R G B that is highlight, ambient R G B.
  std::vector<float> m_data;
  std::vector<float> m_white;  // R G B and 1 / their sum; empty until an edit needs it
  // What edits have made of surfaces' colours: white before the first of them, R G B, and after; else empty.
  std::vector<float> m_surfaces;
};

}  // namespace swaplight

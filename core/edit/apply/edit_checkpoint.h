#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/edit/apply/edit_tile.h"

namespace swaplight {

constexpr int kBandRows = 32;  ///< a band of a tile fits into a core's own cache

/// Remembers the set as it is below the edit that is being painted in, band by band as they are needed, so
/// that a dab costs one edit and those above it. Threads may work on different bands at once.
class EditCheckpoint {
 public:
  using Edits = std::vector<std::shared_ptr<const PreparedEdit>>;

  EditCheckpoint(int width, int height);

  /// Tells how the stack changed. Forgets what is no longer true; starts to remember where it was painted.
  /// True where it has begun anew.
  bool follow(const Edits& before, const Edits& after);
  void forget();

  /// How many edits of the stack are below the checkpoint; 0 where there is none.
  [[nodiscard]] size_t editsBelow() const { return m_below; }
  /// True from when edits were added at the end of the stack: a band that is not there yet is still as the
  /// whole stack was before.
  [[nodiscard]] bool startedAtTheEnd() const { return m_atEnd; }
  /// The state of lights below, for an area within one band; `evaluate` computes a band that is not there
  /// yet, of all lights.
  [[nodiscard]] EditTile stateAt(const PixelRect& area, const LightIndices& lights,
                                 const std::function<EditTile(const PixelRect& band)>& evaluate);

 private:
  [[nodiscard]] size_t bytes() const;

  int m_width, m_height;
  size_t m_below = 0;
  bool m_atEnd = false;
  std::vector<std::unique_ptr<EditTile>> m_bands;
};

}  // namespace swaplight

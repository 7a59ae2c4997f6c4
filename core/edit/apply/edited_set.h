#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/edit/apply/edit_checkpoint.h"
#include "core/edit/apply/prepared_edit.h"
#include "core/edit/stack/edit.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// The set's lights and those that the edits add. Throws InputError where a new one has the name of another.
[[nodiscard]] EditedLights editedLights(const SolvedSet& set, const EditStack& stack);

/// Of an edit of highlights, where a set has none.
inline constexpr const char* kNoHighlights =
    "nothing changes: this set has no highlights. A solve keeps them of glossy things under two lights or "
    "more";

/// The truth that EditedSet is compared with: the whole picture, one edit after the other, without tiles or
/// caches. New lights follow the set's own; beta is of the result; quality is not filled in. What edits of
/// lamps cannot know is among the capture's warnings. Throws InputError.
[[nodiscard]] SolvedSet applyEdits(const SolvedSet& set, const EditStack& stack,
                                   const ShadowSource& shadows = {}, const SurfaceSource& surfaces = {});

/// A solved set seen through a stack of edits. Keeps the result, and computes again only what a change of the
/// stack can have changed, light by light and tile by tile, when it is asked for. Not for use by several
/// threads at once.
class EditedSet {
 public:
  /// Keeps the set: it must not change. Shadows and surfaces are asked for when an edit needs them.
  explicit EditedSet(std::shared_ptr<const SolvedSet> set, ShadowSource shadows = {},
                     SurfaceSource surfaces = {});

  /// Takes a new stack. Computes nothing yet; asks for shadows and surfaces again where what is said of them
  /// (thresholds, marks, the lamps' places) has changed.
  /// Where the stack has other new lights, result() has other images; those of lights that stay keep their
  /// pixels where they lie in memory. Throws InputError, and keeps the old stack then.
  void setStack(const EditStack& stack);
  /// The next stack's edits ask for surfaces again: others have been found by the same places.
  void surfacesChanged() { m_surfacesChanged = true; }
  [[nodiscard]] const EditStack& stack() const { return m_stack; }
  /// One of the stack's edits (this very object) as it runs; nullptr: there is none.
  [[nodiscard]] std::shared_ptr<const PreparedEdit> prepared(const Edit* edit) const;

  /// Computes what is out of date in the area. Returns the rectangles (at most one a tile) that have changed.
  std::vector<PixelRect> update(const PixelRect& area);
  std::vector<PixelRect> update();

  /// A tile that is out of date; nothing where all is done.
  [[nodiscard]] std::optional<PixelRect> staleTile() const;
  /// The lights that are out of date in one tile or another: those that update computes.
  [[nodiscard]] const LightIndices& staleLights() const { return m_staleLights; }

  /// The edited set: up to date where update has been. New lights follow the set's own. Without quality,
  /// which is that of the set as solved, and without beta (updateBeta).
  [[nodiscard]] const SolvedSet& result() const { return m_result; }
  [[nodiscard]] const SolvedSet& original() const { return *m_set; }
  /// What the masks of its edits are drawn on.
  [[nodiscard]] MaskContext& context() { return m_context; }
  /// The beta maps that its edits take from files.
  [[nodiscard]] BetaFiles& files() { return m_files; }

 private:
  using Prepared = std::shared_ptr<const PreparedEdit>;
  void markStale(const PixelRect& area);
  void markAllStale();
  [[nodiscard]] int columns() const { return (m_set->width() + kTileSize - 1) / kTileSize; }
  [[nodiscard]] EditTile evaluate(const PixelRect& area, size_t edits, const LightIndices& lights) const;
  [[nodiscard]] EditTile belowCheckpoint(const PixelRect& band) const;
  void compute(const PixelRect& area);

  std::shared_ptr<const SolvedSet> m_set;
  MaskContext m_context;
  BetaFiles m_files;
  EditStack m_stack;
  std::vector<Prepared> m_prepared;
  SolvedSet m_result;
  bool m_surfacesChanged = false;
  EditCheckpoint m_checkpoint;
  std::vector<PixelRect> m_stale;       // a rectangle a tile, empty where the tile is up to date
  LightIndices m_staleLights;           // in any of them
  std::vector<PixelRect> m_staleBelow;  // what it was when the checkpoint began
};

}  // namespace swaplight

#include "core/edit/apply/edit_checkpoint.h"

#include <algorithm>

#include "core/edit/apply/edit_changes.h"

namespace swaplight {
namespace {

constexpr int kBandsATile = kTileSize / kBandRows;
constexpr size_t kMostBytes = size_t{320} << 20;
constexpr size_t kMostAbove = 4;  // edits that a dab may cost before the checkpoint follows it

int tilesAcross(int pixels) {
  return (pixels + kTileSize - 1) / kTileSize;
}

bool looksAround(const EditCheckpoint::Edits& edits, size_t from) {
  return std::any_of(edits.begin() + static_cast<ptrdiff_t>(from), edits.end(),
                     [](const auto& edit) { return edit->reach() > 0; });
}

bool isPainted(const EditCheckpoint::Edits& edits, size_t index) {
  if (index >= edits.size()) return false;
  const Mask& mask = edits[index]->edit->mask;
  return std::any_of(mask.begin(), mask.end(),
                     [](const MaskShape& shape) { return std::holds_alternative<PaintShape>(shape.shape); });
}

}  // namespace

EditCheckpoint::EditCheckpoint(int width, int height) : m_width(width), m_height(height) {
  forget();
}

void EditCheckpoint::forget() {
  m_below = 0;
  m_atEnd = false;
  m_bands.clear();
  m_bands.resize(size_t(tilesAcross(m_width)) * size_t(tilesAcross(m_height)) * kBandsATile);
}

size_t EditCheckpoint::bytes() const {
  size_t sum = 0;
  for (const auto& band : m_bands) sum += band ? band->bytes() : 0;
  return sum;
}

bool EditCheckpoint::follow(const Edits& before, const Edits& after) {
  const size_t same = commonEdits(before, after);
  const bool holds = m_below > 0 && same >= m_below && !looksAround(after, m_below);
  if (holds && same - m_below <= kMostAbove && bytes() < kMostBytes) return false;
  forget();
  if (same == 0 || looksAround(after, same) || !isPainted(after, same)) return true;
  m_below = same;
  m_atEnd = same == before.size();
  return true;
}

EditTile EditCheckpoint::stateAt(const PixelRect& area, const LightIndices& lights,
                                 const std::function<EditTile(const PixelRect& band)>& evaluate) {
  const int column = area.x / kTileSize;
  const int row = area.y / kBandRows;
  auto& band = m_bands[size_t(row) * size_t(tilesAcross(m_width)) + size_t(column)];
  if (!band) {
    const PixelRect whole =
        intersection({column * kTileSize, row * kBandRows, kTileSize, kBandRows}, {0, 0, m_width, m_height});
    band = std::make_unique<EditTile>(evaluate(whole));
  }
  return {*band, lights, area};
}

}  // namespace swaplight

#include "core/edit/edit_checkpoint.h"

#include <algorithm>

#include "core/edit/edit_changes.h"

namespace swaplight {
namespace {

constexpr int kBandsATile = kTileSize / kBandRows;
constexpr size_t kMostBands = 1024;  // 256 MB with two lights, 512 MB with four

int tilesAcross(int pixels) {
  return (pixels + kTileSize - 1) / kTileSize;
}

}  // namespace

EditCheckpoint::EditCheckpoint(int width, int height) : m_width(width), m_height(height) {
  forget();
}

void EditCheckpoint::forget() {
  m_below = 0;
  m_bands.clear();
  m_bands.resize(size_t(tilesAcross(m_width)) * size_t(tilesAcross(m_height)) * kBandsATile);
}

void EditCheckpoint::follow(const Edits& before, const Edits& after) {
  const auto painted = paintedEdit(before, after);
  const bool looksAround = painted && std::any_of(after.begin() + static_cast<ptrdiff_t>(*painted),
                                                  after.end(), [](const auto& e) { return e->reach() > 0; });
  const auto kept = static_cast<size_t>(
      std::count_if(m_bands.begin(), m_bands.end(), [](const auto& band) { return band != nullptr; }));
  // The edits below are the same objects: paintedEdit says so.
  if (painted && *painted == m_below && !looksAround && kept < kMostBands) return;
  forget();
  if (painted && !looksAround) m_below = *painted;
}

EditTile EditCheckpoint::stateAt(const PixelRect& area,
                                 const std::function<EditTile(const PixelRect& band)>& evaluate) {
  const int column = area.x / kTileSize;
  const int row = area.y / kBandRows;
  auto& band = m_bands[size_t(row) * size_t(tilesAcross(m_width)) + size_t(column)];
  if (!band) {
    const PixelRect whole =
        intersection({column * kTileSize, row * kBandRows, kTileSize, kBandRows}, {0, 0, m_width, m_height});
    band = std::make_unique<EditTile>(evaluate(whole));
  }
  return {*band, area};
}

}  // namespace swaplight

#include "core/edit/apply/edit_tile.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <opencv2/imgproc.hpp>

#include "core/edit/apply/edit_rows.h"
#include "core/edit/apply/highlight_row.h"
#include "core/edit/apply/reflectance_row.h"
#include "core/edit/pool/lamp_gain.h"

namespace swaplight {
namespace {

// Below it a surface's colour is noise: a few times the sensor's, at unit white.
float darkestSurface(const SolvedSet& set) {
  constexpr double kNoises = 4;
  return set.report ? static_cast<float>(kNoises * set.report->noise.read) : 0;
}

void copyRow(const Image& from, int channel, int y, const PixelRect& area, float* to) {
  std::copy_n(from.view().row(channel, y) + area.x, area.width, to);
}

}  // namespace

EditTile::EditTile(const SolvedSet& set, const Layout& layout, const PixelRect& area)
    : m_set(&set),
      m_places(static_cast<size_t>(layout.count), -1),
      m_ambient(layout.ambient),
      m_highlights(layout.highlights),
      m_area(area),
      m_plane(static_cast<size_t>(area.width) * static_cast<size_t>(area.height)) {
  for (const int light : layout.lights) m_places[static_cast<size_t>(light)] = m_here++;
  m_data.resize(m_plane * static_cast<size_t>(m_here * (m_highlights ? 6 : 3) + (m_ambient ? 3 : 0)));
}

EditTile::EditTile(const SolvedSet& set, int count, const LightIndices& lights, const PixelRect& area)
    : EditTile(set,
               {lights, count, set.ambient.has_value() && static_cast<int>(lights.size()) == count,
                !set.highlights.empty()},
               area) {
  for (const int light : lights)
    for (int c = 0; light < set.lightCount() && c < 3; ++c)
      for (int y = area.y; y < area.bottom(); ++y)
        copyRow(set.contributions[static_cast<size_t>(light)], c, y, area, writableRow(light, c, y));
  if (m_ambient) copyAmbient(*set.ambient);
  copyHighlights();
}

EditTile::EditTile(const SolvedSet& set, const SolvedSet& edited, const PixelRect& area)
    : EditTile(set, {allLights(edited.lightCount()), edited.lightCount(), set.ambient.has_value(), false},
               area) {
  for (int i = 0; i < m_here; ++i)
    for (int c = 0; c < 3; ++c)
      for (int y = area.y; y < area.bottom(); ++y)
        copyRow(edited.contributions[static_cast<size_t>(i)], c, y, area, writableRow(i, c, y));
  if (m_ambient) copyAmbient(*edited.ambient);
}

EditTile::EditTile(const EditTile& whole, const LightIndices& lights, const PixelRect& area)
    : EditTile(*whole.m_set,
               {lights, static_cast<int>(whole.m_places.size()),
                whole.m_ambient && lights.size() == whole.m_places.size(), whole.m_highlights},
               area) {
  const int skip = area.x - whole.m_area.x;
  for (int y = area.y; y < area.bottom(); ++y)
    for (int c = 0; c < 3; ++c) {
      for (const int light : lights) {
        const HighlightRow to = lightRow(light, c, y, area.x);
        std::copy_n(whole.row(light, c, y) + skip, area.width, to.light);
        if (m_highlights) std::copy_n(whole.highlightRow(light, c, y) + skip, area.width, to.part);
      }
      if (m_ambient) std::copy_n(whole.ambientRow(c, y) + skip, area.width, writableAmbientRow(c, y));
    }
  const auto copyPlanes = [&](const std::vector<float>& from, size_t planes, std::vector<float>& to) {
    if (from.empty()) return;
    to.resize(planes * m_plane);
    for (int plane = 0; plane < static_cast<int>(planes); ++plane)
      for (int y = area.y; y < area.bottom(); ++y)
        std::copy_n(whole.rowOf(from, plane, y) + skip, area.width,
                    to.data() + (rowOf(to, plane, y) - to.data()));
  };
  copyPlanes(whole.m_white, 4, m_white);
  copyPlanes(whole.m_surfaces, 6, m_surfaces);
}

void EditTile::needWhite() {
  if (!m_white.empty()) return;
  m_white.resize(4 * m_plane);
  for (const Image& contribution : m_set->contributions)
    for (int c = 0; c < 3; ++c)
      for (int y = m_area.y; y < m_area.bottom(); ++y) {
        const float* in = contribution.view().row(c, y) + m_area.x;
        float* sum = writableWhiteRow(c, y);
        for (int x = 0; x < m_area.width; ++x) sum[x] += in[x];
      }
  float* white = m_white.data();
  for (size_t p = 0; p < m_plane; ++p) {
    const float grey = white[p] + white[m_plane + p] + white[2 * m_plane + p];
    white[kInverseGrey * m_plane + p] = grey > 0 ? 1 / grey : 0;
  }
}

void EditTile::needSurfaces() {
  if (!m_surfaces.empty()) return;
  needWhite();
  m_surfaces.resize(6 * m_plane);
  for (const size_t half : {size_t{0}, size_t{3}})
    std::copy_n(m_white.data(), 3 * m_plane, m_surfaces.data() + half * m_plane);
}

void EditTile::copyHighlights() {
  for (size_t i = 0; i < m_set->highlights.size(); ++i)
    for (int c = 0; has(static_cast<int>(i)) && c < 3; ++c)
      for (int y = m_area.y; y < m_area.bottom(); ++y) {
        const float* light = m_set->contributions[i].view().row(c, y) + m_area.x;
        const float* highlight = m_set->highlights[i].view().row(c, y) + m_area.x;
        float* part = lightRow(static_cast<int>(i), c, y, m_area.x).part;
        for (int x = 0; x < m_area.width; ++x) part[x] = light[x] > 0 ? highlight[x] / light[x] : 0;
      }
}

void EditTile::copyAmbient(const Image& ambient) {
  for (int c = 0; c < 3; ++c)
    for (int y = m_area.y; y < m_area.bottom(); ++y) copyRow(ambient, c, y, m_area, writableAmbientRow(c, y));
}

const float* EditTile::highlightRow(int light, int channel, int y) const {
  if (!m_highlights) return nullptr;
  return rowOf(m_data, 3 * (m_here + m_places[static_cast<size_t>(light)]) + channel, y);
}

const float* EditTile::ambientRow(int channel, int y) const {
  return m_ambient ? rowOf(m_data, m_here * (m_highlights ? 6 : 3) + channel, y) : nullptr;
}

float* EditTile::writableRow(int light, int channel, int y) {
  return m_data.data() + (row(light, channel, y) - m_data.data());
}

float* EditTile::writableAmbientRow(int channel, int y) {
  return m_data.data() + (ambientRow(channel, y) - m_data.data());
}

float* EditTile::writableWhiteRow(int channel, int y) {
  return m_white.data() + (whiteRow(channel, y) - m_white.data());
}

HighlightRow EditTile::lightRow(int light, int channel, int y, int x) {
  const int skip = x - m_area.x;
  const float* part = highlightRow(light, channel, y);
  return {writableRow(light, channel, y) + skip,
          part ? m_data.data() + (part - m_data.data()) + skip : nullptr};
}

std::vector<int> EditTile::lightsHere(const PreparedEdit& edit) const {
  std::vector<int> here;
  std::copy_if(edit.lights.begin(), edit.lights.end(), std::back_inserter(here),
               [&](int light) { return has(light); });
  return here;
}

void EditTile::betaRow(int light, int y, int x, int count, float* out) const {
  const int skip = x - m_area.x;
  const ConstRgbRow pixels{row(light, 0, y) + skip, row(light, 1, y) + skip, row(light, 2, y) + skip};
  betaOfRow(pixels, inverseGreyRow(y) + skip, count, out);
}

std::vector<float> EditTile::blurredBeta(int light, int radius) const {
  // Pixels without light have no beta: blur beta and the count of those who have it, then divide.
  cv::Mat beta(m_area.height, m_area.width, CV_32F);
  cv::Mat known(m_area.height, m_area.width, CV_32F);
  for (int y = 0; y < m_area.height; ++y) {
    betaRow(light, m_area.y + y, m_area.x, m_area.width, beta.ptr<float>(y));
    const float* inverse = inverseGreyRow(m_area.y + y);
    for (int x = 0; x < m_area.width; ++x) known.at<float>(y, x) = inverse[x] > 0 ? 1.f : 0.f;
  }
  const cv::Size kernel(2 * radius + 1, 2 * radius + 1);
  cv::GaussianBlur(beta, beta, kernel, radius / 2., 0, cv::BORDER_REPLICATE);
  cv::GaussianBlur(known, known, kernel, radius / 2., 0, cv::BORDER_REPLICATE);
  std::vector<float> blurred(m_plane);
  for (size_t p = 0; p < m_plane; ++p) {
    const float weight = known.ptr<float>()[p];
    blurred[p] = weight > 1e-6f ? beta.ptr<float>()[p] / weight : 0;
  }
  return blurred;
}

template <typename Body>
void EditTile::forEachSpan(const PreparedEdit& edit, const PixelRect& area, const Body& body) {
  std::vector<float> mask(static_cast<size_t>(area.width));
  for (int y = area.y; y < area.bottom(); ++y) {
    if (!edit.mask->row(area.x, y, area.width, mask.data())) continue;
    // Only between the first and the last pixel that the mask lets through.
    const auto isOpen = [](float m) { return m > 0; };
    const auto first = std::find_if(mask.begin(), mask.end(), isOpen);
    const auto end = std::find_if(mask.rbegin(), mask.rend(), isOpen).base();
    std::for_each(first, end, [&](float& m) { m *= edit.edit->opacity; });
    body(Span{area.x + static_cast<int>(first - mask.begin()), y, static_cast<int>(end - first), &*first});
  }
}

std::array<const float*, 3> EditTile::onSurfaces(const Image& light, const Span& span,
                                                 std::vector<float>& room) const {
  const auto rowIn = [&](const Image& image, int c) { return image.view().row(c, span.y) + span.x; };
  if (m_surfaces.empty()) return {rowIn(light, 0), rowIn(light, 1), rowIn(light, 2)};
  const auto count = static_cast<size_t>(span.count);
  room.resize(4 * count);
  float* const given[3] = {room.data(), room.data() + count, room.data() + 2 * count};
  float* const inverse = room.data() + 3 * count;
  const float* before[3];
  const float* after[3];
  for (int c = 0; c < 3; ++c) {
    before[c] = rowOf(m_surfaces, c, span.y) + (span.x - m_area.x);
    after[c] = rowOf(m_surfaces, 3 + c, span.y) + (span.x - m_area.x);
    std::copy_n(rowIn(light, c), count, given[c]);
  }
  for (size_t i = 0; i < count; ++i) {
    const float grey = before[0][i] + before[1][i] + before[2][i];
    inverse[i] = grey > 0 ? 1 / grey : 0;
  }
  changeReflectanceRow(before, after, inverse, darkestSurface(*m_set), span.count,
                       {{given[0], given[1], given[2]}});
  return {given[0], given[1], given[2]};
}

void EditTile::swapLights(const PreparedEdit& edit, const PixelRect& area) {
  forEachSpan(edit, area, [&](const Span& span) {
    for (int c = 0; c < 3; ++c)
      mixTwoLightsRow({{0, 1}, {1, 0}}, span.mask, span.count, lightRow(edit.lights[0], c, span.y, span.x),
                      lightRow(edit.lights[1], c, span.y, span.x));
  });
}

void EditTile::applyOperation(const ShadowOperation& operation, const PreparedEdit& edit,
                              const PixelRect& area) {
  std::vector<float> weight(static_cast<size_t>(area.width)), room;
  forEachSpan(edit, area, [&](const Span& span) {
    for (size_t k = 0; k < edit.lights.size(); ++k) {
      if (!has(edit.lights[k]) || !edit.shadows[k].shadows) continue;
      const ShadowChange& change = edit.shadows[k];
      shadowWeightRow(operation, change, span.x, span.y, span.mask, span.count, weight.data());
      const auto direct = onSurfaces(change.shadows->direct, span, room);
      for (int c = 0; c < 3; ++c)
        changeShadowRow(operation, c, weight.data(), direct[static_cast<size_t>(c)], span.count,
                        writableRow(edit.lights[k], c, span.y) + (span.x - m_area.x));
    }
  });
}

void EditTile::applyOperation(const PlaceOperation& /*operation*/, const PreparedEdit& edit,
                              const PixelRect& area) {
  std::vector<float> room, solvedRoom;
  forEachSpan(edit, area, [&](const Span& span) {
    for (size_t k = 0; k < edit.lights.size(); ++k) {
      const int light = edit.lights[k];
      const PlacedChange& change = edit.placed[k];
      if (!has(light) || change.isNeutral()) continue;
      PlacedRow row;
      row.paint = onSurfaces(change.surfaces().reflectance, span, room);
      if (light < m_set->lightCount())
        row.solved = onSurfaces(m_set->contributions[static_cast<size_t>(light)], span, solvedRoom);
      for (int c = 0; c < 3; ++c)
        row.light[static_cast<size_t>(c)] = writableRow(light, c, span.y) + (span.x - m_area.x);
      change.changeRow(span.x, span.y, span.count, span.mask, row);
    }
  });
}

template <LampOperation T>
void EditTile::applyOperation(const T& /*operation*/, const PreparedEdit& edit, const PixelRect& area) {
  for (size_t k = 0; k < edit.lights.size(); ++k)
    if (has(edit.lights[k]) && edit.lamps[k].gain && edit.lamps[k].gain->usesWhite()) needWhite();
  std::vector<float> room, directRoom;
  forEachSpan(edit, area, [&](const Span& span) {
    const int skip = span.x - m_area.x;
    for (size_t k = 0; k < edit.lights.size(); ++k) {
      const LampEdit& lamp = edit.lamps[k];
      if (!lamp.gain || !has(edit.lights[k])) continue;
      LampRow row;
      row.solved = onSurfaces(*lamp.solved, span, room);
      if (lamp.size != 1) row.direct = onSurfaces(lamp.shadows->direct, span, directRoom);
      for (int c = 0; c < 3; ++c) {
        row.light[c] = writableRow(edit.lights[k], c, span.y) + skip;
        row.white[c] = lamp.gain->usesWhite() ? whiteRow(c, span.y) + skip : nullptr;
      }
      changeLampRow(lamp, span.x, span.y, span.count, span.mask, row);
    }
  });
}

template <HighlightOperation T>
void EditTile::applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area) {
  if (!m_highlights) return;
  const std::vector<int> lights = lightsHere(edit);
  forEachSpan(edit, area, [&](const Span& span) {
    for (const int light : lights)
      for (int c = 0; c < 3; ++c)
        changeHighlightRow(operation.highlightTimes(), span.mask, span.count,
                           lightRow(light, c, span.y, span.x));
  });
}

template <BetaOperation T>
void EditTile::applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area) {
  if (requires { T::kSwapsTwoLights; } && edit.lights.size() == 2) return swapLights(edit, area);
  needWhite();
  std::vector<std::vector<float>> blurred(edit.lights.size());
  if (const int radius = edit.reach(); radius > 0)
    for (size_t k = 0; k < blurred.size(); ++k)
      if (has(edit.lights[k])) blurred[k] = blurredBeta(edit.lights[k], radius);
  const bool share = edit.edit->energy == EnergyMode::Redistribute;

  std::vector<RgbRow> rows;
  ShareScratch scratch(m_places.size(), static_cast<size_t>(area.width));
  forEachSpan(edit, area, [&](const Span& span) {
    const int skip = span.x - m_area.x;
    const auto count = static_cast<size_t>(span.count);

    // Beta as it is and as the operation wants it.
    for (int i = 0; share && i < m_here; ++i)
      betaRow(i, span.y, span.x, span.count, scratch.beta[static_cast<size_t>(i)].data());
    for (size_t k = 0; k < edit.lights.size(); ++k) {
      if (!has(edit.lights[k])) continue;
      const auto i = static_cast<size_t>(edit.lights[k]);
      if (!share) betaRow(edit.lights[k], span.y, span.x, span.count, scratch.beta[i].data());
      BetaRow row{{scratch.beta[i].data(), count}, nullptr, nullptr, edit.table};
      if (!blurred[k].empty())
        row.blurred = blurred[k].data() + static_cast<size_t>((span.y - m_area.y) * m_area.width + skip);
      if (edit.beta) row.map = edit.beta->maps[k].view().row(0, span.y) + span.x;
      float* target = scratch.target[i].data();
      operation.targetRow(row, target);
      std::transform(target, target + count, target, [](float t) { return std::max(t, 0.f); });
    }

    // Move the light.
    const auto pixelsOf = [&](int light) {
      return RgbRow{writableRow(light, 0, span.y) + skip, writableRow(light, 1, span.y) + skip,
                    writableRow(light, 2, span.y) + skip};
    };
    if (share) {
      rows.clear();
      for (int i = 0; i < m_here; ++i) rows.push_back(pixelsOf(i));
      return shareRow(rows, edit.lights, span.mask, span.count, scratch);
    }
    const ConstRgbRow white{whiteRow(0, span.y) + skip, whiteRow(1, span.y) + skip,
                            whiteRow(2, span.y) + skip};
    for (const int i : edit.lights) {
      if (!has(i)) continue;
      const auto k = static_cast<size_t>(i);
      addRow(pixelsOf(i), white, scratch.beta[k].data(), scratch.target[k].data(), span.mask, span.count);
    }
  });
}

void EditTile::applyOperation(const UnknownGelOperation& /*operation*/, const PreparedEdit& edit,
                              const PixelRect& area) {
  needWhite();
  forEachSpan(edit, area, [&](const Span& span) {
    GelRows rows{};
    for (int c = 0; c < 3; ++c) {
      for (int j = 0; j < 2; ++j) rows.light[j][c] = lightRow(edit.gel.lights[j], c, span.y, span.x);
      rows.white[c] = writableWhiteRow(c, span.y) + (span.x - m_area.x);
    }
    rows.inverseGrey = writableWhiteRow(kInverseGrey, span.y) + (span.x - m_area.x);
    changeGelRow(edit.gel, span.mask, span.count, rows);
  });
}

template <SurfaceOperation T>
void EditTile::applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area) {
  std::array<std::vector<float>, 3> after;
  for (std::vector<float>& channel : after) channel.resize(static_cast<size_t>(area.width));
  const float* const afterRows[3] = {after[0].data(), after[1].data(), after[2].data()};
  const std::vector<int> lights = lightsHere(edit);
  const float dark = darkestSurface(*m_set);
  needSurfaces();
  forEachSpan(edit, area, [&](const Span& span) {
    const int skip = span.x - m_area.x;
    const auto pixels = [&](int light, int c) { return writableRow(light, c, span.y) + skip; };
    const auto ambient = [&](int c) { return writableAmbientRow(c, span.y) + skip; };
    const auto whites = [&](int plane) { return writableWhiteRow(plane, span.y) + skip; };
    float* white[3] = {whites(0), whites(1), whites(2)};
    float* inverse = whites(kInverseGrey);
    for (int i = 0; i < span.count; ++i) {
      const Rgb light(white[0][i], white[1][i], white[2][i]);
      const Rgb next = light + span.mask[i] * (operation.recolored(light) - light);
      for (int c = 0; c < 3; ++c) after[static_cast<size_t>(c)][static_cast<size_t>(i)] = next[c];
    }
    for (const int j : lights)
      changeReflectanceRow(white, afterRows, inverse, dark, span.count,
                           {{pixels(j, 0), pixels(j, 1), pixels(j, 2)}});
    if (m_ambient)
      changeReflectanceRow(white, afterRows, inverse, dark, span.count,
                           {{ambient(0), ambient(1), ambient(2)}});
    for (int c = 0; c < 3; ++c) {  // white may have changed since the first recolouring, by other gels
      float* surface = m_surfaces.data() + (rowOf(m_surfaces, 3 + c, span.y) - m_surfaces.data()) + skip;
      for (int i = 0; i < span.count; ++i)
        surface[i] = white[c][i] == surface[i] || !(white[c][i] > 0)
                         ? afterRows[c][i]
                         : surface[i] * (afterRows[c][i] / white[c][i]);
    }
    for (int i = 0; i < span.count; ++i) {
      float grey = 0;
      for (int c = 0; c < 3; ++c) grey += white[c][i] = afterRows[c][i];
      inverse[i] = grey > 0 ? 1 / grey : 0;
    }
  });
}

void EditTile::apply(const PreparedEdit& edit, const PixelRect& part) {
  const PixelRect area = intersection(part, edit.mask->bounds());
  if (area.empty() || !edit.isActive() || edit.lights.empty() || !edit.mask->touches(area)) return;
  std::visit([&](const auto& operation) { applyOperation(operation, edit, area); }, edit.edit->operation);
}

}  // namespace swaplight

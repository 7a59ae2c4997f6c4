#include "core/edit/apply/edit_tile.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

#include "core/edit/apply/edit_rows.h"
#include "core/edit/apply/highlight_row.h"
#include "core/edit/apply/reflectance_row.h"
#include "core/edit/pool/lamp_gain.h"

namespace swaplight {
EditTile::EditTile(const SolvedSet& set, int lights, const PixelRect& area)
    : m_lights(lights),
      m_ambient(set.ambient.has_value()),
      m_highlights(!set.highlights.empty()),
      m_area(area),
      m_plane(static_cast<size_t>(area.width) * static_cast<size_t>(area.height)),
      m_data(m_plane * planes()) {
  float* white = m_data.data() + static_cast<size_t>(m_lights) * 3 * m_plane;
  for (int i = 0; i < set.lightCount(); ++i)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < area.height; ++y) {
        const float* in = set.contributions[static_cast<size_t>(i)].view().row(c, area.y + y) + area.x;
        std::copy_n(in, area.width, writableRow(i, c, area.y + y));
        float* sum = white + static_cast<size_t>(c) * m_plane + static_cast<size_t>(y * area.width);
        for (int x = 0; x < area.width; ++x) sum[x] += in[x];
      }
  float* inverse = white + 3 * m_plane;
  for (size_t p = 0; p < m_plane; ++p) {
    const float grey = white[p] + white[m_plane + p] + white[2 * m_plane + p];
    inverse[p] = grey > 0 ? 1 / grey : 0;
  }
  if (m_ambient) copyAmbient(*set.ambient);
  copyHighlights(set);
}

size_t EditTile::planes() const {
  return static_cast<size_t>(m_lights) * (m_highlights ? 6 : 3) + (m_ambient ? 7 : 4);
}

void EditTile::copyHighlights(const SolvedSet& set) {
  for (size_t i = 0; i < set.highlights.size(); ++i)
    for (int c = 0; c < 3; ++c)
      for (int y = m_area.y; y < m_area.bottom(); ++y) {
        const float* light = set.contributions[i].view().row(c, y) + m_area.x;
        const float* highlight = set.highlights[i].view().row(c, y) + m_area.x;
        float* part = lightRow(static_cast<int>(i), c, y, m_area.x).part;
        for (int x = 0; x < m_area.width; ++x) part[x] = light[x] > 0 ? highlight[x] / light[x] : 0;
      }
}

void EditTile::copyAmbient(const Image& ambient) {
  for (int c = 0; c < 3; ++c)
    for (int y = m_area.y; y < m_area.bottom(); ++y)
      std::copy_n(ambient.view().row(c, y) + m_area.x, m_area.width, writableRow(m_lights + 1, 1 + c, y));
}

EditTile::EditTile(const SolvedSet& set, const SolvedSet& edited, const PixelRect& area)
    : EditTile(set, edited.lightCount(), area) {
  for (int i = 0; i < m_lights; ++i)
    for (int c = 0; c < 3; ++c)
      for (int y = area.y; y < area.bottom(); ++y)
        std::copy_n(edited.contributions[static_cast<size_t>(i)].view().row(c, y) + area.x, area.width,
                    writableRow(i, c, y));
  if (m_ambient) copyAmbient(*edited.ambient);
}

EditTile::EditTile(const EditTile& whole, const PixelRect& area)
    : m_lights(whole.m_lights),
      m_ambient(whole.m_ambient),
      m_highlights(whole.m_highlights),
      m_area(area),
      m_plane(static_cast<size_t>(area.width) * static_cast<size_t>(area.height)),
      m_data(m_plane * planes()) {
  float* out = m_data.data();
  for (int plane = 0; plane < static_cast<int>(planes()); ++plane)
    for (int y = area.y; y < area.bottom(); ++y) {
      const float* in = whole.row(plane / 3, plane % 3, y) + (area.x - whole.m_area.x);
      out = std::copy_n(in, area.width, out);
    }
}

const float* EditTile::row(int light, int channel, int y) const {
  return m_data.data() + static_cast<size_t>(light * 3 + channel) * m_plane +
         static_cast<size_t>(y - m_area.y) * static_cast<size_t>(m_area.width);
}

const float* EditTile::ambientRow(int channel, int y) const {
  return m_ambient ? row(m_lights + 1, 1 + channel, y) : nullptr;
}

const float* EditTile::highlightRow(int light, int channel, int y) const {
  const int first = m_lights * 3 + (m_ambient ? 7 : 4);
  return m_highlights ? row(0, first + light * 3 + channel, y) : nullptr;
}

float* EditTile::writableRow(int light, int channel, int y) {
  return m_data.data() + (row(light, channel, y) - m_data.data());
}

HighlightRow EditTile::lightRow(int light, int channel, int y, int x) {
  const int skip = x - m_area.x;
  const float* part = highlightRow(light, channel, y);
  return {writableRow(light, channel, y) + skip,
          part ? m_data.data() + (part - m_data.data()) + skip : nullptr};
}

const float* EditTile::whiteRow(int channel, int y) const {
  return row(m_lights, channel, y);
}

const float* EditTile::inverseGreyRow(int y) const {
  return row(m_lights + 1, 0, y);
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

void EditTile::swapLights(const PreparedEdit& edit, const PixelRect& area) {
  forEachSpan(edit, area, [&](const Span& span) {
    for (int c = 0; c < 3; ++c)
      mixTwoLightsRow({{0, 1}, {1, 0}}, span.mask, span.count, lightRow(edit.lights[0], c, span.y, span.x),
                      lightRow(edit.lights[1], c, span.y, span.x));
  });
}

void EditTile::applyOperation(const ShadowOperation& operation, const PreparedEdit& edit,
                              const PixelRect& area) {
  std::vector<float> weight(static_cast<size_t>(area.width));
  forEachSpan(edit, area, [&](const Span& span) {
    for (size_t k = 0; k < edit.lights.size(); ++k) {
      const ShadowChange& change = edit.shadows[k];
      shadowWeightRow(operation, change, span.x, span.y, span.mask, span.count, weight.data());
      for (int c = 0; c < 3; ++c)
        changeShadowRow(operation, c, weight.data(), change.shadows->direct.view().row(c, span.y) + span.x,
                        span.count, writableRow(edit.lights[k], c, span.y) + (span.x - m_area.x));
    }
  });
}

template <LampOperation T>
void EditTile::applyOperation(const T& /*operation*/, const PreparedEdit& edit, const PixelRect& area) {
  forEachSpan(edit, area, [&](const Span& span) {
    const int skip = span.x - m_area.x;
    for (size_t k = 0; k < edit.lights.size(); ++k) {
      const LampEdit& lamp = edit.lamps[k];
      if (!lamp.gain) continue;
      LampRow row;
      for (int c = 0; c < 3; ++c) {
        row.light[c] = writableRow(edit.lights[k], c, span.y) + skip;
        row.white[c] = whiteRow(c, span.y) + skip;
        row.solved[c] = lamp.solved->view().row(c, span.y) + span.x;
      }
      changeLampRow(lamp, span.x, span.y, span.count, span.mask, row);
    }
  });
}

template <HighlightOperation T>
void EditTile::applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area) {
  if (!m_highlights) return;
  forEachSpan(edit, area, [&](const Span& span) {
    for (const int light : edit.lights)
      for (int c = 0; c < 3; ++c)
        changeHighlightRow(operation.highlightTimes(), span.mask, span.count,
                           lightRow(light, c, span.y, span.x));
  });
}

template <BetaOperation T>
void EditTile::applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area) {
  if (requires { T::kSwapsTwoLights; } && edit.lights.size() == 2) return swapLights(edit, area);
  std::vector<std::vector<float>> blurred;
  if (const int radius = edit.reach(); radius > 0)
    for (const int light : edit.lights) blurred.push_back(blurredBeta(light, radius));
  const bool share = edit.edit->energy == EnergyMode::Redistribute;

  std::vector<RgbRow> rows;
  ShareScratch scratch(static_cast<size_t>(m_lights), static_cast<size_t>(area.width));
  forEachSpan(edit, area, [&](const Span& span) {
    const int skip = span.x - m_area.x;
    const auto count = static_cast<size_t>(span.count);

    // Beta as it is and as the operation wants it.
    for (int i = 0; share && i < m_lights; ++i)
      betaRow(i, span.y, span.x, span.count, scratch.beta[static_cast<size_t>(i)].data());
    for (size_t k = 0; k < edit.lights.size(); ++k) {
      const auto i = static_cast<size_t>(edit.lights[k]);
      if (!share) betaRow(edit.lights[k], span.y, span.x, span.count, scratch.beta[i].data());
      BetaRow row{{scratch.beta[i].data(), count}, nullptr, nullptr, edit.table};
      if (!blurred.empty())
        row.blurred = blurred[k].data() + static_cast<size_t>((span.y - m_area.y) * m_area.width + skip);
      if (edit.beta) row.map = edit.beta->maps[k].view().row(0, span.y) + span.x;
      float* target = scratch.target[i].data();
      operation.targetRow(row, target);
      std::transform(target, target + count, target, [](float t) { return std::max(t, 0.f); });
    }

    // Move the light.
    rows.clear();
    for (int i = 0; i < m_lights; ++i)
      rows.push_back({writableRow(i, 0, span.y) + skip, writableRow(i, 1, span.y) + skip,
                      writableRow(i, 2, span.y) + skip});
    if (share) return shareRow(rows, edit.lights, span.mask, span.count, scratch);
    const ConstRgbRow white{whiteRow(0, span.y) + skip, whiteRow(1, span.y) + skip,
                            whiteRow(2, span.y) + skip};
    for (const int i : edit.lights) {
      const auto k = static_cast<size_t>(i);
      addRow(rows[k], white, scratch.beta[k].data(), scratch.target[k].data(), span.mask, span.count);
    }
  });
}

void EditTile::applyOperation(const UnknownGelOperation& /*operation*/, const PreparedEdit& edit,
                              const PixelRect& area) {
  forEachSpan(edit, area, [&](const Span& span) {
    GelRows rows{};
    const auto rowOf = [&](int light, int c) { return writableRow(light, c, span.y) + (span.x - m_area.x); };
    for (int c = 0; c < 3; ++c) {
      for (int j = 0; j < 2; ++j) rows.light[j][c] = lightRow(edit.gel.lights[j], c, span.y, span.x);
      rows.white[c] = rowOf(m_lights, c);
    }
    rows.inverseGrey = rowOf(m_lights + 1, 0);
    changeGelRow(edit.gel, span.mask, span.count, rows);
  });
}

template <SurfaceOperation T>
void EditTile::applyOperation(const T& operation, const PreparedEdit& edit, const PixelRect& area) {
  std::array<std::vector<float>, 3> after;
  for (std::vector<float>& channel : after) channel.resize(static_cast<size_t>(area.width));
  const float* const afterRows[3] = {after[0].data(), after[1].data(), after[2].data()};
  forEachSpan(edit, area, [&](const Span& span) {
    const int skip = span.x - m_area.x;
    const auto rowOf = [&](int light, int c) { return writableRow(light, c, span.y) + skip; };
    float* white[3] = {rowOf(m_lights, 0), rowOf(m_lights, 1), rowOf(m_lights, 2)};
    float* inverse = rowOf(m_lights + 1, 0);
    for (int i = 0; i < span.count; ++i) {
      const Rgb light(white[0][i], white[1][i], white[2][i]);
      const Rgb next = light + span.mask[i] * (operation.recolored(light) - light);
      for (int c = 0; c < 3; ++c) after[static_cast<size_t>(c)][static_cast<size_t>(i)] = next[c];
    }
    for (int j = 0; j < m_lights; ++j)
      changeReflectanceRow(white, afterRows, inverse, span.count, {{rowOf(j, 0), rowOf(j, 1), rowOf(j, 2)}});
    if (m_ambient)
      changeReflectanceRow(white, afterRows, inverse, span.count,
                           {{rowOf(m_lights + 1, 1), rowOf(m_lights + 1, 2), rowOf(m_lights + 1, 3)}});
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

#include "core/edit/apply/edited_set.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/parallel.h"
#include "core/capture/light_name.h"
#include "core/edit/apply/edit_changes.h"
#include "core/edit/apply/edit_tile.h"
#include "core/edit/apply/lamp_limits.h"

namespace swaplight {
namespace {

// A set of the size with room for the lights, without beta; contributions are not initialised.
SolvedSet emptyResult(const SolvedSet& set, const EditedLights& lights) {
  SolvedSet result;
  result.capture = set.capture;
  result.report = set.report;
  result.carried = set.carried;
  if (set.ambient) result.ambient = set.ambient->clone();
  for (size_t i = 0; i < lights.names.size(); ++i) {
    result.contributions.emplace_back(set.contributions.front().spec());
    if (!set.highlights.empty()) result.highlights.emplace_back(set.contributions.front().spec());
    if (i >= result.capture.lights.size())
      result.capture.lights.push_back({lights.names[i], Role::Other, Json::object()});
  }
  return result;
}

// The pictures of lights that come and go: `known` is their old place, -1 of new ones.
std::vector<Image> movedPictures(std::vector<Image>& pictures, const std::vector<int>& known,
                                 const ImageSpec& spec) {
  std::vector<Image> moved;
  for (const int place : known)
    if (place >= 0)
      moved.push_back(std::move(pictures[static_cast<size_t>(place)]));
    else
      moved.emplace_back(spec, 0.F);
  return moved;
}

// Lights come and go; those that stay keep their pixels, where they lie; new ones are dark.
void changeLights(const SolvedSet& set, const EditedLights& lights, SolvedSet& result) {
  std::vector<int> known;
  std::vector<Light> described = set.capture.lights;
  for (size_t i = 0; i < lights.names.size(); ++i) {
    known.push_back(result.capture.lightIndex(lights.names[i]));
    if (i >= described.size()) described.push_back({lights.names[i], Role::Other, Json::object()});
  }
  const ImageSpec& spec = set.contributions.front().spec();
  result.contributions = movedPictures(result.contributions, known, spec);
  if (!set.highlights.empty()) result.highlights = movedPictures(result.highlights, known, spec);
  result.capture.lights = std::move(described);
}

// What is highlight in a light. As it was, to the bit, where the light is: part of it and then times it, it
// would be rounded twice.
void writeHighlights(const SolvedSet& set, size_t light, const EditTile& tile, const PixelRect& part, int c,
                     int y, float* to) {
  const int skip = part.x - tile.area().x;
  const float* now = tile.row(static_cast<int>(light), c, y) + skip;
  const float* share = tile.highlightRow(static_cast<int>(light), c, y) + skip;
  std::transform(now, now + part.width, share, to, std::multiplies<>());
  if (light >= set.highlights.size()) return;
  const float* was = set.contributions[light].view().row(c, y) + part.x;
  const float* highlight = set.highlights[light].view().row(c, y) + part.x;
  for (int x = 0; x < part.width; ++x)
    if (now[x] == was[x] && was[x] > 0 && share[x] == highlight[x] / was[x]) to[x] = highlight[x];
}

// The lights that the tile has.
void writeBack(const SolvedSet& set, const EditTile& tile, const PixelRect& part, SolvedSet& result) {
  const int skip = part.x - tile.area().x;
  for (int c = 0; c < 3; ++c)
    for (int y = part.y; y < part.bottom(); ++y) {
      const auto placeIn = [&](Image& picture) { return picture.span().row(c, y) + part.x; };
      if (const float* ambient = tile.ambientRow(c, y))
        std::copy_n(ambient + skip, part.width, placeIn(*result.ambient));
      for (int i = 0; i < result.lightCount(); ++i) {
        if (!tile.has(i)) continue;
        const auto k = static_cast<size_t>(i);
        std::copy_n(tile.row(i, c, y) + skip, part.width, placeIn(result.contributions[k]));
        if (!result.highlights.empty())
          writeHighlights(set, k, tile, part, c, y, placeIn(result.highlights[k]));
      }
    }
}

std::string warningOf(const Edit& edit, const std::string& warning) {
  return fmt::format("edit \"{}\": {}", edit.name.empty() ? operationName(edit.operation) : edit.name,
                     warning);
}

}  // namespace

EditedLights editedLights(const SolvedSet& set, const EditStack& stack) {
  EditedLights lights{{}, set.width(), set.height(), stack.lampPlaces};
  for (const Light& light : set.capture.lights) lights.names.push_back(light.name);
  for (const std::string& name : stack.newLights) {
    if (set.capture.lightIndex(name) >= 0)
      throw InputError("the edits add a light \"{}\", but the set has one of that name: give it another.",
                       name);
    checkLightNames({&name, 1}, "the edits' new lights");
    lights.names.push_back(name);
  }
  return lights;
}

SolvedSet applyEdits(const SolvedSet& set, const EditStack& stack, const ShadowSource& shadows,
                     const SurfaceSource& surfaces) {
  const EditedLights lights = editedLights(set, stack);
  const PixelRect all{0, 0, set.width(), set.height()};
  MaskContext context(set, shadows, surfaces);
  BetaFiles files;
  const int count = static_cast<int>(lights.names.size());
  EditTile picture(set, count, allLights(count), all);
  SolvedSet result = emptyResult(set, lights);
  std::set<int> placed;
  EarlierEdits earlier;  // how far a lamp is moved and turned is judged together
  for (const auto& edit : stack.edits) {
    const auto kept = std::make_shared<const PreparedEdit>(prepareEdit(edit, lights, context, files));
    const PreparedEdit& prepared = *kept;
    for (size_t k = 0; k < prepared.placed.size() && prepared.isActive(); ++k)
      if (prepared.lights[k] < set.lightCount() && !prepared.placed[k].isNeutral() &&
          !placed.insert(prepared.lights[k]).second)
        result.capture.warnings.push_back(warningOf(
            *edit,
            fmt::format("\"{}\" is placed by an earlier edit, too, and each starts from where its lamp "
                        "stood: change that one instead",
                        lights.names[static_cast<size_t>(prepared.lights[k])])));
    picture.apply(prepared, all);
    for (const std::string& warning : lampWarnings(prepared, lights, earlier))
      result.capture.warnings.push_back(warningOf(*edit, warning));
    if (std::holds_alternative<MoveOperation>(edit->operation) ||
        std::holds_alternative<TurnOperation>(edit->operation))
      earlier.push_back(kept);
    if (prepared.isActive() && usesHighlights(edit->operation) && set.highlights.empty())
      result.capture.warnings.push_back(warningOf(*edit, kNoHighlights));
  }
  writeBack(set, picture, all, result);
  updateBeta(result);
  return result;
}

EditedSet::EditedSet(std::shared_ptr<const SolvedSet> set, ShadowSource shadows, SurfaceSource surfaces)
    : m_set(std::move(set)),
      m_context(*m_set, std::move(shadows), std::move(surfaces)),
      m_result(emptyResult(*m_set, editedLights(*m_set, {}))),
      m_checkpoint(m_set->width(), m_set->height()) {
  const int rows = (m_set->height() + kTileSize - 1) / kTileSize;
  m_stale.resize(static_cast<size_t>(columns()) * static_cast<size_t>(rows));
  markAllStale();
}

void EditedSet::setStack(const EditStack& stack) {
  const EditedLights lights = editedLights(*m_set, stack);
  const bool sameLights = stack.newLights == m_stack.newLights;

  // Prepare what is new; what failed to prepare leaves the old stack in force.
  const bool sameShadows = shadowOptionsOf(stack) == shadowOptionsOf(m_stack);
  const bool sameSurfaces = stack.lampPlaces == m_stack.lampPlaces && !m_surfacesChanged;
  const auto stays = [&](const Edit& edit) {
    return (sameShadows || !usesShadows(edit)) && (sameSurfaces || !usesSurfaces(edit));
  };
  if (!sameShadows) m_context.forgetDrawn();
  std::vector<Prepared> prepared;
  for (const auto& edit : stack.edits) {
    const auto known = std::find_if(m_prepared.begin(), m_prepared.end(),
                                    [&](const Prepared& p) { return p->edit == edit; });
    if (known != m_prepared.end() && sameLights && stays(*edit)) {
      prepared.push_back(*known);
      continue;
    }
    const auto place =
        known != m_prepared.end()
            ? known
            : m_prepared.begin() + static_cast<ptrdiff_t>(std::min(prepared.size(), m_prepared.size()));
    const PreparedEdit* earlier =
        place != m_prepared.end() && stays(*(*place)->edit) ? place->get() : nullptr;
    prepared.push_back(
        std::make_shared<const PreparedEdit>(prepareEdit(edit, lights, m_context, m_files, earlier)));
  }
  const bool otherFindings =
      std::any_of(stack.edits.begin(), stack.edits.end(), [&](const auto& edit) { return !stays(*edit); });
  if (!sameLights) changeLights(*m_set, lights, m_result);
  if (otherFindings) {
    m_checkpoint.forget();
    markAllStale();
  } else if (!sameLights) {
    // Where no edit acts, lights that stay are as they were and new ones are dark.
    m_checkpoint.forget();
    m_staleLights = allLights(m_result.lightCount());
    for (const auto* edits : {&m_prepared, &prepared})
      for (const PixelRect& area : changedAreas(*edits, {})) markStale(area);
  } else {
    if (m_checkpoint.follow(m_prepared, prepared)) m_staleBelow = m_stale;
    m_staleLights.merge(changedLights(m_prepared, prepared, m_result.lightCount()));
    for (const PixelRect& area : changedAreas(m_prepared, prepared)) markStale(area);
  }
  m_staleLights = withTiedLights(std::move(m_staleLights), prepared, m_result.lightCount());
  m_prepared = std::move(prepared);
  m_stack = stack;
  m_surfacesChanged = false;
}

std::shared_ptr<const PreparedEdit> EditedSet::prepared(const Edit* edit) const {
  const auto found = std::find_if(m_prepared.begin(), m_prepared.end(),
                                  [&](const Prepared& one) { return one->edit.get() == edit; });
  return found == m_prepared.end() ? nullptr : *found;
}

void EditedSet::markAllStale() {
  m_staleLights = allLights(m_result.lightCount());
  markStale({0, 0, m_set->width(), m_set->height()});
}

void EditedSet::markStale(const PixelRect& area) {
  const PixelRect inside = intersection(area, {0, 0, m_set->width(), m_set->height()});
  if (inside.empty()) return;
  for (int row = inside.y / kTileSize; row <= (inside.bottom() - 1) / kTileSize; ++row)
    for (int column = inside.x / kTileSize; column <= (inside.right() - 1) / kTileSize; ++column) {
      const int tile = row * columns() + column;
      PixelRect& stale = m_stale[static_cast<size_t>(tile)];
      const PixelRect whole{column * kTileSize, row * kTileSize, kTileSize, kTileSize};
      stale = enclosing(stale, intersection(whole, inside));
    }
}

std::optional<PixelRect> EditedSet::staleTile() const {
  for (const PixelRect& stale : m_stale)
    if (!stale.empty()) return stale;
  return std::nullopt;
}

std::vector<PixelRect> EditedSet::update() {
  return update({0, 0, m_set->width(), m_set->height()});
}

std::vector<PixelRect> EditedSet::update(const PixelRect& area) {
  std::vector<PixelRect> changed;
  for (const PixelRect& stale : m_stale)
    if (!intersection(stale, area).empty()) changed.push_back(stale);

  // Edits that look around would do so again for each band.
  const bool looksAround =
      m_checkpoint.editsBelow() == 0 &&
      std::any_of(m_prepared.begin(), m_prepared.end(), [](const Prepared& p) { return p->reach() > 0; });
  std::vector<PixelRect> bands;
  for (const PixelRect& rect : changed) {
    for (int y = rect.y, next = 0; y < rect.bottom(); y = next) {
      next = looksAround ? rect.bottom() : std::min(rect.bottom(), (y / kBandRows + 1) * kBandRows);
      bands.push_back({rect.x, y, rect.width, next - y});
    }
  }
  parallelEach(static_cast<int>(bands.size()), [&](int i) { compute(bands[static_cast<size_t>(i)]); });
  for (PixelRect& stale : m_stale)
    if (!intersection(stale, area).empty()) stale = {};
  if (!staleTile()) m_staleLights.clear();
  return changed;
}

EditTile EditedSet::evaluate(const PixelRect& area, size_t edits, const LightIndices& lights) const {
  const PixelRect all{0, 0, m_set->width(), m_set->height()};
  // What later edits look at around the area has to be computed too.
  int around = 0;
  for (size_t k = 0; k < edits; ++k) around += m_prepared[k]->reach();
  EditTile tile(*m_set, m_result.lightCount(), lights, intersection(area.grown(around), all));
  for (size_t k = 0; k < edits; ++k) {
    around -= m_prepared[k]->reach();
    tile.apply(*m_prepared[k], intersection(area.grown(around), all));
  }
  return tile;
}

EditTile EditedSet::belowCheckpoint(const PixelRect& band) const {
  const int tile = band.y / kTileSize * columns() + band.x / kTileSize;
  const bool otherWhite =
      std::any_of(m_prepared.begin(), m_prepared.begin() + static_cast<ptrdiff_t>(m_checkpoint.editsBelow()),
                  [](const Prepared& p) { return p->isActive() && actsOnAllLights(p->edit->operation); });
  // Nothing has been computed here since: the result is what is below, if the set at unit white is as solved.
  // It holds highlights, not what part of a light they are: where an edit took the light away that is lost.
  if (!otherWhite && m_set->highlights.empty() && m_checkpoint.startedAtTheEnd() &&
      m_staleBelow[static_cast<size_t>(tile)].empty())
    return {*m_set, m_result, band};
  const LightIndices lights = allLights(m_result.lightCount());
  return {evaluate(band, m_checkpoint.editsBelow(), lights), lights, band};
}

void EditedSet::compute(const PixelRect& area) {
  const size_t below = m_checkpoint.editsBelow();
  if (below == 0) {
    writeBack(*m_set, evaluate(area, m_prepared.size(), m_staleLights), area, m_result);
    return;
  }
  EditTile tile =
      m_checkpoint.stateAt(area, m_staleLights, [&](const PixelRect& band) { return belowCheckpoint(band); });
  for (size_t k = below; k < m_prepared.size(); ++k) tile.apply(*m_prepared[k], area);
  writeBack(*m_set, tile, area, m_result);
}

}  // namespace swaplight

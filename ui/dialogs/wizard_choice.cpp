#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/capture/lightings.h"
#include "core/intake/photograph_choice.h"
#include "ui/dialogs/capture_wizard.h"

// Which photographs the wizard uses, as which lightings, and what a capture.json says of them.

namespace swaplight {
namespace {

/// A colour that was typed for a photograph before it was left out is kept; what is no colour is not.
void tellLeftOut(const std::vector<WizardCell>& cells, Shot& shot) {
  shot.colorNames.assign(cells.size(), "");
  for (size_t i = 0; i < cells.size(); ++i) try {
      const ShotColor color = shotColorFromText(cells[i].text);
      shot.lightColors[i] = color.color;
      shot.colorNames[i] = color.name();
    } catch (const InputError&) {
      shot.lightColors[i].reset();
    }
}

/// The exposures of a capture's brackets, as they are typed, one for each photograph that it uses; "" where
/// it has no brackets.
std::string bracketText(const Capture& capture, const ShotFolder& folder) {
  const std::vector<int> lightings = lightingsOf(capture.shots);
  if (static_cast<size_t>(*std::max_element(lightings.begin(), lightings.end())) + 1 == lightings.size())
    return "";
  const std::vector<ToldPhotograph> told = toldPhotographs(capture, folder);
  const std::vector<float> stops = toldExposures(capture, folder);
  std::string text;
  for (size_t k = 0; k < told.size(); ++k)
    if (told[k].used) text += fmt::format("{}{}", text.empty() ? "" : ",", stops[k]);
  return text;
}

/// The exposures of lightings that have one photograph each; empty where they have several, or all are alike.
Brackets toldAlone(const Capture& capture, const ShotFolder& folder) {
  if (!bracketText(capture, folder).empty()) return {};
  Brackets alone{1, {}, "as told"};
  const std::vector<ToldPhotograph> told = toldPhotographs(capture, folder);
  const std::vector<float> stops = toldExposures(capture, folder);
  for (size_t k = 0; k < told.size(); ++k)
    if (told[k].used) alone.stops.push_back(stops[k]);
  const bool even = std::all_of(alone.stops.begin(), alone.stops.end(), [](float stop) { return stop == 0; });
  return even ? Brackets{} : alone;
}

/// As near to each other as exposures are written.
bool alike(const Brackets& a, const Brackets& b) {
  constexpr float kWritten = 0.01F;  // stops
  return a.length == b.length &&
         std::equal(a.stops.begin(), a.stops.end(), b.stops.begin(), b.stops.end(),
                    [](float left, float right) { return std::abs(left - right) < kWritten; });
}

}  // namespace

std::vector<size_t> CaptureWizard::lightings() const {
  std::vector<size_t> used;
  for (size_t row = 0; row < m_rows.size(); ++row)
    if (m_rows[row].used) used.push_back(row);
  return used;
}

ShotFolder CaptureWizard::usedFolder() const {
  std::vector<std::string> out;
  for (const WizardRow& row : m_rows)
    for (const size_t shot : row.photographs)
      if (!row.used) out.push_back(m_found->folder.shots[shot].file);
  return withShotsLeftOut(m_found->folder, out, "the photographs");
}

void CaptureWizard::setBracketsTo(Brackets brackets) {
  m_brackets = std::move(brackets);
  m_picking.reset();
  m_rows = regrouped(m_rows, static_cast<size_t>(m_brackets.length));
  setLights(m_lights.size());
}

void CaptureWizard::check(bool findThem) {
  m_checking.start(
      [draft = emptyDraft({"light"}), all = m_found->pixels, used = usedPhotographs(m_rows),
       findThem](const Progress&) mutable {
        const std::shared_ptr<const CapturePixels> pixels = pixelsOf(all, used);
        Checked checked{draft.folder.folder, used, {}, {}};
        if (findThem) {
          checked.brackets = findBrackets(draft.folder, *pixels);
          setBrackets(draft, *checked.brackets);
        }
        checked.warnings = draft.folder.notes;
        for (std::string& warning : pictureWarnings(draft, *pixels))
          checked.warnings.push_back(std::move(warning));
        return checked;
      },
      m_wake);
}

std::optional<Brackets> CaptureWizard::typedBrackets() {
  m_exposuresWrong.clear();
  try {
    return m_exposures.empty() ? Brackets{} : toldBrackets(usedFolder(), m_exposures);
  } catch (const InputError& error) {
    m_exposuresWrong = error.what();
    return std::nullopt;
  }
}

void CaptureWizard::readExposures(const std::string& text) {
  m_exposures = text;
  m_exposuresTold = true;
  std::optional<Brackets> brackets = typedBrackets();
  if (!brackets || (brackets->stops == m_brackets.stops && brackets->length == m_brackets.length)) return;
  setBracketsTo(std::move(*brackets));
  check(false);
}

void CaptureWizard::useRow(size_t row, bool used) {
  m_rows[row].used = used;
  m_guess.clear();
  // What was found is as before until it has been looked at again, where the number of photographs allows it.
  std::optional<Brackets> brackets = typedBrackets();
  setBracketsTo(brackets ? std::move(*brackets) : Brackets{});
  if (!m_exposuresTold) m_exposuresWrong.clear();
  check(!m_exposuresTold);
}

CaptureDraft CaptureWizard::emptyDraft(const std::vector<std::string>& lights) const {
  CaptureDraft draft = draftOf(usedFolder(), lights);
  setBrackets(draft, m_brackets);
  return draft;
}

CaptureDraft CaptureWizard::draft() const {
  CaptureDraft draft = emptyDraft(m_lights);
  draft.frame = m_frame;
  size_t lighting = 0, out = 0;
  for (const WizardRow& row : m_rows) {
    if (row.used) {
      std::vector<ShotColor> colors;
      for (const WizardCell& cell : row.cells) colors.push_back(shotColorFromText(cell.text));
      setLighting(draft, lighting++, std::move(colors));
      continue;
    }
    for (size_t k = 0; k < row.photographs.size(); ++k, ++out) tellLeftOut(row.cells, draft.leftOut[out]);
  }
  return draft;
}

std::vector<ShotColor> CaptureWizard::ring() const {
  std::vector<ShotColor> ring;
  for (const WizardCell& cell : m_rows[lightings().front()].cells)
    ring.push_back(shotColorFromText(cell.text));
  return ring;
}

bool CaptureWizard::restoreTyped() {
  if (m_typed.folder != m_folder) return false;
  size_t photographs = 0;
  for (const WizardRow& row : m_typed.rows) photographs += row.photographs.size();
  if (photographs != m_found->folder.shots.size()) return false;
  m_lights = m_typed.lights;
  m_rows = m_typed.rows;
  m_brackets = m_typed.brackets;
  m_exposures = m_typed.exposures;
  m_exposuresTold = m_typed.exposuresTold;
  m_frame = m_typed.frame;
  m_solve = m_typed.solve;
  if (m_exposuresTold || usedPhotographs(m_rows).size() < photographs) check(false);
  return true;
}

void CaptureWizard::restoreTold(const Capture& capture) {
  const ShotFolder& folder = m_found->folder;
  const std::vector<ToldPhotograph> told = toldPhotographs(capture, folder);
  if (std::none_of(told.begin(), told.end(),
                   [](const ToldPhotograph& one) { return one.used && !one.colors.empty(); }))
    return;  // it is about other photographs
  if (capture.lights.size() > kMostLights) {
    m_found->folder.notes.push_back(
        fmt::format("capture.json has {} lights, {} can be entered here: not filled in",
                    capture.lights.size(), kMostLights));
    m_found->warnings.push_back(m_found->folder.notes.back());
    return;
  }
  m_lights.clear();
  for (const Light& light : capture.lights) m_lights.push_back(light.name);
  m_frame = capture.frame;
  m_rows.clear();
  for (size_t k = 0; k < told.size(); ++k) {
    WizardRow row{{k}, told[k].used};
    for (const std::string& color : told[k].colors) row.cells.push_back({color});
    m_rows.push_back(std::move(row));
  }
  const size_t used = usedPhotographs(m_rows).size();
  setBracketsTo({});
  m_exposures.clear();
  m_exposuresTold = false;
  if (std::any_of(told.begin(), told.end(), [](const ToldPhotograph& one) { return one.colors.empty(); }))
    return check(true);  // with one more than it tells of the brackets may be others
  if (const Brackets alone = toldAlone(capture, folder); !alone.stops.empty()) {
    setBracketsTo(alone);
    m_exposures = exposureList(m_brackets);
    m_exposuresTold = true;
    return check(false);
  }
  m_exposures = bracketText(capture, folder);
  std::optional<Brackets> brackets = typedBrackets();
  if (used == told.size() && brackets && alike(*brackets, m_found->brackets)) brackets = m_found->brackets;
  m_exposuresWrong.clear();
  setBracketsTo(brackets ? std::move(*brackets) : Brackets{});
  m_exposures = exposureList(m_brackets);
  m_exposuresTold = m_brackets.length != m_found->brackets.length;
  if (used < told.size() || m_exposuresTold) check(false);
}

}  // namespace swaplight

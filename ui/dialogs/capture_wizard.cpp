#include "ui/dialogs/capture_wizard.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/option_hints.h"
#include "core/capture/light_name.h"
#include "core/intake/photograph_choice.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/manners.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr const char* kWizardTitle = "New capture from photographs";
constexpr int kThumbnailWidth = 480, kThumbnailHeight = 270;  // in pixels, for the largest screens
constexpr const char* kUsualNames[CaptureWizard::kMostLights] = {"key",    "fill",   "back",   "practical",
                                                                 "kicker", "light6", "light7", "light8"};
constexpr float kFooterButton = 110, kFooterGap = 10;
constexpr const char* kFooterWords =
    "Writes capture.json next to the photographs, then separates the lights.";

constexpr const char* kColorHint =
    "A colour: gel number, linear r/g/b, #rrggbb, 3200K, off, unknown, or picked from a white card.";

float hintWidth(const std::string& words) {
  ImGui::PushFont(fonts().small);
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  ImGui::PopFont();
  return width;
}

/// Words that are larger where there is room, and stand in a tooltip, too, where there is too little.
void drawInRestOfLine(const std::string& words) {
  const float room = ImGui::GetContentRegionAvail().x;
  if (ImGui::CalcTextSize(words.c_str()).x <= room) return ImGui::TextUnformatted(words.c_str());
  hint(words);
  if (hintWidth(words) > room) tooltip(words.c_str());
}

void drawColorHint() {
  ImGui::PushTextWrapPos(0);
  hint(kColorHint);
  ImGui::PopTextWrapPos();
  markItem("wizard.color_hint");
}

/// From the window's edge to the buttons below.
float footerWidth() {
  return ImGui::GetContentRegionMax().x - 2 * px(kFooterButton) - ImGui::GetStyle().ItemSpacing.x;
}

/// Of the last line, which takes as many as its words need.
float footerHeight(const std::string& words) {
  ImGui::PushFont(fonts().small);
  const float width = footerWidth() - px(kFooterGap) - ImGui::GetCursorStartPos().x;
  const float height = ImGui::CalcTextSize(words.c_str(), nullptr, false, width).y;
  ImGui::PopFont();
  return std::max(height + ImGui::GetStyle().FramePadding.y, ImGui::GetFrameHeight()) +
         ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace

/// The charts of the folder; of those that cannot be read it is said, whichever photographs are ticked.
void CaptureWizard::readCharts(const ColorConfig& config, const CaptureDraft& draft, const Progress& progress,
                               Photographs& found) {
  const auto say = [&](const InputError& error) { found.folder.notes.emplace_back(error.what()); };
  try {
    found.charts = chartColors(config, found.folder, draft.colorSpace, found.folder.charts, progress, say);
  } catch (const InputError& error) {
    say(error);  // their exposures cannot be compared
  }
  for (const ChartColor& chart : found.charts)
    for (const std::string& warning : chart.warnings)
      found.folder.notes.push_back(chart.file + ": " + warning);
}

void CaptureWizard::start(std::shared_ptr<const ColorConfig> config, const fs::path& folder) {
  close();
  m_folder = folder;
  m_config = std::move(config);
  m_reading.start(
      [config = m_config, folder](const Progress& progress) {
        Photographs found;
        found.folder = scanShotFolder(*config, folder);
        // Any name does for looking at the pictures; the person gives the lights theirs.
        CaptureDraft draft = draftOf(found.folder, {"light"});
        found.pixels = std::make_shared<const CapturePixels>(
            loadCapturePixels(*config, captureOf(draft), progress.part(0, 0.7F)));
        progress.update(0.7F, "checking the photographs");
        found.brackets = findBrackets(found.folder, *found.pixels);
        setBrackets(draft, found.brackets);
        found.thumbnails = shotThumbnails(*found.pixels, kThumbnailWidth, kThumbnailHeight);
        readCharts(*config, draft, progress.part(0.8F, 1), found);
        try {
          if (const fs::path file = found.folder.folder / "capture.json"; fs::exists(file))
            found.told = readCapture(*config, file);
        } catch (const InputError& error) {
          found.folder.notes.emplace_back(error.what());  // what is in it cannot be filled in
        }
        found.warnings = found.folder.notes;
        for (std::string& warning : pictureWarnings(draft, *found.pixels))
          found.warnings.push_back(std::move(warning));
        return found;
      },
      m_wake);
}

void CaptureWizard::close() {
  m_reading.cancel();
  m_guessing.cancel();
  m_checking.cancel();
  m_testing.cancel();
  m_linearity.reset();
  m_tested.clear();  // a test that is still running is about this folder
  if (m_folder && m_found)
    m_typed = {*m_folder, m_lights, m_brackets, m_exposures, m_exposuresTold, m_rows, m_frame, m_solve};
  m_folder.reset();
  m_found.reset();
  m_textures.clear();
  m_lights.clear();
  m_rows.clear();
  m_brackets = {};
  m_exposures.clear();
  m_exposuresTold = false;
  m_exposuresWrong.clear();
  m_guess.clear();
  m_picking.reset();
  m_chartFor.reset();
  m_frame = {};
  m_cropping.reset();
  m_replace = false;
  m_solve = {};
}

void CaptureWizard::update(Messages& messages) {
  const Taken read = takeOrReport(m_reading, messages, "these photographs", [this](Photographs found) {
    if (!m_folder) return;
    m_found = std::move(found);
    for (size_t k = 0; k < m_found->folder.shots.size(); ++k) m_rows.push_back({{k}});
    setBracketsTo(m_found->brackets);
    m_exposures = exposureList(m_brackets);
    setLights(std::clamp<size_t>(m_rows.size(), 2, 4));
    if (!restoreTyped() && m_found->told) restoreTold(*m_found->told);
    for (const SmallPicture& thumbnail : m_found->thumbnails)
      m_textures.emplace_back().update(thumbnail.width, thumbnail.height, thumbnail.rgba.data());
  });
  takeOrReport(m_checking, messages, "these exposures", [this](Checked checked) {
    // Another folder may be open by now, or other photographs be ticked: those are looked at anew.
    if (!m_found || checked.folder != m_found->folder.folder || checked.used != usedPhotographs(m_rows))
      return;
    m_found->warnings = std::move(checked.warnings);
    if (!checked.brackets || m_exposuresTold) return;
    setBracketsTo(std::move(*checked.brackets));
    m_exposures = exposureList(m_brackets);
  });
  takeOrReport(m_testing, messages, "this question", [this](LinearityEvidence evidence) {
    if (m_found) m_linearity = std::move(evidence);
  });
  const Taken guessed = takeOrReport(m_guessing, messages, "this guess", [this](const RotationGuess& guess) {
    if (!m_found || m_guessOf != guessedAbout()) return;  // it is about other photographs
    const CaptureDraft placed = withRotation(draft(), ring(), guess.steps);
    const std::vector<size_t> rows = lightings();
    for (size_t k = 1; k < rows.size(); ++k)
      for (size_t i = 0; i < m_lights.size(); ++i)
        m_rows[rows[k]].cells[i] = {placed.colors[k * static_cast<size_t>(m_brackets.length)][i].text, true};
    m_guess = guess.words;
  });
  if ((read == Taken::Failed || guessed == Taken::Failed) && !m_found) close();
}

void CaptureWizard::setLights(size_t count) {
  while (m_lights.size() < count) m_lights.emplace_back(kUsualNames[m_lights.size()]);
  m_lights.resize(count);
  for (WizardRow& row : m_rows) row.cells.resize(count);
}

void CaptureWizard::oneLampAShot(bool on) {
  const std::vector<size_t> rows = lightings();
  setLights(rows.size());
  for (size_t k = 0; k < rows.size(); ++k)
    for (size_t i = 0; i < m_lights.size(); ++i)
      m_rows[rows[k]].cells[i] = {(k == i) == on ? "white" : "off", false};
  m_guess.clear();
}

/// What has to be put right before it can be solved; empty where nothing has.
std::string CaptureWizard::mistake() const {
  if (!m_exposuresWrong.empty()) return withoutOptionHints(m_exposuresWrong);
  try {
    checkLightNames(m_lights, "the lights");
    for (const size_t row : lightings())
      for (size_t i = 0; i < m_lights.size(); ++i) {
        const std::string& text = m_rows[row].cells[i].text;
        if (text.empty())
          return fmt::format("What colour was {} in {}? (\"unknown\" if you cannot tell.)", m_lights[i],
                             fileOf(row));
        static_cast<void>(shotColorFromText(text));
      }
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string CaptureWizard::guessedAbout() const {
  const std::vector<size_t> rows = lightings();
  std::string all = m_found->folder.folder.string() + fmt::format("\n{}", m_brackets.length);
  for (const size_t photograph : usedPhotographs(m_rows)) all += fmt::format(" {}", photograph);
  for (const WizardCell& cell : m_rows[rows.front()].cells) all += "\n" + cell.text;
  return all;
}

void CaptureWizard::guess() {
  m_guessOf = guessedAbout();
  m_guessing.start(
      [draft = emptyDraft(m_lights), all = m_found->pixels, used = usedPhotographs(m_rows),
       ring = ring()](const Progress&) { return guessRotation(draft, *pixelsOf(all, used), ring); },
      m_wake);
}

void CaptureWizard::drawReading() {
  ImGui::TextUnformatted("Reading the photographs …");
  ImGui::ProgressBar(m_reading.fraction(), ImVec2(-1, px(8)), "");
  if (cancelButton("Cancel", px(110))) close();
  markItem("wizard.cancel");
}

void CaptureWizard::drawLights() {
  const ShotFolder& folder = m_found->folder;
  hint(folder.folder.string());
  const size_t out = folder.shots.size() - usedPhotographs(m_rows).size();
  hint(fmt::format("{} photographs of {} x {} pixels, sorted by {}{}", folder.shots.size(),
                   m_found->pixels->width(), m_found->pixels->height(),
                   folder.timed ? "capture time" : "file name",
                   out > 0 ? fmt::format("; {} left out", out) : ""));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Lights");
  ImGui::SameLine(0, px(10));
  const float side = ImGui::GetFrameHeight();
  ImGui::BeginDisabled(m_lights.size() <= 1);
  const bool fewer = ImGui::Button("\u2212", ImVec2(side, side));
  ImGui::EndDisabled();
  markItem("wizard.fewer");
  tooltip("One light fewer");
  ImGui::SameLine(0, px(4));
  ImGui::BeginDisabled(m_lights.size() >= kMostLights);
  const bool more = ImGui::Button("+", ImVec2(side, side));
  ImGui::EndDisabled();
  markItem("wizard.more");
  tooltip("One light more");
  if (fewer) setLights(m_lights.size() - 1);
  if (more) setLights(m_lights.size() + 1);
  ImGui::SameLine(0, px(16));
  const float align = ImGui::CalcTextSize("Align photographs").x + 2 * side;
  const float even = ImGui::CalcTextSize("Even lamps").x + 2 * side;
  const float boxes = ImGui::GetContentRegionMax().x - align - even;
  const bool beside = ImGui::GetCursorPosX() + hintWidth(kColorHint) + px(10) <= boxes;
  if (beside) {
    drawColorHint();
    ImGui::SameLine();
  }
  ImGui::SetCursorPosX(boxes);
  ImGui::Checkbox("Even lamps", &m_solve.field);
  markItem("wizard.field");
  tooltip(
      "Use this if a lamp or its gel has another colour at one side of the picture than at the other: where "
      "the photographs surely show such a drift, the lamps are made even. Nothing is changed where they do "
      "not; flat_key.jpg, a picture of a grey card under the lamp alone, knows more.");
  ImGui::SameLine(ImGui::GetContentRegionMax().x - align);
  bool aligned = m_solve.align == Remedy::On;
  if (ImGui::Checkbox("Align photographs", &aligned)) m_solve.align = aligned ? Remedy::On : Remedy::Sure;
  markItem("wizard.align");
  tooltip(
      "Use this if the camera moved: photographs are registered to the first one before solving. Without it, "
      "they are where they surely show that it moved.");
  if (!beside) drawColorHint();
}

void CaptureWizard::drawExposures() {
  const size_t count = usedPhotographs(m_rows).size();
  if (m_found->folder.shots.size() < 4 && m_exposures.empty()) return;  // no two lightings of two exposures
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Exposures");
  ImGui::SameLine(0, px(10));
  ImGui::SetNextItemWidth(px(220));
  std::string text = m_exposures;
  if (ImGui::InputTextWithHint("##exposures", "no brackets", &text)) readExposures(text);
  markItem("wizard.exposures");
  markState("wizard.exposures.text", m_exposures);
  tooltip(
      "The stops of a bracket's photographs over its first one, as 0, -3, +2; every lighting repeats them. "
      "Empty: every photograph is a lighting of its own.");
  ImGui::SameLine(0, px(10));
  std::string words =
      m_checking.running() ? "checking the photographs …"
      : m_brackets.length > 1
          ? fmt::format("{} photographs are {} lightings of {} exposures{}", count, lightings().size(),
                        m_brackets.length, m_exposuresTold ? "" : ": found")
      : m_exposures.empty() ? "every photograph is a lighting of its own"
                            : "every photograph is a lighting of its own, at these exposures";
  hint(words);
  markState("wizard.brackets", words);
}

// The two ways of photographing lights that have no gels.
void CaptureWizard::drawPresets() {
  const size_t rows = lightings().size();
  const bool fits = rows > 1 && rows <= kMostLights;
  const std::string count = fits ? fmt::format("{} photographs, {} lights: ", rows, rows)
                                 : fmt::format("For 2 to {} photographs: ", kMostLights);
  const auto preset = [&](const char* words, const char* mark, bool on, const char* tip) {
    ImGui::BeginDisabled(!fits);
    if (ImGui::Button(words)) oneLampAShot(on);
    ImGui::EndDisabled();
    markItem(mark);
    tooltip((count + tip).c_str());
    ImGui::SameLine(0, px(10));
  };
  preset("One lamp per shot", "wizard.one_lamp", true, "in each of them one lamp was on, in their order.");
  preset("All on, one off", "wizard.one_off", false, "in each of them one lamp was off, in their order.");
}

void CaptureWizard::drawGuess() {
  drawPresets();
  const std::vector<size_t> rows = lightings();
  const std::vector<Cell>& cells = m_rows[rows.front()].cells;
  const bool first = std::all_of(cells.begin(), cells.end(), [](const Cell& cell) {
    try {
      return !cell.text.empty() && shotColorFromText(cell.text).color.has_value();
    } catch (const InputError&) {
      return false;
    }
  });
  ImGui::BeginDisabled(!first || m_guessing.running() || rows.size() < 2);
  if (ImGui::Button(m_guessing.running() ? "Guessing …" : "Guess the others")) guess();
  ImGui::EndDisabled();
  markItem("wizard.guess");
  tooltip(
      "Finds how the gels moved from light to light in the other photographs. The first photograph's colours "
      "must be known.");
  ImGui::SameLine(0, px(10));
  ImGui::AlignTextToFramePadding();
  const char* needed = first ? "" : "Enter the first photograph's colours to guess the others.";
  drawInRestOfLine(m_guess.empty() ? needed : m_guess);
  if (!m_guess.empty()) markState("wizard.guess_words", m_guess);
}

std::vector<std::string> CaptureWizard::warnings() const {
  std::vector<std::string> warnings = m_found->warnings;
  if (mistake().empty())
    for (std::string& warning : colorWarnings(draft())) warnings.push_back(std::move(warning));
  for (std::string& warning : warnings) warning = withoutOptionHints(warning);
  return warnings;
}

void CaptureWizard::drawWarnings(const std::vector<std::string>& warnings, float height) {
  ImGui::BeginChild("##warnings", ImVec2(0, height));
  ImGui::PushTextWrapPos(0);
  drawLinearity();
  if (warnings.empty() && !linearity()) ImGui::TextDisabled("No problems found.");
  for (const std::string& warning : warnings) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kChanged), "%s", kIconWarning);
    ImGui::SameLine(0, px(6));
    ImGui::TextUnformatted(warning.c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
  markState("wizard.warnings", fmt::format("{}", warnings.size()));
  markState("wizard.warnings.text", fmt::format("{}", fmt::join(warnings, " | ")));
}

void CaptureWizard::drawFooter(const std::string& wrong, Messages& messages, const Answers& answers) {
  const bool exists = fs::exists(m_found->folder.folder / "capture.json");
  const float button = px(kFooterButton);
  const float buttons = footerWidth();
  if (exists && wrong.empty()) {
    ImGui::Checkbox("Replace the existing capture.json to solve", &m_replace);
    markItem("wizard.replace");
    tooltip(
        "This folder has a capture.json already. It will be written anew, with what is seen here; what it "
        "says beyond that (noise, notes of other programs) is kept.");
  } else {
    ImGui::AlignTextToFramePadding();
    ImGui::PushTextWrapPos(buttons - px(kFooterGap));
    hint(wrong.empty() ? kFooterWords : wrong);
    ImGui::PopTextWrapPos();
    markItem("wizard.footer");
  }
  ImGui::SameLine(buttons);
  const bool go = defaultButton("Solve", button, wrong.empty() && !busy() && (!exists || m_replace));
  markItem("wizard.solve");
  ImGui::SameLine();
  const bool cancelled = cancelButton("Cancel", button);
  markItem("wizard.cancel");
  if (cancelled) close();
  if (!go) return;
  try {
    const fs::path written = writeDraft(draft(), m_replace);
    SolveOptions options = m_solve;
    // The tick stands below the answer, and counts as long as that is seen.
    if (!linearity() || linearity()->answer != LinearityEvidence::Answer::Curved)
      options.correctTone = Remedy::Sure;
    close();
    answers.solve(written, options);
  } catch (const std::exception& error) {
    messages.error(error.what());
  }
}

void CaptureWizard::draw(Messages& messages, const Answers& answers) {
  if (!m_folder) return;
  if (!ImGui::IsPopupOpen(kWizardTitle)) ImGui::OpenPopup(kWizardTitle);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(
      m_found ? ImVec2(std::min(px(1180), screen.x - px(40)), std::min(px(820), screen.y - px(40)))
              : ImVec2(px(460), 0));
  if (!ImGui::BeginPopupModal(
          kWizardTitle, nullptr,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return;
  beginTabStops();
  if (!m_found) {
    drawReading();
  } else {
    drawLights();
    drawExposures();
    const float line = ImGui::GetFrameHeightWithSpacing();
    const std::vector<std::string> warned = warnings();
    // The answer to whether they hold light takes two lines and a tick.
    const float answer = linearity() ? ImGui::GetFrameHeightWithSpacing() : 0;
    const float lines = answer + std::max(1.F, static_cast<float>(warned.size() + (linearity() ? 2 : 0))) *
                                     ImGui::GetTextLineHeightWithSpacing();
    const float room = std::min({px(96), 0.18F * ImGui::GetWindowHeight(), lines + px(6)});
    const std::string wrong = mistake();
    drawTable(ImGui::GetContentRegionAvail().y - 2 * line - footerHeight(wrong) - room - px(24));
    drawGuess();
    drawFrame();
    drawLightTest(wrong);
    ImGui::Separator();
    drawWarnings(warned, room);
    ImGui::Separator();
    drawFooter(wrong, messages, answers);
  }
  const auto chartFor = std::exchange(m_chartFor, std::nullopt);
  if (!m_folder) ImGui::CloseCurrentPopup();
  endTabStops();
  ImGui::EndPopup();
  if (m_folder && chartFor) answers.readChart(chartQuestion(chartFor->first, chartFor->second));
}

}  // namespace swaplight

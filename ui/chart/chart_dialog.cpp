#include "ui/chart/chart_dialog.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/chart/camera_file.h"
#include "core/color/srgb.h"
#include "core/file/json_file.h"
#include "core/intake/shot_thumbnail.h"
#include "ui/jobs/take_or_report.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/manners.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr const char* kTitle = "Colour chart";
constexpr float kColumn = 330;  ///< of words, beside the picture
constexpr float kGap = 16, kButton = 130;
constexpr int kShownWidth = 1120, kShownHeight = 760;

/// Where the corners begin when no chart was found: in the middle, as wide as charts are.
ChartCorners cornersInTheMiddle(int width, int height) {
  const double side = .5 * std::min(width / kChartWidth, height / kChartHeight);
  const double across = side * kChartWidth / 2, down = side * kChartHeight / 2;
  const double x = width / 2., y = height / 2.;
  return {{{x - across, y - down}, {x + across, y - down}, {x + across, y + down}, {x - across, y + down}}};
}

void heading(const char* words) {
  ImGui::Dummy(ImVec2(0, px(6)));
  ImGui::PushFont(fonts().strong);
  ImGui::TextUnformatted(words);
  ImGui::PopFont();
}

void warning(const std::string& words) {
  ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kChanged), "%s", kIconWarning);
  ImGui::SameLine(0, px(6));
  ImGui::TextWrapped("%s", words.c_str());
}

}  // namespace

void ChartDialog::start(std::shared_ptr<const ColorConfig> config, const std::filesystem::path& file,
                        const ColorSpaceOf& colorSpaceOf, Use use) {
  close();
  m_config = std::move(config);
  m_file = file;
  m_colorSpaceOf = colorSpaceOf;
  m_use = std::move(use);
  m_reading.start(
      [=, config = m_config](const Progress& progress) {
        Read read;
        const auto photograph = std::make_shared<ChartPhotograph>(readChartPhotograph(
            *config, file, colorSpaceOf ? colorSpaceOf(file) : "", progress.part(0, .4F)));
        read.photograph = photograph;
        read.small = shotThumbnails(photograph->pixels, kShownWidth, kShownHeight).front();
        try {
          read.shot = foundChart(*photograph, progress.part(.4F, 1));
        } catch (const InputError& error) {
          read.wrong = error.what();
        }
        return read;
      },
      m_wake);
}

void ChartDialog::close() {
  m_reading.cancel();
  m_fitting.cancel();
  m_gel.forget();
  m_config.reset();
  m_photograph.reset();
  m_shown = false;
  m_shot.reset();
  m_wrong.clear();
  m_use = {};
}

void ChartDialog::take(std::optional<ChartShot> shot, std::string wrong) {
  m_shot = std::move(shot);
  m_wrong = std::move(wrong);
  if (m_shot && !m_picture.isDragged()) m_corners = m_shot->corners;  // they may be another way round
}

void ChartDialog::update(Messages& messages) {
  const Taken read = takeOrReport(m_reading, messages, "this photograph", [this](Read found) {
    if (!isOpen()) return;
    m_photograph = std::move(found.photograph);
    const Image& picture = m_photograph->picture();
    m_picture.show(found.small, picture.width(), picture.height());
    m_corners = cornersInTheMiddle(picture.width(), picture.height());
    if (!found.shot && found.wrong.empty())
      found.wrong = "No chart was found. Drag the four corners onto the chart's corner patches.";
    take(std::move(found.shot), std::move(found.wrong));
  });
  if (read == Taken::Failed) close();
  takeOrReport(m_fitting, messages, "this chart", [this](Fitted fitted) {
    if (isOpen() && fitted.photograph == m_photograph) take(std::move(fitted.shot), std::move(fitted.wrong));
  });
  m_gel.update(messages);
}

void ChartDialog::fit() {
  m_fitting.start(
      [photograph = m_photograph, corners = m_corners](const Progress&) {
        Fitted fitted{photograph, {}, {}};
        try {
          fitted.shot = chartAt(*photograph, corners);
        } catch (const InputError& error) {
          fitted.wrong = error.what();
        }
        return fitted;
      },
      m_wake);
}

void ChartDialog::drawReading() {
  ImGui::TextUnformatted("Looking for the chart …");
  ImGui::ProgressBar(m_reading.fraction(), ImVec2(-1, px(8)), "");
  if (cancelButton("Cancel", px(110))) close();
  markItem("chart.cancel");
}

void ChartDialog::drawLight(const ChartFit& fit) {
  heading("Light");
  const float most = std::max({fit.light.r, fit.light.g, fit.light.b, 1e-6F});
  beginNoTabStops();
  colorChip("##light", srgbFromLinear(glm::max(fit.light, Rgb(0)) / most),
            ImVec2(ImGui::GetFrameHeight(), ImGui::GetFrameHeight()),
            "The light on the chart, as bright as it can be shown");
  endNoTabStops();
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const std::string words = fmt::format("{:.3f} / {:.3f} / {:.3f}", fit.light.r, fit.light.g, fit.light.b);
  ImGui::TextUnformatted(words.c_str());
  markItem("chart.light");
  tooltip("Linear red, green and blue that a surface would have which reflects everything");
  markState("chart.light.text", words);
  hint(fmt::format("± {:.3f} / {:.3f} / {:.3f}", fit.lightError.r, fit.lightError.g, fit.lightError.b));
}

void ChartDialog::drawCamera(Messages& messages, FileChooser& chooser) {
  const ChartFit& fit = m_shot->fit;
  heading("Camera");
  ImGui::TextWrapped("Without its matrix colours are off by %.1f.", fit.meanBalanced);
  if (fit.matrix)
    ImGui::TextWrapped("With it they are off by %.1f, at most %.1f.", fit.meanDeltaE, fit.mostDeltaE);
  else
    ImGui::TextWrapped("This light lacks a colour: it tells no matrix.");
  hint("CIEDE2000: 1 is hardly seen. Point at a patch.");
  ImGui::BeginDisabled(!fit.matrix);
  const bool save = ImGui::Button("Save the matrix …", ImVec2(-1, 0));
  ImGui::EndDisabled();
  markItem("chart.save");
  tooltip("Saves the camera's matrix as a file, for swaplight balance --camera.");
  if (!save) return;
  FileChooser::Question question;
  question.title = "Save the camera's matrix";
  question.button = "Save";
  question.extensions = {".json"};
  question.saving = true;
  question.name = "camera.json";
  question.folder = m_file.parent_path();
  question.answer = [camera = jsonFromCamera(*m_shot), &messages](const std::filesystem::path& file) {
    try {
      writeJson(camera, file);
      messages.info("Saved " + file.string() + ".");
    } catch (const std::exception& error) {
      messages.error(error.what());
    }
  };
  chooser.ask(std::move(question));
}

void ChartDialog::drawWords() {
  if (m_fitting.running()) ImGui::TextUnformatted("Reading the patches …");
  if (!m_wrong.empty()) warning(m_wrong);
  markState("chart.wrong", m_wrong);
  markState("chart.read", m_shot && !m_fitting.running() ? "yes" : "no");
  if (!m_shot) return;
  for (const std::string& words : m_shot->fit.warnings) warning(words);
}

void ChartDialog::drawFooter() {
  const float buttons = (m_use ? 2 : 1) * px(kButton) + (m_use ? ImGui::GetStyle().ItemSpacing.x : 0);
  ImGui::SetCursorPos(
      {ImGui::GetContentRegionMax().x - buttons, ImGui::GetContentRegionMax().y - ImGui::GetFrameHeight()});
  bool used = false;
  if (m_use) {
    used = defaultButton("Use this light", px(kButton), m_shot && !busy(),
                         "The light's colour in the photograph that you came from (Enter)");
    markItem("chart.use");
    ImGui::SameLine();
  }
  const bool closed = cancelButton(m_use ? "Cancel" : "Close", px(kButton));
  markItem("chart.close");
  if (used) m_use(*m_shot);
  if (used || closed) close();
}

void ChartDialog::draw(Messages& messages, FileChooser& chooser) {
  if (!isOpen()) return;
  if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(m_photograph
                               ? ImVec2(std::min(px(kShownWidth + kColumn + 3 * kGap), screen.x - px(40)),
                                        std::min(px(kShownHeight + 60), screen.y - px(40)))
                               : ImVec2(px(460), 0));
  if (!ImGui::BeginPopupModal(
          kTitle, nullptr,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return;
  beginTabStops();
  if (!m_photograph) {
    drawReading();
  } else {
    if (!std::exchange(m_shown, true)) restartTabRound();
    const ImVec2 room = ImGui::GetContentRegionAvail(), low = ImGui::GetCursorScreenPos();
    const ImVec2 start = ImGui::GetCursorPos();
    ImGui::SetCursorPos({start.x + room.x - px(kColumn), start.y});
    ImGui::BeginChild("##words", {px(kColumn), room.y - ImGui::GetFrameHeightWithSpacing()});
    joinTabRound();
    ImGui::PushFont(fonts().strong);
    ImGui::TextWrapped("%s", m_file.filename().c_str());
    ImGui::PopFont();
    drawWords();
    if (m_shot) {
      drawLight(m_shot->fit);
      drawCamera(messages, chooser);
      heading("Gel");
      m_gel.draw(m_config, m_colorSpaceOf, *m_shot, messages, chooser);
    }
    ImGui::EndChild();
    drawFooter();
    beginNoTabStops();
    const bool moved = m_picture.draw(low, {room.x - px(kColumn + kGap), room.y}, m_corners,
                                      m_shot && !m_fitting.running() ? &m_shot->fit : nullptr);
    endNoTabStops();
    if (moved && isOpen()) fit();
  }
  if (!isOpen()) ImGui::CloseCurrentPopup();
  endTabStops();
  ImGui::EndPopup();
}

}  // namespace swaplight

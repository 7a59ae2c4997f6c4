#include "ui/chart/gel_measure.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/chart/chart_photograph.h"
#include "core/chart/measured_gel.h"
#include "core/color/chromaticity.h"
#include "core/color/srgb.h"
#include "core/lamp/gel.h"
#include "ui/jobs/take_or_report.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/manners.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

void field(const char* id, const char* expected, std::string& text, float width, const char* mark,
           const char* tip) {
  ImGui::SetNextItemWidth(width);
  ImGui::InputTextWithHint(id, expected, &text);
  markItem(mark);
  tooltip(tip);
}

void wrapped(const std::string& words, ImU32 color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextWrapped("%s", words.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

void GelMeasure::forget() {
  m_reading.cancel();
  ++m_question;
  m_without = {};
}

void GelMeasure::ask(const std::shared_ptr<const ColorConfig>& config, const ColorSpaceOf& colorSpaceOf,
                     const ChartShot& through, FileChooser& chooser) {
  FileChooser::Question question;
  question.title = "The chart under the same lamp, without the gel";
  question.button = "Read";
  question.extensions = photographExtensions();
  question.folder = through.file.parent_path();
  question.answer = [this, config, colorSpaceOf, through,
                     question = ++m_question](const std::filesystem::path& file) {
    m_without = {file, {}, {}, question};
    m_reading.start(
        [=](const Progress& progress) {
          Without without{file, {}, {}, question};
          try {
            const ChartPhotograph photograph = readChartPhotograph(
                *config, file, colorSpaceOf ? colorSpaceOf(file) : "", progress.part(0, .4F));
            std::optional<ChartShot> shot = foundChart(photograph, progress.part(.4F, 1));
            if (!shot) shot = chartAsIn(photograph, through);
            if (shot)
              without.shot = *shot;
            else
              without.wrong = "No chart found in " + file.filename().string() + ".";
          } catch (const InputError& error) {
            without.wrong = error.what();
          }
          return without;
        },
        m_wake);
  };
  chooser.ask(std::move(question));
}

void GelMeasure::update(Messages& messages) {
  const Taken taken = takeOrReport(m_reading, messages, "this photograph", [this](Without without) {
    if (without.question == m_question) m_without = std::move(without);
  });
  if (taken == Taken::Stopped || taken == Taken::Failed) m_without = {};
}

void GelMeasure::drawName(const Rgb& filter, Messages& messages) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x;
  field("##brand", "Brand", m_brand, .6F * room, "chart.gel.brand", "Who makes it: Rosco, Lee …");
  ImGui::SameLine();
  field("##number", "Number", m_number, .4F * room, "chart.gel.number", "Its number: 4660");
  field("##name", "Name", m_name, -1, "chart.gel.name", "Its name, which may be left out");
  ImGui::BeginDisabled(m_brand.empty() || m_number.empty());
  const bool add = ImGui::Button("Add to my gels", ImVec2(-1, 0));
  ImGui::EndDisabled();
  markItem("chart.gel.add");
  tooltip("Adds it to measured.csv among your tables of gels: from now on it is in every list of gels.");
  if (!add) return;
  try {
    const Gel& gel = addMeasuredGel({m_brand, m_number, m_name}, filter);
    messages.info(fmt::format("{} {} is among the gels.", gel.id, gel.name));
    m_number.clear();
    m_name.clear();
  } catch (const std::exception& error) {
    messages.error(error.what());
  }
}

void GelMeasure::draw(const std::shared_ptr<const ColorConfig>& config, const ColorSpaceOf& colorSpaceOf,
                      const ChartShot& through, Messages& messages, FileChooser& chooser) {
  ImGui::BeginDisabled(busy());
  const bool asked = ImGui::Button(busy() ? "Reading …" : "Photograph without the gel …", ImVec2(-1, 0));
  ImGui::EndDisabled();
  markItem("chart.gel.without");
  tooltip(
      "To measure the gel through which this chart is lit: choose a photograph of the chart under the same "
      "lamp, as exposed as this one, without the gel.");
  if (asked) ask(config, colorSpaceOf, through, chooser);
  if (m_without.file.empty() || busy()) return;
  if (!m_without.wrong.empty()) return wrapped(m_without.wrong, kChanged);
  try {
    const Rgb filter = measuredGel(through, m_without.shot);
    const Rgb chip = srgbFromLinear(filter / std::max({filter.r, filter.g, filter.b, 1e-6F}));
    beginNoTabStops();
    colorChip("##gel", chip, ImVec2(ImGui::GetFrameHeight(), ImGui::GetFrameHeight()),
              "The gel's colour in daylight");
    endNoTabStops();
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const std::string words = fmt::format("Lets {:.0f} % of white through", 100 * luminance(filter));
    ImGui::TextUnformatted(words.c_str());
    markState("chart.gel.words", words);
    hint(fmt::format("{:.3f} / {:.3f} / {:.3f}, over {}", filter.r, filter.g, filter.b,
                     m_without.file.filename().string()));
    drawName(filter, messages);
  } catch (const InputError& error) {
    wrapped(error.what(), kChanged);
  }
}

}  // namespace swaplight

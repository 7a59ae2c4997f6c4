#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/pixel_rect.h"
#include "ui/dialogs/capture_wizard.h"
#include "ui/kit/gel_list.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/manners.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kThumbnailColumn = 176;
constexpr float kRowHeight = 92;

/// What a cell's text says: a colour, unknown, or nonsense.
struct Reading {
  std::optional<Rgb> color;
  std::string mistake;
};
Reading readingOf(const std::string& text) {
  try {
    return {text.empty() ? std::nullopt : shotColorFromText(text).color, ""};
  } catch (const InputError& error) {
    return {{}, error.what()};
  }
}

/// The colour as it is seen; black for off.
Rgb chipOf(const Rgb& color) {
  const float brightest = std::max({color.r, color.g, color.b});
  return brightest > 0 ? srgbFromLinear(color / brightest) : Rgb(0);
}

/// What is cropped away, darker.
void drawCrop(const CaptureFrame& frame, const CapturePixels& pixels, ImVec2 at, ImVec2 size) {
  if (!frame.crop) return;
  const auto x = [&](int place) {
    return at.x + size.x * static_cast<float>(place) / static_cast<float>(pixels.width());
  };
  const auto y = [&](int place) {
    return at.y + size.y * static_cast<float>(place) / static_cast<float>(pixels.height());
  };
  const ImVec2 low(x(frame.crop->x), y(frame.crop->y)), high(x(frame.crop->right()), y(frame.crop->bottom()));
  const ImVec2 end(at.x + size.x, at.y + size.y);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  constexpr ImU32 kAway = IM_COL32(0, 0, 0, 170);
  draw->AddRectFilled(at, ImVec2(end.x, low.y), kAway);
  draw->AddRectFilled(ImVec2(at.x, high.y), end, kAway);
  draw->AddRectFilled(ImVec2(at.x, low.y), ImVec2(low.x, high.y), kAway);
  draw->AddRectFilled(ImVec2(high.x, low.y), ImVec2(end.x, high.y), kAway);
  draw->AddRect(low, high, kText);
}

}  // namespace

void CaptureWizard::cropOnThumbnail(ImVec2 at, ImVec2 size) {
  constexpr float kLeast = 0.03F;  // of the picture: less is a click
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const std::pair place(std::clamp((mouse.x - at.x) / size.x, 0.0F, 1.0F),
                        std::clamp((mouse.y - at.y) / size.y, 0.0F, 1.0F));
  if (ImGui::IsItemActivated()) m_cropping = place;
  if (!ImGui::IsItemActive() || !m_cropping) return;
  const float x = std::min(place.first, m_cropping->first), y = std::min(place.second, m_cropping->second);
  const float width = std::abs(place.first - m_cropping->first);
  const float height = std::abs(place.second - m_cropping->second);
  if (width < kLeast || height < kLeast) return;
  const auto pixels = [](float part, int count) {
    return static_cast<int>(std::lround(part * static_cast<float>(count)));
  };
  const int across = m_found->pixels->width(), down = m_found->pixels->height();
  m_frame.crop =
      intersection({pixels(x, across), pixels(y, down), pixels(width, across), pixels(height, down)},
                   {0, 0, across, down});
}

void CaptureWizard::drawFrame() {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Use");
  ImGui::SameLine(0, px(10));
  constexpr double kScales[] = {1, 0.5, 0.25, 0.125};
  const auto* shown = std::find(std::begin(kScales), std::end(kScales), m_frame.scale);
  int scale = static_cast<int>(shown - std::begin(kScales));
  ImGui::SetNextItemWidth(px(120));
  if (ImGui::Combo("##scale", &scale, "full size\0half size\0a quarter\0an eighth\0"))
    m_frame.scale = kScales[scale];
  markItem("wizard.scale");
  tooltip("Smaller pictures solve faster. The photographs are not changed.");
  ImGui::SameLine(0, px(10));
  const int across = m_found->pixels->width(), down = m_found->pixels->height();
  if (!m_frame.crop) {
    ImGui::TextDisabled("of each photograph. To crop, drag over one.");
    return;
  }
  int numbers[4] = {m_frame.crop->x, m_frame.crop->y, m_frame.crop->width, m_frame.crop->height};
  ImGui::SetNextItemWidth(px(320));
  if (ImGui::InputInt4("##crop", numbers)) {
    const PixelRect crop =
        intersection({numbers[0], numbers[1], numbers[2], numbers[3]}, {0, 0, across, down});
    if (!crop.empty()) m_frame.crop = crop;
  }
  markItem("wizard.crop");
  tooltip("Crop in pixels of the photographs: left, top, width, height.");
  ImGui::SameLine(0, px(10));
  if (ImGui::Button("All of them")) m_frame.crop.reset();
  markItem("wizard.uncrop");
  tooltip("Use the whole photographs again");
}

void CaptureWizard::takeCard(size_t row, int x, int y) {
  try {
    CaptureDraft card = emptyDraft({"light"});
    std::vector<size_t> shots = m_rows[row].photographs;
    const std::vector<size_t> used = usedPhotographs(m_rows);
    CaptureDraft all = card;
    all.brackets = m_brackets;
    all.folder.shots.clear();
    for (const size_t shot : used) all.folder.shots.push_back(m_found->folder.shots[shot]);
    const std::vector<float> exposures = exposuresOf(all);
    // The lighting by itself: only its pictures are looked at.
    Brackets own{static_cast<int>(shots.size()), {}, {}};
    std::vector<FoundShot> files;
    for (const size_t shot : shots) {
      const auto place = std::find(used.begin(), used.end(), shot) - used.begin();
      own.stops.push_back(exposures[static_cast<size_t>(place)]);
      files.push_back(m_found->folder.shots[shot]);
    }
    card.folder.shots = std::move(files);
    card.colors.resize(shots.size());
    card.brackets = std::move(own);
    m_rows[row].cells[m_picking->second] = {
        colorOfCard(card, *pixelsOf(m_found->pixels, shots), 0, x, y).text, false};
    m_picking.reset();
  } catch (const InputError&) {
    // black: the next click may hit the card
  }
}

void CaptureWizard::drawThumbnail(size_t row) {
  const size_t shot = m_rows[row].first();
  const SmallPicture& picture = m_found->thumbnails[shot];
  const float scale = std::min(px(kThumbnailColumn - 10) / static_cast<float>(picture.width),
                               px(kRowHeight) / static_cast<float>(picture.height));
  const ImVec2 size(std::floor(scale * static_cast<float>(picture.width)),
                    std::floor(scale * static_cast<float>(picture.height)));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end(at.x + size.x, at.y + size.y);
  beginNoTabStops();
  const bool clicked = ImGui::InvisibleButton("##picture", size);
  endNoTabStops();
  markItem({"wizard.picture.", row});
  const bool picking = m_picking && m_picking->first == row;
  if (!picking && m_rows[row].used) cropOnThumbnail(at, size);
  drawTexture(m_textures[shot].id(), at, end);
  if (picking) ImGui::GetWindowDrawList()->AddRect(at, end, kAccent, 0, 0, px(2));
  drawCrop(m_frame, *m_found->pixels, at, size);
  if (!m_rows[row].used) ImGui::GetWindowDrawList()->AddRectFilled(at, end, IM_COL32(0, 0, 0, 190));
  if (!picking || !clicked) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto pixel = [](float place, float length, int count) {
    return std::clamp(static_cast<int>(place / length * static_cast<float>(count)), 0, count - 1);
  };
  takeCard(row, pixel(mouse.x - at.x, size.x, m_found->pixels->width()),
           pixel(mouse.y - at.y, size.y, m_found->pixels->height()));
}

CaptureWizard::ChartQuestion CaptureWizard::chartQuestion(size_t row, size_t light) {
  const ShotFolder& folder = m_found->folder;
  const std::string colorSpace = emptyDraft(m_lights).colorSpace;
  return {folder.folder,
          [config = m_config, folder, colorSpace](const std::filesystem::path& file) {
            return colorSpaceOfChart(*config, folder, colorSpace, file);
          },
          // Meanwhile brackets may have been found, which are other rows, or another folder be open.
          [this, folder, colorSpace, photograph = m_rows[row].first(), light](const ChartShot& chart) {
            if (!m_found || m_found->folder.folder != folder.folder) return;
            for (WizardRow& one : m_rows)
              if (std::ranges::count(one.photographs, photograph) > 0 && light < one.cells.size())
                one.cells[light] = {lightOfChart(*m_config, folder, colorSpace, chart).text, false};
          }};
}

void CaptureWizard::drawChoices(size_t row, size_t light) {
  if (!ImGui::BeginPopup("##gels")) return;
  Cell& cell = m_rows[row].cells[light];
  for (const char* word : {"white", "off", "unknown", "?a"}) {
    if (ImGui::Selectable(fmt::format("      {}", word).c_str(), cell.text == word)) cell = {word, false};
    markItem({"wizard.choose.", word});
    if (word[0] == '?') tooltip("Unknown, but the same gel wherever you write this name");
  }
  for (const ChartColor& chart : m_found->charts) {
    const std::string& text = chart.color.text;
    if (ImGui::Selectable(fmt::format("      {}  {}", chart.file, text).c_str(), cell.text == text))
      cell = {text, false};
    markItem({"wizard.choose.", chart.file});
    tooltip("The light in this photograph of a colour chart");
  }
  if (ImGui::Selectable("      a colour chart \u2026")) m_chartFor = std::pair(row, light);
  markItem("wizard.choose.chart");
  tooltip(
      "Choose a photograph of a colour chart that this light alone shines on; where the chart is not found, "
      "show its corners.");
  ImGui::Separator();
  ImGui::BeginChild("##list", ImVec2(px(346), px(260)));
  if (const auto chosen = gelChoices(cell.text, m_filter)) {
    cell = {*chosen, false};
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndChild();
  ImGui::EndPopup();
}

void CaptureWizard::drawCell(size_t row, size_t light) {
  Cell& cell = m_rows[row].cells[light];
  const Reading reading = readingOf(cell.text);
  const std::string mark = fmt::format("wizard.cell.{}.{}", row, light);
  const float side = ImGui::GetFrameHeight();
  ImGui::PushID(static_cast<int>(light));
  ImGui::Dummy(ImVec2(0, (px(kRowHeight) - 2 * side) / 2));
  beginNoTabStops();
  if (reading.color)
    colorChip("##chip", chipOf(*reading.color), ImVec2(side, side), cell.text.c_str());
  else
    ImGui::Dummy(ImVec2(side, side));
  endNoTabStops();
  ImGui::SameLine(0, px(4));
  ImGui::SetNextItemWidth(std::max(px(60), ImGui::GetContentRegionAvail().x - 2 * side - px(12)));
  const bool wrong = !reading.mistake.empty(), guessed = cell.guessed;
  if (wrong) ImGui::PushStyleColor(ImGuiCol_Text, kMute);
  if (!wrong && guessed) ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
  const char* expected = !m_rows[row].used            ? "left out"
                         : row == lightings().front() ? "gel or colour"
                                                      : "to be guessed";
  if (ImGui::InputTextWithHint("##colour", expected, &cell.text)) cell.guessed = false;
  if (wrong || guessed) ImGui::PopStyleColor();
  markItem(mark);
  markState(mark + ".text", cell.text);
  tooltip(wrong          ? reading.mistake.c_str()
          : cell.guessed ? "Guessed from the photographs"
                         : "This light's colour in this photograph");
  ImGui::SameLine(0, px(4));
  beginNoTabStops();  // from field to field: all that the two buttons give can be typed
  const bool picking = m_picking == std::pair(row, light);
  if (toggleButton(kIconPicker, picking, kAccent, side,
                   "Then click a white card in this photograph that only this light reaches"))
    m_picking = picking ? std::nullopt : std::optional(std::pair(row, light));
  markItem({mark, ".pick"});
  ImGui::SameLine(0, px(4));
  if (toggleButton(kIconDown, false, kAccent, side, "Gels, white, off, unknown, colour charts"))
    ImGui::OpenPopup("##gels");
  markItem({mark, ".list"});
  endNoTabStops();
  drawChoices(row, light);
  ImGui::PopID();
}

// The line below the picture: its name, and the tick that keeps it.
void CaptureWizard::drawUse(size_t row) {
  const WizardRow& shown = m_rows[row];
  const std::vector<size_t> used = lightings();
  const auto place = std::find(used.begin(), used.end(), row);
  const size_t more = shown.photographs.size() - 1;
  const std::string words = (shown.used ? fmt::format("{}  ", place - used.begin() + 1) : "") + fileOf(row) +
                            (more > 0 ? fmt::format(" and {} more", more) : "");
  bool keep = shown.used;
  ImGui::PushFont(fonts().small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  ImGui::BeginDisabled(shown.used && used.size() < 2);
  beginNoTabStops();
  const bool changed = ImGui::Checkbox((words + "###use").c_str(), &keep);
  endNoTabStops();
  ImGui::EndDisabled();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::PopFont();
  markItem({"wizard.use.", row});
  markState(fmt::format("wizard.use.{}.on", row), shown.used ? "yes" : "no");
  tooltip(shown.used
              ? "Untick to leave this photograph out. The file stays, and so do the colours that you entered."
              : "Left out of the capture. Tick to use it again.");
  if (changed) m_toUse = std::pair(row, keep);
}

void CaptureWizard::drawRow(size_t row) {
  ImGui::PushID(static_cast<int>(m_rows[row].first()));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  drawThumbnail(row);
  drawUse(row);
  ImGui::BeginDisabled(!m_rows[row].used);
  for (size_t i = 0; i < m_lights.size(); ++i) {
    ImGui::TableNextColumn();
    drawCell(row, i);
  }
  ImGui::EndDisabled();
  ImGui::PopID();
}

void CaptureWizard::drawTable(float height) {
  constexpr ImGuiTableFlags flags =
      ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH;
  const auto columns = static_cast<int>(m_lights.size());
  if (!ImGui::BeginTable("##shots", columns + 1, flags, ImVec2(0, height))) return;
  joinTabRound();
  ImGui::TableSetupScrollFreeze(1, 1);
  ImGui::TableSetupColumn("shot", ImGuiTableColumnFlags_WidthFixed, px(kThumbnailColumn));
  for (int i = 0; i < columns; ++i)
    ImGui::TableSetupColumn("light", ImGuiTableColumnFlags_WidthFixed, px(232));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  hint("Light names");
  for (size_t i = 0; i < m_lights.size(); ++i) {
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(i));
    ImGui::SetNextItemWidth(px(216));
    ImGui::InputText("##name", &m_lights[i]);
    ImGui::PopID();
    markItem({"wizard.light.", i});
    tooltip("This light's name");
  }
  for (size_t row = 0; row < m_rows.size(); ++row) drawRow(row);
  ImGui::EndTable();
  if (const auto change = std::exchange(m_toUse, std::nullopt)) useRow(change->first, change->second);
}

}  // namespace swaplight

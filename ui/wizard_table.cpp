#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/color/srgb.h"
#include "core/error.h"
#include "ui/capture_wizard.h"
#include "ui/gel_list.h"
#include "ui/icons.h"
#include "ui/layout_probe.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace swaplight {
namespace {

constexpr float kThumbnailColumn = 176;
constexpr float kThumbnailHeight = 92;

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

}  // namespace

void CaptureWizard::drawThumbnail(size_t shot) {
  const ShotThumbnail& picture = m_found->thumbnails[shot];
  const float scale = std::min(px(kThumbnailColumn - 10) / static_cast<float>(picture.width),
                               px(kThumbnailHeight) / static_cast<float>(picture.height));
  const ImVec2 size(std::floor(scale * static_cast<float>(picture.width)),
                    std::floor(scale * static_cast<float>(picture.height)));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("##picture", size);
  markItem(fmt::format("wizard.picture.{}", shot));
  const bool picking = m_picking && m_picking->first == shot;
  drawTexture(m_textures[shot].id(), at, ImVec2(at.x + size.x, at.y + size.y));
  if (picking)
    ImGui::GetWindowDrawList()->AddRect(at, ImVec2(at.x + size.x, at.y + size.y), kAccent, 0, 0, px(2));
  if (!picking || !clicked) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto pixel = [](float place, float length, int count) {
    return std::clamp(static_cast<int>(place / length * static_cast<float>(count)), 0, count - 1);
  };
  const Image& pixels = m_found->pixels->shots[shot];
  Cell& cell = m_cells[shot][m_picking->second];
  try {
    cell = {colorOfCard(pixels, pixel(mouse.x - at.x, size.x, pixels.width()),
                        pixel(mouse.y - at.y, size.y, pixels.height()))
                .text,
            false};
    m_picking.reset();
  } catch (const InputError&) {
    return;  // black: the next click may hit the card
  }
}

void CaptureWizard::drawCell(size_t shot, size_t light) {
  Cell& cell = m_cells[shot][light];
  const Reading reading = readingOf(cell.text);
  const std::string mark = fmt::format("wizard.cell.{}.{}", shot, light);
  const float side = ImGui::GetFrameHeight();
  ImGui::PushID(static_cast<int>(light));
  ImGui::Dummy(ImVec2(0, (px(kThumbnailHeight) - 2 * side) / 2));
  if (reading.color)
    colorChip("##chip", chipOf(*reading.color), ImVec2(side, side), cell.text.c_str());
  else
    ImGui::Dummy(ImVec2(side, side));
  ImGui::SameLine(0, px(4));
  ImGui::SetNextItemWidth(std::max(px(60), ImGui::GetContentRegionAvail().x - 2 * side - px(12)));
  const bool wrong = !reading.mistake.empty();
  if (wrong) ImGui::PushStyleColor(ImGuiCol_Text, kMute);
  if (!wrong && cell.guessed) ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
  if (ImGui::InputTextWithHint("##colour", shot == 0 ? "gel or colour" : "to be guessed", &cell.text))
    cell.guessed = false;
  if (wrong || cell.guessed) ImGui::PopStyleColor();
  markItem(mark);
  tooltip(wrong ? reading.mistake.c_str() : cell.guessed ? "Guessed from the pictures" : nullptr);
  ImGui::SameLine(0, px(4));
  const bool picking = m_picking == std::pair(shot, light);
  if (toggleButton(kIconPicker, picking, kAccent, side,
                   "Then click on a white card in this shot that only this light shines on"))
    m_picking = picking ? std::nullopt : std::optional(std::pair(shot, light));
  markItem(mark + ".pick");
  ImGui::SameLine(0, px(4));
  if (toggleButton(kIconDown, false, kAccent, side, "Gels, white, off, unknown")) ImGui::OpenPopup("##gels");
  markItem(mark + ".list");
  if (ImGui::BeginPopup("##gels")) {
    for (const char* word : {"white", "off", "unknown"}) {
      if (ImGui::Selectable(fmt::format("      {}", word).c_str(), cell.text == word)) cell = {word, false};
      markItem(std::string("wizard.choose.") + word);
    }
    ImGui::Separator();
    ImGui::BeginChild("##list", ImVec2(px(346), px(260)));
    if (const auto chosen = gelChoices(cell.text, m_filter)) {
      cell = {*chosen, false};
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndChild();
    ImGui::EndPopup();
  }
  ImGui::PopID();
}

void CaptureWizard::drawShot(size_t shot) {
  ImGui::PushID(static_cast<int>(shot));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  drawThumbnail(shot);
  hint(fmt::format("{}  {}", shot + 1, m_found->folder.shots[shot].file));
  for (size_t i = 0; i < m_lights.size(); ++i) {
    ImGui::TableNextColumn();
    drawCell(shot, i);
  }
  ImGui::PopID();
}

void CaptureWizard::drawTable(float height) {
  constexpr ImGuiTableFlags flags =
      ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH;
  const auto columns = static_cast<int>(m_lights.size());
  if (!ImGui::BeginTable("##shots", columns + 1, flags, ImVec2(0, height))) return;
  ImGui::TableSetupScrollFreeze(1, 1);
  ImGui::TableSetupColumn("shot", ImGuiTableColumnFlags_WidthFixed, px(kThumbnailColumn));
  for (int i = 0; i < columns; ++i)
    ImGui::TableSetupColumn("light", ImGuiTableColumnFlags_WidthFixed, px(232));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  hint("The lights are called");
  for (size_t i = 0; i < m_lights.size(); ++i) {
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(i));
    ImGui::SetNextItemWidth(px(216));
    ImGui::InputText("##name", &m_lights[i]);
    ImGui::PopID();
    markItem(fmt::format("wizard.light.{}", i));
  }
  for (size_t k = 0; k < m_cells.size(); ++k) drawShot(k);
  ImGui::EndTable();
}

}  // namespace swaplight

#include "ui/kit/theme.h"

#include <imgui_freetype.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>

#include "ui/kit/font_files.h"
#include "ui/kit/icons.h"

namespace swaplight {
namespace {

constexpr float kBodySize = 18;
constexpr float kSmallSize = 16;
constexpr float kTitleSize = 38;

// Latin with accents, Greek for beta and sigma, punctuation, arrows and mathematics.
const ImWchar kTextRanges[] = {0x20, 0x17f, 0x391, 0x3c9, 0x2010, 0x2044, 0x2190, 0x2195, 0x2200, 0x2265, 0};

// Only the icons in use: the font has thousands.
const ImVector<ImWchar>& iconRanges() {
  static const ImVector<ImWchar> ranges = [] {
    ImFontGlyphRangesBuilder builder;
    builder.AddText(kAllIcons);
    ImVector<ImWchar> built;
    builder.BuildRanges(&built);
    return built;
  }();
  return ranges;
}

Fonts theFonts;
float theScale = 1;

ImFont* loadFont(const char* interFace, float size) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const float pixels = std::round(size * theScale);
  ImFontConfig config;
  config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  ImFont* font = nullptr;
  for (const std::filesystem::path& file : {kInterFolder / interFace, kFallbackFont}) {
    if (!font && std::filesystem::exists(file))
      font = atlas.AddFontFromFileTTF(file.c_str(), pixels, &config, kTextRanges);
  }
  if (!font) font = atlas.AddFontDefault();
  if (std::filesystem::exists(kIconFontFile)) {
    config.MergeMode = true;
    config.GlyphOffset = ImVec2(0, std::round(0.18F * pixels));
    config.GlyphMinAdvanceX = pixels * 1.15F;
    atlas.AddFontFromFileTTF(kIconFontFile.c_str(), std::round(pixels * 1.15F), &config, iconRanges().Data);
  }
  return font;
}

ImVec4 grey(float value, float alpha = 1) {
  return {value, value, value, alpha};
}

void setColors(ImGuiStyle& style) {
  ImGui::StyleColorsDark(&style);
  const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(kAccent);
  const auto accentAt = [&](float alpha) { return ImVec4(accent.x, accent.y, accent.z, alpha); };
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(kText);
  c[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(kFaint);
  c[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(kPanel);
  c[ImGuiCol_ChildBg] = grey(0, 0);
  c[ImGuiCol_PopupBg] = grey(0.17F, 0.99F);
  c[ImGuiCol_Border] = grey(0.28F);
  c[ImGuiCol_FrameBg] = grey(0.245F);
  c[ImGuiCol_FrameBgHovered] = grey(0.30F);
  c[ImGuiCol_FrameBgActive] = grey(0.34F);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = grey(0.13F);
  c[ImGuiCol_MenuBarBg] = grey(0.125F);
  c[ImGuiCol_ScrollbarBg] = grey(0, 0);
  c[ImGuiCol_ScrollbarGrab] = grey(0.34F);
  c[ImGuiCol_CheckMark] = accent;
  c[ImGuiCol_SliderGrab] = grey(0.42F);  // the value is read through it
  c[ImGuiCol_SliderGrabActive] = accent;
  c[ImGuiCol_Button] = grey(0.27F);
  c[ImGuiCol_ButtonHovered] = grey(0.34F);
  c[ImGuiCol_ButtonActive] = accentAt(0.75F);
  c[ImGuiCol_Header] = accentAt(0.32F);
  c[ImGuiCol_HeaderHovered] = accentAt(0.42F);
  c[ImGuiCol_HeaderActive] = accentAt(0.55F);
  c[ImGuiCol_Separator] = grey(0.27F);
  c[ImGuiCol_SeparatorHovered] = accentAt(0.7F);
  c[ImGuiCol_SeparatorActive] = accent;
  c[ImGuiCol_Tab] = grey(0.2F);
  c[ImGuiCol_TabHovered] = accentAt(0.5F);
  c[ImGuiCol_TabActive] = grey(0.32F);
  c[ImGuiCol_PlotHistogram] = accent;
  c[ImGuiCol_TextSelectedBg] = accentAt(0.45F);
  c[ImGuiCol_NavHighlight] = accent;
  c[ImGuiCol_ModalWindowDimBg] = grey(0, 0.55F);
}

void setSizes(ImGuiStyle& style) {
  style.WindowPadding = ImVec2(px(10), px(10));
  style.FramePadding = ImVec2(px(8), px(4));
  style.ItemSpacing = ImVec2(px(8), px(6));
  style.ItemInnerSpacing = ImVec2(px(6), px(4));
  style.IndentSpacing = px(16);
  style.ScrollbarSize = px(12);
  style.GrabMinSize = px(11);
  style.FrameRounding = style.GrabRounding = px(4);
  style.PopupRounding = style.TabRounding = px(5);
  style.WindowRounding = px(8);
  style.ChildRounding = px(6);
  style.ScrollbarRounding = px(6);
  style.WindowBorderSize = style.PopupBorderSize = std::max(1.0F, std::floor(theScale));
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = ImVec2(0.5F, 0.5F);
}

}  // namespace

const Fonts& fonts() {
  return theFonts;
}

float px(float length) {
  return std::round(length * theScale);
}

float atScaleOne(float length) {
  return length / theScale;
}

Rgb backgroundCode() {
  const ImVec4 code = ImGui::ColorConvertU32ToFloat4(kPanel);
  return {code.x, code.y, code.z};
}

void applyTheme(float scale) {
  theScale = scale;
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  theFonts.body = loadFont("Inter-Regular.otf", kBodySize);
  theFonts.strong = loadFont("Inter-SemiBold.otf", kBodySize);
  theFonts.small = loadFont("Inter-Regular.otf", kSmallSize);
  theFonts.title = loadFont("Inter-SemiBold.otf", kTitleSize);
  io.FontDefault = theFonts.body;
  ImGuiStyle style;
  ImGui::GetStyle() = style;
  setColors(ImGui::GetStyle());
  setSizes(ImGui::GetStyle());
}

}  // namespace swaplight

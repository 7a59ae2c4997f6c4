#include "ui/dialogs/start_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/capture/capture.h"
#include "core/file/json_file.h"
#include "core/file/user_folders.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr size_t kRecentShown = 5;
constexpr float kPageWidth = 880, kGap = 12, kWords = 44;

std::string homely(const fs::path& path) {
  const std::string home = homeFolder().string();
  const std::string text = path.string();
  return home.size() > 1 && text.starts_with(home) ? fmt::format("~{}", text.substr(home.size())) : text;
}

/// "film_set" as one writes it: "Film set".
std::string plainName(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return withCapital(std::move(name));
}

std::string lightsOf(const fs::path& capture) try {
  std::string names;
  for (const Light& light : captureFromJson(readJson(capture), capture.parent_path()).lights)
    names += (names.empty() ? "" : ", ") + light.name;
  return "Lights: " + names;
} catch (const std::exception&) {
  return {};
}

/// A capture is called as its folder is.
std::string nameOf(const fs::path& file) {
  return plainName(file.filename() == "capture.json" ? file.parent_path().filename().string()
                                                     : file.stem().string());
}

/// Words in one line, with dots where they are cut.
void line(ImVec2 at, float width, ImU32 color, ImFont* font, const std::string& text) {
  ImGui::PushFont(font);
  ImGui::GetWindowDrawList()->AddText(at, color, cutToWidth(text, width).c_str());
  ImGui::PopFont();
}

bool wideButton(const char* icon, const std::string& text, float width) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(14), px(10)));
  const bool clicked = ImGui::Button(fmt::format("{}   {}", icon, text).c_str(), ImVec2(width, 0));
  ImGui::PopStyleVar();
  return clicked;
}

}  // namespace

StartPage::StartPage(const fs::path& samples, KeptPictures kept, std::function<void()> wake)
    : m_kept(std::move(kept)), m_wake(std::move(wake)) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(samples, error)) {
    const fs::path capture = entry.path() / "capture.json";
    const std::string name = entry.path().filename().string();
    if (fs::exists(capture, error))
      m_samples.push_back({capture, samples / "pictures" / (name + ".jpg"), "sample." + name, nameOf(capture),
                           lightsOf(capture)});
  }
  std::sort(m_samples.begin(), m_samples.end(),
            [](const Entry& a, const Entry& b) { return a.file < b.file; });
}

void StartPage::read(const std::vector<Entry>& recent, int written) {
  if (auto pictures = m_reading.take()) {
    m_pictures = std::move(*pictures);
    m_textures.clear();
  }
  // The page comes back when what was open is closed, whose picture may still be being written.
  const bool back = ImGui::GetFrameCount() != std::exchange(m_lastFrame, ImGui::GetFrameCount()) + 1;
  std::vector<fs::path> pictures;
  for (const std::vector<Entry>& entries : {std::cref(m_samples), std::cref(recent)})
    for (const Entry& entry : entries) pictures.push_back(entry.picture);
  m_due |= back || m_asked != pictures || std::exchange(m_written, written) != written;
  if (!m_due || m_reading.running()) return;
  m_due = false;
  m_asked = pictures;
  m_reading.start(
      [pictures](const Progress& progress) {
        Pictures read;
        for (const fs::path& picture : pictures) {
          progress.update(0, "pictures");
          read[picture] = readSmallPicture(picture);
        }
        return read;
      },
      m_wake);
}

unsigned StartPage::textureOf(const fs::path& picture, int width, int height) {
  const auto found = m_pictures.find(picture);
  if (found == m_pictures.end() || found->second.empty()) return 0;
  Texture& made = m_textures[picture];
  if (made.width != width || made.height != height) {
    made.texture.update(width, height, filling(found->second, width, height).rgba.data());
    made.width = width;
    made.height = height;
  }
  return made.texture.id();
}

bool StartPage::drawCard(const Entry& entry, float width) {
  const float high = std::floor(width * 9 / 16);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("##card", ImVec2(width, high + px(kWords)));
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemFocused();
  markItem({"welcome.", entry.id});
  tooltip(homely(entry.file).c_str());
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 corner(at.x + width, at.y + high);
  list->AddRectFilled(at, ImVec2(corner.x, corner.y + px(kWords)), lit ? kCardChosen : kCard, px(4));
  if (const unsigned texture = textureOf(entry.picture, static_cast<int>(width), static_cast<int>(high));
      texture != 0)
    drawTexture(texture, at, corner);
  else
    line(ImVec2(at.x + width / 2 - px(8), at.y + high / 2 - px(8)), px(40), kFaint, fonts().strong,
         kIconImage);
  if (lit) list->AddRect(at, ImVec2(corner.x, corner.y + px(kWords)), kAccent, px(4), 0, px(1.5F));
  const float words = width - 2 * px(8);
  line(ImVec2(at.x + px(8), corner.y + px(4)), words, kText, fonts().strong, entry.name);
  line(ImVec2(at.x + px(8), corner.y + px(23)), words, kFaint, fonts().small, entry.about);
  return clicked;
}

void StartPage::drawCards(const std::vector<Entry>& entries, float width, size_t columns,
                          SessionController& session) {
  const float card =
      std::floor((width - static_cast<float>(columns - 1) * px(kGap)) / static_cast<float>(columns));
  fs::path chosen;
  for (size_t i = 0; i < entries.size(); ++i) {
    if (i % columns != 0) ImGui::SameLine(0, px(kGap));
    ImGui::PushID(entries[i].id.c_str());
    if (drawCard(entries[i], card)) chosen = entries[i].file;
    ImGui::PopID();
  }
  if (!chosen.empty()) session.open(chosen);
}

void StartPage::draw(SessionController& session, const ActionTable& actions, int written) {
  std::vector<Entry> recent;
  for (const fs::path& file : session.recent().files())
    if (recent.size() < kRecentShown)
      recent.push_back({file, m_kept.pictureOf(file), fmt::format("recent.{}", recent.size()), nameOf(file),
                        homely(file.parent_path())});
  read(recent, written);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + room.x, at.y + room.y), kViewerGround);
  const float width = std::min(px(kPageWidth), room.x - px(40));
  ImGui::SetCursorPos(ImVec2((room.x - width) / 2, std::max(px(16), room.y * 0.06F)));
  ImGui::BeginGroup();
  ImGui::PushFont(fonts().title);
  ImGui::TextUnformatted("Swaplight");
  ImGui::PopFont();
  ImGui::TextDisabled(
      "Photograph a set while its lights change colour. Swaplight separates the lights, and you relight the "
      "set.");
  ImGui::Dummy(ImVec2(0, px(8)));
  const bool first = recent.empty();  // somebody's first start
  const float button = first ? (width - 2 * px(kGap)) / 3 : (width - px(kGap)) / 2;
  if (wideButton(kIconOpen, "Open …", button)) actions.run("file.open");
  markItem("welcome.open");
  tooltip("A capture, a solved set or a session. Or drop a file or folder here.");
  ImGui::SameLine(0, px(kGap));
  if (wideButton(kIconPhoto, "Import photographs …", button)) actions.run("file.new");
  markItem("welcome.new");
  tooltip(
      "A folder of photographs of a set whose lights changed colour: the wizard asks what is not in the "
      "files.");
  if (first && !m_samples.empty()) {
    ImGui::SameLine(0, px(kGap));
    if (wideButton(kIconHelp, "Take the tour", button)) actions.run("help.tour");
    markItem("welcome.tour");
    tooltip("Five steps through the studio, over a sample. A minute.");
  }
  ImGui::Dummy(ImVec2(0, px(10)));
  if (!m_samples.empty()) {
    hint("Samples");
    drawCards(m_samples, width, std::max<size_t>(3, m_samples.size()), session);
  }
  if (!recent.empty()) {
    ImGui::Dummy(ImVec2(0, px(10)));
    hint("Recent");
    drawCards(recent, width, kRecentShown, session);
  }
  ImGui::EndGroup();
}

}  // namespace swaplight

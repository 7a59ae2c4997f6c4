#include "ui/kit/file_chooser.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "core/base/lower_case.h"
#include "core/file/user_folders.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/manners.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

bool listed(const fs::path& file, const std::vector<std::string>& extensions) {
  return extensions.empty() ||
         std::find(extensions.begin(), extensions.end(), lowerExtension(file)) != extensions.end();
}

std::string sizeText(uintmax_t bytes) {
  if (bytes < 1000) return fmt::format("{} B", bytes);
  if (bytes < 1000 * 1000) return fmt::format("{:.0f} kB", static_cast<double>(bytes) / 1e3);
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

}  // namespace

const std::vector<std::string>& photographExtensions() {
  static const std::vector<std::string> all = {".exr", ".png", ".tif", ".tiff", ".jpg", ".jpeg",
                                               ".hdr", ".dng", ".cr2", ".cr3",  ".nef", ".arw",
                                               ".raf", ".orf", ".rw2", ".pef",  ".x3f"};
  return all;
}

void FileChooser::ask(Question question) {
  m_question = std::move(question);
  m_opened = false;
  m_toField = true;
  m_name = m_question->name;
  m_confirm.clear();
  m_wrong.clear();
  const fs::path begin = !m_question->folder.empty() ? m_question->folder : m_folder;
  std::error_code error;
  goTo(!begin.empty() && fs::is_directory(begin, error) ? begin : homeFolder());
}

void FileChooser::goTo(const fs::path& folder) {
  m_folder = folder.lexically_normal();
  m_entries.clear();
  m_error.clear();
  m_wrong.clear();
  m_toField = true;  // what was typed into goes on being typed into
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(m_folder, error)) {
    const std::string name = entry.path().filename().string();
    std::error_code ignored;
    const bool isFolder = entry.is_directory(ignored);
    if (name.starts_with(".") || (!isFolder && !listed(entry.path(), m_question->extensions))) continue;
    m_entries.push_back({name, isFolder, isFolder ? 0 : entry.file_size(ignored)});
  }
  if (error) m_error = "Cannot read this folder: " + error.message();
  std::sort(m_entries.begin(), m_entries.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lowerCase(a.name) < lowerCase(b.name);
  });
  m_tabStop = m_entries.empty() ? "" : m_entries.front().name;
}

void FileChooser::drawPlaces() {
  std::optional<fs::path> chosen;
  const auto place = [&](const char* icon, const char* name, const char* mark, const fs::path& folder) {
    if (ImGui::Button(fmt::format("{}  {}", icon, name).c_str())) chosen = folder;
    markItem({"chooser.", mark});
    tooltip(folder.c_str());
    ImGui::SameLine();
  };
  place(kIconHome, "Home", "home", homeFolder());
  place(kIconFolder, "Computer", "computer", "/");
  place(kIconParent, "Up", "up", m_folder.parent_path());
  if (m_question->saving) drawNewFolder();
  ImGui::NewLine();
  if (chosen) goTo(*chosen);
}

void FileChooser::drawNewFolder() {
  if (ImGui::Button(fmt::format("{}  New folder", kIconAdd).c_str())) {
    m_newFolder.clear();
    m_newFolderError.clear();
    ImGui::OpenPopup("##new folder");
  }
  markItem("chooser.new_folder");
  tooltip("Makes a folder in the one that is shown, and goes there.");
  const ImVec2 below(ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + px(2));
  ImGui::SameLine();
  ImGui::SetNextWindowPos(below, ImGuiCond_Appearing);
  if (!ImGui::BeginPopup("##new folder")) return;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(px(260));
  const bool entered = ImGui::InputTextWithHint("##folder", "Name of the new folder", &m_newFolder,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  markItem("chooser.new_folder_name");
  if (ImGui::IsItemEdited()) m_newFolderError.clear();
  if (!m_newFolderError.empty()) {
    ImGui::PushTextWrapPos(px(260));
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kChanged), "%s", m_newFolderError.c_str());
    ImGui::PopTextWrapPos();
    markItem("chooser.new_folder_error");
  }
  if (entered) {
    makeFolder();
    if (m_newFolderError.empty())
      ImGui::CloseCurrentPopup();
    else
      ImGui::SetKeyboardFocusHere(-1);
  }
  ImGui::EndPopup();
}

void FileChooser::makeFolder() {
  const fs::path name = m_newFolder;
  m_newFolderError.clear();
  if (m_newFolder.empty() || name != name.filename() || m_newFolder == "." || m_newFolder == "..") {
    m_newFolderError = "Write a name without a slash.";
    return;
  }
  std::error_code error;
  if (!fs::create_directory(m_folder / name, error) && !error)
    error = std::make_error_code(std::errc::file_exists);
  if (error)
    m_newFolderError = "It cannot be made: " + error.message() + ".";
  else
    goTo(m_folder / name);
}

// Every part of the path is a button that goes there.
void FileChooser::drawPath() {
  fs::path so_far;
  fs::path chosen;
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  int id = 0;
  for (const fs::path& part : m_folder) {
    if (part.empty()) continue;
    so_far /= part;
    const float width = ImGui::CalcTextSize(part.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (id > 0) {
      ImGui::SameLine(0, 0);
      if (ImGui::GetContentRegionAvail().x < width + px(20)) ImGui::NewLine();
    }
    ImGui::PushID(id++);
    if (ImGui::Button((part.string() + (part == "/" ? "" : " /")).c_str())) chosen = so_far;
    ImGui::PopID();
    markItem({"chooser.path.", id});
    tooltip(so_far.c_str());
  }
  ImGui::PopStyleColor();
  if (!chosen.empty()) goTo(chosen);
}

bool FileChooser::drawEntry(const Entry& entry) {
  const std::string label = fmt::format("{}  {}", entry.folder ? kIconFolder : kIconFile, entry.name);
  const bool stop = entry.name == m_tabStop;  // the list is one stop: arrows go from line to line
  if (!stop) beginNoTabStops();
  const bool pressed =
      ImGui::Selectable(label.c_str(), !entry.folder && entry.name == m_name,
                        ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups);
  if (!stop) endNoTabStops();
  markItem({"chooser.", entry.name});
  if (keyboardIsHere()) m_tabStop = entry.name;
  const bool taken = pressed && (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) || pressedByEnter());
  if (pressed && !entry.folder) m_name = entry.name;
  if (!entry.folder) {
    const std::string size = sizeText(entry.bytes);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(size.c_str()).x);
    ImGui::TextDisabled("%s", size.c_str());
  }
  return taken || (pressed && entry.folder && !m_question->saving);
}

bool FileChooser::drawEntries(float height) {
  const Entry* taken = nullptr;
  ImGui::BeginChild("##entries", ImVec2(0, height), true);
  joinTabRound();
  if (!m_error.empty()) ImGui::TextWrapped("%s", m_error.c_str());
  if (m_error.empty() && m_entries.empty()) ImGui::TextDisabled("%s", nothingHere(*m_question));
  for (const Entry& entry : m_entries)
    if (drawEntry(entry)) taken = &entry;
  ImGui::EndChild();
  const bool file = taken && !taken->folder;
  if (taken && taken->folder) goTo(m_folder / taken->name);
  return file;
}

const char* FileChooser::nothingHere(const Question& question) {
  if (question.forFolder) return "No folders and no photographs here.";
  return question.saving ? "No such files here." : "No files here that can be opened.";
}

const char* FileChooser::fieldHint(const Question& question) {
  if (question.forFolder) return "Folder shown above; type a path to change it";
  return question.saving ? "File name" : "File name or path";
}

void FileChooser::choose() {
  const fs::path typed = m_name;
  fs::path file = typed.is_absolute() ? typed : m_folder / typed;
  std::error_code ignored;
  if (m_question->forFolder && !fs::is_directory(file, ignored)) {
    if (!fs::exists(file, ignored)) {
      m_wrong = fmt::format("There is no folder {}.", file.lexically_normal().string());
      return;
    }
    file = file.parent_path();  // a file of the list: its folder
  }
  if (!m_question->forFolder && fs::is_directory(file, ignored)) {
    m_name.clear();
    goTo(file);
    return;
  }
  if (m_question->saving) {
    if (!m_question->extensions.empty() && !listed(file, m_question->extensions))
      file += m_question->extensions.front();
    if (fs::exists(file, ignored) && m_confirm != file) {
      m_confirm = file;
      return;
    }
  }
  const auto answer = std::move(m_question->answer);
  m_question.reset();
  ImGui::CloseCurrentPopup();
  answer(file);
}

std::string FileChooser::footerWords() const {
  if (!m_wrong.empty()) return m_wrong;
  if (m_confirm.empty()) return {};
  return fmt::format("{} already exists. Press {} again to replace it.",
                     fs::path(m_confirm).filename().string(), m_question->button);
}

void FileChooser::draw() {
  if (!m_question) return;
  const std::string window = m_question->title + "###chooser";
  if (!m_opened) ImGui::OpenPopup(window.c_str());
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(px(820), screen.x - px(60)), std::min(px(580), screen.y - px(60)));
  ImGui::SetNextWindowSize(size);
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  bool open = true;
  if (!ImGui::BeginPopupModal(
          window.c_str(), &open,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    m_question.reset();
    return;
  }
  beginTabStops();
  drawPlaces();
  drawPath();
  const std::string words = footerWords();
  const float footer = ImGui::GetFrameHeightWithSpacing() * (words.empty() ? 1.0F : 2.0F) + px(8);
  bool done = drawEntries(ImGui::GetContentRegionAvail().y - footer);
  if (!words.empty()) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kChanged), "%s", words.c_str());
    markItem("chooser.words");
    markState("chooser.words", words);
  }
  const float button = px(110);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2 * (button + ImGui::GetStyle().ItemSpacing.x));
  if (std::exchange(m_toField, false)) ImGui::SetKeyboardFocusHere();
  ImGui::InputTextWithHint("##name", fieldHint(*m_question), &m_name, ImGuiInputTextFlags_AutoSelectAll);
  markItem("chooser.name");
  if (ImGui::IsItemEdited()) m_wrong.clear();
  tooltip("A name, or a whole path.");
  m_opened = true;
  ImGui::SameLine();
  const bool complete = m_question->forFolder || !m_name.empty();
  if (defaultButton(m_question->button.c_str(), button, complete)) done = true;
  markItem("chooser.accept");
  ImGui::SameLine();
  if (cancelButton("Cancel", button)) {
    m_question.reset();
    ImGui::CloseCurrentPopup();
  } else if (done && complete) {
    m_toField = true;
    choose();
  }
  endTabStops();
  ImGui::EndPopup();
}

}  // namespace swaplight

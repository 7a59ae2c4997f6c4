#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace swaplight {

/// Of photographs, raw ones too.
[[nodiscard]] const std::vector<std::string>& photographExtensions();

/// A dialog that chooses a file, and needs no desktop environment.
class FileChooser {
 public:
  struct Question {
    std::string title;                    ///< "Open"
    std::string button;                   ///< "Open"
    std::vector<std::string> extensions;  ///< what is listed: ".json", in lower case; empty: everything
    bool saving = false;                  ///< a name may be typed, an existing file is asked about
    std::string name;                     ///< suggested, when saving
    std::filesystem::path folder;         ///< where to begin; empty: where the last question ended
    std::function<void(const std::filesystem::path&)> answer;
    bool forFolder = false;  ///< the folder that is shown is the answer; files are only listed
  };

  void ask(Question question);
  /// Where the last question ended; empty: there was none.
  [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
  /// Where a question begins that names no folder, from the last time.
  void beginIn(std::filesystem::path folder) { m_folder = std::move(folder); }
  [[nodiscard]] bool isOpen() const { return m_question.has_value(); }
  /// Draws the dialog while a question is open.
  void draw();

 private:
  struct Entry {
    std::string name;
    bool folder;
    uintmax_t bytes;
  };
  void goTo(const std::filesystem::path& folder);
  void drawPlaces();
  void drawNewFolder();
  void makeFolder();
  void drawPath();
  /// Each is true where a file was taken (of an entry: also a folder).
  bool drawEntry(const Entry& entry);
  bool drawEntries(float height);
  void choose();
  [[nodiscard]] std::string footerWords() const;
  /// What the list says that has no lines.
  static const char* nothingHere(const Question& question);
  static const char* fieldHint(const Question& question);

  std::optional<Question> m_question;
  bool m_opened = false;
  bool m_toField = false;  ///< the name is to be typed
  std::filesystem::path m_folder;
  std::vector<Entry> m_entries;
  std::string m_tabStop;  ///< the entry that Tab comes to
  std::string m_error;
  std::string m_name;
  std::string m_wrong;           ///< why what was typed was not taken
  std::string m_confirm;         ///< the existing file that the person was asked about
  std::string m_newFolder;       ///< the name of a folder that is being made
  std::string m_newFolderError;  ///< why it was not
};

}  // namespace swaplight

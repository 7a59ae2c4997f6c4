#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/filter/filter_library.h"

namespace swaplight {

class DocumentEditor;

/// The camera looks that can be named, and which of them are favourites: read when first asked for, and
/// again when a file has changed.
class LookShelf {
 public:
  /// `library` gives the filters; `favouritesFile` as favourite_looks.h says.
  LookShelf(std::function<FilterLibrary&()> library, std::filesystem::path favouritesFile);

  /// The person's own before those that come along; of two of one name the first.
  [[nodiscard]] const std::vector<FilterPipeline>& looks();
  /// In the person's order. Names whose look is gone are left out, but kept in the file.
  [[nodiscard]] std::vector<const FilterPipeline*> favourites();
  [[nodiscard]] bool isFavourite(const std::string& name);
  /// What is wrong with the file of the favourites, in a line, once; empty: nothing. The scene types stand
  /// in.
  [[nodiscard]] std::string takeProblem() { return std::exchange(m_problem, {}); }

  /// Makes a look a favourite, or one no more, in the file. Throws InputError.
  void star(const std::string& name, bool on);
  /// Files of looks have changed.
  void readAgain() { m_read = false; }

  /// As a document holds it, wherever the look's file lies.
  [[nodiscard]] FilterPipeline lookOf(const FilterPipeline& look) const;

 private:
  void read();

  std::function<FilterLibrary&()> m_library;
  std::filesystem::path m_favouritesFile;
  std::vector<FilterPipeline> m_looks;
  std::vector<std::string> m_names;  ///< of the favourites
  std::string m_problem;
  bool m_read = false;
};

/// The document is seen through this look; through none where it was seen through one of this name. One step
/// of the history.
void toggleCameraLook(DocumentEditor& editor, const LookShelf& shelf, const FilterPipeline& look);

}  // namespace swaplight

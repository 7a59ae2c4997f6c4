#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/filter/filter.h"
#include "core/filter/filter_pipeline.h"

namespace swaplight {

/// A folder of filters; subfolders are looked into.
struct FilterFolder {
  std::filesystem::path path;
  bool builtIn = false;
};

/// Where a person's own and the machine's filters lie, the person's first: $XDG_DATA_HOME/swaplight/filters,
/// $XDG_DATA_HOME/ISF, /usr/share/ISF (and the same without XDG_DATA_HOME in ~/.local/share).
[[nodiscard]] std::vector<FilterFolder> personalFilterFolders();

/// All filters of some folders, by name. A value; copies share the filters.
class FilterLibrary {
 public:
  /// Reads every file that ends in .fs (or .FS). Of two filters of one name the first folder's counts.
  /// Folders that are missing are passed over; a broken file is skipped and its error kept in problems().
  explicit FilterLibrary(std::span<const FilterFolder> folders);

  [[nodiscard]] const std::vector<std::shared_ptr<const Filter>>& filters() const { return m_filters; }
  [[nodiscard]] const std::vector<std::string>& problems() const { return m_problems; }

  /// By name, whatever its case and with spaces, dashes or underscores; or, where the name ends in ".fs", the
  /// file, named from `folder`. Throws InputError that suggests names alike.
  [[nodiscard]] std::shared_ptr<const Filter> find(const std::string& name,
                                                   const std::filesystem::path& folder = {}) const;
  /// Reads a file, once as long as it does not change, so that find() gives the same filter every time.
  /// Throws InputError.
  void load(const std::filesystem::path& file);

 private:
  [[nodiscard]] std::string namesLike(const std::string& name) const;

  std::vector<std::shared_ptr<const Filter>> m_filters;  ///< sorted by name
  std::vector<std::string> m_problems;
  struct Loaded {
    std::filesystem::file_time_type changed;
    std::shared_ptr<const Filter> filter;
  };
  std::map<std::filesystem::path, Loaded> m_loaded;  ///< by load()
};

/// A stage whose filter is known: every parameter has a value of its own type. Pictures are named by paths
/// that can be opened from anywhere.
struct ResolvedStage {
  std::shared_ptr<const Filter> filter;
  std::vector<FilterValue> values;  ///< as filter->inputs
};

/// One of the filters asks for FilteredImage::light.
[[nodiscard]] bool wantsLight(std::span<const ResolvedStage> stages);

/// `where` begins the message. Throws InputError: no such filter or parameter (lists those there are), a
/// value of the wrong type or out of range.
[[nodiscard]] ResolvedStage resolveStage(const FilterLibrary& library, const FilterStage& stage,
                                         const std::filesystem::path& folder, const std::string& where);

/// The same look wherever its file will lie: values of the filters' own types, pictures and filters' files by
/// absolute paths. Stages that cannot be resolved stay as they are.
[[nodiscard]] FilterPipeline standalone(FilterPipeline pipeline, const FilterLibrary& library);

/// Every .swaplook file of some folders, by name; broken ones are passed over.
[[nodiscard]] std::vector<FilterPipeline> pipelinesIn(std::span<const std::filesystem::path> folders);

/// A camera look: a file where the name ends in .swaplook, else one of the folders', whatever its case and
/// with spaces, dashes or underscores. Throws InputError that lists the names.
[[nodiscard]] FilterPipeline findPipeline(const std::string& name,
                                          std::span<const std::filesystem::path> folders);

/// The key by which names are alike: small letters and digits.
[[nodiscard]] std::string filterKey(const std::string& name);

}  // namespace swaplight

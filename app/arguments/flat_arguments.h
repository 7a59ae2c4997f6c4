#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace swaplight {

/// A file as the manifest in `folder` names it: relative to the folder.
[[nodiscard]] std::string pathInManifest(const std::filesystem::path& folder, const std::string& file);

/// The pictures by which uneven lamps and lenses are put right, for every verb that takes photographs.
class FlatArguments {
 public:
  void addTo(CLI::App& verb);
  /// Light: its picture, as the manifest in `folder` names it. Throws InputError that quotes the option.
  [[nodiscard]] std::map<std::string, std::string> lamps(const std::filesystem::path& folder) const;
  /// The pictures, as given: no output may replace them.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  /// "" where there is none.
  [[nodiscard]] std::string lens(const std::filesystem::path& folder) const;

 private:
  std::vector<std::string> m_lamps;
  std::string m_lens;
};

}  // namespace swaplight

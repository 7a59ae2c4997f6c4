#include "app/arguments/flat_arguments.h"

#include "core/base/error.h"

namespace swaplight {

std::string pathInManifest(const std::filesystem::path& folder, const std::string& file) {
  namespace fs = std::filesystem;
  const fs::path from = fs::absolute(folder).lexically_normal();
  return fs::absolute(file).lexically_normal().lexically_relative(from).string();
}

void FlatArguments::addTo(CLI::App& verb) {
  verb.add_option(
          "--flat", m_lamps,
          "A grey card that this light alone shines on and that fills the picture: evens the lamp's colour")
      ->type_name("LIGHT=FILE")
      ->allow_extra_args(false);
  verb.add_option("--vignetting", m_lens,
                  "An evenly lit surface through the same lens: gives back what it takes of the corners")
      ->type_name("FILE");
}

std::map<std::string, std::string> FlatArguments::lamps(const std::filesystem::path& folder) const {
  std::map<std::string, std::string> lamps;
  for (const std::string& text : m_lamps) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size())
      throw InputError("--flat {}: write LIGHT=FILE", text);
    lamps[text.substr(0, equals)] = pathInManifest(folder, text.substr(equals + 1));
  }
  return lamps;
}

std::vector<std::filesystem::path> FlatArguments::files() const {
  std::vector<std::filesystem::path> files;
  for (const std::string& text : m_lamps) files.emplace_back(text.substr(text.find('=') + 1));
  if (!m_lens.empty()) files.emplace_back(m_lens);
  return files;
}

std::string FlatArguments::lens(const std::filesystem::path& folder) const {
  return m_lens.empty() ? "" : pathInManifest(folder, m_lens);
}

}  // namespace swaplight

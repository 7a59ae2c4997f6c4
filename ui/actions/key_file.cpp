#include "ui/actions/key_file.h"

#include <sstream>

#include "core/file/atomic_file.h"

namespace swaplight {
namespace {

constexpr size_t kLargestFile = 1 << 20;

}  // namespace

void applyKeyText(ActionTable& actions, const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string id, keys;
    words >> id;
    std::getline(words >> std::ws, keys);
    if (!id.empty() && id[0] != '#') actions.setKeys(id, keys);
  }
}

std::string keyText(const ActionTable& actions) {
  std::string text =
      "# Swaplight's keyboard shortcuts: an action, then its keys. Delete a line to restore its default.\n";
  for (const Action& action : actions.actions())
    if (action.keys != action.ownKeys) text += action.id + " " + action.keys + "\n";
  return text;
}

void readKeyFile(ActionTable& actions, const std::filesystem::path& file) {
  if (std::filesystem::exists(file)) applyKeyText(actions, readFile(file, kLargestFile));
}

void writeKeyFile(const ActionTable& actions, const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  writeFile(file, keyText(actions));
}

}  // namespace swaplight

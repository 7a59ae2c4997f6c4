#include "ui/state/window_memory.h"

#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/file/user_folders.h"

namespace swaplight {
namespace {

constexpr int kLeastWidth = 640, kLeastHeight = 400, kMostSide = 16384;

}  // namespace

std::filesystem::path windowMemoryFile() {
  return stateFolder() / "window.json";
}

WindowMemory readWindowMemory(const std::filesystem::path& file) {
  WindowMemory memory;
  try {
    if (!std::filesystem::exists(file)) return memory;
    const Json json = readJson(file);
    const int width = json.value("width", memory.width), height = json.value("height", memory.height);
    if (width >= kLeastWidth && height >= kLeastHeight && width <= kMostSide && height <= kMostSide) {
      memory.width = width;
      memory.height = height;
    }
    memory.maximized = json.value("maximized", false);
    memory.folder = json.value("folder", "");
  } catch (const std::exception&) {
    return {};
  }
  return memory;
}

void writeWindowMemory(const WindowMemory& memory, const std::filesystem::path& file) {
  try {
    std::filesystem::create_directories(file.parent_path());
    writeJson(Json{{"width", memory.width},
                   {"height", memory.height},
                   {"maximized", memory.maximized},
                   {"folder", memory.folder.string()}},
              file);
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace swaplight

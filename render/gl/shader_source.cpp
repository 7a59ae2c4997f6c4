#include "render/gl/shader_source.h"

#include <fmt/core.h>

#include <fstream>
#include <sstream>

#include "core/base/error.h"

namespace swaplight {

namespace fs = std::filesystem;

fs::path shaderFolder() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  fs::path installed = program.parent_path().parent_path() / "share" / "swaplight" / "shaders";
  if (fs::is_directory(installed, ignored)) return installed;
  fs::path source = SWAPLIGHT_SHADER_DIR;
  if (fs::is_directory(source, ignored)) return source;
  throw ResourceError(
      fmt::format("the shaders are missing: they were expected in {} or {}. Install swaplight again",
                  installed.string(), source.string()));
}

std::string shaderSource(const std::string& file) {
  const fs::path path = shaderFolder() / file;
  std::ifstream in(path);
  if (!in) throw ResourceError(fmt::format("the shader {} cannot be read", path.string()));
  std::string source;
  for (std::string line; std::getline(in, line);) {
    constexpr std::string_view kInclude = "#include \"";
    if (line.starts_with(kInclude))
      source += shaderSource(line.substr(kInclude.size(), line.rfind('"') - kInclude.size()));
    else
      source += line + '\n';
  }
  return source;
}

std::string numberedSource(const std::string& source) {
  std::istringstream in(source);
  std::string numbered;
  int number = 0;
  for (std::string line; std::getline(in, line);) numbered += fmt::format("{:4}  {}\n", ++number, line);
  return numbered;
}

}  // namespace swaplight

#include "core/color/gel.h"

#include <algorithm>
#include <cctype>

#include "core/error.h"
#include "core/file/atomic_file.h"
#include "core/session/user_folders.h"

namespace swaplight {
namespace {

constexpr size_t kLargestTable = size_t{16} << 20;

}  // namespace

const std::vector<Gel>& allGels() {
  static const std::vector<Gel> gels = [] {
    const std::filesystem::path file = dataFolder() / "gels.csv";
    std::vector<Gel> all;
    if (std::filesystem::exists(file)) all = gelsFromCsv(readFile(file, kLargestTable), file.string());
    all.insert(all.end(), builtInGels().begin(), builtInGels().end());
    return all;
  }();
  return gels;
}

const Gel& findGel(const std::string& id) {
  const auto sameLetter = [](char a, char b) {
    return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
  };
  std::string known;
  for (const Gel& gel : allGels()) {
    if (std::equal(gel.id.begin(), gel.id.end(), id.begin(), id.end(), sameLetter)) return gel;
    known += (known.empty() ? "" : ", ") + gel.id;
  }
  throw InputError(
      "there is no gel {} here; known are {}, and what the file gels.csv in the data folder adds", id, known);
}

}  // namespace swaplight

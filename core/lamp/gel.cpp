#include "core/lamp/gel.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <mutex>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/file/atomic_file.h"
#include "core/file/user_folders.h"

namespace swaplight {
namespace {

constexpr const char* kMeasured = "measured.csv";
constexpr size_t kLargestTable = size_t{16} << 20;  // bytes: no table of gels is

/// Every list that was ever given out; the last one is in use.
struct GelLists {
  std::mutex mutex;
  std::deque<std::vector<Gel>> lists;
};

GelLists& gelLists() {
  static GelLists instance;
  return instance;
}

/// Upper or lower case.
bool sameId(const std::string& a, const std::string& b) {
  return std::ranges::equal(a, b, [](char one, char other) {
    return std::toupper(static_cast<unsigned char>(one)) == std::toupper(static_cast<unsigned char>(other));
  });
}

std::filesystem::path tablesFolder() {
  return dataFolder() / "gels";
}

std::vector<std::filesystem::path> personsTables() {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(dataFolder() / "gels.csv")) files.push_back(dataFolder() / "gels.csv");
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(tablesFolder(), none))
    if (lowerExtension(entry.path()) == ".csv") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Gel> readGels() {
  std::vector<Gel> all;
  for (const std::filesystem::path& file : personsTables()) {
    const std::vector<Gel> own = gelsFromCsv(readGelTable(file), file.string());
    all.insert(all.end(), own.begin(), own.end());
  }
  all.insert(all.end(), builtInGels().begin(), builtInGels().end());
  return all;
}

/// A table in the person's folder, whose gels are known from now on.
void keepTable(const std::filesystem::path& name, const std::string& text) {
  std::error_code ignored;
  std::filesystem::create_directories(tablesFolder(), ignored);
  writeFile(tablesFolder() / name, text);
  GelLists& gels = gelLists();
  const std::lock_guard lock(gels.mutex);
  gels.lists.push_back(readGels());
}

}  // namespace

const std::vector<Gel>& allGels() {
  GelLists& gels = gelLists();
  const std::lock_guard lock(gels.mutex);
  if (gels.lists.empty()) gels.lists.push_back(readGels());
  return gels.lists.back();
}

std::string readGelTable(const std::filesystem::path& csv) {
  return readFile(csv, kLargestTable);
}

size_t importGels(const std::filesystem::path& csv) {
  if (csv.filename() == kMeasured)
    throw InputError("{}: gels that are measured here are kept under that name: rename the table",
                     csv.string());
  const std::string text = readGelTable(csv);
  const size_t count = gelsFromCsv(text, csv.string()).size();
  keepTable(csv.filename(), text);
  return count;
}

const Gel& addMeasuredGel(const GelLabel& label, const Rgb& filter) {
  const std::filesystem::path table = tablesFolder() / kMeasured;
  const std::string before = std::filesystem::exists(table) ? readGelTable(table) : "";
  const std::string text = withMeasuredGel(before, table.string(), label, filter);
  const std::string id = gelsFromCsv(text, table.string()).back().id;
  for (const Gel& gel : allGels())
    if (gel.source == Gel::Source::Table && sameId(gel.id, id))
      throw InputError("{} is in one of your own tables already: give this gel another number", id);
  keepTable(table.filename(), text);
  return findGel(id);
}

const Gel& findGel(const std::string& id) {
  std::string known;
  for (const Gel& gel : allGels()) {
    if (sameId(gel.id, id)) return gel;
    known += (known.empty() ? "" : ", ") + gel.id;
  }
  throw InputError(
      "there is no gel {} here; known are {}, and what the file gels.csv in the data folder adds", id, known);
}

}  // namespace swaplight

#include "core/filter/kept_filter.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/file/atomic_file.h"
#include "core/filter/filter_file.h"
#include "core/filter/filter_header.h"
#include "core/filter/filter_library.h"
#include "core/filter/filter_names.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

void setDefaults(Json& inputs, const ResolvedStage& stage) {
  for (Json& input : inputs) {
    const Filter& filter = *stage.filter;
    for (size_t i = 0; i < filter.inputs.size(); ++i)
      if (input.value("NAME", "") == filter.inputs[i].name &&
          filter.inputs[i].type != FilterInputType::Event &&
          !std::holds_alternative<std::string>(stage.values[i]))
        input["DEFAULT"] = jsonFromFilterValue(stage.values[i]);
  }
}

bool isTaken(const std::string& name, const fs::path& folder) {
  std::error_code missing;
  for (fs::directory_iterator at(folder, missing), end; !missing && at != end; at.increment(missing))
    if (isFilterFile(at->path()) && filterKey(at->path().stem().string()) == filterKey(name)) return true;
  return false;
}

std::string freeName(const std::string& filter, const fs::path& folder) {
  const std::string first = filter.starts_with("my-") ? filter : "my-" + filter;
  std::string name = first;
  for (int i = 2; isTaken(name, folder); ++i) name = fmt::format("{}-{}", first, i);
  return name;
}

}  // namespace

fs::path keepFilter(const ResolvedStage& stage, const fs::path& folder, const std::string& asked) {
  const Filter& filter = *stage.filter;
  const std::string name = asked.empty() ? freeName(filter.name, folder) : asked;
  if (name.front() == '.' || name.find('/') != std::string::npos)
    throw InputError(
        "\"{}\" cannot be a filter's name: it becomes the name of a file; take letters and dashes", name);
  if (!filter.imports.empty())
    throw InputError(
        "{}: reads pictures that lie beside its file; copy the file and them, and change its header",
        filter.file.string());
  const std::string text = readFile(filter.file, kLargestFilter);
  FilterHeader header = headerOf(text, filter.file.string());
  if (const auto inputs = header.json.find("INPUTS"); inputs != header.json.end())
    setDefaults(*inputs, stage);
  if (const auto own = header.json.find("SWAPLIGHT"); own != header.json.end() && own->contains("INPUTS"))
    setDefaults((*own)["INPUTS"], stage);
  std::error_code error;
  fs::create_directories(folder, error);  // writing says what is wrong
  const fs::path file = folder / (name + kFilterEnding);
  if (isTaken(name, folder))
    throw InputError("{}: there is a filter of this name already; take another one, or delete it",
                     file.string());
  if (!filter.vertexSource.empty()) writeFile(folder / (name + ".vs"), filter.vertexSource);
  writeFile(file, text.substr(0, header.begin) + header.json.dump(2) + text.substr(header.end));
  return file;
}

}  // namespace swaplight

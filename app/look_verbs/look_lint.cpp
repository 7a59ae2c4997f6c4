#include <fmt/format.h>

#include <algorithm>

#include "app/look_verbs/look_actions.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/filter/filter_file.h"
#include "core/filter/filter_names.h"
#include "render/filter/filter_check.h"
#include "render/gl/egl_context.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

/// Files as they are, folders as the .fs files below them.
std::vector<fs::path> filesOf(const std::vector<std::string>& names) {
  std::vector<fs::path> files;
  for (const std::string& name : names) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.emplace_back(name);
      continue;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(name))
      if (isFilterFile(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool isBuiltIn(const fs::path& file) {
  std::error_code error;
  const fs::path inside = fs::relative(file, builtInFilterFolder(), error);
  return !error && !inside.empty() && *inside.begin() != "..";
}

/// Loads, compiles and draws a filter; says what is wrong with it, nothing where all is right. What only
/// strangers' filters for codes do, and programs commonly bear with, becomes a note.
std::string problemOf(const fs::path& file, double mostSeconds, Filter& filter) try {
  filter = readFilter(file);
  filter.builtIn = isBuiltIn(file);
  const std::string fault = faultOf(std::make_shared<const Filter>(filter), mostSeconds);
  if (fault.empty() || filter.ours) return fault.empty() ? "" : file.string() + ": " + fault;
  filter.notes.push_back(fault);
  return {};
} catch (const InputError& error) {
  return error.what();
}

}  // namespace

int lintFilters(const LookArguments& arguments, Terminal& terminal) {
  const std::vector<fs::path> files = filesOf(arguments.names);
  if (files.empty()) throw InputError("look lint: name the .fs files to check, or folders of them");
  const EglContext context;
  Json rows = Json::array();
  std::string text;
  size_t bad = 0;
  for (const fs::path& file : files) {
    Filter filter;
    const std::string problem = problemOf(file, arguments.mostSeconds, filter);
    if (!problem.empty()) ++bad;
    text += (problem.empty() ? file.string() + ": loads, compiles and draws" : problem) + '\n';
    for (const std::string& note : filter.notes) text += fmt::format("{}: note: {}\n", file.string(), note);
    rows.push_back(
        {{"file", file.string()}, {"ok", problem.empty()}, {"problem", problem}, {"notes", filter.notes}});
  }
  text += fmt::format("{} of {} are fine", files.size() - bad, files.size());
  terminal.result(text, {{"files", std::move(rows)}, {"fine", files.size() - bad}, {"broken", bad}});
  return bad == 0 ? 0 : 2;
}

}  // namespace swaplight

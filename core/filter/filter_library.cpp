#include "core/filter/filter_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/user_folders.h"
#include "core/filter/filter_file.h"
#include "core/filter/filter_names.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

/// Every file with this extension below a folder, in the order of their names.
std::vector<fs::path> filesIn(const fs::path& folder, const char* extension) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && at != end; at.increment(error))
    if (lowerExtension(at->path()) == extension) files.push_back(at->path());
  std::sort(files.begin(), files.end());
  return files;
}

/// How many letters have to be changed, added or left out (Levenshtein).
size_t distanceOf(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string inputNames(const Filter& filter) {
  std::string names;
  for (const FilterInput& input : filter.inputs) names += (names.empty() ? "" : ", ") + input.name;
  return names.empty() ? "it has none" : "it has " + names;
}

}  // namespace

std::string filterKey(const std::string& name) {
  std::string key;
  for (const unsigned char c : name)
    if (std::isalnum(c) || c > 127) key += static_cast<char>(std::tolower(c));
  return key;
}

std::vector<FilterPipeline> pipelinesIn(std::span<const fs::path> folders) {
  std::vector<FilterPipeline> pipelines;
  for (const fs::path& folder : folders)
    for (const fs::path& file : filesIn(folder, kLookEnding)) try {
        pipelines.push_back(readPipeline(file));
      } catch (const InputError&) {  // said where it is asked for by its file
        continue;
      }
  return pipelines;
}

FilterPipeline findPipeline(const std::string& name, std::span<const fs::path> folders) {
  if (isLookFile(name)) return readPipeline(name);
  std::string names;
  for (FilterPipeline& pipeline : pipelinesIn(folders)) {
    if (filterKey(pipeline.name) == filterKey(name)) return std::move(pipeline);
    names += (names.empty() ? "" : ", ") + pipeline.name;
  }
  throw InputError("there is no camera look \"{}\": there are {}, or name a .swaplook file", name, names);
}

std::vector<FilterFolder> personalFilterFolders() {
  return {{dataFolder() / "filters"}, {dataFolder().parent_path() / "ISF"}, {"/usr/share/ISF"}};
}

FilterLibrary::FilterLibrary(std::span<const FilterFolder> folders) {
  std::set<std::string> seen;
  for (const FilterFolder& folder : folders)
    for (const fs::path& file : filesIn(folder.path, kFilterEnding)) try {
        Filter filter = readFilter(file);
        filter.builtIn = folder.builtIn;
        if (seen.insert(filterKey(filter.name)).second)
          m_filters.push_back(std::make_shared<const Filter>(std::move(filter)));
      } catch (const InputError& error) {
        m_problems.emplace_back(error.what());
      }
  std::sort(m_filters.begin(), m_filters.end(),
            [](const auto& a, const auto& b) { return filterKey(a->name) < filterKey(b->name); });
}

std::shared_ptr<const Filter> FilterLibrary::find(const std::string& name, const fs::path& folder) const {
  if (isFilterFile(name)) {
    const fs::path file = folder / name;  // an absolute name is one without the folder
    const auto loaded = m_loaded.find(file);
    return loaded != m_loaded.end() ? loaded->second.filter
                                    : std::make_shared<const Filter>(readFilter(file));
  }
  const std::string key = filterKey(name);
  for (const auto& filter : m_filters)
    if (filterKey(filter->name) == key) return filter;
  for (const std::string& problem : m_problems)  // "folder/name.fs: ..." or "folder/name.fs:3: ..."
    if (filterKey(fs::path(problem.substr(0, lowerCase(problem).find(".fs:"))).filename().string()) == key)
      throw InputError("{}", problem);
  throw InputError("there is no filter \"{}\"{}; swaplight look list shows all", name, namesLike(name));
}

void FilterLibrary::load(const fs::path& file) {
  std::error_code error;
  const fs::file_time_type changed = fs::last_write_time(file, error);
  Loaded& loaded = m_loaded[file];
  if (loaded.filter && loaded.changed == changed) return;
  try {
    loaded = {changed, std::make_shared<const Filter>(readFilter(file))};
  } catch (const InputError&) {
    m_loaded.erase(file);
    throw;
  }
}

std::string FilterLibrary::namesLike(const std::string& name) const {
  const std::string key = filterKey(name);
  std::string names;
  for (const auto& filter : m_filters) {
    const std::string other = filterKey(filter->name);
    const bool part =
        key.size() > 2 && (other.find(key) != std::string::npos || key.find(other) != std::string::npos);
    if (part || distanceOf(key, other) <= 1 + key.size() / 4)
      names += (names.empty() ? "" : ", ") + filter->name;
  }
  return names.empty() ? "" : "; did you mean " + names + "?";
}

bool wantsLight(std::span<const ResolvedStage> stages) {
  return std::any_of(stages.begin(), stages.end(),
                     [](const ResolvedStage& stage) { return !stage.filter->light.empty(); });
}

ResolvedStage resolveStage(const FilterLibrary& library, const FilterStage& stage, const fs::path& folder,
                           const std::string& where) {
  ResolvedStage resolved;
  try {
    resolved.filter = library.find(stage.filter, folder);
  } catch (const InputError& error) {
    throw InputError("{}: {}", where, error.what());
  }
  const Filter& filter = *resolved.filter;
  for (const auto& [name, value] : stage.parameters)
    if (!filter.findInput(name))
      throw InputError("{}: {} has no parameter \"{}\": {}", where, filter.name, name, inputNames(filter));
  for (const FilterInput& input : filter.inputs) {
    const std::string place = fmt::format("{}: {}: {}", where, filter.name, input.name);
    const auto given = stage.parameters.find(input.name);
    FilterValue value =
        given == stage.parameters.end() ? input.standard : valueOfType(given->second, input.type, place);
    input.check(value, place, filter.ours);
    if (auto* file = std::get_if<std::string>(&value);
        file && !file->empty() && !fs::path(*file).is_absolute())
      *file = (folder / *file).string();
    resolved.values.push_back(std::move(value));
  }
  return resolved;
}

FilterPipeline standalone(FilterPipeline pipeline, const FilterLibrary& library) {
  const fs::path folder = pipeline.folder.empty() ? fs::current_path() : fs::absolute(pipeline.folder);
  for (FilterStage& stage : pipeline.stages) try {
      const ResolvedStage resolved = resolveStage(library, stage, folder, pipeline.name);
      if (isFilterFile(stage.filter)) stage.filter = resolved.filter->file.string();
      for (size_t i = 0; i < resolved.values.size(); ++i)
        if (const auto given = stage.parameters.find(resolved.filter->inputs[i].name);
            given != stage.parameters.end())
          given->second = resolved.values[i];
    } catch (const InputError&) {  // whoever draws it says so
      continue;
    }
  return pipeline;
}

}  // namespace swaplight

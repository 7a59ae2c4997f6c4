#include "app/arguments/camera_look_arguments.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "app/program/number_range.h"
#include "core/base/error.h"
#include "core/file/frame_range.h"
#include "core/filter/filter_names.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoLook = "none";

}  // namespace

FilterPipeline FilterRequest::pipeline() const {
  if (!look.empty() && !filters.empty()) throw InputError("--filter and a camera look: ask for one of them");
  if (!look.empty()) return findPipeline(look, installedLookFolders());
  FilterPipeline pipeline;
  pipeline.name = "filters";
  pipeline.folder = fs::current_path();
  for (const std::string& text : filters) pipeline.stages.push_back(stageFromText(text));
  return pipeline;
}

std::shared_ptr<CameraLook> readyLook(const FilterPipeline& pipeline, const std::string& where, bool strict,
                                      CameraLookOptions options, Terminal& terminal) {
  const FilterLibrary library = installedFilters();
  if (!strict)
    options.leftOut = [&terminal](const std::string& line) { terminal.say("warning: left out: {}", line); };
  return std::make_shared<CameraLook>(pipeline, library, where, options);
}

std::function<std::shared_ptr<FrameFilter>(const FilterPipeline&)> versionLooks(Terminal& terminal) {
  const auto said = std::make_shared<std::set<std::string>>();
  return [&terminal, said](const FilterPipeline& look) -> std::shared_ptr<FrameFilter> {
    const std::string where = "camera look " + look.name;
    try {
      return readyLook(look, where, false, {}, terminal);
    } catch (const ResourceError& error) {
      const std::string line = fmt::format("{}: {}; drawn without it", where, error.what());
      if (said->insert(line).second) terminal.say("warning: {}", line);
      return nullptr;
    }
  };
}

void checkPlace(const CameraLook& look, const std::string& place) {
  for (const ResolvedStage& stage : look.stages()) {
    const std::vector<std::string>& where = stage.filter->where;
    if (std::find(where.begin(), where.end(), place) == where.end())
      throw InputError(
          "{}: this filter is for the {}, not for a {}; leave it out, or add \"{}\" to WHERE in {}",
          stage.filter->name, fmt::join(where, ", "), place, place,
          stage.filter->builtIn ? "a copy of its file" : stage.filter->file.string());
  }
}

std::string stillName(const std::string& file, std::optional<int> number) {
  if (!hasFrameNumber(file)) return file;
  if (!number)
    throw InputError(
        "{}: has a place for a frame's number, and none is given: add --frame 12, or write a name without #, "
        "@ and %d",
        file);
  return frameName(file, *number);
}

int codeWithLook(int code, const CameraLook* look) {
  return code == 0 && look && !look->leftOut().empty() ? 1 : code;
}

void CameraLookArguments::addTo(CLI::App& verb) {
  constexpr const char* kGroup = "Camera look";
  verb.add_option("--camera-look", m_request.look,
                  "What the picture is seen through: a camera look by name (swaplight look list) or "
                  "FILE.swaplook; none: not the session's either")
      ->type_name("NAME")
      ->group(kGroup);
  verb.add_option("--filter", m_request.filters, "A filter, with its parameters; again for the next one")
      ->type_name("NAME,param=value")
      ->expected(1)
      ->take_all()
      ->group(kGroup);
  verb.add_option("--frame", m_frame,
                  "The number of a still, from which grain and flicker follow (default: 0)")
      ->check(NumberRange(-1e8, 1e8))
      ->type_name("N")
      ->group(kGroup);
  verb.add_option("--fps", m_options.framesPerSecond, "Frames a second, for filters that ask (default: 24)")
      ->check(NumberRange(0.01, 10000))
      ->type_name("X")
      ->group(kGroup);
  verb.add_option("--tile", m_options.tileSide,
                  "Longest side of the parts in which a large frame is filtered (default: 4096 pixels)")
      ->check(NumberRange(16, 16384))
      ->type_name("N")
      ->group(kGroup);
}

std::shared_ptr<CameraLook> CameraLookArguments::look(const std::optional<Session>& session,
                                                      Terminal& terminal) const {
  const bool typed = !m_request.filters.empty();
  const bool none = m_request.look == kNoLook && !typed;
  const bool ofSession = m_request.empty() && session && !session->document.cameraLook.stages.empty();
  if (none || (m_request.empty() && !ofSession)) return nullptr;
  const FilterPipeline pipeline = ofSession ? session->document.cameraLook : m_request.pipeline();
  const std::string where = typed ? "--filter" : "camera look " + pipeline.name;
  try {
    return readyLook(pipeline, where, typed, m_options, terminal);
  } catch (const ResourceError& error) {
    throw ResourceError(fmt::format("{}: {}; --camera-look none leaves it out", where, error.what()));
  }
}

std::vector<fs::path> CameraLookArguments::inputs(const CameraLook* look) const {
  std::vector<fs::path> files;
  if (look) files = look->files();
  if (isLookFile(m_request.look)) files.emplace_back(m_request.look);
  return files;
}

}  // namespace swaplight

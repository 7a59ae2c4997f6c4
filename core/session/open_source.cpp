#include "core/session/open_source.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/capture/capture_pixels.h"
#include "core/capture/response_curve.h"
#include "core/edit/apply/edited_set.h"
#include "core/file/json_file.h"
#include "core/image/io/image_io.h"
#include "core/session/session_file.h"
#include "core/set/solved_file.h"
#include "core/shadow/detect/detect_shadows.h"
#include "core/solve/solve_photographs.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr float kReadingShare = 0.2F;  // of the time that opening a capture takes

}  // namespace

fs::path sourceFile(const fs::path& path) {
  const fs::path file = fs::absolute(path).lexically_normal();
  std::error_code error;
  return fs::is_directory(file, error) ? file / "capture.json" : file;
}

SourceKind sourceKind(const fs::path& path) {
  std::error_code error;  // what cannot be looked at is none of these
  if (fs::is_directory(path, error))
    return fs::exists(path / "capture.json", error) ? SourceKind::Capture : SourceKind::Folder;
  if (isSessionFile(path)) return SourceKind::Session;
  const std::string extension = lowerExtension(path);
  if (extension == ".json") return SourceKind::Capture;
  if (extension == ".exr" && fs::exists(path, error) && isSolvedSet(path)) return SourceKind::SolvedSet;
  return SourceKind::Other;
}

std::vector<fs::path> filesOfSource(const fs::path& path) {
  std::vector<fs::path> files{path};
  if (sourceKind(path) != SourceKind::Capture) return files;
  const fs::path manifest = sourceFile(path);
  files.push_back(manifest);
  const Json json = readJson(manifest);
  const auto add = [&](const Json& object, const char* key) {
    if (object.is_object() && object.contains(key) && object[key].is_string())
      files.push_back(manifest.parent_path() / object[key].get<std::string>());
  };
  const auto addAll = [&](const Json& object, const char* key) {
    if (const auto paths = object.find(key); paths != object.end() && paths->is_object())
      for (const auto& [light, picture] : paths->items()) add(*paths, light.c_str());
  };
  for (const char* picture : {"ambient", "dark", "vignetting"}) add(json, picture);
  if (!json.is_object()) return files;
  if (const auto space = json.find("color_space"); space != json.end() && space->is_string())
    if (isResponseFile(space->get<std::string>())) add(json, "color_space");
  for (const char* list : {"shots", "left_out"})
    if (const auto shots = json.find(list); shots != json.end() && shots->is_array())
      for (const Json& shot : *shots) {
        add(shot, "image");
        if (shot.is_object()) addAll(shot, "flats");
      }
  for (const char* pictures : {"truth", "flats"}) addAll(json, pictures);
  return files;
}

std::vector<fs::path> filesOfDocument(const Document& document) {
  std::vector<fs::path> files = filesOfSource(document.source);
  files.emplace_back(document.colorConfig);
  const auto addEdits = [&](const EditStack& edits) {
    const std::vector<fs::path> read = filesOfEdits(edits);
    files.insert(files.end(), read.begin(), read.end());
  };
  const auto addLook = [&](const FilterPipeline& look) {
    const std::vector<fs::path> read = filesOfPipeline(look);
    files.insert(files.end(), read.begin(), read.end());
  };
  addEdits(document.edits);
  Edit next;
  next.mask = document.selection;
  EditStack restricted;
  restricted.append(next);
  addEdits(restricted);
  addLook(document.cameraLook);
  for (const SavedLook& look : document.looks)
    if (look.scene) {
      addEdits(look.scene->edits);
      addLook(look.scene->cameraLook);
    }
  return files;
}

SolvedSet openSource(const ColorConfig& config, const fs::path& path, const SolveOptions& options,
                     const Progress& progress) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw InputError("{}: there is no such file", path.string());
  if (error) throw InputError("{}: cannot be read ({}).", path.string(), error.message());
  switch (sourceKind(path)) {
    case SourceKind::SolvedSet:
      return readSolvedSet(path, progress,
                           options.highlights ? HighlightReading::All : HighlightReading::None);
    case SourceKind::Capture: {
      const Capture capture = readCapture(config, sourceFile(path));
      CapturePixels pixels = loadCapturePixels(config, capture, progress.part(0, kReadingShare));
      const FlatFields fields = loadFlatFields(config, capture, progress.part(kReadingShare, kReadingShare));
      return solvePhotographs(capture, std::move(pixels), fields, options, progress.part(kReadingShare, 1));
    }
    case SourceKind::Session:
    case SourceKind::Folder:
    case SourceKind::Other:
      break;
  }
  // A file that cannot be read, or is cut, says so itself.
  if (lowerExtension(path) == ".exr") static_cast<void>(readImageSpec(path));
  throw InputError(
      "{}: neither a capture nor a solved set. Open a capture.json, a solved set (EXR) or a session "
      "(.swaplight). Of photographs make a capture first: in the studio by File, New from photographs, else "
      "by `swaplight new`.",
      path.string());
}

SolvedSet withEdits(const std::shared_ptr<const SolvedSet>& set, const EditStack& edits) {
  const ShadowSource shadows = shadowSource(set, shadowOptionsOf(edits));
  return withEdits(set, edits, shadows, surfaceSource(set, shadows, edits.lampPlaces));
}

SolvedSet withEdits(const std::shared_ptr<const SolvedSet>& set, const EditStack& edits,
                    const ShadowSource& shadows, const SurfaceSource& surfaces) {
  return applyEdits(*set, fitEdits(edits, set->width(), set->height()), shadows, surfaces);
}

}  // namespace swaplight

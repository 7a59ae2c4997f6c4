#include "core/session/open_source.h"

#include <algorithm>
#include <cctype>

#include "core/capture/capture_pixels.h"
#include "core/edit/apply/edited_set.h"
#include "core/session/session_file.h"
#include "core/set/solved_file.h"
#include "core/shadow/detect/detect_shadows.h"
#include "core/solve/solve.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr float kReadingShare = 0.2F;  // of the time that opening a capture takes

std::string lowerExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

fs::path sourceFile(const fs::path& path) {
  const fs::path file = fs::absolute(path).lexically_normal();
  return fs::is_directory(file) ? file / "capture.json" : file;
}

SourceKind sourceKind(const fs::path& path) {
  if (fs::is_directory(path))
    return fs::exists(path / "capture.json") ? SourceKind::Capture : SourceKind::Folder;
  if (isSessionFile(path)) return SourceKind::Session;
  const std::string extension = lowerExtension(path);
  if (extension == ".json") return SourceKind::Capture;
  if (extension == ".exr" && fs::exists(path) && isSolvedSet(path)) return SourceKind::SolvedSet;
  return SourceKind::Other;
}

SolvedSet openSource(const ColorConfig& config, const fs::path& path, const SolveOptions& options,
                     const Progress& progress) {
  if (!fs::exists(path)) throw InputError("{}: there is no such file", path.string());
  switch (sourceKind(path)) {
    case SourceKind::SolvedSet:
      return readSolvedSet(path, progress);
    case SourceKind::Capture: {
      const Capture capture = readCapture(config, sourceFile(path));
      const CapturePixels pixels = loadCapturePixels(config, capture, progress.part(0, kReadingShare));
      return solve(capture, pixels, options, progress.part(kReadingShare, 1));
    }
    case SourceKind::Session:
    case SourceKind::Folder:
    case SourceKind::Other:
      break;
  }
  throw InputError(
      "{}: neither a capture nor a solved set. Open a capture.json, an EXR that `swaplight solve` "
      "has written, or a session (.swaplight).",
      path.string());
}

SolvedSet withEdits(const std::shared_ptr<const SolvedSet>& set, const EditStack& edits) {
  const EditStack fitted = fitEdits(edits, set->width(), set->height());
  ShadowOptions shadows;
  shadows.thresholds = fitted.shadowThresholds;
  return applyEdits(*set, fitted, shadowSource(set, shadows));
}

}  // namespace swaplight

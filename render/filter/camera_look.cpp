#include "render/filter/camera_look.h"

#include "core/base/error.h"

namespace swaplight {
namespace {

/// The program itself, and what passes through its memory, took 0.9 GiB beside it at 16K.
constexpr size_t kMostTextureBytes = size_t{512} << 20;

}  // namespace

CameraLook::CameraLook(FilterPipeline pipeline, const FilterLibrary& library, const std::string& where,
                       const CameraLookOptions& options)
    : m_pipeline(std::move(pipeline)), m_where(where), m_options(options) {
  std::vector<std::string> broken;
  for (const FilterStage& stage : m_pipeline.stages) try {
      if (stage.on) m_stages.push_back(resolveStage(library, stage, m_pipeline.folder, where));
    } catch (const InputError& error) {
      if (!m_options.leftOut) throw;
      broken.emplace_back(error.what());
    }
  if (!m_stages.empty()) {
    m_engine = std::make_unique<FilterEngine>();
    PipelineOptions readying;
    if (m_options.leftOut) readying.leftOut = [&](const std::string& line) { broken.push_back(line); };
    m_stages = m_engine->usable(m_stages, readying);
  }
  if (m_stages.empty() && !broken.empty()) failAll(broken.front());
  for (const std::string& line : broken) leaveOut(line);
}

void CameraLook::failAll(const std::string& line) const {
  throw InputError("{}; {} has no filter that can be used", line, m_where);
}

void CameraLook::leaveOut(const std::string& line) {
  {
    const std::lock_guard lock(m_mutex);
    if (!m_leftOut.insert(line).second) return;
  }
  m_options.leftOut(line);
}

FilteredImage CameraLook::apply(FilteredImage frame, const std::function<void(ImageSpan)>& displayFromScene,
                                int frameNumber, const Progress& progress) {
  if (!m_engine) return frame;
  PipelineOptions options;
  options.displayFromScene = displayFromScene;
  options.time = {frameNumber, m_options.framesPerSecond};
  options.tileSide = m_options.tileSide;
  options.mostTextureBytes = kMostTextureBytes;
  options.limitsPerTile.mostSeconds = m_options.mostSecondsPerTile;
  size_t broken = 0;
  if (m_options.leftOut)
    options.leftOut = [&](const std::string& line) {
      if (++broken == m_stages.size()) failAll(line);
      leaveOut(line);
    };
  return m_engine->apply(std::move(frame), m_stages, options, progress);
}

std::vector<std::string> CameraLook::leftOut() const {
  const std::lock_guard lock(m_mutex);
  return {m_leftOut.begin(), m_leftOut.end()};
}

std::vector<std::filesystem::path> CameraLook::files() const {
  std::vector<std::filesystem::path> files;
  for (const ResolvedStage& stage : m_stages) {
    files.push_back(stage.filter->file);
    for (const FilterValue& value : stage.values)
      if (const auto* file = std::get_if<std::string>(&value); file && !file->empty())
        files.emplace_back(*file);
  }
  return files;
}

}  // namespace swaplight

#include "render/filter/pipeline_memory.h"

#include <algorithm>

namespace swaplight {
namespace {

/// Larger frames are drawn anew: a copy of theirs would take more memory than the studio has to spare.
constexpr size_t kMostPixels = size_t{32} << 20;

}  // namespace

PipelineMemory::Plan PipelineMemory::plan(std::span<const ResolvedStage> stages, Image& frame,
                                          PictureEncoding& encoding) {
  // Parts of filters that are not the program's own agree to a thousandth only.
  const auto own = [](const ResolvedStage& stage) { return stage.filter->builtIn; };
  if (!std::all_of(stages.begin(), stages.end(), own)) {
    forget();
    return {};
  }
  const auto same = [](const ResolvedStage& a, const ResolvedStage& b) {
    return a.filter == b.filter && a.values == b.values;
  };
  const auto changed = std::mismatch(stages.begin(), stages.end(), m_last.begin(), m_last.end(), same).first;
  const auto alike = static_cast<size_t>(changed - stages.begin());
  // In the encoding that the changed filter wants; another filter in its place may want another one.
  const bool sameNext =
      m_count < stages.size() && m_count < m_last.size() && stages[m_count].filter == m_last[m_count].filter;
  if (m_count > alike || !sameNext) forget();
  m_last.assign(stages.begin(), stages.end());
  const bool keeps = alike > m_count && alike < stages.size() && frame.pixelCount() <= kMostPixels;
  const Plan plan{m_count, keeps ? alike : 0};
  if (m_count == 0) return plan;
  frame = m_frame.clone();
  encoding = m_encoding;
  return plan;
}

void PipelineMemory::keep(size_t count, const Image& frame, PictureEncoding encoding) {
  m_count = count;
  m_frame = frame.clone();
  m_encoding = encoding;
}

void PipelineMemory::forget() {
  m_last.clear();
  m_count = 0;
  m_frame = {};
}

}  // namespace swaplight

#include "core/export/cue_frames.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/export/provenance.h"
#include "core/export/timecode.h"
#include "core/file/json_file.h"
#include "core/session/open_source.h"
#include "core/shadow/detect/detect_shadows.h"

namespace swaplight {
namespace {

constexpr size_t kSetsKept = 2;  // a fade's two ends: sets are large
constexpr const char* kRigText = "swaplight/rig";

/// The document's stage with all lights of the set, as the studio has it.
Stage stageFor(const SolvedSet& set, const Document& document) {
  return {fitRig(document.rig, withNewLights(set.capture, document.edits)), document.edits};
}

}  // namespace

FrameInput animatedInput(FrameInput input, const RigAnimation& animation, int frame, int first) {
  input.rig = rigAt(input.rig, animation, frame);
  input.carried = withTimecode(input.set->carried, frame - first);
  if (const auto text = input.text.find(kRigText); text != input.text.end())
    text->second = jsonText(jsonFromRig(input.rig));
  return input;
}

CueFrames::CueFrames(std::shared_ptr<const SolvedSet> set, const Document& document, const CueTiming& timing,
                     bool withText)
    : m_set(std::move(set)),
      m_timeline(document.cues, document.looks, stageFor(*m_set, document), timing),
      m_animation(m_timeline.animation()),
      m_keyed(m_timeline.keyedRig()) {
  if (withText) m_text = provenanceOf(*m_set, m_keyed, document.source);
}

FrameInput CueFrames::at(int frame) const {
  FrameInput input;
  input.set = edited(m_timeline.at(frame).edits);
  input.rig = m_keyed;
  input.text = m_text;
  input = animatedInput(std::move(input), m_animation, frame, m_timeline.firstFrame());
  // Lights that only the edits of other cues add are dark, and not in this set.
  input.rig = fitRig(input.rig, input.set->capture);
  return input;
}

std::shared_ptr<const SolvedSet> CueFrames::edited(const EditStack& edits) const {
  if (edits == EditStack{}) return m_set;
  const std::lock_guard lock(m_mutex);  // finding shadows and applying edits use all processors anyway
  const auto kept =
      std::find_if(m_kept.begin(), m_kept.end(), [&](const Edited& k) { return k.edits == edits; });
  if (kept != m_kept.end()) return kept->set;
  const ShadowOptions finding = shadowOptionsOf(edits);
  if (!m_shadows || m_finding != finding || m_places != edits.lampPlaces) {
    if (!m_shadows || m_finding != finding) m_shadows = shadowSource(m_set, finding);
    m_surfaces = surfaceSource(m_set, m_shadows, edits.lampPlaces);
    m_finding = finding;
    m_places = edits.lampPlaces;
  }
  auto made = std::make_shared<const SolvedSet>(withEdits(m_set, edits, m_shadows, m_surfaces));
  if (m_timeline.stands(edits)) {
    m_kept.insert(m_kept.begin(), Edited{edits, made});
    if (m_kept.size() > kSetsKept) m_kept.pop_back();
  }
  return made;
}

}  // namespace swaplight

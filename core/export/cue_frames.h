#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/cue/cue_timeline.h"
#include "core/edit/mask/mask_context.h"
#include "core/export/frame_sequence.h"
#include "core/session/document.h"

namespace swaplight {

/// What changes in an input from frame to frame: the rig by its keys, the time code, the header's text of the
/// rig where it has one. `first`: the frame that the photographs' time code belongs to.
[[nodiscard]] FrameInput animatedInput(FrameInput input, const RigAnimation& animation, int frame, int first);

/// The frames of a document's cue list, for exportSequence: lights by the keys that the list stands for, as
/// `relight --key` makes them; edits as they fade. View and camera look are not the cues': they are the
/// sequence's.
class CueFrames {
 public:
  /// `set` without edits, in the working space. `withText`: for EXR headers. Throws InputError as CueTimeline
  /// does, and where a version's lights or edits do not suit the set.
  CueFrames(std::shared_ptr<const SolvedSet> set, const Document& document, const CueTiming& timing,
            bool withText);

  [[nodiscard]] const CueTimeline& timeline() const { return m_timeline; }
  /// May be called from several threads.
  [[nodiscard]] FrameInput at(int frame) const;

 private:
  /// A set with edits, kept for frames that have the same.
  struct Edited {
    EditStack edits;
    std::shared_ptr<const SolvedSet> set;
  };
  [[nodiscard]] std::shared_ptr<const SolvedSet> edited(const EditStack& edits) const;

  std::shared_ptr<const SolvedSet> m_set;
  CueTimeline m_timeline;
  RigAnimation m_animation;
  Rig m_keyed;
  std::map<std::string, std::string> m_text;  ///< for headers
  mutable std::mutex m_mutex;
  mutable std::vector<Edited> m_kept;  ///< the newest first
  mutable ShadowSource m_shadows;      ///< of the set, found so
  mutable ShadowOptions m_finding;
  mutable SurfaceSource m_surfaces;  ///< the same
  mutable LampPlaces m_places;
};

}  // namespace swaplight

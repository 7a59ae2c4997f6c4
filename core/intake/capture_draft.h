#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/intake/brackets.h"
#include "core/intake/shot_color.h"
#include "core/intake/shot_folder.h"

namespace swaplight {

/// A capture that is being described: photographs, lights, and which colour each light had in each shot.
struct CaptureDraft {
  ShotFolder folder;
  std::vector<std::string> lights;                ///< names, see checkLightNames
  std::vector<std::vector<ShotColor>> colors;     ///< [shot][light]
  std::string colorSpace;                         ///< of the pictures
  CaptureFrame frame;                             ///< the part of them that is used, and its size
  Brackets brackets = {};                         ///< which shots are exposures of one lighting
  std::map<std::string, std::string> flats = {};  ///< light: a picture of a grey card (flat_fields.h)
  std::string vignetting = {};                    ///< a picture of an evenly lit surface, or ""
  std::set<std::string> crossed = {};             ///< files of shots through crossed polarisers
  std::vector<Shot> leftOut = {};                 ///< photographs of the set that are not used

  [[nodiscard]] size_t lightings() const {
    return folder.shots.size() / static_cast<size_t>(brackets.length);
  }
};

/// A draft in which every colour is unknown; shots that the folder's capture.json marks as crossed are; the
/// folder's flat_key… is the flat picture of the light "key", its response.csv the curve of JPEG, PNG and
/// TIFF. Throws InputError: names that cannot be, colour spaces that differ.
[[nodiscard]] CaptureDraft draftOf(const ShotFolder& folder, const std::vector<std::string>& lights);

/// Groups the shots; every colour is unknown again.
void setBrackets(CaptureDraft& draft, Brackets brackets);

/// The colours that the lights had in a lighting, in all its exposures. What is unknown and has no name gets
/// one where there are several: it is the same in each.
void setLighting(CaptureDraft& draft, size_t lighting, std::vector<ShotColor> colors);

/// Stops of each shot over the first: those of the brackets, else of the files where all say them, in steps
/// of a twentieth (files round their times); else 0.
[[nodiscard]] std::vector<float> exposuresOf(const CaptureDraft& draft);

/// colorOfCard in a lighting: in its longest exposure that is not clipped there, over that exposure.
[[nodiscard]] ShotColor colorOfCard(const CaptureDraft& draft, const CapturePixels& pixels, size_t lighting,
                                    int x, int y);

/// The capture that it describes. Lights called after a role have it; otherwise, without any, the first is
/// the key and the second the fill. Exposures are those of the brackets, else of the files, where all say
/// them.
[[nodiscard]] Capture captureOf(const CaptureDraft& draft);

/// What a person should know of the pictures, at once and in words: clipped areas, a moved camera, differing
/// exposures.
[[nodiscard]] std::vector<std::string> pictureWarnings(const CaptureDraft& draft,
                                                       const CapturePixels& pixels);
/// And of the colours: what cannot be told apart, or only with noise; which are unknown, and what they are
/// assumed to be.
[[nodiscard]] std::vector<std::string> colorWarnings(const CaptureDraft& draft);

/// Writes capture.json beside the shots. Throws InputError where there is one already, unless it is to be
/// replaced, and where it cannot be written. What the one that is replaced says beyond a draft stays
/// (kept_description.h). Returns its path.
std::filesystem::path writeDraft(const CaptureDraft& draft, bool replace);

}  // namespace swaplight

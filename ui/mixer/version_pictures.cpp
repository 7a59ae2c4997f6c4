#include "ui/mixer/version_pictures.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/session/open_source.h"
#include "core/set/shrunk_set.h"
#include "ui/jobs/take_or_report.h"
#include "ui/pictures/frame_picture.h"

namespace swaplight {
namespace {

constexpr int kLongest = 320;  ///< of the small copy, in pixels: more than a thumbnail has

std::shared_ptr<const SolvedSet> smallCopy(const SolvedSet& set) {
  const int factor = std::max(1, (std::max(set.width(), set.height()) + kLongest - 1) / kLongest);
  return std::make_shared<const SolvedSet>(
      shrunkSet(set, std::max(1, set.width() / factor), std::max(1, set.height() / factor)));
}

std::shared_ptr<const SolvedSet> editedCopy(const std::shared_ptr<const SolvedSet>& small,
                                            const EditStack& edits) {
  if (edits.edits.empty() && edits.newLights.empty()) return small;
  try {
    return std::make_shared<const SolvedSet>(withEdits(small, edits));
  } catch (const InputError&) {
    return small;
  }
}

}  // namespace

VersionPictures::Drawn VersionPictures::draw(Request request, std::shared_ptr<const SolvedSet> small) {
  if (!small) small = smallCopy(*request.original);
  const auto edited = editedCopy(small, request.edits);
  SmallPicture picture = framePicture(*edited, ViewPictures(edited), *request.config, *request.table,
                                      request.rig, request.width, request.height);
  return {std::move(request), std::move(small), std::move(picture)};
}

void VersionPictures::update(Messages& messages) {
  takeOrReport(m_job, messages, "the picture of a version",
               [this](Drawn drawn) { m_drawn = std::move(drawn); });
}

std::optional<SmallPicture> VersionPictures::picture(const LightsContext& studio, const SavedLook& version,
                                                     const std::shared_ptr<const DisplayTable>& table,
                                                     int width, int height) {
  Request request{studio.set()->original,
                  studio.colors.config(),
                  table,
                  version.rig,
                  version.scene->edits,
                  width,
                  height};
  if (m_drawn && m_drawn->of == request) return m_drawn->picture;
  if (m_job.running() || m_asked == request) return std::nullopt;
  const bool known = m_drawn && m_drawn->of.original == request.original;
  m_asked = request;
  m_job.start([request = std::move(request),
               small = known ? m_drawn->small : nullptr](const Progress&) { return draw(request, small); },
              m_wake);
  return std::nullopt;
}

}  // namespace swaplight

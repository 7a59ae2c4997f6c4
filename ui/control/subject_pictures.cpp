#include "ui/control/subject_pictures.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/capture/capture_pixels.h"
#include "core/view/subject_image.h"

namespace swaplight {
namespace {

constexpr size_t kKeptPictures = 2;

bool followsEdits(const ViewSubject& subject) {
  return subject.kind == ViewSubject::Kind::Beta || subject.kind == ViewSubject::Kind::Reflectance ||
         ofHighlights(subject);
}

Image readPhotograph(const ColorConfig& config, Capture capture, int shot, const Image& like,
                     const Progress& progress) {
  capture.shots = {capture.shots.at(static_cast<size_t>(shot))};
  capture.ambient.reset();
  CapturePixels pixels = loadCapturePixels(config, capture, progress);
  Image& image = pixels.shots.front();
  if (image.width() != like.width() || image.height() != like.height())
    throw InputError("{}: the photograph is {} x {}, the set {} x {}", capture.shots.front().image,
                     image.width(), image.height(), like.width(), like.height());
  return std::move(image);
}

}  // namespace

const SubjectPictures::Shown* SubjectPictures::picture(const std::shared_ptr<const ColorConfig>& config,
                                                       const OpenSet& set, const ViewSubject& subject) {
  const auto found = std::find_if(m_shown.begin(), m_shown.end(),
                                  [&](const Shown& shown) { return shown.subject == subject; });
  if (found != m_shown.end()) {
    m_shown.splice(m_shown.end(), m_shown, found);
    return &m_shown.back();
  }
  // The quality is that of the solve: edits have none.
  if (subject.kind != ViewSubject::Kind::Photograph)
    return &keep(subject, subjectImage(followsEdits(subject) ? set.solved() : *set.original, subject));
  const bool failed = std::find(m_failed.begin(), m_failed.end(), subject) != m_failed.end();
  if (failed || m_job.running()) return nullptr;
  m_reading = subject;
  m_stale = false;
  m_job.start(
      [config, solved = set.original, shot = subject.index](const Progress& progress) {
        return readPhotograph(*config, solved->capture, shot, solved->contributions.front(), progress);
      },
      m_wake);
  return nullptr;
}

void SubjectPictures::update(Messages& messages) {
  const Taken taken = takeOrReport(m_job, messages, "this photograph", [this](Image image) {
    if (!m_stale) keep(m_reading, std::move(image));
  });
  if (taken == Taken::Failed && !m_stale) m_failed.push_back(m_reading);
  m_illumination.update(messages);
}

void SubjectPictures::editsChanged() {
  m_illumination.editsChanged();
  m_shown.remove_if([](const Shown& shown) { return followsEdits(shown.subject); });
}

void SubjectPictures::forget() {
  m_job.cancel();
  m_stale = m_job.running();
  m_shown.clear();
  m_failed.clear();
  m_illumination.forget();
}

const SubjectPictures::Shown& SubjectPictures::keep(const ViewSubject& subject, Image image) {
  if (m_shown.size() == kKeptPictures) m_shown.pop_front();
  Shown shown{subject, std::move(image), nullptr};
  shown.pyramid = std::make_unique<Pyramid>(shown.image.view());
  m_shown.push_back(std::move(shown));
  return m_shown.back();
}

}  // namespace swaplight

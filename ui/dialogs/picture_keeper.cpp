#include "ui/dialogs/picture_keeper.h"

#include <algorithm>
#include <cmath>

#include "ui/pictures/frame_picture.h"

namespace swaplight {
namespace {

constexpr std::chrono::seconds kStill{1};
constexpr int kWidth = 480, kHeight = 270;  // for the largest screens

SmallPicture pictureOf(const LiveSet& live, const ColorConfig& config, const Document& document) {
  const LiveSet::Reading reading = live.read();
  ViewSettings settings;
  settings.display = displayWithin(config, document.display);
  const DisplayTable table(config, reading.set().colorSpace(), settings);
  const ViewPictures& pictures = reading.pictures();
  const double scale = fitZoom(pictures.width(), pictures.height(), kWidth, kHeight);
  const auto across = [scale](int length) {
    return std::max(1, static_cast<int>(std::lround(length * scale)));
  };
  return framePicture(reading.set(), pictures, config, table, document.rig, across(pictures.width()),
                      across(pictures.height()));
}

}  // namespace

void PictureKeeper::update(const LightsContext& studio) {
  try {
    if (m_writing.take()) ++m_count;
  } catch (const std::exception&) {
    return;  // a picture that is not there is worth no message
  }
  const OpenSet* set = studio.set();
  const std::vector<std::filesystem::path>& files = studio.session.recent().files();
  if (set == nullptr || files.empty()) return;
  const Shown shown{files.front(), studio.session.setRevision(), studio.editor.revision()};
  const auto now = std::chrono::steady_clock::now();
  if (shown != m_shown) m_since = now;
  m_shown = shown;
  if (shown == m_written || now - m_since < kStill || m_writing.running() || studio.editor.inGesture())
    return;
  m_written = shown;
  m_writing.start(
      [kept = m_kept, files, live = set->live, config = studio.colors.config(),
       document = studio.document()](const Progress&) {
        kept.keep(files.front(), pictureOf(*live, *config, document));
        kept.keepOnly(files);
        return true;
      },
      m_wake);
}

}  // namespace swaplight

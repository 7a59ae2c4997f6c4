#include "ui/dialogs/picture_keeper.h"

#include <algorithm>
#include <cmath>

#include "ui/pictures/frame_picture.h"

namespace swaplight {
namespace {

constexpr std::chrono::seconds kStill{1};
constexpr int kWidth = 480, kHeight = 270;  // for the largest screens

}  // namespace

void PictureKeeper::update(const LightsContext& studio) {
  try {
    static_cast<void>(m_writing.take());
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
  const auto table =
      studio.table.table(studio.colors.config(), set->solved().colorSpace(), studio.document().display);
  const double scale = fitZoom(set->pictures().width(), set->pictures().height(), kWidth, kHeight);
  const auto across = [scale](int length) {
    return std::max(1, static_cast<int>(std::lround(length * scale)));
  };
  m_writing.start(
      [kept = m_kept, files,
       picture =
           framePicture(*set->live, *studio.colors.config(), *table, studio.document().rig,
                        across(set->pictures().width()), across(set->pictures().height()))](const Progress&) {
        kept.keep(files.front(), picture);
        kept.keepOnly(files);
        return true;
      },
      m_wake);
}

}  // namespace swaplight

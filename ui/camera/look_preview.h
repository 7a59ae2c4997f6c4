#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/filter/filter_library.h"
#include "render/viewport_renderer.h"
#include "ui/camera/draft_size.h"
#include "ui/camera/seen_picture.h"
#include "ui/camera/seen_request.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"

namespace swaplight {

class FilterEngine;
class PipelineMemory;

/// The frame under the document's camera look, for the viewer: drawn in a thread with an OpenGL context of
/// its own, so that no filter holds the window up. While something is dragged it is drawn small enough to
/// follow the hand, and a draft that takes less than a frame is waited for; as soon as nothing is held, it is
/// drawn at full size, by the same filters as `relight` and `export` use. Of a frame that stays the same only
/// the filters from the changed one on are drawn again.
class LookPreview {
 public:
  /// The two sides of a comparison.
  enum class Side { A, B };
  struct SeenOptions {
    bool settled = true;   ///< nothing is being dragged
    bool asLarge = false;  ///< drafts are enlarged to the frame's size, to be compared pixel by pixel
  };

  explicit LookPreview(std::function<void()> wake);
  LookPreview(const LookPreview&) = delete;
  LookPreview& operator=(const LookPreview&) = delete;
  ~LookPreview();

  /// What there is of it: the last picture that was drawn for this set, which may still be of an earlier
  /// request; nothing before the first one, or where it cannot be drawn.
  std::optional<LayeredPicture> picture(Side side, const SeenRequest& request, SeenOptions options);
  /// The picture that picture() last gave for this request, or of an earlier one; nullptr where it gives
  /// none.
  [[nodiscard]] std::shared_ptr<const SeenPicture> shown(Side side, const SeenRequest& request) const;
  /// What is shown there is what was asked for last; `exact`: at full size, too.
  [[nodiscard]] bool follows(Side side, bool exact = false) const;
  /// Counts up with every picture that is drawn.
  [[nodiscard]] int count() const { return m_count; }
  /// To be called often: takes what was drawn.
  void update(Messages& messages);
  /// Another set is open.
  void forget();
  /// Nothing of it is shown: lets go of it, unless it is of these pixels, to be shown again at once.
  void releaseOtherSet(Side side, const std::shared_ptr<const LiveSet>& live);
  /// A picture is being drawn.
  [[nodiscard]] bool busy() const;

  /// The filters that there are; read when first asked for.
  FilterLibrary& library();
  /// A file of the library has changed.
  void readLibraryAgain() { m_library.reset(); }
  [[nodiscard]] bool libraryRead() const { return m_library.has_value(); }
  /// Why a filter of the last picture was left out, a line each.
  [[nodiscard]] const std::vector<std::string>& leftOut() const { return m_leftOut; }
  /// Of the last picture: its number, the part of the full width at which it was drawn, milliseconds of its
  /// filters, and from when it was asked for until it was there. For measuring.
  [[nodiscard]] const std::string& words() const { return m_words; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Engine;
  struct Drawing;
  struct Drawn {
    Image image;
    std::optional<Pyramid> pyramid;  ///< of the image
    std::string colorSpace;          ///< empty: codes for a display
    std::vector<std::string> leftOut;
    double seconds = 0;  ///< of all of it
    double filterSeconds = 0;
  };
  /// What is kept of the filters before the one that is being changed, of one frame at one size.
  struct Kept {
    SeenRequest frame;  ///< without a look
    float scale = 0;
    std::shared_ptr<PipelineMemory> memory;
  };
  struct Place {
    SeenRequest asked, making, shown, failed;
    float makingScale = 1, shownScale = 0;  ///< 0: nothing is shown
    Kept draft, exact;
    std::array<std::shared_ptr<SeenPicture>, 2> pictures{std::make_shared<SeenPicture>(),
                                                         std::make_shared<SeenPicture>()};
    size_t front = 0;
    bool settled = true;
    Clock::time_point askedAt, makingSince;  ///< when this request was first asked for
    Job<Drawn> job;
  };

  static void forget(Place& place);
  void advance(Place& place);
  void start(Place& place, float scale);
  void waitForDraft(Place& place);
  void take(Place& place);
  void adopt(Place& place, Drawn drawn);
  [[nodiscard]] float draftScale(const SeenRequest& request);
  [[nodiscard]] Drawing drawingOf(Place& place, float scale);
  [[nodiscard]] static Drawn draw(const Drawing& drawing, const Progress& progress);

  std::function<void()> m_wake;
  std::optional<FilterLibrary> m_library;
  std::shared_ptr<Engine> m_engine;
  std::array<Place, 2> m_places;
  DraftSize m_draftSize;
  std::vector<std::string> m_leftOut, m_toWarn, m_toReport;
  std::set<std::string> m_said;
  int m_count = 0;
  std::string m_words;
};

}  // namespace swaplight

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/filter/filter_library.h"
#include "render/surface.h"
#include "ui/camera/seen_request.h"
#include "ui/jobs/job.h"

namespace swaplight {

class FilterEngine;

/// Small pictures of the frame that is open, seen through filters: for the lists of filters. They are drawn
/// one by one in a thread, when nothing else waits for it, and again when the frame changes; until then the
/// last ones are shown.
class LookThumbnails {
 public:
  explicit LookThumbnails(std::function<void()> wake);
  LookThumbnails(const LookThumbnails&) = delete;
  LookThumbnails& operator=(const LookThumbnails&) = delete;
  ~LookThumbnails();

  /// A picture for the screen.
  struct Shown {
    unsigned texture = 0;  ///< 0: there is none yet, or the filters are broken
    int width = 0, height = 0;
  };
  /// The frame through these filters, `height` pixels high. To be asked for in every frame that shows it;
  /// `key` tells pictures apart.
  Shown picture(const std::string& key, const FilterPipeline& look, int height);

  /// What picture() asks for from here on is what is to be drawn.
  void beginFrame() { ++m_frameCount; }
  /// To be called often. `frame`: without its look; nothing where no set is open. `idle`: there is time.
  void update(const std::optional<SeenRequest>& frame, bool idle, FilterLibrary& library);
  /// Pictures that are asked for and not yet drawn.
  [[nodiscard]] size_t pending() const;
  /// Another set is open.
  void forget();
  /// None are shown: lets go of them, unless they are of these pixels.
  void releaseOtherSet(const std::shared_ptr<const LiveSet>& live);

 private:
  struct Entry {
    FilterPipeline look, drawnLook;
    int height = 0, drawnHeight = 0;
    int drawnOf = 0;  ///< m_frame's number
    uint64_t asked = 0;
    SurfaceTexture texture;
    Shown shown;
  };
  struct Engine;
  struct Drawn {
    std::shared_ptr<const Image> light;
    std::string key;
    FilterPipeline look;
    int frame = 0, width = 0, height = 0;
    std::vector<uint8_t> rgba;  ///< empty: a filter is broken
  };

  [[nodiscard]] bool isWanted(const Entry& entry) const;
  void take();
  void start(const std::string& key, const Entry& entry, FilterLibrary& library);

  std::function<void()> m_wake;
  std::shared_ptr<Engine> m_engine;
  std::optional<SeenRequest> m_frame;
  int m_frameNumber = 0;                 ///< of m_frame, from 1
  std::shared_ptr<const Image> m_light;  ///< m_frame, small; none before the first picture of it
  uint64_t m_frameCount = 0;
  std::map<std::string, Entry> m_entries;
  bool m_failed = false;  ///< there is no OpenGL
  Job<Drawn> m_job;
};

}  // namespace swaplight

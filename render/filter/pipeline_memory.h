#pragma once

#include <span>
#include <vector>

#include "core/filter/filter_library.h"
#include "core/image/image.h"
#include "render/filter/filter_program.h"

namespace swaplight {

/// What a picture's values are, on their way through a pipeline.
enum class PictureEncoding { SceneLight, DisplayCodes, DisplayLight };

/// What the filters before the one that is being changed have made of a frame, so that only the filters from
/// the changed one on are drawn again: the same to the bit, and therefore of the program's own filters only.
/// Of one frame, one view and one time; a frame that changes wants another memory.
class PipelineMemory {
 public:
  /// Where drawing is to begin, and after how many filters (0: none) keep() is to be called.
  struct Plan {
    size_t begin = 0, keepAfter = 0;
  };
  /// Begins with what is kept, where it is of these stages' beginning: then it replaces `frame`.
  Plan plan(std::span<const ResolvedStage> stages, Image& frame, PictureEncoding& encoding);
  /// After `count` filters the frame is this, in the encoding that the next filter wants.
  void keep(size_t count, const Image& frame, PictureEncoding encoding);
  void forget();

 private:
  std::vector<ResolvedStage> m_last;  ///< that were drawn
  size_t m_count = 0;                 ///< of filters that have made m_frame; 0: there is none
  Image m_frame;
  PictureEncoding m_encoding = PictureEncoding::SceneLight;
};

}  // namespace swaplight

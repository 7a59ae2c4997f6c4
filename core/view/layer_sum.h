#pragma once

#include <vector>

#include "core/color/rgb.h"
#include "core/image/image.h"
#include "core/view/pyramid.h"

namespace swaplight {

/// What is seen of a layer: pixels of three channels, or of one that counts for all three, times a factor.
struct VisibleLayer {
  const Pyramid* picture = nullptr;  ///< whose pixels they are
  ImageView pixels;
  Rgb factor{1, 1, 1};
};

/// Adds up layers. Remembers the sum of those that stay while others change, so that one slider costs the
/// same for any number of lights.
class LayerSum {
 public:
  /// Says what is to be added up from now on. All layers have one size.
  void set(std::vector<VisibleLayer> layers);
  /// To be called when a picture's pixels have changed where they are.
  void pixelsChanged(const Pyramid& picture);
  void forget();

  /// A channel of a row of the sum. From any thread.
  void row(int channel, int y, float* out) const;

 private:
  void rememberOthers();

  std::vector<VisibleLayer> m_layers;
  std::vector<char> m_stale;     ///< layers whose pixels have changed since set()
  std::vector<char> m_changing;  ///< layers that are not in m_others; empty: there is no m_others
  Image m_others;
};

}  // namespace swaplight

#pragma once

#include <vector>

#include "core/image/image.h"
#include "core/view/view_layer.h"

namespace swaplight {

/// What is seen of a layer.
struct VisibleLayer : ViewLayer {
  VisibleLayer(const ViewLayer& layer, ImageView seen) : ViewLayer(layer), pixels(seen) {}
  ImageView pixels;  ///< of its picture
};

/// Adds up layers. Remembers the sum of those that stay while others change, so that one slider costs the
/// same for any number of lights.
class LayerSum {
 public:
  /// Says what is to be added up from now on. All layers have one size.
  void set(std::vector<VisibleLayer> layers);
  /// To be called when a picture's pixels have changed where they are.
  void pixelsChanged(const Pyramid& picture);

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

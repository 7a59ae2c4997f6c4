#pragma once

#include <optional>
#include <string>

#include "ui/kit/layout_probe.h"

namespace swaplight {

/// Five steps for who is here for the first time: a card beside the thing that it is about, over the studio
/// as it is, which goes on working below.
class Tour {
 public:
  void start();
  void stop() { m_step.reset(); }
  [[nodiscard]] bool going() const { return m_step.has_value(); }
  /// `light`: the name of the set's first light; empty as long as no set is open. True where what it points
  /// at has come to another place, so that another frame is wanted.
  bool draw(const std::string& light);

 private:
  void drawButtons();

  std::optional<size_t> m_step;
  std::optional<ItemRect> m_about;  ///< in the last frame
};

}  // namespace swaplight

#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <string>

#include "core/color/rgb.h"
#include "core/ocio/color_config.h"
#include "core/view/display/view_settings.h"
#include "core/view/view_window.h"
#include "render/display_program.h"
#include "render/gl/tiled_texture.h"
#include "render/view_target.h"

namespace swaplight {

/// Shows linear pictures on the graphics card, as 8-bit display codes. Enlarged pictures show their pixels as
/// squares; shrunk ones are read from halved pictures and interpolated. Needs the context in which it was
/// made.
class ViewRenderer {
 public:
  /// `config` must outlive it. `colorSpace` is that of the pictures; empty: they are data, shown without a
  /// view.
  ViewRenderer(const ColorConfig& config, std::string colorSpace);

  /// Draws over what is in the target, where there is a picture. Throws InputError where the configuration
  /// lacks the display, the view or a look.
  struct Part {
    glm::vec3 side{0, 0, 1};  ///< only where side.x * x + side.y * y + side.z >= 0, for a pixel's centre
    bool absolute = false;    ///< the picture is a difference, of which the size is shown
  };
  void draw(TiledTexture& picture, const ViewWindow& window, const ViewSettings& settings, const Part& part,
            ViewTarget& target);
  /// A whole picture; the target gets the window's size, and is transparent where there is no picture.
  void draw(TiledTexture& picture, const ViewWindow& window, const ViewSettings& settings,
            ViewTarget& target);

 private:
  const DisplayProgram& programFor(const ViewSettings& settings);

  const ColorConfig& m_config;
  std::string m_colorSpace;
  Rgb m_luminanceWeights;
  std::map<DisplayChoice, DisplayProgram> m_programs;
  GlVertexArray m_vertexArray;
};

}  // namespace swaplight

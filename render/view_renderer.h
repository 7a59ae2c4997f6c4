#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/color/color_config.h"
#include "core/color/rgb.h"
#include "core/view/view_settings.h"
#include "core/view/view_window.h"
#include "render/display_program.h"
#include "render/tiled_texture.h"

namespace swaplight {

/// Shows linear pictures on the graphics card: into a texture of the window's size, as 8-bit display codes.
/// Enlarged pictures show their pixels as squares; shrunk ones are read from halved pictures and
/// interpolated. Needs the context in which it was made.
class ViewRenderer {
 public:
  /// `config` must outlive it; `colorSpace` is that of the pictures.
  ViewRenderer(const ColorConfig& config, std::string colorSpace);

  /// The texture (row 0 is the top; transparent where there is no picture), valid until the next call. Throws
  /// InputError where the configuration lacks the display or the view.
  unsigned draw(TiledTexture& picture, const ViewWindow& window, const ViewSettings& settings);
  /// The same for maps that are data: no view.
  unsigned drawData(TiledTexture& picture, const ViewWindow& window, const ViewSettings& settings);

  /// What was drawn last: 8-bit R G B A from the top, window.width * window.height of them.
  [[nodiscard]] std::vector<uint8_t> readback() const;

 private:
  unsigned drawWith(const DisplayProgram& display, TiledTexture& picture, const ViewWindow& window,
                    const ViewSettings& settings);
  void resize(int width, int height);

  const ColorConfig& m_config;
  std::string m_colorSpace;
  Rgb m_luminanceWeights;
  std::map<std::pair<std::string, std::string>, DisplayProgram> m_programs;  ///< by display and view
  DisplayProgram m_data;
  GlVertexArray m_vertexArray;
  GlTexture m_target;
  GlFramebuffer m_framebuffer;
  int m_width = 0;
  int m_height = 0;
};

}  // namespace swaplight

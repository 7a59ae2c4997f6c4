#pragma once

#include <string>
#include <vector>

#include "core/ocio/color_config.h"
#include "render/gl/gl_handle.h"
#include "render/gl/shader_program.h"

namespace swaplight {

/// The shader that shows a linear picture through one view of a colour configuration: OpenColorIO writes its
/// middle part and the tables that go with it. Where the view is graded, the grade is the only thing that can
/// change without another program.
class DisplayProgram {
 public:
  DisplayProgram() = default;
  /// Throws InputError where the configuration lacks the space, the display, the view or a look.
  DisplayProgram(const ColorConfig& config, const std::string& colorSpace, const DisplayChoice& choice);
  /// Shows values as they are: for maps that are data.
  [[nodiscard]] static DisplayProgram forData();

  [[nodiscard]] const ShaderProgram& program() const { return m_program; }
  /// The grade to draw with, of a view that was made with one. To be called while the program is bound.
  void setGrade(const ColorGrade& grade) const;

  /// A table of the view, to be bound while drawing.
  struct Table {
    std::string sampler;
    unsigned target = 0;  ///< GL_TEXTURE_1D, _2D, _3D
    GlTexture texture;
  };
  [[nodiscard]] const std::vector<Table>& tables() const { return m_tables; }

 private:
  ShaderProgram m_program;
  std::vector<Table> m_tables;
};

}  // namespace swaplight

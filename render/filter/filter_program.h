#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "core/filter/filter_library.h"
#include "render/filter/filter_texture.h"
#include "render/gl/shader_program.h"

namespace swaplight {

/// Where in time a frame stands. Grain and flicker follow from it alone, so that every machine of a farm
/// draws the same.
struct FilterTime {
  int frame = 0;
  double framesPerSecond = 24;
  bool operator==(const FilterTime&) const = default;
};

/// What a filter is held to.
struct FilterLimits {
  double mostSeconds = 20;  ///< for a filter that is not the program's own
  float notANumber = 0;     ///< stands where a filter computes no number; another value makes those visible
};

/// Pictures that a filter reads, by the names that its shader gives them.
using FilterPictures = std::map<std::string, std::shared_ptr<const FilterTexture>>;

/// A filter, compiled for the current OpenGL context.
class FilterProgram {
 public:
  /// For frames and targets that are textures of this kind; other pictures are read by coordinates. Throws
  /// InputError that names the filter's file and the line where it does not compile.
  explicit FilterProgram(std::shared_ptr<const Filter> filter, TextureKind kind = TextureKind::Coordinates);

  [[nodiscard]] const Filter& filter() const { return *m_filter; }
  /// Whether a part of the frame can be drawn from that part and its halo.
  [[nodiscard]] bool tiles() const;
  /// How far a pixel looks, in pixels of a frame of this size; 0 where it looks at itself alone.
  [[nodiscard]] int halo(std::span<const FilterValue> values, int wholeWidth, int wholeHeight) const;

  /// Draws the window `output`, all passes of it, from an input that holds it and its halo. `values` as
  /// filter().inputs. Throws InputError where it takes longer than it may, and ResourceError where graphics
  /// memory is short.
  [[nodiscard]] FilterTexture draw(const FilterTexture& input, const FilterWindow& output,
                                   std::span<const FilterValue> values, const FilterPictures& pictures,
                                   const FilterTime& time, const FilterLimits& limits) const;
  /// The pixels of all textures that are held while this is drawn, input and result included.
  [[nodiscard]] size_t pixelsHeld(const FilterWindow& input, const FilterWindow& output,
                                  std::span<const FilterValue> values) const;

 private:
  struct Drawing;
  void compile(TextureKind kind, std::optional<int> pass);
  void compileForAnyPass(TextureKind kind);  ///< what does not compile for one
  [[nodiscard]] FilterWindow windowOf(const FilterPass& pass, std::span<const FilterValue> values,
                                      const FilterWindow& input) const;
  void drawPass(int index, const FilterTexture& target, Drawing& drawing) const;
  void drawStrips(const FilterTexture& target, Drawing& drawing) const;

  std::shared_ptr<const Filter> m_filter;
  std::vector<std::string> m_images;
  bool m_looksElsewhere = false;
  std::vector<ShaderProgram> m_programs;  ///< of each pass
  GlVertexArray m_vertexArray;
};

}  // namespace swaplight

#include "render/filter/filter_program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/error.h"
#include "core/filter/glsl/glsl_translation.h"
#include "core/filter/size_expression.h"
#include "render/filter/filter_uniforms.h"
#include "render/gl/gl_info.h"
#include "render/gl/gl_scope.h"

namespace swaplight {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::optional<double> numberOf(const FilterValue& value) {
  if (const auto* number = std::get_if<float>(&value)) return *number;
  if (const auto* choice = std::get_if<int>(&value)) return *choice;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? 1 : 0;
  return {};
}

double evaluate(const Filter& filter, std::span<const FilterValue> values, const std::string& expression,
                int width, int height) {
  return expressionValue(expression, [&](const std::string& name) -> std::optional<double> {
    if (name == "WIDTH") return width;
    if (name == "HEIGHT") return height;
    for (size_t i = 0; i < filter.inputs.size(); ++i)
      if (filter.inputs[i].name == name) return numberOf(values[i]);
    return {};
  });
}

bool read(std::span<const ShaderProgram> passes, const std::string& image) {
  return std::any_of(passes.begin(), passes.end(),
                     [&](const ShaderProgram& pass) { return pass.hasUniform(image); });
}

}  // namespace

struct FilterProgram::Drawing {
  const FilterTexture& input;
  std::span<const FilterValue> values;
  const FilterPictures& pictures;
  const FilterTime& time;
  const FilterLimits& limits;
  Clock::time_point begin = Clock::now();
  std::map<std::string, FilterTexture> targets = {};
  std::map<TextureKind, FilterTexture> black = {};

  /// Stands for a picture that is missing, and for a target that is not drawn yet.
  const FilterTexture& blackOf(TextureKind kind) {
    FilterTexture& texture = black[kind];
    if (!texture) {
      texture = FilterTexture(FilterWindow::whole(1, 1), kind);
      texture.clear();
    }
    return texture;
  }
};

FilterProgram::FilterProgram(std::shared_ptr<const Filter> filter, TextureKind kind)
    : m_filter(std::move(filter)), m_vertexArray(GlVertexArray::make()) {
  for (size_t pass = 0; pass < m_filter->passes.size(); ++pass) {
    try {
      compile(kind, static_cast<int>(pass));
    } catch (const std::runtime_error&) {
      compileForAnyPass(kind);
    }
  }
}

void FilterProgram::compile(TextureKind kind, std::optional<int> pass) {
  GlslTranslation translation =
      translateFilter(*m_filter, {m_filter->builtIn, kind == TextureKind::Pixels, pass});
  m_programs.push_back(ShaderProgram::fromSources(translation.vertex, translation.fragment));
  m_images = std::move(translation.images);
  m_looksElsewhere = translation.looksElsewhere;
}

void FilterProgram::compileForAnyPass(TextureKind kind) {
  try {
    compile(kind, {});
  } catch (const std::runtime_error& error) {
    throw InputError("{}", compileErrorLine(error.what(), m_filter->file.string()));
  }
}

bool FilterProgram::tiles() const {
  return m_filter->halo || (!m_looksElsewhere && m_filter->passes.size() == 1);
}

int FilterProgram::halo(std::span<const FilterValue> values, int wholeWidth, int wholeHeight) const {
  if (!m_filter->halo) return 0;
  const double pixels = evaluate(*m_filter, values, *m_filter->halo, wholeWidth, wholeHeight);
  return static_cast<int>(std::clamp(std::ceil(pixels), 0.0, 1e5));
}

FilterWindow FilterProgram::windowOf(const FilterPass& pass, std::span<const FilterValue> values,
                                     const FilterWindow& in) const {
  const auto side = [&](const std::string& expression, int standard) {
    if (expression.empty()) return standard;
    const double value = evaluate(*m_filter, values, expression, in.wholeWidth, in.wholeHeight);
    return static_cast<int>(std::clamp(std::floor(value), 1.0, 32768.0));
  };
  const int width = side(pass.widthExpression, in.wholeWidth);
  const int height = side(pass.heightExpression, in.wholeHeight);
  // The pass's own grid of pixels is that of the whole frame, whatever part of it is drawn.
  const auto scaled = [](int pixel, int of, int whole, bool up) {
    const auto product = static_cast<int64_t>(pixel) * of;
    return static_cast<int>((product + (up ? whole - 1 : 0)) / whole);
  };
  FilterWindow window{scaled(in.x, width, in.wholeWidth, false),
                      scaled(in.y, height, in.wholeHeight, false),
                      0,
                      0,
                      width,
                      height};
  window.width = scaled(in.x + in.width, width, in.wholeWidth, true) - window.x;
  window.height = scaled(in.y + in.height, height, in.wholeHeight, true) - window.y;
  return window;
}

void FilterProgram::drawPass(int index, const FilterTexture& target, Drawing& drawing) const {
  const FilterPass& pass = m_filter->passes[static_cast<size_t>(index)];
  const ShaderProgram& program = m_programs[static_cast<size_t>(index)];
  const FilterWindow& window = target.window();
  const auto set = [&](const std::string& name, const UniformValue& value) {
    if (program.hasUniform(name)) program.set({{name, value}});
  };
  const BoundProgram use(program.id(), m_vertexArray.id());
  for (size_t i = 0; i < m_filter->inputs.size(); ++i)
    setFilterInput(program, m_filter->inputs[i], drawing.values[i]);
  BoundTextures bound;
  for (const std::string& image : m_images) {
    const FilterTexture* texture = nullptr;
    if (const auto found = drawing.targets.find(image); found != drawing.targets.end())
      texture = &found->second;
    else if (const auto picture = drawing.pictures.find(image); picture != drawing.pictures.end())
      texture = picture->second.get();
    else if (image == "inputImage")
      texture = &drawing.input;
    FilterWindow place = texture ? texture->window() : FilterWindow::whole(1, 1);
    if (!texture) {
      const auto other = std::find_if(m_filter->passes.begin(), m_filter->passes.end(),
                                      [&](const FilterPass& each) { return each.target == image; });
      const bool isTarget = other != m_filter->passes.end();  // not drawn yet: black, and of its size
      if (isTarget) place = windowOf(*other, drawing.values, drawing.input.window());
      if (program.hasUniform(image))
        texture = &drawing.blackOf(isTarget ? drawing.input.kind() : TextureKind::Coordinates);
    }
    if (program.hasUniform(image)) set(image, bound.add(texture->target(), texture->texture()));
    set("isf_window_" + image, glm::vec4(place.x, place.y, place.wholeWidth, place.wholeHeight));
  }
  const double seconds = drawing.time.frame / drawing.time.framesPerSecond;
  const bool display = m_filter->space == FilterSpace::Display && !pass.isFloat;
  set("RENDERSIZE", glm::vec2(window.wholeWidth, window.wholeHeight));
  set("TIME", static_cast<float>(seconds));
  set("TIMEDELTA", static_cast<float>(1 / drawing.time.framesPerSecond));
  set("DATE", glm::vec4(1970, 1, 1, static_cast<float>(seconds)));  // no clock: every run draws the same
  set("FRAMEINDEX", drawing.time.frame);
  set("PASSINDEX", index);
  set("isf_origin", glm::vec2(window.x, window.y));
  set("isf_target", glm::vec4(window.x, window.y, window.width, window.height));
  set("isf_notANumber", drawing.limits.notANumber);
  set("isf_bounds",
      display ? glm::vec2(0, 1) : glm::vec2(-FilterTexture::kBrightest, FilterTexture::kBrightest));
  drawStrips(target, drawing);
}

/// A filter of unknown origin is drawn in strips of rows, between which the clock is looked at.
void FilterProgram::drawStrips(const FilterTexture& target, Drawing& drawing) const {
  constexpr int kFirstStrip = 8;
  constexpr double kStripSeconds = 0.1;
  const FilterWindow& window = target.window();
  const OverwriteState overwrite;
  const BoundFramebuffer bound(target.framebuffer(), window.width, window.height);
  const Capability scissor(GL_SCISSOR_TEST, true);
  int rows = m_filter->builtIn ? window.height : kFirstStrip;
  for (int y = 0; y < window.height;) {
    const Clock::time_point begin = Clock::now();
    glScissor(0, y, window.width, rows);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    y += rows;
    if (m_filter->builtIn) continue;
    finishGl();
    if (secondsSince(drawing.begin) > drawing.limits.mostSeconds)
      throw InputError(
          "{}: takes longer than {:.3g} s for {} x {} pixels, and was stopped; look for a loop that does not "
          "end, "
          "or allow it more time",
          m_filter->file.string(), drawing.limits.mostSeconds, window.width, window.height);
    if (secondsSince(begin) < kStripSeconds) rows *= 2;
  }
}

FilterTexture FilterProgram::draw(const FilterTexture& input, const FilterWindow& output,
                                  std::span<const FilterValue> values, const FilterPictures& pictures,
                                  const FilterTime& time, const FilterLimits& limits) const {
  Drawing drawing{input, values, pictures, time, limits};
  const int last = static_cast<int>(m_filter->passes.size()) - 1;
  for (int i = 0; i < last; ++i) {
    const FilterPass& pass = m_filter->passes[static_cast<size_t>(i)];
    FilterTexture target(windowOf(pass, values, input.window()),
                         input.kind());  // a new one: the pass may read what stood there before
    drawPass(i, target, drawing);
    drawing.targets[pass.target] = std::move(target);
    const auto later = std::span(m_programs).subspan(static_cast<size_t>(i) + 1);
    std::erase_if(drawing.targets, [&](const auto& drawn) { return !read(later, drawn.first); });
  }
  FilterTexture result(output, input.kind());
  drawPass(last, result, drawing);
  checkGl("while a filter is drawn");
  return result;
}

size_t FilterProgram::pixelsHeld(const FilterWindow& input, const FilterWindow& output,
                                 std::span<const FilterValue> values) const {
  std::map<std::string, size_t> targets;
  const auto held = [&] {
    size_t pixels = input.pixelCount();
    for (const auto& [name, count] : targets) pixels += count;
    return pixels;
  };
  size_t most = 0;
  for (size_t i = 0; i + 1 < m_programs.size(); ++i) {  // as draw() does
    const FilterPass& pass = m_filter->passes[i];
    const size_t drawn = windowOf(pass, values, input).pixelCount();
    most = std::max(most, held() + drawn);
    targets[pass.target] = drawn;
    const auto later = std::span(m_programs).subspan(i + 1);
    std::erase_if(targets, [&](const auto& target) { return !read(later, target.first); });
  }
  return std::max(most, held() + output.pixelCount());
}

}  // namespace swaplight

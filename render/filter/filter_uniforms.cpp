#include "render/filter/filter_uniforms.h"

#include <span>
#include <stdexcept>
#include <vector>

#include "core/base/curve.h"
#include "core/filter/glsl/glsl_translation.h"

namespace swaplight {
namespace {

UniformValue vectorUniform(const FilterVector& v) {
  if (v.size() == 2) return glm::vec2(v[0], v[1]);
  if (v.size() == 3) return glm::vec3(v[0], v[1], v[2]);
  return glm::vec4(v[0], v[1], v[2], v[3]);
}

/// From rows, so that `matrix * vector` has a row a result.
template <typename Matrix>
Matrix matrixOf(const FilterMatrix& rows) {
  Matrix matrix;
  for (int row = 0; row < Matrix::length(); ++row)
    for (int column = 0; column < Matrix::length(); ++column)
      matrix[column][row] = rows[static_cast<size_t>(row)][static_cast<size_t>(column)];
  return matrix;
}

UniformValue matrixUniform(const FilterMatrix& rows) {
  if (rows.size() == 2) return matrixOf<glm::mat2>(rows);
  if (rows.size() == 3) return matrixOf<glm::mat3>(rows);
  return matrixOf<glm::mat4>(rows);
}

/// By tests of the type and not by std::visit, whose unreachable branch leaves an empty function that lld
/// gives the unwinding table of its neighbour: what the neighbour throws would end the program.
UniformValue uniformFrom(const FilterValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? 1 : 0;
  if (const auto* choice = std::get_if<int>(&value)) return *choice;
  if (const auto* number = std::get_if<float>(&value)) return *number;
  if (const auto* point = std::get_if<FilterPoint>(&value)) return glm::vec2((*point)[0], (*point)[1]);
  if (const auto* color = std::get_if<FilterColor>(&value))
    return glm::vec4((*color)[0], (*color)[1], (*color)[2], (*color)[3]);
  if (const auto* vector = std::get_if<FilterVector>(&value)) return vectorUniform(*vector);
  if (const auto* matrix = std::get_if<FilterMatrix>(&value)) return matrixUniform(*matrix);
  throw std::logic_error("a picture or a curve is no uniform");
}

void setCurve(const ShaderProgram& program, const std::string& name, const FilterCurve& curve) {
  if (!program.hasUniform("isf_count_" + name)) return;
  const std::vector<double> slopes = curveSlopes(curve);
  std::vector<glm::vec3> points;
  for (size_t i = 0; i < curve.size(); ++i)
    points.emplace_back(curve[i][0], curve[i][1], static_cast<float>(slopes[i]));
  program.set({{"isf_points_" + name, std::span<const glm::vec3>(points)},
               {"isf_count_" + name, static_cast<int>(points.size())}});
}

}  // namespace

void setFilterInput(const ShaderProgram& program, const FilterInput& input, const FilterValue& value) {
  const std::string name = glslName(input.name);
  const bool picture = std::holds_alternative<std::string>(value);
  if (const auto* curve = std::get_if<FilterCurve>(&value))
    setCurve(program, name, *curve);
  else if (!picture && program.hasUniform(name))
    program.set({{name, uniformFrom(value)}});
}

}  // namespace swaplight

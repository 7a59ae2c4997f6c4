#pragma once

// For those who need OpenColorIO itself, such as the renderer for its shaders. Everyone else: color_config.h.

#include <OpenColorIO/OpenColorIO.h>

#include <map>
#include <string>
#include <utility>

#include "core/ocio/color_config.h"
#include "core/ocio/grade_transform.h"

namespace swaplight {

/// The configuration that needs no file: scene-linear Rec.709 as reference, ACES by OCIO's built-in
/// transforms.
[[nodiscard]] OCIO::ConstConfigRcPtr builtinConfig();

struct ColorConfig::Impl {
  OCIO::ConstConfigRcPtr config;
  std::string name;  ///< the file, or "built-in"
  /// The same colour space in the built-in configuration and in this one, through which this one is given the
  /// built-in's spaces that it lacks. Equal and empty where this one is the built-in.
  std::string bridgeBuiltin;
  std::string bridgeHere;
  std::string gradingSpace;  ///< see ColorConfig::gradingSpace

  [[nodiscard]] bool has(const std::string& colorSpace) const;

  // Processors, made once for the same names. One thread at a time makes one, whatever its configuration:
  // OpenColorIO 2.1 copies environment variables into a string that all threads share while it does. What is
  // made may be applied by any number of threads. These throw InputError on unknown names; OCIO::Exception
  // never leaves.

  /// Without approximations; null where nothing has to be done.
  [[nodiscard]] OCIO::ConstCPUProcessorRcPtr conversion(const std::string& from, const std::string& to) const;
  [[nodiscard]] OCIO::ConstCPUProcessorRcPtr view(const std::string& from, const DisplayChoice& choice) const;
  /// From a view's codes to the light of its display, CIE XYZ with 1 for 100 cd/m2; null where the
  /// configuration does not say: a view whose colour space is no display's, or a display whose transform has
  /// no inverse. Does not throw.
  [[nodiscard]] OCIO::ConstCPUProcessorRcPtr shownLight(const DisplayChoice& choice) const;
  /// For a shader.
  [[nodiscard]] OCIO::ConstGPUProcessorRcPtr shaderView(const std::string& from,
                                                        const DisplayChoice& choice) const;
  /// A shader's two halves of a graded view, between which the grade acts: to codes of the grading space, and
  /// from them on.
  [[nodiscard]] OCIO::ConstGPUProcessorRcPtr shaderToGrading(const std::string& from) const;
  [[nodiscard]] OCIO::ConstGPUProcessorRcPtr shaderViewFromGrading(const std::string& from,
                                                                   const DisplayChoice& choice) const;
  /// The code of the brightest light, 65504: no grade goes beyond it.
  [[nodiscard]] double highestGradingCode(const std::string& from) const;
  /// The grade on light of a space, which stays in it.
  [[nodiscard]] OCIO::ConstCPUProcessorRcPtr graded(const std::string& from, const ColorGrade& grade) const;

 private:
  [[nodiscard]] OCIO::ConstProcessorRcPtr makeConversion(const std::string& from,
                                                         const std::string& to) const;
  [[nodiscard]] OCIO::ConstProcessorRcPtr makeView(const std::string& from,
                                                   const DisplayChoice& choice) const;
  [[nodiscard]] OCIO::ConstProcessorRcPtr madeView(const std::string& from,
                                                   const DisplayChoice& choice) const;
  [[nodiscard]] const OCIO::ConstProcessorRcPtr& madeConversion(const std::string& from,
                                                                const std::string& to) const;
  [[nodiscard]] OCIO::ConstProcessorRcPtr makeGrade(const std::string& from, const ColorGrade& grade) const;
  [[nodiscard]] double highestCode(const std::string& from) const;

  mutable std::map<std::pair<std::string, std::string>, OCIO::ConstProcessorRcPtr> m_conversions;
  mutable std::map<std::pair<std::string, DisplayChoice>, OCIO::ConstProcessorRcPtr> m_views;
};

}  // namespace swaplight

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// The OpenColorIO configuration in use: $OCIO if set, else one built in code out of OCIO 2.1's built-in
/// transforms (lin_rec709, srgb, acescg, aces2065_1, raw; displays sRGB, Rec.709, P3-D65; views). Immutable,
/// shared, safe to use from several threads.
class ColorConfig {
 public:
  /// The configuration for this process, made on first use. Throws InputError where $OCIO cannot be read.
  static const ColorConfig& current();
  explicit ColorConfig(const std::string& ocioFile);  ///< empty: the built-in one

  ColorConfig(const ColorConfig&) = delete;
  ColorConfig& operator=(const ColorConfig&) = delete;
  ~ColorConfig();

  [[nodiscard]] std::string name() const;
  [[nodiscard]] std::vector<std::string> colorSpaces() const;
  [[nodiscard]] std::vector<std::string> displays() const;
  [[nodiscard]] std::vector<std::string> views(const std::string& display) const;
  /// What the configuration says about a view, for people; may be empty.
  [[nodiscard]] std::string viewDescription(const std::string& display, const std::string& view) const;
  [[nodiscard]] std::string defaultDisplay() const;
  [[nodiscard]] std::string defaultView(const std::string& display) const;

  /// Throws InputError that lists the known colour spaces.
  void checkColorSpace(const std::string& name) const;

  /// In place, on the first three channels. Throws InputError on an unknown space.
  void convert(ImageSpan image, const std::string& from, const std::string& to) const;
  /// Scene-linear to display code values 0..1, in place, on the first three channels.
  void applyView(ImageSpan image, const std::string& from, const std::string& display,
                 const std::string& view) const;

  struct Impl;
  [[nodiscard]] const Impl& impl() const { return *m_impl; }

 private:
  std::unique_ptr<Impl> m_impl;
};

}  // namespace swaplight

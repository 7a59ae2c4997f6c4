#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/ocio/display_choice.h"

namespace swaplight {

/// An OpenColorIO configuration: one of a file, or one built in code out of OCIO 2.1's built-in transforms
/// (lin_rec709, srgb, acescg, aces2065_1, raw; displays sRGB, Rec.709, P3-D65, Rec.2100; views). Immutable,
/// safe to use from several threads.
///
/// There is no current one: who converts colours is given the one to do it with, and a job keeps its own for
/// as long as it runs. See chosen_config.h for how a program comes to one.
class ColorConfig {
 public:
  /// Empty: the built-in one. Throws InputError that names the file.
  explicit ColorConfig(const std::string& ocioFile);

  ColorConfig(const ColorConfig&) = delete;
  ColorConfig& operator=(const ColorConfig&) = delete;
  ~ColorConfig();

  [[nodiscard]] std::string name() const;  ///< "built-in", or the file
  [[nodiscard]] std::string title()
      const;  ///< short, for people: the name that it gives itself, or its file's
  [[nodiscard]] std::vector<std::string> colorSpaces() const;
  [[nodiscard]] std::vector<std::string> displays() const;
  [[nodiscard]] std::vector<std::string> views(const std::string& display) const;
  /// What the configuration says about a view, for people; may be empty.
  [[nodiscard]] std::string viewDescription(const std::string& display, const std::string& view) const;
  /// The looks that a view brings along, as OpenColorIO writes them; empty: none.
  [[nodiscard]] std::string viewLook(const std::string& display, const std::string& view) const;
  [[nodiscard]] std::vector<std::string> looks() const;
  /// What the configuration says about a look, for people; may be empty.
  [[nodiscard]] std::string lookDescription(const std::string& look) const;
  /// The first name in looks as DisplayChoice holds them that the configuration lacks; empty: none.
  [[nodiscard]] std::string unknownLook(const std::string& looks) const;
  [[nodiscard]] std::string defaultDisplay() const;
  [[nodiscard]] std::string defaultView(const std::string& display) const;

  /// The colour space that the configuration's file rules give a picture; empty where only its default rule
  /// or a rule without a colour space applies.
  [[nodiscard]] std::string colorSpaceOfFile(const std::filesystem::path& picture) const;

  /// Throws InputError where a display or view is unknown or does not work (a table is missing, say), and
  /// where a look does; lists the known ones.
  void checkView(const DisplayChoice& choice) const;
  /// lin_rec709, acescg or aces2065_1 where a colour space is one of those, however the configuration calls
  /// it (ACEScg, Utility - Linear - sRGB); else the name itself, also of one that is not known.
  [[nodiscard]] std::string knownName(const std::string& name) const;
  /// Throws InputError that lists the known colour spaces.
  void checkColorSpace(const std::string& name) const;
  /// The same, and where it holds no scene-linear light: codes, or data.
  void checkLinear(const std::string& name) const;

  /// In place, on the first three channels. Throws InputError on an unknown space.
  void convert(ImageSpan image, const std::string& from, const std::string& to) const;
  /// Scene-linear to display code values 0..1, in place, on the first three channels. Throws InputError as
  /// checkView does.
  void applyView(ImageSpan image, const std::string& from, const DisplayChoice& choice) const;

  /// The logarithmic colour space on whose codes a grade works: that of the role color_timing, or acescct
  /// where the configuration has none that light can be brought to and back from.
  [[nodiscard]] std::string gradingSpace() const;
  /// Light of a colour space under a grade, in place, on the first three channels. Nothing becomes brighter
  /// than 65504. Throws InputError on an unknown space.
  void applyGrade(ImageSpan image, const std::string& space, const ColorGrade& grade) const;

  struct Impl;
  [[nodiscard]] const Impl& impl() const { return *m_impl; }

 private:
  std::unique_ptr<Impl> m_impl;
};

}  // namespace swaplight

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/ocio/color_config.h"

namespace swaplight {

struct ImageFileInfo;

/// A picture as its header describes it.
struct FoundShot {
  std::string file;   ///< name in the folder
  std::string taken;  ///< date and time, "2026:11:21 10:00:00"; empty where the file does not say
  std::string colorSpace;
  std::string format;
  int width = 0, height = 0;
  /// log2 of exposure time x ISO / f-number squared; nothing where the file does not say all three.
  std::optional<double> exposureStops;
};

/// log2 of exposure time x ISO / f-number squared; nothing where the header does not say all three.
[[nodiscard]] std::optional<double> statedExposure(const ImageFileInfo& info);

/// The photographs of a set that lie in a folder, in order of time.
struct ShotFolder {
  std::filesystem::path folder;  ///< absolute
  std::vector<FoundShot> shots;
  std::vector<std::string> leftOut;          ///< photographs of the set that are not used
  std::optional<std::string> ambient;        ///< a picture whose name begins with "ambient"
  std::optional<std::string> dark;           ///< one whose name begins with "dark"
  std::map<std::string, std::string> flats;  ///< of "flat_key.jpg" and the like: light, picture
  std::vector<std::string> charts;        ///< "chart_key.jpg" and the like, beside others: of colour charts
  std::optional<std::string> response;    ///< "response.csv", where it is: the camera's curve
  std::optional<std::string> vignetting;  ///< one whose name begins with "vignetting"
  bool timed = false;              ///< in the order of the time they were taken at; else of their names
  std::vector<std::string> notes;  ///< what was left out and why, in words
};

/// Looks at the pictures directly in a folder; their colour spaces are those of the configuration's file
/// rules, else of their headers. Left out are solved sets, what this program has exported (layers, frames,
/// beta maps), of a camera's pair the JPEG beside its raw file, and pictures of another size than more than
/// half of them have. Numbers in names count as numbers: shot_10 comes after shot_9. Throws InputError where
/// it is no folder or has no picture; a picture that cannot be read is left out with a note.
[[nodiscard]] ShotFolder scanShotFolder(const ColorConfig& config, const std::filesystem::path& folder);

/// The same with these files as its shots, in this order. Throws InputError for one that is not there.
[[nodiscard]] ShotFolder withShots(const ColorConfig& config, ShotFolder folder,
                                   const std::vector<std::string>& files);

/// Without these shots, which are left out. Throws InputError, which begins with `where`: one that is not
/// there, or none that remains.
[[nodiscard]] ShotFolder withShotsLeftOut(ShotFolder folder, const std::vector<std::string>& files,
                                          const std::string& where);

/// The space of the shots, as a capture's file names it. Throws InputError where they differ.
[[nodiscard]] std::string colorSpaceOf(const ShotFolder& folder);

}  // namespace swaplight

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// The files that beta maps of these lights are written to: the file itself, or, where its name ends in .png,
/// name.<light>.png a light, which is what may be replaced then.
[[nodiscard]] std::vector<std::filesystem::path> betaMapFiles(const std::filesystem::path& file,
                                                              std::span<const std::string> lights);

/// Writes the beta maps of all lights for an image editor: an EXR with a channel beta.<light> each (float),
/// or, where the name ends in .png, a 16-bit grey PNG a light (65535 is 1). Returns the files written
/// (betaMapFiles). Throws InputError where they cannot be written.
std::vector<std::filesystem::path> writeBetaMaps(const SolvedSet& set, const std::filesystem::path& file);

/// Beta maps that were read from one file.
struct BetaMaps {
  std::vector<Image> maps;  ///< one a light: one channel, 0..1
  /// What the proportions of a pixel add up to, and where.
  struct Sum {
    float value = 1;
    int x = 0, y = 0;
  };
  Sum least, most;  ///< over the pixels that have any light; 1 where there is none
};

/// Reads the beta maps of lights: for each the channel named, or beta.<light>, or the file's only one, or Y,
/// or the mean of its R, G and B (an editor may have made a colour picture of it). Integer files are taken as
/// 0..1, without a transfer curve. Throws InputError: another size, no such channel, values that are not
/// finite or outside 0..1 by more than rounding (1/1000); Stopped when asked to.
[[nodiscard]] BetaMaps readBetaMaps(const std::filesystem::path& file, const std::string& channel,
                                    const std::vector<std::string>& lights, int width, int height,
                                    const Progress& progress = {});

/// Lights that share what there is cannot have more than all of it together, and where `all` lights of a set
/// are among them, not less. Throws InputError that names the pixel that is farthest off, where that is by
/// more than rounding (1/1000 a light).
void checkProportions(const BetaMaps& beta, bool all, const std::filesystem::path& file);

}  // namespace swaplight

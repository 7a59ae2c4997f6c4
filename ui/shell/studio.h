#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "render/viewport_renderer.h"

namespace swaplight {

struct StudioOptions {
  std::filesystem::path file;  ///< opened at once; empty: the first screen
  int width = 1600;            ///< of the window, in pixels
  int height = 900;
  bool sizeGiven = true;                ///< else the window stands as it did last
  Engine engine = Engine::Auto;         ///< who computes what the viewer shows
  float scale = 0;                      ///< of the interface; 0: the desktop's
  std::filesystem::path screenshot;     ///< written once the file is there, without a window; then ends
  std::filesystem::path script;         ///< commands, one a line, run one after the other
  std::filesystem::path layoutProbe;    ///< where named widgets lie goes here, for tests
  double frameSeconds = 0;              ///< a frame takes at least as long: a slow machine, for tests
  std::filesystem::path samplesFolder;  ///< offered on the first screen
  /// Once true (a signal) the studio ends at once; nothing is lost.
  const std::atomic<bool>* stop = nullptr;
};

/// The desktop application, until the person closes it. Throws InputError where the file, the script or the
/// screenshot cannot be what they should; ResourceError where there is no display or no OpenGL.
void runStudio(const StudioOptions& options);

}  // namespace swaplight

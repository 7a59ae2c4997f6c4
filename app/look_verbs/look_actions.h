#pragma once

#include <string>
#include <vector>

#include "app/arguments/camera_look_arguments.h"
#include "app/program/terminal.h"
#include "core/export/frame_file.h"
#include "core/filter/filter_library.h"
#include "render/filter/pipeline_renderer.h"

namespace swaplight {

/// What `swaplight look` is asked for.
struct LookArguments {
  std::string action;
  std::vector<std::string> names;  ///< of filters, looks or a frame, as the action has it
  FilterRequest request;
  std::string output, save, name;
  std::string light;  ///< the name of one of a set
  FrameOptions frame;
  std::optional<int> frameNumber;
  double framesPerSecond = 24;
  int tileSide = 4096;
  int width = 240;  ///< of thumbnails, in pixels
  double mostSeconds = 20;
  bool alpha = false;
  bool stages = false;  ///< a thumbnail after every filter of a look
};

// An action each. They return the exit code and throw InputError.

int listFilters(const LookArguments& arguments, Terminal& terminal);
int showFilter(const LookArguments& arguments, Terminal& terminal);
int lintFilters(const LookArguments& arguments, Terminal& terminal);
int applyFilters(const LookArguments& arguments, Terminal& terminal);
int starLooks(const LookArguments& arguments, Terminal& terminal);
int keepFilterAs(const LookArguments& arguments, Terminal& terminal);
int filterLightOfSet(const LookArguments& arguments, Terminal& terminal);
int drawThumbnails(const LookArguments& arguments, Terminal& terminal);

}  // namespace swaplight

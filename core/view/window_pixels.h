#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/view/layer_sum.h"
#include "core/view/view_layer.h"
#include "core/view/view_window.h"

namespace swaplight {

/// Brings a row of linear pixels to the monitor: `count` pixels as 8-bit R G B A. Called from several
/// threads.
using RowCodes =
    std::function<void(const float* r, const float* g, const float* b, int count, uint8_t* rgba)>;

/// The pixels of a window: the layers' sum at the window's size, through `codes`, into rows of
/// window.width * 4 bytes. The layers are of one size, and the window lies inside of them. Shrunk pictures
/// are read from the nearest level of their pyramid and interpolated; enlarged ones are interpolated, too,
/// and show their pixels as squares beyond four times. What is read is what is seen: each visible pixel of
/// that level once, whatever the number of layers. A memory, where given, makes that true of the speed too
/// while few of the factors change.
void windowPixels(std::span<const ViewLayer> layers, const ViewWindow& window, const RowCodes& codes,
                  uint8_t* rgba, LayerSum* memory = nullptr);

/// The same before `codes`: linear R G B of the window's size.
void windowLinear(std::span<const ViewLayer> layers, const ViewWindow& window, ImageSpan out);

}  // namespace swaplight

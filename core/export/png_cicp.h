#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace swaplight {

/// Code points of ITU-T H.273: primaries, transfer, matrix, full range.
using CodePoints = std::array<uint8_t, 4>;

/// Those of what a display shows, by the words in its name: BT.2100 with PQ (9, 16, 0, 1) or HLG (9, 18, 0,
/// 1). Nothing for any other display: an ICC profile says it better.
[[nodiscard]] std::optional<CodePoints> codePointsOf(const std::string& display);

/// The bytes of a PNG with a cICP chunk (PNG, third edition, 11.3.2.6), which OpenImageIO 2.4 does not write,
/// after its header. Throws InputError where they are no PNG; `name` begins the message.
[[nodiscard]] std::string withCicp(std::string png, const CodePoints& points, const std::string& name);

}  // namespace swaplight

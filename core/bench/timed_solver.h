#pragma once

#include <string>

#include "core/bench/bench_scene.h"
#include "core/set/solved_set.h"

namespace swaplight {

// Megapixels a second of pictures in memory: the best of several runs that take at least `seconds` together.

/// Room for an answer, used again by every solver.
[[nodiscard]] SolvedSet roomFor(const BenchScene& scene);

/// The memory's limit: every plane of the shots read, every plane of the answer written, with or without
/// beta.
[[nodiscard]] double memorySpeed(const BenchScene& scene, SolvedSet& room, bool beta, double seconds);

/// An estimator by name, with or without beta.
[[nodiscard]] double estimatorSpeed(const std::string& solver, const BenchScene& scene, SolvedSet& room,
                                    bool beta, double seconds);

/// The dissertation's search, timed on a part of the picture: it needs a minute for all of it.
[[nodiscard]] double bruteForceSpeed(const BenchScene& scene, SolvedSet& room, double seconds);

}  // namespace swaplight

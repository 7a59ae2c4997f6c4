#include "core/intake/kept_description.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/flat_fields.h"
#include "core/capture/left_out.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

void addKept(KeptJson& made, const KeptJson& before) {
  Json all = before.json();
  all.update(made.json(), true);
  made = std::move(all);
}

/// A picture that is still there, and is not one of the shots now.
void addKept(std::optional<std::string>& kept, const std::optional<std::string>& before,
             const Capture& made) {
  const auto isIt = [&](const Shot& shot) { return shot.image == *before; };
  if (!kept && before && std::filesystem::exists(made.folder / *before) &&
      std::none_of(made.shots.begin(), made.shots.end(), isIt))
    kept = before;
}

void addKept(std::vector<Shot>& made, const std::vector<Shot>& before) {
  for (Shot& shot : made) {
    const auto same =
        std::find_if(before.begin(), before.end(), [&](const Shot& one) { return one.image == shot.image; });
    if (same != before.end()) addKept(shot.extra, same->extra);
  }
}

void addKept(std::vector<Light>& made, const Capture& before) {
  for (Light& light : made)
    if (const int same = before.lightIndex(light.name); same >= 0) {
      light.role = before.lights[static_cast<size_t>(same)].role;
      addKept(light.extra, before.lights[static_cast<size_t>(same)].extra);
    }
}

}  // namespace

Capture withKept(Capture made, const Capture& before) {
  made.name = before.name;
  addKept(made.ambient, before.ambient, made);
  addKept(made.dark, before.dark, made);
  if (!made.noise) made.noise = before.noise;
  for (const auto& [light, picture] : before.truth)
    if (made.lightIndex(light) >= 0) made.truth.try_emplace(light, picture);
  addKept(made.lights, before);
  addKept(made.shots, before.shots);
  std::vector<Shot> leftOut = leftOutOf(made);
  addKept(leftOut, before.shots);
  addKept(leftOut, leftOutOf(before));
  addKept(made.shots, leftOutOf(before));
  addKept(made.extra, withLeftOut(before, {}).extra);
  return withoutLostFlats(std::move(made), std::move(leftOut));
}

std::set<std::string> crossedIn(const std::filesystem::path& file) {
  std::set<std::string> crossed;
  if (!std::filesystem::exists(file)) return crossed;
  try {
    for (const Shot& shot : captureFromJson(readJson(file), file.parent_path(), file).shots)
      if (shot.crossed) crossed.insert(shot.image);
  } catch (const InputError&) {
    crossed.clear();  // withKept() keeps it aside
  }
  return crossed;
}

Capture withKept(Capture made, const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return made;
  Capture before;
  try {
    before = captureFromJson(readJson(file), file.parent_path(), file);
  } catch (const InputError&) {
    // Whoever wrote it may want it back.
    std::filesystem::copy_file(file, file.string() + ".broken",
                               std::filesystem::copy_options::overwrite_existing);
    return made;
  }
  return withKept(std::move(made), before);
}

}  // namespace swaplight

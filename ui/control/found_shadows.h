#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/capture/no_such_light.h"
#include "core/normals/set_surfaces.h"
#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// Each light's shadows, by its name.
using ShadowsByLight = std::map<std::string, std::shared_ptr<const LightShadows>>;

/// A light's own. Throws InputError where it has none.
[[nodiscard]] inline const std::shared_ptr<const LightShadows>& shadowsOf(const ShadowsByLight& found,
                                                                          const std::string& light) {
  const auto known = found.find(light);
  if (known != found.end()) return known->second;
  std::vector<std::string> names;
  for (const auto& [name, shadows] : found) names.push_back(name);
  throw noSuchLight("shadows", light, names);
}

/// What was found last, for several threads: what one of them has got never changes under it.
class FoundShadows {
 public:
  using All = std::shared_ptr<const ShadowsByLight>;

  [[nodiscard]] All all() const {
    const std::lock_guard lock(m_mutex);
    return m_all;
  }
  void replace(ShadowsByLight found) {
    auto next = std::make_shared<const ShadowsByLight>(std::move(found));
    const std::lock_guard lock(m_mutex);
    m_all = std::move(next);
  }

 private:
  mutable std::mutex m_mutex;
  All m_all = std::make_shared<const ShadowsByLight>();
};

/// How the surfaces are turned that were found last, likewise.
class FoundSurfaces {
 public:
  using Surfaces = std::shared_ptr<const SetSurfaces>;

  [[nodiscard]] Surfaces last() const {
    const std::lock_guard lock(m_mutex);
    return m_last;
  }
  void replace(Surfaces found) {
    const std::lock_guard lock(m_mutex);
    m_last = std::move(found);
  }

 private:
  mutable std::mutex m_mutex;
  Surfaces m_last;
};

}  // namespace swaplight

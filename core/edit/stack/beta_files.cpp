#include "core/edit/stack/beta_files.h"

#include <algorithm>

#include "core/base/error.h"

namespace swaplight {

std::shared_ptr<const BetaMaps> readBeta(const BetaRequest& request, const Progress& progress) {
  return std::make_shared<const BetaMaps>(readBetaMaps(request.picture.file, request.picture.channel,
                                                       request.lights, request.width, request.height,
                                                       progress));
}

std::shared_ptr<const BetaMaps> BetaFiles::maps(const BetaRequest& request) {
  for (const Read& read : m_read) {
    if (!(read.request == request)) continue;
    if (!read.refusal.empty()) throw InputError(read.refusal);
    if (auto maps = read.maps.lock()) return maps;
  }
  auto maps = readBeta(request);
  keep(request, maps);
  return maps;
}

bool BetaFiles::known(const BetaRequest& request) const {
  return std::any_of(m_read.begin(), m_read.end(), [&](const Read& read) {
    return read.request == request && (!read.refusal.empty() || !read.maps.expired());
  });
}

void BetaFiles::keep(const BetaRequest& request, const std::shared_ptr<const BetaMaps>& maps,
                     const std::string& refusal) {
  std::erase_if(m_read, [&](const Read& read) {
    return read.request == request || (read.refusal.empty() && read.maps.expired());
  });
  m_read.push_back({request, maps, refusal});
}

}  // namespace swaplight

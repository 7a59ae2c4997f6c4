#include "ui/control/beta_reader.h"

#include <algorithm>
#include <utility>

namespace swaplight {

void BetaReader::choose(const Edit& edit, const EditedLights& lights, std::function<void()> then) {
  const auto request = betaRequest(edit, lights);
  if (!request) return;
  m_chosen = Chosen{edit, lights, std::move(then)};
  start(*request);
}

void BetaReader::start(const BetaRequest& request) {
  m_request = request;
  m_job.start([request](const Progress& progress) { return readBeta(request, progress); }, m_wake);
}

void BetaReader::update(Messages& messages) {
  try {
    auto maps = m_job.take();
    if (!maps) return;
    if (m_chosen) checkBeta(m_chosen->edit, m_chosen->lights, **maps);
    keep(std::move(*maps), "");
    if (const auto chosen = std::exchange(m_chosen, std::nullopt)) chosen->then();
  } catch (const Stopped&) {
    m_chosen.reset();
  } catch (const std::exception& error) {
    // Whoever asks for an edit's maps is told later.
    if (std::exchange(m_chosen, std::nullopt))
      messages.error(error.what());
    else
      keep(nullptr, error.what());
  }
}

void BetaReader::keep(Maps maps, const std::string& refusal) {
  std::erase_if(m_kept, [&](const Kept& one) { return one.request == m_request; });
  m_kept.push_back({m_request, std::move(maps), refusal});
}

bool BetaReader::isRead(const BetaRequest& request, BetaFiles& files) {
  if (files.known(request)) return true;
  const auto kept =
      std::find_if(m_kept.begin(), m_kept.end(), [&](const Kept& one) { return one.request == request; });
  if (kept != m_kept.end()) {
    files.keep(request, kept->maps, kept->refusal);
    return true;
  }
  if (!m_job.running()) start(request);
  return false;
}

void BetaReader::forget() {
  m_job.cancel();
  m_chosen.reset();
  m_kept.clear();
}

}  // namespace swaplight

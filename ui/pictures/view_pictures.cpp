#include "ui/pictures/view_pictures.h"

#include <algorithm>

namespace swaplight {

ViewPictures::ViewPictures(std::shared_ptr<const SolvedSet> set) : m_set(std::move(set)) {
  m_contributions.reserve(m_set->contributions.size());
  for (const Image& contribution : m_set->contributions) m_contributions.emplace_back(contribution.view());
  if (m_set->ambient) m_ambient.emplace(m_set->ambient->view());
}

std::vector<const Pyramid*> ViewPictures::refresh(const std::vector<PixelRect>& changed,
                                                  const std::set<int>& lights) {
  std::vector<const Pyramid*> others;
  const auto refreshOne = [&](Pyramid& picture) {
    for (const PixelRect& rect : changed) picture.refresh(rect.x, rect.y, rect.width, rect.height);
    others.push_back(&picture);
  };
  for (const int light : lights) refreshOne(m_contributions.at(static_cast<size_t>(light)));
  if (m_ambient && lights.size() == m_contributions.size()) refreshOne(*m_ambient);
  return others;
}

void ViewPictures::lightsChanged() {
  std::vector<Pyramid> pictures;
  for (const Image& contribution : m_set->contributions) {
    const auto known = std::find_if(
        m_contributions.begin(), m_contributions.end(),
        [&](const Pyramid& picture) { return picture.level(0).data == contribution.view().data; });
    if (known == m_contributions.end())
      pictures.emplace_back(contribution.view());
    else
      pictures.push_back(std::move(*known));
  }
  m_contributions = std::move(pictures);
}

std::vector<ViewLayer> ViewPictures::layers(const ViewSubject& subject, std::span<const Rgb> factors,
                                            float ambientFactor) const {
  std::vector<ViewLayer> layers;
  if (subject.kind == ViewSubject::Kind::Contribution) {
    layers.push_back({&m_contributions.at(static_cast<size_t>(subject.index)), Rgb(1)});
    return layers;
  }
  for (size_t i = 0; i < m_contributions.size(); ++i)
    layers.push_back({&m_contributions[i], i < factors.size() ? factors[i] : Rgb(0)});
  if (m_ambient) layers.push_back({&*m_ambient, Rgb(ambientFactor)});
  return layers;
}

}  // namespace swaplight

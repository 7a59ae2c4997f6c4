#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <shared_mutex>
#include <utility>
#include <vector>

#include "ui/pictures/view_pictures.h"

namespace swaplight {

/// A set that changes while it is shown, with its pictures at every size: the open set with the document's
/// edits. The interface's thread changes it and reads it as it likes; every other thread reads it through
/// read(), during which nothing changes.
class LiveSet {
 public:
  /// Whoever changes the pixels or lights of `set` later does it while holding what write() gives.
  explicit LiveSet(std::shared_ptr<const SolvedSet> set)
      : m_set(std::move(set)), m_pictures(std::make_unique<ViewPictures>(m_set)) {}
  LiveSet(const LiveSet&) = delete;
  LiveSet& operator=(const LiveSet&) = delete;

  /// For the interface's thread only.
  [[nodiscard]] const SolvedSet& set() const { return *m_set; }
  [[nodiscard]] const ViewPictures& pictures() const { return *m_pictures; }

  /// What another thread sees. Short: the interface's changes wait for it.
  class Reading {
   public:
    [[nodiscard]] const SolvedSet& set() const { return m_live.set(); }
    [[nodiscard]] const ViewPictures& pictures() const { return m_live.pictures(); }

   private:
    friend LiveSet;
    explicit Reading(const LiveSet& live) : m_live(live), m_lock(live.m_mutex) {}
    const LiveSet& m_live;
    std::shared_lock<std::shared_mutex> m_lock;
  };
  /// The set must outlive it.
  [[nodiscard]] Reading read() const { return Reading(*this); }

  /// While it lives, only this thread reads.
  class Writing {
   public:
    /// Pixels of these lights in these rectangles have changed. Returns the pictures that show them.
    std::vector<const Pyramid*> pixelsChanged(const std::vector<PixelRect>& changed,
                                              const std::set<int>& lights) {
      return m_pictures.refresh(changed, lights);
    }
    /// There are other lights: pictures of those that lie where they lay are kept.
    void lightsChanged() { m_pictures.lightsChanged(); }

   private:
    friend LiveSet;
    Writing(ViewPictures& pictures, std::unique_lock<std::shared_mutex> lock)
        : m_pictures(pictures), m_lock(std::move(lock)) {}
    ViewPictures& m_pictures;
    std::unique_lock<std::shared_mutex> m_lock;
  };
  [[nodiscard]] Writing write() { return {*m_pictures, std::unique_lock(m_mutex)}; }
  /// Nothing while somebody reads.
  [[nodiscard]] std::optional<Writing> tryWrite() {
    std::unique_lock lock(m_mutex, std::try_to_lock);
    if (!lock) return std::nullopt;
    return Writing(*m_pictures, std::move(lock));
  }

 private:
  std::shared_ptr<const SolvedSet> m_set;
  std::unique_ptr<ViewPictures> m_pictures;
  mutable std::shared_mutex m_mutex;
};

}  // namespace swaplight

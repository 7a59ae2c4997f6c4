#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/session/kept_pictures.h"
#include "render/surface.h"
#include "ui/actions/action_table.h"
#include "ui/control/session_controller.h"
#include "ui/jobs/job.h"

namespace swaplight {

/// What to do first, shown in the viewer's place while nothing is open: samples and what was open last, as
/// pictures.
class StartPage {
 public:
  /// `samples`: a folder with a folder a capture, and their pictures in `pictures/NAME.jpg`.
  StartPage(const std::filesystem::path& samples, KeptPictures kept, std::function<void()> wake);
  /// `written`: counts the pictures that were kept (PictureKeeper).
  void draw(SessionController& session, const ActionTable& actions, int written);

 private:
  /// A file to open, in words.
  struct Entry {
    std::filesystem::path file;
    std::filesystem::path picture;  ///< its file, which need not exist
    std::string id;                 ///< for tests and scripts: "sample.film_set", "recent.0"
    std::string name;               ///< "Film set"
    std::string about;              ///< what it is, or where it lies
  };
  struct Texture {
    int width = 0, height = 0;
    SurfaceTexture texture;
  };
  using Pictures = std::map<std::filesystem::path, SmallPicture>;  ///< by their files

  /// Asks for the pictures of what was open last, where they may be others than those that are there.
  void read(const std::vector<Entry>& recent, int written);
  void drawCards(const std::vector<Entry>& entries, float width, size_t columns, SessionController& session);
  /// True when clicked.
  bool drawCard(const Entry& entry, float width);
  [[nodiscard]] unsigned textureOf(const std::filesystem::path& picture, int width, int height);

  KeptPictures m_kept;
  std::function<void()> m_wake;
  std::vector<Entry> m_samples;
  std::vector<std::filesystem::path> m_asked;  ///< the pictures that were asked for last
  int m_lastFrame = -1;                        ///< of ImGui, in which the page was drawn
  int m_written = -1;                          ///< pictures that had been kept then
  bool m_due = true;                           ///< there may be other pictures than those that were read
  Job<Pictures> m_reading;
  Pictures m_pictures;
  std::map<std::filesystem::path, Texture> m_textures;
};

}  // namespace swaplight

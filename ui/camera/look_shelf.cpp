#include "ui/camera/look_shelf.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/filter/favourite_looks.h"
#include "core/session/document_editor.h"
#include "render/filter/pipeline_renderer.h"
#include "ui/camera/camera_look_edit.h"

namespace swaplight {

LookShelf::LookShelf(std::function<FilterLibrary&()> library, std::filesystem::path favouritesFile)
    : m_library(std::move(library)), m_favouritesFile(std::move(favouritesFile)) {}

void LookShelf::read() {
  if (m_read) return;
  m_read = true;
  m_looks.clear();
  std::set<std::string> seen;
  for (FilterPipeline& look : pipelinesIn(installedLookFolders()))
    if (seen.insert(filterKey(look.name)).second) m_looks.push_back(std::move(look));
  m_problem.clear();
  try {
    m_names = readFavouriteLooks(m_favouritesFile);
  } catch (const InputError& error) {
    m_problem = error.what();
    m_names = sceneTypes();
  }
}

const std::vector<FilterPipeline>& LookShelf::looks() {
  read();
  return m_looks;
}

std::vector<const FilterPipeline*> LookShelf::favourites() {
  read();
  std::vector<const FilterPipeline*> favourites;
  for (const std::string& name : m_names) {
    const auto look = std::find_if(m_looks.begin(), m_looks.end(), [&](const FilterPipeline& one) {
      return filterKey(one.name) == filterKey(name);
    });
    if (look != m_looks.end()) favourites.push_back(&*look);
  }
  return favourites;
}

bool LookShelf::isFavourite(const std::string& name) {
  read();
  return swaplight::isFavourite(m_names, name);
}

void LookShelf::star(const std::string& name, bool on) {
  // Read again: another studio or the command line may have changed it.
  std::vector<std::string> names = readFavouriteLooks(m_favouritesFile);
  names = on ? withFavourite(std::move(names), name) : withoutFavourite(std::move(names), name);
  writeFavouriteLooks(names, m_favouritesFile);
  m_names = std::move(names);
}

FilterPipeline LookShelf::lookOf(const FilterPipeline& look) const {
  return standalone(look, m_library());
}

void toggleCameraLook(DocumentEditor& editor, const LookShelf& shelf, const FilterPipeline& look) {
  if (editor.document().cameraLook.name == look.name)
    removeCameraLook(editor);
  else
    useCameraLook(editor, shelf.lookOf(look));
}

}  // namespace swaplight

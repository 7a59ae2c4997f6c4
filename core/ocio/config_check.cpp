#include "core/ocio/config_check.h"

#include <filesystem>
#include <functional>
#include <map>
#include <vector>

#include "core/base/error.h"

namespace swaplight {
namespace {

constexpr uintmax_t kLargest = uintmax_t{256} << 20;

/// What is not there is said where it is used.
void checkRegular(const std::filesystem::path& file, const std::string& what) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return;
  if (!std::filesystem::is_regular_file(file, error)) throw InputError("{} is no regular file.", what);
  if (std::filesystem::file_size(file, error) > kLargest && !error)
    throw InputError("{} is larger than {} MiB, which none is.", what, kLargest >> 20);
}

/// Walks from colour spaces and looks along what their transforms name.
class ConfigWalk {
 public:
  ConfigWalk(const OCIO::ConstConfigRcPtr& config, const std::string& name)
      : m_config(config), m_name(name) {}

  void space(const char* called) {
    if (!called || !*called) return;
    const auto space = m_config->getColorSpace(called);
    if (!space) return;  // OpenColorIO says so itself
    visit("the colour space " + std::string(space->getName()), [&] {
      transform(space->getTransform(OCIO::COLORSPACE_DIR_TO_REFERENCE));
      transform(space->getTransform(OCIO::COLORSPACE_DIR_FROM_REFERENCE));
    });
  }
  void look(const char* called) {
    if (!called || !*called) return;
    const auto look = m_config->getLook(called);
    if (!look) return;
    visit("the look " + std::string(look->getName()), [&] {
      space(look->getProcessSpace());
      transform(look->getTransform());
      transform(look->getInverseTransform());
    });
  }
  void viewTransform(const char* called) {
    if (!called || !*called) return;
    const auto view = m_config->getViewTransform(called);
    if (!view) return;
    visit("the view transform " + std::string(view->getName()), [&] {
      transform(view->getTransform(OCIO::VIEWTRANSFORM_DIR_TO_REFERENCE));
      transform(view->getTransform(OCIO::VIEWTRANSFORM_DIR_FROM_REFERENCE));
    });
  }
  void namedTransform(const char* called) {
    if (!called || !*called) return;
    const auto named = m_config->getNamedTransform(called);
    if (!named) return;
    visit("the transform " + std::string(named->getName()), [&] {
      transform(named->getTransform(OCIO::TRANSFORM_DIR_FORWARD));
      transform(named->getTransform(OCIO::TRANSFORM_DIR_INVERSE));
    });
  }

 private:
  enum class State { Open, Done };

  void visit(const std::string& what, const std::function<void()>& follow) {
    const auto [found, isNew] = m_seen.try_emplace(what, State::Open);
    if (!isNew && found->second == State::Open)
      throw InputError("{}: {} leads back to itself. Correct the configuration.", m_name, what);
    if (!isNew) return;
    follow();
    m_seen[what] = State::Done;
  }

  void transform(const OCIO::ConstTransformRcPtr& given) {
    if (!given) return;
    if (const auto group = OCIO::DynamicPtrCast<const OCIO::GroupTransform>(given)) {
      for (int i = 0; i < group->getNumTransforms(); ++i) transform(group->getTransform(i));
    } else if (const auto convert = OCIO::DynamicPtrCast<const OCIO::ColorSpaceTransform>(given)) {
      either(convert->getSrc());
      either(convert->getDst());
    } else if (const auto looks = OCIO::DynamicPtrCast<const OCIO::LookTransform>(given)) {
      either(looks->getSrc());
      either(looks->getDst());
      everyLook(looks->getLooks());
    } else if (const auto view = OCIO::DynamicPtrCast<const OCIO::DisplayViewTransform>(given)) {
      either(view->getSrc());
      displayView(view->getDisplay(), view->getView());
    } else if (const auto file = OCIO::DynamicPtrCast<const OCIO::FileTransform>(given)) {
      table(file->getSrc());
    }
  }

  /// A colour space's name may be that of a transform.
  void either(const char* called) {
    space(called);
    namedTransform(called);
  }

  void displayView(const char* display, const char* view) {
    either(m_config->getDisplayViewColorSpaceName(display, view));
    viewTransform(m_config->getDisplayViewTransformName(display, view));
    everyLook(m_config->getDisplayViewLooks(display, view));
  }

  /// "+warm, -cold | neutral".
  void everyLook(const std::string& list) {
    std::string one;
    for (const char c : list + ",") {
      if (c != ',' && c != ':' && c != '|') {
        if (c != '+' && c != '-' && c != ' ') one += c;
        continue;
      }
      if (!one.empty()) look(one.c_str());
      one.clear();
    }
  }

  void table(const char* source) {
    std::filesystem::path file;
    try {
      file = m_config->getCurrentContext()->resolveFileLocation(source);
    } catch (const OCIO::Exception&) {
      return;
    }
    checkRegular(file, fmt::format("{}: the table {}", m_name, file.string()));
  }

  const OCIO::ConstConfigRcPtr& m_config;
  const std::string& m_name;
  std::map<std::string, State> m_seen;
};

}  // namespace

void checkConfigFile(const std::string& file) {
  checkRegular(file, file + ": the colour configuration");
}

void checkConfig(const OCIO::ConstConfigRcPtr& config, const std::string& name) {
  ConfigWalk walk(config, name);
  const auto allSpaces = OCIO::SEARCH_REFERENCE_SPACE_ALL;
  for (int i = 0; i < config->getNumColorSpaces(allSpaces, OCIO::COLORSPACE_ALL); ++i)
    walk.space(config->getColorSpaceNameByIndex(allSpaces, OCIO::COLORSPACE_ALL, i));
  for (int i = 0; i < config->getNumLooks(); ++i) walk.look(config->getLookNameByIndex(i));
  for (int i = 0; i < config->getNumViewTransforms(); ++i)
    walk.viewTransform(config->getViewTransformNameByIndex(i));
  for (int i = 0; i < config->getNumNamedTransforms(OCIO::NAMEDTRANSFORM_ALL); ++i)
    walk.namedTransform(config->getNamedTransformNameByIndex(OCIO::NAMEDTRANSFORM_ALL, i));
}

}  // namespace swaplight

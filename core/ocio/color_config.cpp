#include "core/ocio/color_config.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ocio/color_config_impl.h"
#include "core/ocio/config_check.h"

namespace swaplight {
namespace {

/// The names that every capture may use (docs/formats.md, A capture), whatever configuration is in use.
constexpr std::array<const char*, 7> kAlwaysKnown = {"lin_rec709",  "srgb",      "acescg", "aces2065_1",
                                                     "lin_rec2020", "lin_p3d65", "raw"};
constexpr int kGrain = 16;           // rows
constexpr float kBrightest = 65504;  // the largest half float

std::string join(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// OpenColorIO's words in one line that ends.
std::string oneLine(std::string words) {
  std::replace(words.begin(), words.end(), '\n', ' ');
  while (!words.empty() && words.back() == ' ') words.pop_back();
  return words.ends_with('.') ? words : words + ".";
}

template <typename Work>
auto inWords(const std::string& config, const Work& work) {
  try {
    return work();
  } catch (const OCIO::Exception& error) {
    throw InputError("{}: OpenColorIO: {}", config, oneLine(error.what()));
  }
}

/// Finds a colour space that a foreign configuration and the built-in one both have: by its interchange role,
/// by the names that the usual configurations give it, or by the guess that its scene-linear is Rec.709.
void findBridge(ColorConfig::Impl& impl) {
  const std::array<std::array<const char*, 2>, 10> candidates = {{{"aces2065_1", "aces_interchange"},
                                                                  {"aces2065_1", "ACES2065-1"},
                                                                  {"aces2065_1", "ACES - ACES2065-1"},
                                                                  {"acescg", "ACEScg"},
                                                                  {"acescg", "ACES - ACEScg"},
                                                                  {"lin_rec709", "lin_rec709"},
                                                                  {"lin_rec709", "Linear Rec.709 (sRGB)"},
                                                                  {"lin_rec709", "Utility - Linear - sRGB"},
                                                                  {"lin_rec709", "scene_linear"},
                                                                  {"lin_rec709", "linear"}}};
  for (const auto& [ours, theirs] : candidates) {
    const auto space = impl.config->getColorSpace(theirs);
    if (!space || space->isData()) continue;
    impl.bridgeBuiltin = ours;
    impl.bridgeHere = space->getName();
    return;
  }
}

/// Where grades are made: the role for it, if light can be brought there and back; else ACEScct, by the
/// bridge.
std::string findGradingSpace(const ColorConfig::Impl& impl) {
  const std::string fallback = "acescct";
  const auto space = impl.config->getColorSpace(OCIO::ROLE_COLOR_TIMING);
  if (!space || space->isData() || space->getReferenceSpaceType() != OCIO::REFERENCE_SPACE_SCENE)
    return fallback;
  const std::string light = impl.bridgeHere.empty() ? "lin_rec709" : impl.bridgeHere;
  try {
    static_cast<void>(impl.config->getProcessor(light.c_str(), space->getName())->getDefaultCPUProcessor());
    static_cast<void>(impl.config->getProcessor(space->getName(), light.c_str())->getDefaultCPUProcessor());
    return space->getName();
  } catch (const OCIO::Exception&) {
    return fallback;  // a table that cannot be turned round
  }
}

const OCIO::ConstConfigRcPtr& sharedBuiltin() {
  static const OCIO::ConstConfigRcPtr config = builtinConfig();
  return config;
}

/// One processor that does one thing after the other.
OCIO::ConstProcessorRcPtr chain(const OCIO::ConstConfigRcPtr& config, const OCIO::ConstProcessorRcPtr& first,
                                const OCIO::ConstProcessorRcPtr& second) {
  const auto both = OCIO::GroupTransform::Create();
  both->appendTransform(first->createGroupTransform());
  both->appendTransform(second->createGroupTransform());
  return config->getProcessor(both);
}

OCIO::ConstProcessorRcPtr viewIn(const OCIO::ConstConfigRcPtr& config, const std::string& from,
                                 const DisplayChoice& choice) {
  const auto transform = OCIO::DisplayViewTransform::Create();
  transform->setSrc(from.c_str());
  transform->setDisplay(choice.display.c_str());
  transform->setView(choice.view.c_str());
  const auto pipeline = OCIO::LegacyViewingPipeline::Create();
  pipeline->setDisplayViewTransform(transform);
  pipeline->setLooksOverrideEnabled(choice.look.has_value());
  pipeline->setLooksOverride(choice.look.value_or("").c_str());
  return pipeline->getProcessor(config);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Lossless: the default optimisation replaces powers by approximations.
OCIO::ConstCPUProcessorRcPtr losslessProcessor(const OCIO::ConstProcessorRcPtr& processor) {
  if (processor->isNoOp()) return nullptr;
  return processor->getOptimizedCPUProcessor(OCIO::BIT_DEPTH_F32, OCIO::BIT_DEPTH_F32,
                                             OCIO::OPTIMIZATION_LOSSLESS);
}

/// Runs a processor, if any, over the first three planes, bands of rows in parallel.
void applyProcessor(const OCIO::ConstCPUProcessorRcPtr& cpu, const ImageSpan& image) {
  if (!cpu) return;
  constexpr auto kFloat = static_cast<ptrdiff_t>(sizeof(float));
  parallelRows(image.height, kGrain, [&](int begin, int end) {
    OCIO::PlanarImageDesc band(image.row(0, begin), image.row(1, begin), image.row(2, begin), nullptr,
                               image.width, end - begin, OCIO::BIT_DEPTH_F32, kFloat,
                               image.rowStride * kFloat);
    cpu->apply(band);
  });
}

/// True where light in this space can be added and multiplied: whatever is brighter by a factor has numbers
/// larger by it, and white is the sum of the primaries.
bool addsUp(const ColorConfig& config, const std::string& colorSpace) {
  constexpr std::array<float, 5> kLevels = {1, 0, 0.01F, 0.18F, 16};
  Image colors(ImageSpec::rgb(4, static_cast<int>(kLevels.size())), 0);  // red, green, blue, white
  for (size_t i = 0; i < kLevels.size(); ++i)
    for (int c = 0; c < 3; ++c) colors.plane(c)[4 * i + c] = colors.plane(c)[4 * i + 3] = kLevels[i];
  config.convert(colors.span(), "lin_rec709", colorSpace);
  for (int c = 0; c < 3; ++c) {
    const float* numbers = colors.plane(c);
    const auto near = [](float a, float b, float level) {
      return std::abs(a - b) <= 1e-3F * std::max(level, std::abs(b)) + 1e-5F;
    };
    if (!near(numbers[0] + numbers[1] + numbers[2], numbers[3], 1)) return false;
    for (size_t i = 0; i < 4 * kLevels.size(); ++i)
      if (!near(numbers[i], kLevels[i / 4] * numbers[i % 4], kLevels[i / 4])) return false;
  }
  return true;
}

void checkThreeChannels(const ImageSpan& image) {
  if (image.channels < 3)
    throw InputError("a picture with {} channels has no colour to convert, expected R, G, B.",
                     image.channels);
}

void clampToUnit(const ImageSpan& image) {
  parallelRows(image.height, kGrain, [&](int begin, int end) {
    for (int c = 0; c < 3; ++c)
      for (int y = begin; y < end; ++y) {
        float* row = image.row(c, y);
        for (int x = 0; x < image.width; ++x) row[x] = row[x] > 0 ? (row[x] < 1 ? row[x] : 1) : 0;  // NaN: 0
      }
  });
}

}  // namespace

bool ColorConfig::Impl::has(const std::string& colorSpace) const {
  return config->getColorSpace(colorSpace.c_str()) != nullptr;
}

OCIO::ConstProcessorRcPtr ColorConfig::Impl::makeConversion(const std::string& from,
                                                            const std::string& to) const {
  const OCIO::ConstConfigRcPtr& known = sharedBuiltin();
  const auto in = [&](const char* a, const char* b) { return config->getProcessor(a, b); };
  const auto inBuiltin = [&](const char* a, const char* b) { return known->getProcessor(a, b); };
  const bool fromHere = has(from);
  const bool toHere = has(to);
  if (fromHere && toHere) return in(from.c_str(), to.c_str());
  if (!fromHere && !toHere) return inBuiltin(from.c_str(), to.c_str());
  if (fromHere)
    return chain(config, in(from.c_str(), bridgeHere.c_str()), inBuiltin(bridgeBuiltin.c_str(), to.c_str()));
  return chain(config, inBuiltin(from.c_str(), bridgeBuiltin.c_str()), in(bridgeHere.c_str(), to.c_str()));
}

OCIO::ConstProcessorRcPtr ColorConfig::Impl::makeView(const std::string& from,
                                                      const DisplayChoice& choice) const {
  if (has(from)) return viewIn(config, from, choice);
  return chain(config, sharedBuiltin()->getProcessor(from.c_str(), bridgeBuiltin.c_str()),
               viewIn(config, bridgeHere, choice));
}

OCIO::ConstProcessorRcPtr ColorConfig::Impl::madeView(const std::string& from,
                                                      const DisplayChoice& choice) const {
  OCIO::ConstProcessorRcPtr& made = m_views[{from, choice.withoutGrade()}];
  if (!made) made = makeView(from, choice);
  const ColorGrade* grade = choice.actingGrade();  // not kept: a slider makes many
  return grade ? chain(config, makeGrade(from, *grade), made) : made;
}

const OCIO::ConstProcessorRcPtr& ColorConfig::Impl::madeConversion(const std::string& from,
                                                                   const std::string& to) const {
  OCIO::ConstProcessorRcPtr& made = m_conversions[{from, to}];
  if (!made) made = makeConversion(from, to);
  return made;
}

double ColorConfig::Impl::highestCode(const std::string& from) const {
  std::array<float, 3> code{kBrightest, kBrightest, kBrightest};
  madeConversion(from, gradingSpace)->getDefaultCPUProcessor()->applyRGB(code.data());
  return *std::max_element(code.begin(), code.end());
}

OCIO::ConstProcessorRcPtr ColorConfig::Impl::makeGrade(const std::string& from,
                                                       const ColorGrade& grade) const {
  const auto all = OCIO::GroupTransform::Create();
  all->appendTransform(madeConversion(from, gradingSpace)->createGroupTransform());
  all->appendTransform(gradeTransform(grade, highestCode(from))->createEditableCopy());
  all->appendTransform(madeConversion(gradingSpace, from)->createGroupTransform());
  return config->getProcessor(all);
}

OCIO::ConstCPUProcessorRcPtr ColorConfig::Impl::conversion(const std::string& from,
                                                           const std::string& to) const {
  const std::lock_guard lock(processorMutex());
  return inWords(name, [&] { return losslessProcessor(madeConversion(from, to)); });
}

OCIO::ConstCPUProcessorRcPtr ColorConfig::Impl::view(const std::string& from,
                                                     const DisplayChoice& choice) const {
  const std::lock_guard lock(processorMutex());
  return inWords(name, [&] { return losslessProcessor(madeView(from, choice)); });
}

OCIO::ConstCPUProcessorRcPtr ColorConfig::Impl::shownLight(const DisplayChoice& choice) const {
  const std::lock_guard lock(processorMutex());
  try {
    const std::string own = config->getDisplayViewColorSpaceName(choice.display.c_str(), choice.view.c_str());
    const auto space =
        config->getColorSpace((own == OCIO::OCIO_VIEW_USE_DISPLAY_NAME ? choice.display : own).c_str());
    if (!space || space->getReferenceSpaceType() != OCIO::REFERENCE_SPACE_DISPLAY) return nullptr;
    if (const auto to = space->getTransform(OCIO::COLORSPACE_DIR_TO_REFERENCE))
      return config->getProcessor(to)->getDefaultCPUProcessor();
    const auto from = space->getTransform(OCIO::COLORSPACE_DIR_FROM_REFERENCE);
    if (!from) return nullptr;
    return config->getProcessor(from, OCIO::TRANSFORM_DIR_INVERSE)->getDefaultCPUProcessor();
  } catch (const OCIO::Exception&) {
    return nullptr;  // a transform that cannot be turned round
  }
}

OCIO::ConstGPUProcessorRcPtr ColorConfig::Impl::shaderView(const std::string& from,
                                                           const DisplayChoice& choice) const {
  const std::lock_guard lock(processorMutex());
  return inWords(name, [&] { return madeView(from, choice)->getDefaultGPUProcessor(); });
}

OCIO::ConstGPUProcessorRcPtr ColorConfig::Impl::shaderToGrading(const std::string& from) const {
  const std::lock_guard lock(processorMutex());
  return inWords(name, [&] { return madeConversion(from, gradingSpace)->getDefaultGPUProcessor(); });
}

OCIO::ConstGPUProcessorRcPtr ColorConfig::Impl::shaderViewFromGrading(const std::string& from,
                                                                      const DisplayChoice& choice) const {
  const std::lock_guard lock(processorMutex());
  return inWords(name, [&] {
    return chain(config, madeConversion(gradingSpace, from), madeView(from, choice.withoutGrade()))
        ->getDefaultGPUProcessor();
  });
}

double ColorConfig::Impl::highestGradingCode(const std::string& from) const {
  const std::lock_guard lock(processorMutex());
  return inWords(name, [&] { return highestCode(from); });
}

OCIO::ConstCPUProcessorRcPtr ColorConfig::Impl::graded(const std::string& from,
                                                       const ColorGrade& grade) const {
  const std::lock_guard lock(processorMutex());
  return inWords(name, [&] { return losslessProcessor(makeGrade(from, grade)); });
}

ColorConfig::ColorConfig(const std::string& ocioFile) : m_impl(std::make_unique<Impl>()) {
  const std::lock_guard lock(processorMutex());
  OCIO::SetLoggingLevel(OCIO::LOGGING_LEVEL_NONE);
  m_impl->name = ocioFile.empty() ? "built-in" : ocioFile;
  if (ocioFile.empty()) {
    m_impl->config = sharedBuiltin();
    m_impl->gradingSpace = findGradingSpace(*m_impl);
    return;
  }
  checkConfigFile(ocioFile);
  OCIO::ClearAllCaches();  // which know a table by its file's name, also when it has changed
  inWords(ocioFile, [&] {
    m_impl->config = OCIO::Config::CreateFromFile(ocioFile.c_str());
    checkConfig(m_impl->config, ocioFile);
    m_impl->config->validate();
    findBridge(*m_impl);
  });
  if (m_impl->bridgeHere.empty())
    throw InputError(
        "{}: OpenColorIO: the configuration has no scene-linear colour space. Give it the role "
        "scene_linear or aces_interchange.",
        ocioFile);
  m_impl->gradingSpace = findGradingSpace(*m_impl);
}

ColorConfig::~ColorConfig() = default;

std::string ColorConfig::name() const {
  return m_impl->name;
}

std::string ColorConfig::title() const {
  if (m_impl->config == sharedBuiltin()) return m_impl->name;
  const std::string own = m_impl->config->getName();
  return own.empty() ? std::filesystem::path(m_impl->name).filename().string() : own;
}

std::string ColorConfig::colorSpaceOfFile(const std::filesystem::path& picture) const {
  try {
    size_t rule = 0;
    const char* space = m_impl->config->getColorSpaceFromFilepath(picture.string().c_str(), rule);
    const auto rules = m_impl->config->getFileRules();
    const bool decided = space && *space != '\0' && rule + 1 < rules->getNumEntries();
    return decided && m_impl->has(space) ? m_impl->config->getColorSpace(space)->getName() : "";
  } catch (const OCIO::Exception&) {
    return {};
  }
}

void ColorConfig::checkView(const DisplayChoice& choice) const {
  const DisplayChoice asked = namedDisplay(*this, choice).withoutGrade();
  const std::string &display = asked.display, &view = asked.view;
  if (!contains(displays(), display))
    throw InputError("there is no display '{}'; {} has {}", display, name(), join(displays()));
  if (!contains(views(display), view))
    throw InputError("the display {} has no view '{}'; {} has {}", display, view, name(),
                     join(views(display)));
  if (const std::string unknown = unknownLook(asked.look.value_or("")); !unknown.empty())
    throw InputError("there is no look '{}'; {} has {}", unknown, name(),
                     looks().empty() ? "none" : join(looks()));
  static_cast<void>(m_impl->view("lin_rec709", asked));
}

std::vector<std::string> ColorConfig::colorSpaces() const {
  std::vector<std::string> names;
  for (int i = 0; i < m_impl->config->getNumColorSpaces(); ++i) {
    const std::string name = m_impl->config->getColorSpaceNameByIndex(i);
    const auto space = m_impl->config->getColorSpace(name.c_str());
    if (space->getReferenceSpaceType() == OCIO::REFERENCE_SPACE_SCENE) names.push_back(name);
  }
  for (const char* name : kAlwaysKnown)
    if (!m_impl->has(name)) names.emplace_back(name);
  return names;
}

std::vector<std::string> ColorConfig::displays() const {
  const int count = m_impl->config->getNumDisplays();
  std::vector<std::string> names;
  names.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) names.emplace_back(m_impl->config->getDisplay(i));
  return names;
}

std::vector<std::string> ColorConfig::views(const std::string& display) const {
  const int count = m_impl->config->getNumViews(display.c_str());
  std::vector<std::string> names;
  names.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) names.emplace_back(m_impl->config->getView(display.c_str(), i));
  return names;
}

std::string ColorConfig::viewDescription(const std::string& display, const std::string& view) const {
  return m_impl->config->getDisplayViewDescription(display.c_str(), view.c_str());
}

std::string ColorConfig::viewLook(const std::string& display, const std::string& view) const {
  return m_impl->config->getDisplayViewLooks(display.c_str(), view.c_str());
}

std::vector<std::string> ColorConfig::looks() const {
  const int count = m_impl->config->getNumLooks();
  std::vector<std::string> names;
  names.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) names.emplace_back(m_impl->config->getLookNameByIndex(i));
  return names;
}

std::string ColorConfig::lookDescription(const std::string& look) const {
  const auto found = m_impl->config->getLook(look.c_str());
  return found ? found->getDescription() : "";
}

std::string ColorConfig::unknownLook(const std::string& looks) const {
  constexpr const char* kParting = ",:|";
  for (size_t begin = 0; begin <= looks.size();) {
    const size_t end = std::min(looks.find_first_of(kParting, begin), looks.size());
    std::string name = looks.substr(begin, end - begin);
    name.erase(0, name.find_first_not_of(" \t+-"));
    name.erase(name.find_last_not_of(" \t") + 1);
    if (!name.empty() && !m_impl->config->getLook(name.c_str())) return name;
    begin = end + 1;
  }
  return {};
}

std::string ColorConfig::defaultDisplay() const {
  return m_impl->config->getDefaultDisplay();
}

std::string ColorConfig::defaultView(const std::string& display) const {
  return m_impl->config->getDefaultView(display.c_str());
}

std::string ColorConfig::knownName(const std::string& name) const {
  const std::array<const char*, 3> known = {"lin_rec709", "acescg", "aces2065_1"};
  if (std::find(known.begin(), known.end(), name) != known.end()) return name;
  const OCIO::ConstConfigRcPtr& config = m_impl->has(name) ? m_impl->config : sharedBuiltin();
  const auto space = config->getColorSpace(name.c_str());
  if (!space || space->isData()) return name;
  // The primaries, and two greys: of a curve they do not become what they are.
  constexpr std::array<std::array<float, 3>, 5> kColors = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.18F, 0.18F, 0.18F}, {4, 4, 4}}};
  constexpr float kAlike = 1e-3F;  // configurations round their matrices
  for (const char* candidate : known) {
    Image colors(ImageSpec::rgb(int(kColors.size()), 1));
    for (size_t i = 0; i < kColors.size(); ++i)
      for (int c = 0; c < 3; ++c) colors.plane(c)[i] = kColors[i][size_t(c)];
    try {
      convert(colors.span(), name, candidate);
    } catch (const InputError&) {
      return name;  // a table is missing, say: whoever uses it is told
    }
    bool same = true;
    for (size_t i = 0; i < kColors.size(); ++i)
      for (int c = 0; c < 3; ++c)
        same &= std::abs(colors.plane(c)[i] - kColors[i][size_t(c)]) < kAlike * std::max(kColors[i][0], 1.0F);
    if (same) return candidate;
  }
  return name;
}

void ColorConfig::checkColorSpace(const std::string& name) const {
  const bool always = std::find(kAlwaysKnown.begin(), kAlwaysKnown.end(), name) != kAlwaysKnown.end();
  if (always || m_impl->has(name)) return;
  throw InputError("the colour space \"{}\" is not known. Known ({}): {}.", name, m_impl->name,
                   join(colorSpaces()));
}

void ColorConfig::checkLinear(const std::string& name) const {
  checkColorSpace(name);
  const auto space = (m_impl->has(name) ? m_impl->config : sharedBuiltin())->getColorSpace(name.c_str());
  if (space->isData() || !addsUp(*this, name))
    throw InputError(
        "the colour space \"{}\" holds {}, not scene-linear light: give lin_rec709, acescg, aces2065_1 or "
        "another linear one",
        name, space->isData() ? "data" : "codes");
}

void ColorConfig::convert(ImageSpan image, const std::string& from, const std::string& to) const {
  checkColorSpace(from);
  checkColorSpace(to);
  if (from == to) return;
  checkThreeChannels(image);
  applyProcessor(m_impl->conversion(from, to), image);
}

std::string ColorConfig::gradingSpace() const {
  return m_impl->gradingSpace;
}

void ColorConfig::applyGrade(ImageSpan image, const std::string& space, const ColorGrade& grade) const {
  checkColorSpace(space);
  checkThreeChannels(image);
  if (!grade.idle()) applyProcessor(m_impl->graded(space, grade), image);
}

void ColorConfig::applyView(ImageSpan image, const std::string& from, const DisplayChoice& choice) const {
  checkColorSpace(from);
  checkThreeChannels(image);
  checkView(choice);
  applyProcessor(m_impl->view(from, namedDisplay(*this, choice)), image);
  clampToUnit(image);
}

}  // namespace swaplight

#include "core/session/swatches.h"

#include <algorithm>
#include <exception>

#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/relight/setting.h"

namespace swaplight {
namespace {

void remove(std::vector<LightColor>& colors, const LightColor& color) {
  // As texts: of two colours that read the same one is enough.
  const std::string text = colorText(color);
  std::erase_if(colors, [&](const LightColor& other) { return colorText(other) == text; });
}

void putFirst(std::vector<LightColor>& colors, const LightColor& color, size_t most) {
  remove(colors, color);
  colors.insert(colors.begin(), color);
  if (colors.size() > most) colors.resize(most);
}

Json textsOf(const std::vector<LightColor>& colors) {
  Json texts = Json::array();
  for (const LightColor& color : colors) texts.push_back(colorText(color));
  return texts;
}

std::vector<LightColor> colorsOf(const Json& texts, size_t most) {
  std::vector<LightColor> colors;
  for (const Json& text : texts) {
    if (colors.size() == most) break;
    LightSetting setting;
    applySetting(setting, text.get<std::string>());
    colors.push_back(setting.color);
  }
  return colors;
}

}  // namespace

Swatches::Swatches(std::filesystem::path file) : m_file(std::move(file)) {
  try {
    if (!std::filesystem::exists(m_file)) return;
    const Json lists = readJson(m_file);
    m_kept = colorsOf(lists.at("kept"), kMostKept);
    m_recent = colorsOf(lists.at("recent"), kMostRecent);
  } catch (const std::exception&) {
    m_kept.clear();
    m_recent.clear();
  }
}

void Swatches::keep(const LightColor& color) {
  putFirst(m_kept, color, kMostKept);
  remove(m_recent, color);
  write();
}

void Swatches::drop(const LightColor& color) {
  remove(m_kept, color);
  write();
}

void Swatches::use(const LightColor& color) {
  const std::string text = colorText(color);
  const auto same = [&](const LightColor& other) { return colorText(other) == text; };
  if (text == colorText({}) || std::any_of(m_kept.begin(), m_kept.end(), same)) return;
  if (!m_recent.empty() && same(m_recent.front())) return;
  putFirst(m_recent, color, kMostRecent);
  write();
}

void Swatches::write() const {
  try {
    std::filesystem::create_directories(m_file.parent_path());
    writeJson(Json{{"kept", textsOf(m_kept)}, {"recent", textsOf(m_recent)}}, m_file);
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace swaplight

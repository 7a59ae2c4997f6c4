#include "ui/state/color_choice.h"

#include "core/base/error.h"
#include "core/ocio/chosen_config.h"

namespace swaplight {

ColorChoice::ColorChoice() : m_builtin(sessionConfig({})), m_config(m_builtin) {
  try {
    m_environment = environmentConfig();
    if (m_environment) m_environment->checkView({});
  } catch (const InputError& error) {
    m_environment.reset();
    m_environmentTrouble = error.what();
  }
  if (m_environment) m_config = m_environment;
}

ColorChoice::Found ColorChoice::find(const std::filesystem::path& wanted) {
  if (m_environment) return {m_environment, {}};
  if (wanted.empty()) return {m_builtin, {}};
  try {
    std::shared_ptr<const ColorConfig>& used = m_used[wanted];
    if (!used) {
      const std::shared_ptr<const ColorConfig> config = sessionConfig(wanted);
      config->checkView({});
      used = config;
    }
    return {used, {}};
  } catch (const InputError& error) {
    return {m_builtin, error.what()};
  }
}

std::shared_ptr<const ColorConfig> ColorChoice::configFor(const std::filesystem::path& wanted) {
  return find(wanted).config;
}

void ColorChoice::follow(const std::filesystem::path& wanted, Messages& messages) {
  if (!m_said && !m_environmentTrouble.empty()) messages.errorThatStays(m_environmentTrouble);
  m_said = true;
  if (wanted == m_wanted) return;
  m_wanted = wanted;
  Found found = find(wanted);
  m_config = std::move(found.config);
  m_sessionTrouble = std::move(found.trouble);
  if (!m_sessionTrouble.empty()) messages.error(m_sessionTrouble);
}

const std::string& ColorChoice::trouble() const {
  return m_sessionTrouble.empty() ? m_environmentTrouble : m_sessionTrouble;
}

}  // namespace swaplight

#include "ui/control/color_choice.h"

#include "core/base/error.h"
#include "core/ocio/color_config.h"

namespace swaplight {

ColorChoice::ColorChoice() : m_environmentTrouble(ColorConfig::fallBack()) {}

void ColorChoice::follow(const std::filesystem::path& wanted, Messages& messages) {
  if (!m_said && !m_environmentTrouble.empty()) messages.error(m_environmentTrouble);
  m_said = true;
  if (wanted == m_wanted) return;
  m_wanted = wanted;
  m_sessionTrouble.clear();
  try {
    ColorConfig::choose(wanted);
    ColorConfig::current().checkView({});
  } catch (const InputError& error) {
    ColorConfig::choose({});
    m_sessionTrouble = error.what();
    messages.error(m_sessionTrouble);
  }
}

const std::string& ColorChoice::trouble() const {
  return m_sessionTrouble.empty() ? m_environmentTrouble : m_sessionTrouble;
}

}  // namespace swaplight

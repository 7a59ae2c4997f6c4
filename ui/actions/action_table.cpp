#include "ui/actions/action_table.h"

#include <algorithm>
#include <sstream>

#include "core/base/lower_case.h"

namespace swaplight {
namespace {

bool hasKeys(const Action& action, const std::string& keys) {
  std::istringstream list(action.keys);
  for (std::string one; list >> one;)
    if (one == keys) return true;
  return false;
}

}  // namespace

std::string keysName(const KeyPress& press) {
  std::string name;
  if (press.ctrl) name += "Ctrl+";
  if (press.alt) name += "Alt+";
  if (press.shift) name += "Shift+";
  return name + press.key;
}

bool matchesWords(const std::string& text, const std::string& search) {
  const std::string in = lowerCase(text);
  std::istringstream words(lowerCase(search));
  for (std::string word; words >> word;)
    if (in.find(word) == std::string::npos) return false;
  return true;
}

void ActionTable::add(Action action) {
  action.ownKeys = action.keys;
  m_actions.push_back(std::move(action));
}

const Action* ActionTable::find(const std::string& id) const {
  const auto found =
      std::find_if(m_actions.begin(), m_actions.end(), [&](const Action& action) { return action.id == id; });
  return found == m_actions.end() ? nullptr : &*found;
}

bool ActionTable::run(const std::string& id) const {
  const Action* action = find(id);
  if (!action || !action->isEnabled()) return false;
  action->run();
  return true;
}

void ActionTable::runKeys(const Keyboard& keyboard) const {
  const auto runFor = [&](const std::string& keys) {
    for (const Action& action : m_actions)
      if (hasKeys(action, keys) && action.isEnabled()) {
        if (!action.keysTake || !action.isChecked()) action.run();
        return;
      }
  };
  for (const KeyPress& press : keyboard.presses) runFor(keysName(press));
  // Punctuation is told by what was typed: layouts put it anywhere.
  for (const char32_t typed : keyboard.typed)
    if (typed == U'?') runFor("?");
}

void ActionTable::setKeys(const std::string& id, std::string keys) {
  const auto found =
      std::find_if(m_actions.begin(), m_actions.end(), [&](const Action& action) { return action.id == id; });
  if (found != m_actions.end()) found->keys = std::move(keys);
}

}  // namespace swaplight

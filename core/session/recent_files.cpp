#include "core/session/recent_files.h"

#include <algorithm>
#include <exception>

#include "core/base/json.h"
#include "core/file/json_file.h"

namespace swaplight {

RecentFiles::RecentFiles(std::filesystem::path file) : m_list(std::move(file)) {
  try {
    if (!std::filesystem::exists(m_list)) return;
    const Json list = readJson(m_list);
    for (const Json& entry : list.at("recent"))
      if (entry.is_string() && m_files.size() < kLimit) m_files.emplace_back(entry.get<std::string>());
  } catch (const std::exception&) {
    m_files.clear();
  }
}

void RecentFiles::add(const std::filesystem::path& file) {
  const std::filesystem::path path = std::filesystem::absolute(file).lexically_normal();
  m_files.erase(std::remove(m_files.begin(), m_files.end(), path), m_files.end());
  m_files.insert(m_files.begin(), path);
  if (m_files.size() > kLimit) m_files.resize(kLimit);
  write();
}

void RecentFiles::clear() {
  m_files.clear();
  write();
}

void RecentFiles::write() const {
  Json list = Json::array();
  for (const std::filesystem::path& file : m_files) list.push_back(file.string());
  try {
    std::filesystem::create_directories(m_list.parent_path());
    writeJson(Json{{"recent", list}}, m_list);
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace swaplight

#include "core/filter/filter_header.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/file/json_file.h"

namespace swaplight {

FilterHeader headerOf(const std::string& text, const std::string& name) {
  const size_t open = text.find("/*");
  const size_t begin = open == std::string::npos ? open : text.find_first_not_of(" \t\r\n", open + 2);
  if (begin == std::string::npos || text[begin] != '{')
    throw InputError(
        "{}: no ISF header; a filter begins with /*{{ \"INPUTS\": [{{\"NAME\": \"inputImage\", \"TYPE\": "
        "\"image\"}}] }}*/",
        name);
  const size_t end = text.find("*/", begin);
  if (end == std::string::npos) throw InputError("{}: the header's comment has no end: add }}*/", name);
  // Behind as many line ends as the file has before it, so that the line of which an error speaks is the
  // file's.
  const auto linesBefore = static_cast<size_t>(lineOf(text, begin) - 1);
  return {begin, end,
          parseJson(std::string(linesBefore, '\n') + text.substr(begin, end - begin), name + ": the header")};
}

int lineOf(const std::string& text, size_t offset) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<ptrdiff_t>(offset), '\n'));
}

}  // namespace swaplight

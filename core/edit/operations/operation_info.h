#pragma once

namespace swaplight {

/// What a light edit is called.
struct OperationInfo {
  const char* name;    ///< in files
  const char* title;   ///< in the studio's menu
  const char* tip;     ///< in the studio's menu
  bool inMenu = true;  ///< false where the studio makes it in another way than from its menu
};

}  // namespace swaplight

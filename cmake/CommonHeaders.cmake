# Precompiled headers: what nearly every file of a room reads, compiled once. Files still name every header that they
# use: CMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without (the tidy preset does).
#
#   swaplight_headers(swaplight_app_headers HEADERS <CLI/CLI.hpp> LINK CLI11::CLI11)
#
# The targets of this folder and those below reuse them (swaplight_library, and swaplight_reuse_headers for others).
# Their compile options must be the same but for -O1 to -O3, and so add_compile_options stands before.

set(SWAPLIGHT_COMMON_HEADERS <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <memory> <optional>
  <span> <string> <utility> <vector> <fmt/format.h> <fmt/ranges.h> <glm/glm.hpp> <nlohmann/json.hpp>)
set(SWAPLIGHT_COMMON_LIBRARIES fmt::fmt glm::glm nlohmann_json::nlohmann_json)

macro(swaplight_headers name)
  cmake_parse_arguments(HEADERS "" "" "HEADERS;LINK" ${ARGN})
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/common_headers.cpp)
  target_precompile_headers(${name} PRIVATE ${SWAPLIGHT_COMMON_HEADERS} ${HEADERS_HEADERS})
  target_link_libraries(${name} PRIVATE ${SWAPLIGHT_COMMON_LIBRARIES} ${HEADERS_LINK})
  set(SWAPLIGHT_HEADERS ${name})
endmacro()

# ccache takes precompiled headers only from what g++ has preprocessed with this option.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
  add_compile_options(-fpch-preprocess)
endif()

# Only for targets that know fmt: precompiled headers are refused where the definitions that they saw are others.
function(swaplight_reuse_headers target)
  if(SWAPLIGHT_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${SWAPLIGHT_HEADERS})
  endif()
endfunction()

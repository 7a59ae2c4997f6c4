# A folder is a library:
#
#   swaplight_library(swaplight_relight
#     SOURCES rig.cpp rig.h ...     all of the folder
#     KERNELS weights_kernel.cpp    compiled once for each class of processor (core/simd/simd.h)
#     LINK swaplight_set ...        the project's libraries that its files include, each named
#     PUBLIC glm::glm               others that its headers include
#     PRIVATE TBB::tbb)             others that its sources include
#
# With SWAPLIGHT_UNITY (the presets of releases and sanitizers) several sources of a folder are compiled as one: most of
# the compiler's time goes into headers. What is local to a file must then have a name of its own in its folder.
#
# The link line is the architecture: a test refuses an include that the line does not name, a file that is not
# listed, and circles (tests/structure).

option(SWAPLIGHT_UNITY "Compile several sources of a folder as one: a whole build is faster, one after a small change slower" OFF)
set(SWAPLIGHT_KERNEL_LEVELS "all" CACHE STRING "all: kernels for each class of processor; native: for this one only")
set(SWAPLIGHT_LEVELS 1)
set(SWAPLIGHT_LEVEL_1_OPTIONS "")
if(SWAPLIGHT_SANITIZE OR SWAPLIGHT_KERNEL_LEVELS STREQUAL "native")
  add_compile_definitions(SWAPLIGHT_ONE_LEVEL)  # core/simd/simd.h
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND SWAPLIGHT_LEVELS 3 4)
endif()
if(SWAPLIGHT_KERNEL_LEVELS STREQUAL "native")
  set(SWAPLIGHT_LEVEL_1_OPTIONS -march=native)
endif()
set(SWAPLIGHT_LEVEL_3_OPTIONS -march=x86-64-v3)
set(SWAPLIGHT_LEVEL_4_OPTIONS -march=x86-64-v4)

# Compiles files of kernels once for each class of processor, into a target.
function(swaplight_kernels target)
  foreach(level IN LISTS SWAPLIGHT_LEVELS)
    set(kernels ${target}_level${level})
    add_library(${kernels} OBJECT ${ARGN})
    target_include_directories(${kernels} PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_definitions(${kernels} PRIVATE SWAPLIGHT_LEVEL=level${level})
    target_compile_options(${kernels} PRIVATE -O3 --param=max-completely-peeled-insns=2000
      --param=max-completely-peel-times=64 ${SWAPLIGHT_LEVEL_${level}_OPTIONS})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
    set_property(GLOBAL APPEND PROPERTY SWAPLIGHT_KERNELS ${kernels})
  endforeach()
endfunction()

function(swaplight_library name)
  cmake_parse_arguments(PARSE_ARGV 1 LIB "" "" "SOURCES;KERNELS;LINK;PUBLIC;PRIVATE")
  add_library(${name} STATIC ${LIB_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${LIB_LINK} ${LIB_PUBLIC} PRIVATE ${LIB_PRIVATE})
  set_target_properties(${name} PROPERTIES UNITY_BUILD ${SWAPLIGHT_UNITY} UNITY_BUILD_BATCH_SIZE 16)
  if("swaplight_base" IN_LIST LIB_LINK)  # it brings fmt, whose definitions the precompiled headers have seen
    swaplight_reuse_headers(${name})
  endif()
  if(LIB_KERNELS)
    swaplight_kernels(${name} ${LIB_KERNELS})
  endif()
endfunction()

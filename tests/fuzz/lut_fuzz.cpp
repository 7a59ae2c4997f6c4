#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>

#include "core/ocio/color_config.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

namespace {

constexpr const char* kConfig = R"(ocio_profile_version: 2
search_path: .
roles: {default: lin, scene_linear: lin}
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  d:
    - !<View> {name: v, colorspace: table}
colorspaces:
  - !<ColorSpace> {name: lin, isdata: false}
  - !<ColorSpace>
      name: table
      isdata: false
      from_scene_reference: !<FileTransform> {src: TABLE, interpolation: linear}
)";

/// A table, and a configuration that names it, in a folder of its own in memory.
std::string configWith(const std::string& bytes, const std::string& table) {
  static const std::string folder = [] {
    std::string name = "/dev/shm/swaplight-lut-XXXXXX";
    if (!::mkdtemp(name.data())) std::abort();
    return name;
  }();
  std::ofstream(folder + "/" + table, std::ios::binary) << bytes;
  const std::string file = folder + "/" + table + ".ocio";
  if (static std::set<std::string> written; written.insert(file).second) {
    std::string config = kConfig;
    config.replace(config.find("TABLE"), 5, table);
    std::ofstream(file) << config;
  }
  return file;
}

}  // namespace

// The first byte says which kind of table, the rest is the table.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  constexpr const char* kNames[] = {"t.cube", "t.spi1d", "t.spi3d", "t.3dl",
                                    "t.csp",  "t.clf",   "t.cdl",   "t.icc"};
  const std::string file = configWith(fuzz::textOf(data + 1, size - 1), kNames[data[0] % 8]);
  fuzz::load([&] {
    const ColorConfig config(file);
    Image pixels(ImageSpec::rgb(2, 2), 0.3F);
    config.convert(pixels.span(), "lin", "table");
  });
  return 0;
}

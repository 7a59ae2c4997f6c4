#include <OpenColorIO/OpenColorIO.h>
#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <cstdlib>

#include "app/program/description.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/parallel.h"
#include "core/base/version.h"
#include "core/diagnosis/crash_report.h"
#include "core/diagnosis/machine_facts.h"
#include "core/file/user_folders.h"
#include "core/image/io/picture_process.h"
#include "core/lamp/gel.h"
#include "core/ocio/chosen_config.h"
#include "core/simd/simd.h"
#include "render/gl/egl_context.h"
#include "render/gl/gl_info.h"
#include "ui/kit/font_files.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

/// A report for people and programs; what is wrong is counted.
class Findings {
 public:
  void good(const std::string& what, const std::string& words) { add(what, words, true); }
  void bad(const std::string& what, const std::string& words) { add(what, "PROBLEM: " + words, false); }
  [[nodiscard]] const Description& description() const { return m_description; }

 private:
  void add(const std::string& what, const std::string& words, bool good) {
    m_description.line(what, words);
    m_description.json["facts"].push_back({{"what", what}, {"words", words}, {"good", good}});
  }
  Description m_description;
};

void examineMachine(Findings& findings) {
  const MachineMemory memory = machineMemory();
  findings.good("version", fmt::format("swaplight {}", version()));
  findings.good("system", systemWords());
  findings.good("processor",
                fmt::format("{}, class {}, {} used", processorWords(), processorLevel(), threadCount()));
  const std::string words =
      fmt::format("{:.1f} GB, {:.1f} GB free", memory.gigabytes, memory.availableGigabytes);
  constexpr double kLittle = 1;
  if (memory.availableGigabytes < kLittle)
    findings.bad("memory", words + ": a photograph of 50 megapixels takes 0.6 GB a light");
  else
    findings.good("memory", words);
}

void examineGraphics(Findings& findings) {
  const char* display = std::getenv("WAYLAND_DISPLAY");
  if (!display) display = std::getenv("DISPLAY");
  findings.good("display", display ? display : "none: the studio needs one, the other verbs do not");
  try {
    const EglContext context;
    const GlInfo info = glInfo();
    findings.good("graphics", fmt::format("{}, {}, OpenGL {}, pictures to {} pixels{}", info.renderer,
                                          info.vendor, info.version, info.maxTextureSize,
                                          info.software ? ", drawn by the processor" : ""));
  } catch (const std::exception& error) {
    findings.bad("graphics", error.what());
  }
}

void examineColor(Findings& findings) {
  const char* file = std::getenv("OCIO");
  try {
    const auto config = programConfig();
    findings.good("colour", fmt::format("OpenColorIO {}, {}, {} colour spaces, {} displays",
                                        OCIO_NAMESPACE::GetVersion(), config->name(),
                                        config->colorSpaces().size(), config->displays().size()));
  } catch (const std::exception& error) {
    findings.bad("colour", fmt::format("$OCIO is {}: {}", file ? file : "not set", error.what()));
  }
}

void examinePictures(Findings& findings) {
  findings.good("pictures",
                fmt::format("OpenImageIO {}, decoded {}", OIIO_VERSION_STRING, pictureProcessWords()));
  const std::string libraries = OIIO::get_string_attribute("library_list");
  const size_t raw = libraries.find("raw:");
  if (raw == std::string::npos)
    findings.bad("cameras", "OpenImageIO was built without LibRaw: camera raw cannot be read");
  else
    findings.good("cameras", libraries.substr(raw + 4, libraries.find(';', raw) - raw - 4));
  try {
    findings.good("lamps",
                  fmt::format("{} gels, {} of them of the program", allGels().size(), builtInGels().size()));
  } catch (const std::exception& error) {
    findings.bad("lamps", error.what());
  }
}

void examineFonts(Findings& findings) {
  for (const fs::path& file : {kInterFolder / "Inter-Regular.otf", kIconFontFile}) {
    if (fs::exists(file))
      findings.good("fonts", file.string());
    else
      findings.bad("fonts",
                   fmt::format("{} is missing: install fonts-inter, fonts-material-design-icons-iconfont",
                               file.string()));
  }
}

/// The folder, or the one that it would be made in.
fs::path existing(fs::path folder) {
  std::error_code error;
  while (!fs::is_directory(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
  return folder;
}

void examineFolders(Findings& findings) {
  for (const auto& [what, folder] : {std::pair("settings", configFolder()), std::pair("data", dataFolder()),
                                     std::pair("state", stateFolder())}) {
    std::error_code error;
    const fs::path place = existing(folder);
    const fs::space_info space = fs::space(place, error);
    const std::string words =
        fmt::format("{}, {:.1f} GB free", folder.string(), 1e-9 * double(space.available));
    if (::access(place.c_str(), W_OK) != 0)
      findings.bad(what, words + fmt::format("; {} cannot be written", place.string()));
    else
      findings.good(what, words);
  }
  int reports = 0;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(stateFolder() / "crash", error))
    reports += entry.path().filename().string().starts_with("crash-");
  findings.good("crashes",
                reports == 0 ? "none known"
                             : fmt::format("{} reports in {}", reports, (stateFolder() / "crash").string()));
}

}  // namespace

void addDoctorVerb(Program& program) {
  program.addVerb("doctor", "Say what this machine has for the program: to be pasted into reports of faults",
                  [](Terminal& terminal) {
                    Findings findings;
                    examineMachine(findings);
                    examineGraphics(findings);
                    examineColor(findings);
                    examinePictures(findings);
                    examineFonts(findings);
                    examineFolders(findings);
                    terminal.result(findings.description().text, findings.description().json);
                    return 0;
                  });
}

}  // namespace swaplight

// What it costs to decode strangers' pictures in a process of their own: each file is read by turns there and
// in the program itself. Prints a table. Fails where it costs more than 5 % of the file's time and more than
// 20 ms. usage: decode_bench FOLDER [PAIRS]     (9; its files lie in FOLDER, and have been read before: no
// disk is measured)
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

#include "core/image/io/image_io.h"
#include "core/image/io/picture_process.h"

using namespace swaplight;  // NOLINT(google-build-using-namespace)

namespace {

constexpr double kMostPart = 0.05, kMostSeconds = 0.02;

/// A process that reads pictures and says how long each took.
class Reader {
 public:
  /// Before there are threads.
  explicit Reader(bool apart) {
    int asked[2] = {}, answered[2] = {};
    if (::pipe(asked) != 0 || ::pipe(answered) != 0 || (m_process = ::fork()) < 0) std::abort();
    m_to = m_process == 0 ? answered[1] : asked[1];
    m_from = m_process == 0 ? asked[0] : answered[0];
    ::close(m_process == 0 ? asked[1] : answered[1]);
    if (m_process == 0) serve(apart);
  }
  double seconds(const std::filesystem::path& file) const {
    const std::string name = file.string() + '\n';
    double taken = 0;
    if (::write(m_to, name.data(), name.size()) != static_cast<ssize_t>(name.size()) ||
        ::read(m_from, &taken, sizeof taken) != sizeof taken)
      std::abort();
    return taken;
  }

 private:
  [[noreturn]] void serve(bool apart) const {
    std::optional<PictureProcesses> processes;
    if (apart) processes.emplace();
    FILE* names = ::fdopen(m_from, "r");
    std::string name(4096, '\0');
    while (std::fgets(name.data(), static_cast<int>(name.size()), names)) {
      const auto begun = std::chrono::steady_clock::now();
      const ImageFile file = readImage(name.substr(0, name.find('\n')));
      const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
      if (::write(m_to, &taken, sizeof taken) != sizeof taken) break;
    }
    processes.reset();
    ::_exit(0);
  }
  int m_to = -1, m_from = -1;
  pid_t m_process = -1;
};

/// Gradients with grain, so that it compresses as a photograph does.
Image photograph(int width, int height) {
  Image image(ImageSpec::rgb(width, height), 0);
  std::mt19937 random(1);
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        image.span().row(c, y)[x] =
            0.1F + 0.6F * static_cast<float>(x + c * y) / static_cast<float>(width + 2 * height) +
            0.01F * static_cast<float>(random() % 256) / 256;
  return image;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

struct Format {
  const char *extension, *type;
};
constexpr Format kFormats[] = {{"exr", "half"},   {"exr", "float"}, {"tif", "uint16"}, {"tif", "uint8"},
                               {"png", "uint16"}, {"png", "uint8"}, {"jpg", "uint8"},  {"hdr", "float"}};

/// False where it costs too much.
bool measure(const std::filesystem::path& file, const std::string& name, int pairs, const Reader& here,
             const Reader& apart) {
  std::vector<double> times, differences;
  here.seconds(file), apart.seconds(file);
  for (int pair = 0; pair < pairs; ++pair) {
    const bool first = pair % 2 == 0;
    const double one = (first ? here : apart).seconds(file), two = (first ? apart : here).seconds(file);
    times.push_back(first ? one : two);
    differences.push_back(first ? two - one : one - two);
  }
  const double time = median(times), more = median(differences);
  std::printf("| %-26s | %8.1f | %+8.1f | %+5.1f %% |\n", name.c_str(), 1e3 * time, 1e3 * more,
              100 * more / time);
  std::fflush(stdout);
  return more <= std::max(kMostPart * time, kMostSeconds);
}

}  // namespace

int main(int argc, char** argv) {
  const Reader here(false), apart(true);
  if (argc < 2) return std::fprintf(stderr, "usage: decode_bench FOLDER [PAIRS]\n"), 2;
  const std::filesystem::path folder = argv[1];
  const int pairs = argc > 2 ? std::atoi(argv[2]) : 9;
  bool cheap = true;
  std::printf("| file | in the program, ms | more, ms | of it |\n|---|---|---|---|\n");
  for (const auto& [width, height] : {std::pair{1920, 1080}, {3840, 2160}}) {
    const Image image = photograph(width, height);
    for (const Format& format : kFormats) {
      WriteOptions options;
      options.pixelType = format.type;
      const auto file = folder / fmt::format("{}.{}.{}", width, format.type, format.extension);
      writeImage(image, file, options);
      const std::string name = fmt::format("{}, {}, {} x {}", format.extension, format.type, width, height);
      cheap = measure(file, name, pairs, here, apart) && cheap;
      std::filesystem::remove(file);
    }
  }
  return cheap ? 0 : 1;
}

#include "core/export/look_export.h"

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/export/frame_file.h"
#include "core/file/atomic_file.h"
#include "core/relight/relight.h"

namespace swaplight {
namespace {

constexpr int kCubeSize = 33;

std::string notice(const GlobalLook& look) {
  return fmt::format(
      "The global part of a Swaplight look only: one gain for every pixel, which reproduces {:.1f} % of the "
      "relit picture. What each light does on its own differs from pixel to pixel and is not in this file.",
      100 * look.explained);
}

std::string correctionXml(const GlobalLook& look, bool collection) {
  const std::string correction = fmt::format(
      "  <ColorCorrection id=\"swaplight_global\">\n"
      "    <SOPNode>\n"
      "      <Description>{}</Description>\n"
      "      <Slope>{:.6f} {:.6f} {:.6f}</Slope>\n"
      "      <Offset>0 0 0</Offset>\n"
      "      <Power>1 1 1</Power>\n"
      "    </SOPNode>\n"
      "    <SatNode>\n      <Saturation>1</Saturation>\n    </SatNode>\n"
      "  </ColorCorrection>\n",
      notice(look), look.gain.x, look.gain.y, look.gain.z);
  const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  if (!collection) return head + correction;
  return head + "<ColorCorrectionCollection xmlns=\"urn:ASC:CDL:v1.2\">\n" + correction +
         "</ColorCorrectionCollection>\n";
}

/// The lattice of a cube as a picture: red runs fastest.
Image lattice() {
  Image image(ImageSpec::rgb(kCubeSize * kCubeSize, kCubeSize));
  const auto value = [](int i) { return static_cast<float>(i) / static_cast<float>(kCubeSize - 1); };
  for (int p = 0; p < kCubeSize * kCubeSize * kCubeSize; ++p) {
    image.plane(0)[p] = value(p % kCubeSize);
    image.plane(1)[p] = value(p / kCubeSize % kCubeSize);
    image.plane(2)[p] = value(p / kCubeSize / kCubeSize);
  }
  return image;
}

std::string cubeText(const ColorConfig& config, const GlobalLook& look, const DisplayChoice& choice) {
  const DisplayChoice seen = namedDisplay(config, choice);
  Image image = lattice();
  ColorConfig("").convert(image.span(), "acescct", "lin_rec709");
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p) image.plane(c)[p] *= look.gain[c];
  config.applyView(image.span(), "lin_rec709", seen);
  std::string text = fmt::format(
      "# {}\n# Input: ACEScct. Output: {}.\nTITLE \"Swaplight: global part, {}\"\nLUT_3D_SIZE {}\n"
      "DOMAIN_MIN 0 0 0\nDOMAIN_MAX 1 1 1\n",
      notice(look), displayWords(seen), displayWords(seen), kCubeSize);
  for (size_t p = 0; p < image.pixelCount(); ++p)
    text += fmt::format("{:.6f} {:.6f} {:.6f}\n", image.plane(0)[p], image.plane(1)[p], image.plane(2)[p]);
  return text;
}

}  // namespace

GlobalLook globalLook(const ColorConfig& config, const SolvedSet& set, const Rig& rig) {
  const Image white = sumAtUnitWhite(set);
  const Image relit = relight(set, rigFactors(config, rig, set.colorSpace()), rig.ambient);
  GlobalLook look;
  double energy = 0;
  double missed = 0;
  for (int c = 0; c < 3; ++c) {
    double product = 0;
    double square = 0;
    double own = 0;
    for (size_t p = 0; p < white.pixelCount(); ++p) {
      const double w = white.plane(c)[p];
      const double r = relit.plane(c)[p];
      product += w * r;
      square += w * w;
      own += r * r;
    }
    const double gain = square > 0 ? product / square : 1;
    look.gain[c] = static_cast<float>(gain);
    energy += own;
    missed += own - gain * product;
  }
  look.explained = energy > 0 ? 1 - missed / energy : 1;
  return look;
}

bool isLookFile(const std::filesystem::path& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".cube" || extension == ".ccc" || extension == ".cc";
}

void writeLook(const ColorConfig& config, const GlobalLook& look, const DisplayChoice& display,
               const std::filesystem::path& file) {
  const std::string extension = lowerExtension(file);
  writeFile(file, extension == ".cube" ? cubeText(config, look, display)
                                       : correctionXml(look, extension == ".ccc"));
}

}  // namespace swaplight

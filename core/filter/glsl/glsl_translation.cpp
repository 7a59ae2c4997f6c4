#include "core/filter/glsl/glsl_translation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <regex>
#include <set>

#include "core/filter/glsl/glsl_loops.h"
#include "core/filter/glsl/glsl_tokens.h"

namespace swaplight {
namespace {

using Tokens = std::vector<GlslToken>;

/// Words that ISF's GLSL 1.20 leaves free and 4.10 does not.
const std::set<std::string>& newlyReserved() {
  static const std::set<std::string> words = {
      "sample",   "patch",     "smooth", "flat",      "centroid", "noperspective", "subroutine", "layout",
      "common",   "active",    "filter", "partition", "resource", "input",         "output",     "precise",
      "uint",     "superp",    "half",   "fixed",     "template", "this",          "class",      "union",
      "enum",     "packed",    "using",  "public",    "static",   "extern",        "external",   "interface",
      "long",     "short",     "double", "unsigned",  "switch",   "case",          "default",    "inline",
      "noinline", "namespace", "cast",   "sizeof",    "typedef"};
  return words;
}

std::string replacementOf(const std::string& word, bool vertex) {
  static const std::map<std::string, std::string> both = {{"vv_FragNormCoord", "isf_FragNormCoord"},
                                                          {"vv_vertShaderInit", "isf_vertShaderInit"},
                                                          {"texture2D", "texture"},
                                                          {"texture2DRect", "texture"},
                                                          {"sampler2DRect", "sampler2D"},
                                                          {"main", "isf_userMain"}};
  static const std::map<std::string, std::string> inFragment = {
      {"gl_FragColor", "isf_FragColor"}, {"gl_FragCoord", "isf_FragCoord"}, {"varying", "in"}};
  static const std::map<std::string, std::string> inVertex = {
      {"varying", "out"}, {"attribute", "const"}, {"gl_Vertex", "isf_position"}};
  for (const auto* table : {&both, vertex ? &inVertex : &inFragment})
    if (const auto found = table->find(word); found != table->end()) return found->second;
  return word;
}

bool isNewGlsl(const std::string& number) {
  int version = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), version);
  return error == std::errc::result_out_of_range || version >= 130;
}

/// Whole numbers without a sign: in GLSL 1.20 there are none, and no name is followed by another.
bool hasUnsignedType(const Tokens& tokens) {
  for (size_t at = 0; at < tokens.size(); ++at) {
    if (tokens[at].is("uvec2") || tokens[at].is("uvec3") || tokens[at].is("uvec4")) return true;
    if (!tokens[at].is("uint")) continue;
    const size_t next = nextToken(tokens, at + 1);
    if (next < tokens.size() && tokens[next].kind == GlslToken::Kind::Word) return true;
  }
  return false;
}

/// Written for a newer GLSL than ISF's: words such as switch and uint keep their meaning.
bool isForNewGlsl(const Tokens& tokens) {
  for (size_t at = 0; at < tokens.size(); ++at) {
    if (!tokens[at].is("#")) continue;
    const size_t word = nextToken(tokens, at + 1);
    if (word >= tokens.size() || !tokens[word].is("version")) continue;
    const size_t number = nextToken(tokens, word + 1);
    if (number < tokens.size() && tokens[number].kind == GlslToken::Kind::Number)
      return isNewGlsl(tokens[number].text);
  }
  return hasUnsignedType(tokens);
}

/// Directives that the translation's own replace: to blanks, up to the end of the line.
void dropDirectives(Tokens& tokens) {
  for (size_t at = 0; at < tokens.size(); ++at) {
    if (!tokens[at].is("#")) continue;
    const size_t word = nextToken(tokens, at + 1);
    if (word >= tokens.size() || !(tokens[word].is("version") || tokens[word].is("extension"))) continue;
    for (size_t i = at; i < tokens.size() && tokens[i].text.find('\n') == std::string::npos; ++i)
      tokens[i] = {GlslToken::Kind::Blank, " "};
  }
}

struct ImageCall {
  const char* isf;
  const char* function;
  bool elsewhere;
};
constexpr std::array<ImageCall, 5> kImageCalls = {{{"IMG_PIXEL", "isf_pixel", true},
                                                   {"IMG_NORM_PIXEL", "isf_normPixel", true},
                                                   {"IMG_THIS_PIXEL", "isf_thisPixel", false},
                                                   {"IMG_THIS_NORM_PIXEL", "isf_thisPixel", false},
                                                   {"IMG_SIZE", "isf_size", false}}};

/// IMG_PIXEL(image, p) becomes isf_pixel(image, isf_window_image, p), and so on.
bool replaceImageCalls(Tokens& tokens, const std::set<std::string>& images) {
  bool elsewhere = false;
  for (size_t at = 0; at < tokens.size(); ++at) {
    const auto call = std::find_if(kImageCalls.begin(), kImageCalls.end(),
                                   [&](const ImageCall& row) { return tokens[at].is(row.isf); });
    if (tokens[at].is("texture2D") || tokens[at].is("texture2DRect") || tokens[at].is("texture"))
      elsewhere = true;
    if (call == kImageCalls.end()) continue;
    const size_t open = nextToken(tokens, at + 1);
    const size_t image = nextToken(tokens, open + 1);
    if (image >= tokens.size() || !tokens[open].is("(") || tokens[image].kind != GlslToken::Kind::Word)
      continue;
    tokens[at].text = call->function;
    elsewhere = elsewhere || call->elsewhere;
    const std::string& name = tokens[image].text;
    // The sampler may be the parameter of a function: then it is taken to be all of its image.
    tokens[image].text = images.contains(name)
                             ? fmt::format("{0}, isf_window_{0}", name)
                             : fmt::format("{0}, vec4(0.0, 0.0, vec2(textureSize({0}, 0)))", name);
  }
  return elsewhere;
}

/// ISF's older names of an image's rectangle and size.
void replaceImageNames(Tokens& tokens, const std::set<std::string>& images) {
  std::map<std::string, std::string> names;
  for (const std::string& image : images) {
    names["_" + image + "_imgRect"] = "vec4(0.0, 0.0, 1.0, 1.0)";
    names["_" + image + "_imgSize"] = fmt::format("isf_window_{}.zw", image);
    names["_" + image + "_flip"] = "false";
  }
  for (GlslToken& token : tokens) {
    if (token.kind != GlslToken::Kind::Word || token.text[0] != '_') continue;
    if (const auto found = names.find(token.text); found != names.end()) token.text = found->second;
  }
}

std::string translateBody(const std::string& source, const std::set<std::string>& images, bool vertex,
                          bool maySkipBounds, bool& elsewhere) {
  Tokens tokens = glslTokens(source);
  const bool modern = isForNewGlsl(tokens);
  dropDirectives(tokens);
  elsewhere = replaceImageCalls(tokens, images) || elsewhere;
  replaceImageNames(tokens, images);
  for (GlslToken& token : tokens) {
    if (token.kind != GlslToken::Kind::Word) continue;
    token.text = replacementOf(token.text, vertex);
    if (!modern) token.text = glslName(token.text);
  }
  if (!maySkipBounds) boundLoops(tokens);
  return glslText(tokens);
}

/// "vec3" or "mat3": of as many numbers, or rows, as the default.
std::string sizedType(const char* kind, const FilterInput& input) {
  const auto* vector = std::get_if<FilterVector>(&input.standard);
  return fmt::format("{}{}", kind, vector ? vector->size() : std::get<FilterMatrix>(input.standard).size());
}

std::string glslType(const FilterInput& input) {
  switch (input.type) {
    case FilterInputType::Event:
    case FilterInputType::Bool:
      return "bool";
    case FilterInputType::Choice:
      return "int";
    case FilterInputType::Float:
      return "float";
    case FilterInputType::Point2D:
      return "vec2";
    case FilterInputType::Color:
      return "vec4";
    case FilterInputType::Image:
    case FilterInputType::Audio:
    case FilterInputType::AudioSpectrum:
      return "sampler2D";
    case FilterInputType::Vector:
      return sizedType("vec", input);
    case FilterInputType::Matrix:
      return sizedType("mat", input);
    case FilterInputType::Curve:
      return "float";  // of its function
  }
  return "float";
}

/// A curve is a function: cubic Hermite pieces through points of x, y and slope, constant beyond them.
std::string curveFunction(const std::string& name) {
  return fmt::format(
      "uniform vec3 isf_points_{0}[{1}];\nuniform int isf_count_{0};\n"
      "float {0}(float x) {{\n"
      "  vec3 first = isf_points_{0}[0], last = isf_points_{0}[isf_count_{0} - 1];\n"
      "  if (!(x > first.x)) return first.y;\n"
      "  if (x >= last.x) return last.y;\n"
      "  int i = 0;\n"
      "  for (int k = 1; k < isf_count_{0} - 1; ++k) if (x >= isf_points_{0}[k].x) i = k;\n"
      "  vec3 a = isf_points_{0}[i], b = isf_points_{0}[i + 1];\n"
      "  float h = b.x - a.x, t = (x - a.x) / h, u = 1.0 - t;\n"
      "  return u * u * (1.0 + 2.0 * t) * a.y + t * t * (3.0 - 2.0 * t) * b.y + h * t * u * (u * a.z - t * "
      "b.z);\n"
      "}}\n",
      name, kMostCurvePoints);
}

std::string declaration(const FilterInput& input) {
  const std::string type = glslType(input), name = glslName(input.name);
  if (type == "sampler2D") return {};
  return input.type == FilterInputType::Curve ? curveFunction(name)
                                              : fmt::format("uniform {} {};\n", type, name);
}

std::vector<std::string> imagesOf(const Filter& filter) {
  std::vector<std::string> images;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && std::find(images.begin(), images.end(), name) == images.end())
      images.push_back(name);
  };
  if (filter.takesImage) add("inputImage");
  for (const FilterInput& input : filter.inputs)
    if (glslType(input) == "sampler2D") add(input.name);
  for (const FilterPass& pass : filter.passes) add(pass.target);
  for (const FilterImport& import : filter.imports) add(import.name);
  add(filter.overview);
  add(filter.light);
  return images;
}

/// What the filter's own passes draw, or those before it.
bool isDrawn(const Filter& filter, const std::string& image) {
  return image == "inputImage" || std::any_of(filter.passes.begin(), filter.passes.end(),
                                              [&](const FilterPass& pass) { return pass.target == image; });
}

/// Functions that read an image of this kind of sampler, by the pixel of all of it; `window` says where its
/// texture begins, and its whole size. `level` ends the arguments of a texel, `between` reads
/// between them.
std::string readers(const Filter& filter, const char* sampler, const char* level, const char* between) {
  const char* read = filter.nearest ? "isf_texel(image, floor(p - window.xy))" : between;
  return fmt::format(
      "vec4 isf_texel({0} image, vec2 at) {{\n"
      "  return texelFetch(image, clamp(ivec2(at), ivec2(0), textureSize(image{1}) - 1){1});\n}}\n"
      "vec4 isf_pixel({0} image, vec4 window, vec2 p) {{ return {2}; }}\n"
      "vec4 isf_normPixel({0} image, vec4 window, vec2 p) {{ return isf_pixel(image, window, p * window.zw); "
      "}}\n"
      "vec2 isf_size({0} image, vec4 window) {{ return window.zw; }}\n",
      sampler, level, read);
}

std::string declarations(const Filter& filter, const std::vector<std::string>& images,
                         const TranslationOptions& options) {
  std::string text =
      "#version 410 core\n#define SWAPLIGHT 1\nuniform vec2 RENDERSIZE;\nuniform float TIME;\nuniform float "
      "TIMEDELTA;\n"
      "uniform vec4 DATE;\nuniform int FRAMEINDEX;\nuniform vec2 isf_origin;\nuniform vec4 isf_target;\n"
      "uniform vec2 isf_bounds;\nuniform float isf_notANumber;\n";
  text += options.pass ? fmt::format("const int PASSINDEX = {};\n", *options.pass)
                       : std::string("uniform int PASSINDEX;\n");
  for (const FilterInput& input : filter.inputs) text += declaration(input);
  for (const std::string& image : images) {
    const char* sampler = options.rectangles && isDrawn(filter, image) ? "sampler2DRect" : "sampler2D";
    text += fmt::format("uniform {1} {0};\nuniform vec4 isf_window_{0};\n", image, sampler);
  }
  text += fmt::format("int isf_turns = 0;\nbool isf_go() {{ return ++isf_turns <= {}; }}\n", kMostLoopTurns);
  return text +
         readers(filter, "sampler2D", ", 0",
                 "textureLod(image, (p - window.xy) / vec2(textureSize(image, 0)), 0.0)") +
         readers(filter, "sampler2DRect", "", "texture(image, p - window.xy)");
}

constexpr const char* kFragmentStart =
    "out vec4 isf_FragColor;\n"
    "#define isf_FragCoord vec4(gl_FragCoord.xy + isf_origin, gl_FragCoord.zw)\n"
    "#define isf_FragNormCoord ((gl_FragCoord.xy + isf_origin) / RENDERSIZE)\n";

/// The pixel that is drawn, of an image.
std::string thisPixel(const char* sampler) {
  return fmt::format(
      "vec4 isf_thisPixel({} image, vec4 window) {{\n"
      "  if (window.zw == RENDERSIZE) return isf_texel(image, gl_FragCoord.xy + isf_origin - window.xy);\n"
      "  return isf_normPixel(image, window, isf_FragNormCoord);\n"
      "}}\n",
      sampler);
}

constexpr const char* kFragmentEnd =
    "\nvoid main() {\n"
    "  isf_FragColor = vec4(0.0);\n"
    "  isf_userMain();\n"
    "  bvec4 isf_broken = isnan(isf_FragColor);\n"
    "  isf_FragColor = mix(clamp(isf_FragColor, isf_bounds.x, isf_bounds.y), vec4(isf_notANumber), "
    "isf_broken);\n"
    "}\n";

// A quad of four corners, so that what an author computes at them is interpolated as in other programs.
constexpr const char* kVertexStart =
    "vec2 isf_corner;\nvec2 isf_FragNormCoord;\nvec4 isf_position;\n"
    "void isf_vertShaderInit() {\n"
    "  gl_Position = vec4(isf_corner * 2.0 - 1.0, 0.0, 1.0);\n"
    "  isf_position = gl_Position;\n"
    "  isf_FragNormCoord = (isf_target.xy + isf_corner * isf_target.zw) / RENDERSIZE;\n"
    "}\n"
    "vec4 isf_thisPixel(sampler2D image, vec4 window) { return isf_normPixel(image, window, "
    "isf_FragNormCoord); }\n"
    "vec4 isf_thisPixel(sampler2DRect image, vec4 window) { return isf_normPixel(image, window, "
    "isf_FragNormCoord); }\n";

constexpr const char* kVertexEnd =
    "\nvoid main() {\n"
    "  isf_corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));\n"
    "  isf_vertShaderInit();\n"
    "  isf_userMain();\n"
    "}\n";

/// The first lines, none longer than can be read: they quote the source, and a regular expression's search
/// goes a step deeper with each letter.
std::string beginningOf(const std::string& log) {
  constexpr size_t kMostLines = 20, kLongestLine = 200;
  std::string beginning;
  for (size_t line = 0, at = 0; line < kMostLines && at < log.size(); ++line) {
    const size_t end = std::min(log.find('\n', at), log.size());
    beginning += log.substr(at, std::min(end - at, kLongestLine)) + "\n";
    at = end + 1;
  }
  return beginning;
}

}  // namespace

std::string glslName(const std::string& name) {
  return newlyReserved().contains(name) ? "isf_word_" + name : name;
}

GlslTranslation translateFilter(const Filter& filter, const TranslationOptions& options) {
  GlslTranslation result;
  result.images = imagesOf(filter);
  const std::set<std::string> images(result.images.begin(), result.images.end());
  const std::string head = declarations(filter, result.images, options);
  result.fragment =
      head + kFragmentStart + thisPixel("sampler2D") + thisPixel("sampler2DRect") +
      fmt::format("#line {}\n", filter.sourceLine) +
      translateBody(filter.source, images, false, options.maySkipBounds, result.looksElsewhere) +
      kFragmentEnd;
  const std::string vertex = filter.vertexSource.empty() ? "void main() {}" : filter.vertexSource;
  bool ignored = false;
  result.vertex = head + kVertexStart + "#line 1\n" +
                  translateBody(vertex, images, true, options.maySkipBounds, ignored) + kVertexEnd;
  if (!filter.vertexSource.empty()) result.looksElsewhere = true;
  return result;
}

std::string compileErrorLine(const std::string& allWords, const std::string& file) {
  static const std::regex mesa("[0-9]+:([0-9]+)\\([0-9]+\\): *error: *([^\\n]*)");
  static const std::regex nvidia("[0-9]+\\(([0-9]+)\\) *: *error *[A-Z0-9]*:? *([^\\n]*)");
  static const std::regex others("ERROR: *[0-9]+:([0-9]+): *([^\\n]*)");
  static const std::regex renamed("isf_word_");
  const std::string log = beginningOf(allWords);
  for (const std::regex& pattern : {mesa, nvidia, others}) {
    std::smatch match;
    if (!std::regex_search(log, match, pattern)) continue;
    std::string words = std::regex_replace(match[2].str(), renamed, "");
    words = std::regex_replace(words, std::regex("isf_userMain"), "main");
    words = std::regex_replace(words, std::regex("isf_FragColor"), "gl_FragColor");
    return fmt::format("{}:{}: {}", file, match[1].str(), words);
  }
  return fmt::format("{}: {}", file, log.substr(0, log.find('\n')));
}

}  // namespace swaplight

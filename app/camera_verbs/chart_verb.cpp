#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "app/camera_verbs/camera_verbs.h"
#include "app/program/description.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/chart/camera_file.h"
#include "core/chart/chart_shot.h"
#include "core/chart/measured_gel.h"
#include "core/file/atomic_file.h"
#include "core/file/json_file.h"
#include "core/file/same_file.h"
#include "core/lamp/gel.h"
#include "core/ocio/chosen_config.h"

namespace swaplight {
namespace {

struct ChartCommand {
  std::vector<std::string> photographs;
  std::string output, corners, colorSpace, without, gels;
  std::vector<std::string> labels;
};

/// "X,Y,X,Y,X,Y,X,Y".
ChartCorners cornersFromText(const std::string& text) {
  std::istringstream parts(text);
  std::vector<double> numbers;
  for (std::string part; std::getline(parts, part, ',');)
    if (const auto number = numberFromText(part)) numbers.push_back(double(*number));
  if (numbers.size() != 8 || std::count(text.begin(), text.end(), ',') != 7)
    throw InputError(
        "--corners {}: write X,Y,X,Y,X,Y,X,Y: the outer corners of the chart's four corner patches, one "
        "after the other around it",
        text);
  ChartCorners corners;
  for (size_t j = 0; j < 4; ++j) corners[j] = {numbers[2 * j], numbers[2 * j + 1]};
  return corners;
}

/// The text of the gels' table; none yet where there is none.
std::string tableBefore(const ChartCommand& arguments) {
  return std::filesystem::exists(arguments.gels) ? readGelTable(arguments.gels) : std::string();
}

/// The same for all names of a file, there or not.
std::filesystem::path wholePath(const std::string& file) {
  std::error_code error;  // of what has no such path something else is said
  return std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
}

/// What is told of gels, all of it, before charts are looked for.
void checkGels(const ChartCommand& arguments) {
  const std::vector<std::string>&photographs = arguments.photographs, &labels = arguments.labels;
  if (labels.size() != photographs.size())
    throw InputError("--gel: {} of them for {} photographs: give each its own", labels.size(),
                     photographs.size());
  for (const std::string& photograph : photographs)
    if (wholePath(photograph) == wholePath(arguments.without))
      throw InputError("--without {}: is PHOTO, too: give the photograph of the lamp without a gel",
                       arguments.without);
  std::string table = tableBefore(arguments);
  constexpr Rgb kAny(.5F);
  for (const std::string& label : labels)
    table = withMeasuredGel(table, arguments.gels, GelLabel::fromText(label), kAny);
  if (!arguments.output.empty() && wholePath(arguments.output) == wholePath(arguments.gels))
    throw InputError("--output {}: is the table of --gels: name another file for the camera's matrix",
                     arguments.output);
}

void checkArguments(const ChartCommand& arguments) {
  const bool gels = !arguments.gels.empty();
  if (gels != !arguments.without.empty() || gels != !arguments.labels.empty())
    throw InputError(
        "to measure gels give all three: --without PHOTO, of the lamp without a gel, --gel BRAND,NUMBER,NAME "
        "for each photograph, and --gels TABLE.csv");
  if (gels) checkGels(arguments);
}

std::string colorText(const Rgb& color) {
  return fmt::format("{:.4f}/{:.4f}/{:.4f}", color.r, color.g, color.b);
}

/// How it is known where the chart is, where it was not found.
std::string placeText(const ChartShot& shot) {
  if (!shot.asIn.empty()) return "as in " + shot.asIn.filename().string();
  return shot.found ? "" : "--corners";
}

std::vector<std::string> rowOf(const ChartShot& shot) {
  const ChartFit& fit = shot.fit;
  return {shot.file.filename().string(),
          colorText(fit.light),
          colorText(fit.lightError),
          fmt::format("{:.1f}", fit.meanBalanced),
          fit.matrix ? fmt::format("{:.1f}, {:.1f}", fit.meanDeltaE, fit.mostDeltaE) : "none",
          placeText(shot)};
}

Json jsonOf(const ChartShot& shot) {
  Json json = jsonFromChartFit(shot.fit);
  json["photograph"] = shot.file.string();
  json["color_space"] = shot.colorSpace;
  json["found"] = shot.found;
  json["corners"] = Json::array();
  for (const PicturePlace& corner : shot.corners) json["corners"].push_back({corner.x, corner.y});
  json["exposure_stops"] = shot.exposureStops ? Json(*shot.exposureStops) : Json();
  return json;
}

void describeMatrix(const ChartShot* best, Description& d) {
  d.json["camera_matrix"] = best ? Json(*best->fit.matrix) : Json();
  if (!best) return;
  d.json["camera_matrix_from"] = best->file.string();
  for (size_t i = 0; i < 3; ++i) {
    const auto& row = (*best->fit.matrix)[i];
    d.line(i == 0 ? "matrix" : "", fmt::format("{:8.4f} {:8.4f} {:8.4f}", row[0], row[1], row[2]));
  }
}

/// The table with the photographs' gels.
std::string tableWithGels(const ChartCommand& arguments, const std::vector<ChartShot>& shots,
                          const ChartShot& without, Description& d) {
  std::string table = tableBefore(arguments);
  for (size_t k = 0; k < shots.size(); ++k) {
    const GelLabel label = GelLabel::fromText(arguments.labels[k]);
    const Rgb filter = measuredGel(shots[k], without);
    table = withMeasuredGel(table, arguments.gels, label, filter);
    const Gel gel = gelsFromCsv(table, arguments.gels).back();
    d.line(gel.id,
           fmt::format("{} {}, lets {:.1f} % through", gel.name, colorText(filter), 100 * gel.transmission));
    d.json["gels"].push_back({{"id", gel.id},
                              {"name", gel.name},
                              {"filter", {filter.r, filter.g, filter.b}},
                              {"transmission", gel.transmission}});
  }
  return table;
}

int run(const ChartCommand& arguments, Terminal& terminal) {
  checkArguments(arguments);
  ChartReadingOptions options;
  options.colorSpaceOf = [&](const std::filesystem::path&) { return arguments.colorSpace; };
  if (!arguments.corners.empty()) options.corners = cornersFromText(arguments.corners);
  std::vector<std::filesystem::path> files(arguments.photographs.begin(), arguments.photographs.end());
  if (!arguments.without.empty()) files.insert(files.begin(), arguments.without);
  if (!arguments.gels.empty()) checkOutput(arguments.gels, files);
  if (!arguments.output.empty()) {
    std::vector<std::filesystem::path> inputs = files;
    inputs.emplace_back(arguments.gels);
    checkOutput(arguments.output, inputs);
  }

  const std::vector<ChartShot> shots = readChartShots(*programConfig(), files, options, terminal.progress());
  std::vector<std::vector<std::string>> rows{
      {"photograph", "light", "standard error", "dE00 balanced", "with the matrix", "chart"}};
  Description d;
  for (const ChartShot& shot : shots) {
    rows.push_back(rowOf(shot));
    d.json["shots"].push_back(jsonOf(shot));
    for (const std::string& warning : shot.fit.warnings)
      sayWarnings({shot.file.filename().string() + ": " + warning}, terminal);
  }
  d.text = tableText(std::move(rows));
  const ChartShot* best = bestChartShot(shots);
  describeMatrix(best, d);
  if (!arguments.output.empty() && !best)
    throw InputError("--output {}: no camera matrix can be told of these photographs", arguments.output);
  std::string table;
  if (!arguments.gels.empty())
    table = tableWithGels(arguments, {shots.begin() + 1, shots.end()}, shots.front(), d);
  if (!arguments.output.empty()) writeJson(jsonFromCamera(*best), arguments.output);
  // Last: with the gels in it the same command would be refused.
  if (!arguments.gels.empty()) writeFile(arguments.gels, table);
  for (const std::string& written : {arguments.gels, arguments.output})
    if (!written.empty()) terminal.say("wrote {}", written);
  terminal.result(d.text, d.json);
  return 0;
}

}  // namespace

void addChartVerb(Program& program) {
  const auto a = std::make_shared<ChartCommand>();
  CLI::App& verb = program.addVerb(
      "chart", "Read the light's colour and the camera's matrix off a Macbeth chart in photographs",
      [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("PHOTO", a->photographs, "Photographs with the chart, of one camera, each under one light")
      ->required();
  verb.add_option("-o,--output", a->output, "Write the camera matrix, for balance --camera")
      ->type_name("CAMERA.json");
  verb.add_option("--corners", a->corners,
                  "Where the chart is not found: the outer corners of its corner patches, around it")
      ->type_name("X,Y,X,Y,X,Y,X,Y");
  verb.add_option("--color-space", a->colorSpace, "Of the photographs (default: as the files say)")
      ->type_name("NAME");
  verb.add_option("--without", a->without, "To measure gels: the chart under the lamp without a gel")
      ->type_name("PHOTO");
  verb.add_option("--gel", a->labels, "The gel of each photograph, in their order; may be repeated")
      ->type_name("BRAND,NUMBER,NAME")
      ->allow_extra_args(false);
  verb.add_option("--gels", a->gels,
                  "The table that the gels are written into; it is made where there is none")
      ->type_name("TABLE.csv");
}

}  // namespace swaplight

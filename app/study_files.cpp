#include "app/study_files.hpp"

#include <filesystem>

#include "app/film/child_process.hpp"
#include "app/render.hpp"
#include "core/base/file.hpp"
#include "core/study/study_charts.hpp"
#include "core/world/choices.hpp"

namespace replan::app {
namespace {

constexpr int kPictureSide = 320;  // design pixels: small, so that paths are thick beside what they pass
constexpr double kPictureScale = 3;
constexpr const char* kGnuplot = "gnuplot";
constexpr const char* kNoGnuplot =
    "The diagrams are not drawn, since gnuplot is not installed; the files that end in .gp draw them once it "
    "is.";

/// Has gnuplot draw into the folder.
Result<void> draw_chart(const std::string& script, const std::string& folder) {
  auto gnuplot = ChildProcess::start({kGnuplot, "-"}, {});
  if (!gnuplot) return Error{gnuplot.error()};
  std::string there = "cd \"";
  for (const char c : folder) there += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  const std::string input = there + "\"\n" + script;
  (*gnuplot)->feed({reinterpret_cast<const std::uint8_t*>(input.data()), input.size()});
  return (*gnuplot)->finish();
}

Result<void> write_charts(StudySection& section, const std::string& folder) {
  const bool drawn = ChildProcess::is_installed(kGnuplot);
  if (!drawn && !section.report.charts.empty()) section.notes.emplace_back(kNoGnuplot);
  for (const StudyChart& chart : section.report.charts) {
    if (!can_be_drawn(section.report, chart)) continue;
    const std::string stem = std::string(section.info->id) + "-" + std::string(chart.id);
    const std::string path = (std::filesystem::path(folder) / stem).string();
    const std::string script = chart_script(section.report, chart, stem);
    if (const auto written = write_file_atomically(path + ".gp", script); !written) return written;
    if (!drawn) continue;
    if (const auto done = draw_chart(script, folder); !done) return done;
    auto svg = read_file(path + ".svg");
    if (!svg) return Error{svg.error()};
    section.drawings.push_back({chart.title, {{"", std::move(*svg)}}});
  }
  return {};
}

RenderRequest request_of(const StudyPicture& picture, const std::string& output) {
  RenderRequest request;
  request.scenario = picture.scenario;
  request.output = output;
  request.theme = "light";
  request.legend = false;
  request.at = picture.at_end ? Moment::end : Moment::plan;
  request.overlays = *parse_overlays(picture.overlays);
  return request;
}

/// All planners of a picture side by side.
Result<void> write_png(const StudyPicture& picture, const std::string& path) {
  RenderRequest request = request_of(picture, path);
  request.panes = picture.scenario.planners.size();
  const int columns = static_cast<int>(std::min<std::size_t>(*request.panes, 2));
  const int rows = static_cast<int>((*request.panes + 1) / 2);
  request.scale = kPictureScale;
  request.width = static_cast<int>(columns * kPictureSide * kPictureScale);
  request.height = static_cast<int>(rows * kPictureSide * kPictureScale);
  return render(request);
}

Result<StudyDrawing> write_picture(const StudyPicture& picture, const std::string& stem) {
  Scenario alone = picture.scenario;
  alone.map_file.clear();  // its map goes with it into the folder
  if (const auto written = write_scenario(alone, stem + ".json"); !written) return Error{written.error()};
  if (const auto written = write_png(picture, stem + ".png"); !written) return Error{written.error()};
  StudyDrawing drawing{picture.caption, {}};
  for (const PlannerChoice& choice : picture.scenario.planners) {
    const std::string path = stem + "-" + std::to_string(drawing.parts.size() + 1) + ".svg";
    RenderRequest request = request_of(picture, path);
    request.scenario.planners = {choice};
    request.width = request.height = kPictureSide;
    if (const auto written = render(request); !written) return Error{written.error()};
    auto svg = read_file(path);
    if (!svg) return Error{svg.error()};
    drawing.parts.push_back({std::string(info_of(choice).name), std::move(*svg)});
  }
  return drawing;
}

Result<void> write_pictures(StudySection& section, const std::string& folder) {
  if (section.info->pictures == nullptr) return {};
  const auto pictures = section.info->pictures();
  if (!pictures) return Error{pictures.error()};
  for (const StudyPicture& picture : *pictures) {
    const std::string name = std::string(section.info->id) + "-" + std::string(picture.id);
    auto drawing = write_picture(picture, (std::filesystem::path(folder) / name).string());
    if (!drawing) return Error{drawing.error()};
    section.drawings.push_back(std::move(*drawing));
  }
  return {};
}

}  // namespace

Result<StudySection> write_study(const StudyInfo& info, StudyReport report, const std::string& folder) {
  StudySection section{&info, std::move(report), {}, {}};
  const std::string stem = (std::filesystem::path(folder) / info.id).string();
  for (const auto& [ending, text] : {std::pair{".md", study_markdown(info, section.report)},
                                     {".csv", study_csv(section.report)},
                                     {".json", study_json(info, section.report)}})
    if (const auto written = write_file_atomically(stem + ending, text); !written)
      return Error{written.error()};
  if (const auto written = write_pictures(section, folder); !written) return Error{written.error()};
  if (const auto written = write_charts(section, folder); !written) return Error{written.error()};
  return section;
}

}  // namespace replan::app

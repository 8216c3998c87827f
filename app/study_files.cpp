#include "app/study_files.hpp"

#include <filesystem>

#include "app/film/child_process.hpp"
#include "core/base/file.hpp"
#include "core/study/study_charts.hpp"

namespace replan::app {
namespace {

constexpr const char* kGnuplot = "gnuplot";
constexpr const char* kNoGnuplot =
    "The diagrams are not drawn, since gnuplot is not installed; the files that end in .gp draw them once it "
    "is.";
constexpr const char* kNoPen =
    "The pictures are not drawn, since this replan was built without its window; one that has it opens their "
    "worlds, ID-PICTURE.json.";

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

Result<void> write_pictures(StudySection& section, const std::string& folder, const DrawPicture& draw) {
  if (section.info->pictures == nullptr) return {};
  const auto pictures = section.info->pictures();
  if (!pictures) return Error{pictures.error()};
  if (!draw && !pictures->empty()) section.notes.emplace_back(kNoPen);
  for (const StudyPicture& picture : *pictures) {
    const std::string name = std::string(section.info->id) + "-" + std::string(picture.id);
    const std::string stem = (std::filesystem::path(folder) / name).string();
    Scenario alone = picture.scenario;
    alone.map_file.clear();  // its map goes with it into the folder
    if (const auto written = write_scenario(alone, stem + ".json"); !written) return written;
    if (!draw) continue;
    auto drawing = draw(picture, stem);
    if (!drawing) return Error{drawing.error()};
    section.drawings.push_back(std::move(*drawing));
  }
  return {};
}

}  // namespace

Result<StudySection> write_study(const StudyInfo& info, StudyReport report, const std::string& folder,
                                 const DrawPicture& draw) {
  StudySection section{&info, std::move(report), {}, {}};
  const std::string stem = (std::filesystem::path(folder) / info.id).string();
  for (const auto& [ending, text] : {std::pair{".md", study_markdown(info, section.report)},
                                     {".csv", study_csv(section.report)},
                                     {".json", study_json(info, section.report)}})
    if (const auto written = write_file_atomically(stem + ending, text); !written)
      return Error{written.error()};
  if (const auto written = write_pictures(section, folder, draw); !written) return Error{written.error()};
  if (const auto written = write_charts(section, folder); !written) return Error{written.error()};
  return section;
}

}  // namespace replan::app

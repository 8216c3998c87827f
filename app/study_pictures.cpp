#include "app/study_pictures.hpp"

#include <algorithm>

#include "app/render.hpp"
#include "core/base/file.hpp"
#include "core/world/choices.hpp"

namespace replan::app {
namespace {

constexpr int kPictureSide = 320;  // design pixels: small, so that paths are thick beside what they pass
constexpr double kPictureScale = 3;

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

}  // namespace

Result<StudyDrawing> draw_study_picture(const StudyPicture& picture, const std::string& stem) {
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

}  // namespace replan::app

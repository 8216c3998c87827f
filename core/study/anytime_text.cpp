// Anytime curves as CSV, and as a picture.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/plan/registry.hpp"
#include "core/study/anytime.hpp"
#include "core/study/study_words.hpp"

namespace replan {
namespace {

const char* end_name(AnytimeEnd end) {
  switch (end) {
    case AnytimeEnd::time:
      return "time";
    case AnytimeEnd::stopped:
      return "stopped";
    case AnytimeEnd::planner:
      break;
  }
  return "planner";
}

/// Apart for all eyes (Okabe & Ito), in the order in which planners are drawn.
constexpr std::array<const char*, 7> kCurveColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                      "#e69f00", "#56b4e9", "#000000"};

/// 1, 2 or 5 times a power of ten: about a fifth of a range.
double tick_step(double range) {
  const double rough = range / 5, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double times : {1.0, 2.0, 5.0})
    if (power * times >= rough) return power * times;
  return power * 10;
}

/// One diagram.
class CurvePlot {
 public:
  CurvePlot(std::span<const AnytimeRun> runs, std::span<const double> optima, AnytimeAxis axis, double left)
      : runs_(runs), optima_(optima), axis_(axis), left_(left) {
    fit();
  }

  std::string text() {
    draw_axes();
    const auto groups = by_planner(runs_);
    for (std::size_t i = 0; i < groups.size(); ++i) draw_plans(groups[i], colour(i));
    for (std::size_t i = 0; i < groups.size(); ++i) draw_median(groups[i], colour(i));
    return std::move(out_);
  }
  static const char* colour(std::size_t planner) { return kCurveColours[planner % kCurveColours.size()]; }

 private:
  static constexpr double kTop = 56, kWidth = 400, kHeight = 300;

  void fit() {
    double least = 1e300, most = 0;
    low_ = optima_.empty() ? 1e300 : *std::min_element(optima_.begin(), optima_.end());
    for (const AnytimeRun& run : runs_) {
      if (!run.found()) continue;
      low_ = std::min(low_, run.gains.back().length);
      high_ = std::max(high_, run.gains.front().length);
      least = std::min(least, where(run.gains.front()));
      most = std::max(most, end_of(run));
    }
    if (most <= 0) {  // no plan has a path
      least = most = 1;
      low_ = high_ = optima_.empty() ? 1 : low_;
    }
    high_ = std::max(high_, low_ * 1.001);
    low_ -= (high_ - low_) * 0.05;
    from_ = std::floor(std::log10(std::max(least, 1e-6)));
    to_ = std::max(from_ + 1, std::log10(most));
  }
  [[nodiscard]] double where(const Gain& gain) const {
    return axis_ == AnytimeAxis::time ? gain.ms : static_cast<double>(gain.samples);
  }
  [[nodiscard]] double end_of(const AnytimeRun& run) const {
    return axis_ == AnytimeAxis::time ? run.ms : static_cast<double>(run.samples);
  }
  [[nodiscard]] double x(double at) const {
    return left_ + (std::log10(std::max(at, 1e-6)) - from_) / (to_ - from_) * kWidth;
  }
  [[nodiscard]] double y(double length) const { return kTop + (high_ - length) / (high_ - low_) * kHeight; }

  void line(double x0, double y0, double x1, double y1, const std::string& style) {
    out_ += "<line x1=\"" + told(x0, 1) + "\" y1=\"" + told(y0, 1) + "\" x2=\"" + told(x1, 1) + "\" y2=\"" +
            told(y1, 1) + "\" " + style + "/>\n";
  }
  void words(double x, double y, const char* anchor, const std::string& text) {
    out_ += "<text x=\"" + told(x, 1) + "\" y=\"" + told(y, 1) + "\" text-anchor=\"" + anchor + "\">" + text +
            "</text>\n";
  }
  void draw_axes() {
    const std::string faint = "stroke=\"#dddddd\"", strong = "stroke=\"#666666\"";
    const double bottom = kTop + kHeight;
    for (double power = from_; power <= to_ + 1e-9; ++power) {
      const double at = x(std::pow(10, power));
      line(at, kTop, at, bottom, faint);
      words(at, bottom + 18, "middle", told(std::pow(10, power), power < 0 ? static_cast<int>(-power) : 0));
    }
    const double step = tick_step(high_ - low_);
    for (double length = std::ceil(low_ / step) * step; length <= high_; length += step) {
      line(left_, y(length), left_ + kWidth, y(length), faint);
      words(left_ - 8, y(length) + 4, "end", told(length, step < 1 ? 2 : 0));
    }
    line(left_, bottom, left_ + kWidth, bottom, strong);
    line(left_, kTop, left_, bottom, strong);
    words(left_ + kWidth / 2, bottom + 38, "middle", axis_ == AnytimeAxis::time ? "milliseconds" : "samples");
    for (const double optimum : optima_) {
      line(left_, y(optimum), left_ + kWidth, y(optimum), "stroke=\"#000000\" stroke-dasharray=\"5 4\"");
      words(left_ + kWidth, y(optimum) + 14, "end", "optimum " + told(optimum, 3));
    }
  }
  /// In steps: a length holds until there is a shorter one.
  void draw_curve(std::span<const CurvePoint> curve, double end, const std::string& style) {
    if (curve.empty()) return;
    std::string steps = "M" + told(x(curve[0].at), 1) + " " + told(y(curve[0].length), 1);
    for (const CurvePoint& point : curve.subspan(1))
      steps += "H" + told(x(point.at), 1) + "V" + told(y(point.length), 1);
    steps += "H" + told(x(std::max(end, curve.back().at)), 1);
    out_ += "<path d=\"" + steps + "\" fill=\"none\" " + style + "/>\n";
  }
  void draw_plans(std::span<const AnytimeRun> runs, const char* colour) {
    for (const AnytimeRun& run : runs) {
      std::vector<CurvePoint> curve;
      for (const Gain& gain : run.gains) curve.push_back({where(gain), gain.length});
      draw_curve(curve, end_of(run),
                 std::string("stroke=\"") + colour + "\" stroke-opacity=\"0.25\" stroke-width=\"1\"");
    }
  }
  void draw_median(std::span<const AnytimeRun> runs, const char* colour) {
    double end = 0;
    for (const AnytimeRun& run : runs) end = std::max(end, end_of(run));
    const std::vector<CurvePoint> curve = median_curve(runs, axis_);
    if (curve.empty()) return;
    draw_curve(curve, end, std::string("stroke=\"") + colour + "\" stroke-width=\"2.4\"");
    out_ += "<circle cx=\"" + told(x(curve.front().at), 1) + "\" cy=\"" + told(y(curve.front().length), 1) +
            "\" r=\"4\" fill=\"" + colour + "\"/>\n";
  }

  std::span<const AnytimeRun> runs_;
  std::span<const double> optima_;
  AnytimeAxis axis_;
  double left_;
  double from_ = 0, to_ = 1;  // powers of ten
  double low_ = 0, high_ = 0;
  std::string out_;
};

}  // namespace

std::string anytime_csv(std::span<const AnytimeRun> runs) {
  std::string text = "planner,seed,samples,ms,length,end\n";
  for (const AnytimeRun& run : runs) {
    const std::string start = run.planner + "," + std::to_string(run.seed) + ",";
    for (const Gain& gain : run.gains)
      text +=
          start + std::to_string(gain.samples) + "," + told(gain.ms, 4) + "," + told(gain.length, 6) + ",\n";
    text += start + std::to_string(run.samples) + "," + told(run.ms, 4) + "," +
            (run.found() ? told(run.gains.back().length, 6) : "") + "," + end_name(run.end) + "\n";
  }
  return text;
}

std::string anytime_svg(std::span<const AnytimeRun> runs, std::span<const double> optima) {
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000\" height=\"410\" viewBox=\"0 0 1000 410\" "
      "font-family=\"Inter, sans-serif\" font-size=\"12\" fill=\"#333333\">\n"
      "<rect width=\"1000\" height=\"410\" fill=\"#ffffff\"/>\n";
  const auto groups = by_planner(runs);
  double at = 64;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const PlannerInfo* info = find_planner(groups[i].front().planner);
    const std::string name(info == nullptr ? std::string_view(groups[i].front().planner) : info->name);
    text += "<rect x=\"" + told(at, 0) + "\" y=\"18\" width=\"18\" height=\"4\" fill=\"" +
            CurvePlot::colour(i) + "\"/>\n<text x=\"" + told(at + 24, 0) + "\" y=\"25\">" + name +
            "</text>\n";
    at += 44 + 7 * static_cast<double>(name.size());
  }
  text += CurvePlot(runs, optima, AnytimeAxis::samples, 64).text();
  text += CurvePlot(runs, optima, AnytimeAxis::time, 564).text();
  return text + "</svg>\n";
}

}  // namespace replan

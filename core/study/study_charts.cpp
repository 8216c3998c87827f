#include "core/study/study_charts.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "core/study/study_words.hpp"

namespace replan {
namespace {

/// Okabe & Ito's colours, which everybody can tell apart, from dark to light in print; and a symbol for each.
struct SeriesLook {
  const char* colour;
  int symbol;
};
constexpr std::array<SeriesLook, 6> kLooks{
    {{"#0072B2", 7}, {"#D55E00", 9}, {"#009E73", 5}, {"#CC79A7", 13}, {"#E69F00", 11}, {"#56B4E9", 15}}};
const SeriesLook& look_of(std::size_t planner) {
  return kLooks[planner % kLooks.size()];
}

/// What is drawn of a planner: a value and how far down and up its spread reaches.
struct Drawn {
  double value = 0, low = 0, high = 0;
};

std::optional<Drawn> drawn_of(const StudyReport& report, const StudyChart& chart, std::size_t planner,
                              std::optional<std::size_t> world) {
  if (report.figures[chart.figure].wall_time) {
    const auto ratio = ratio_of(report, chart.figure, planner, 0, world);
    return ratio ? std::optional(Drawn{ratio->median, ratio->low, ratio->high}) : std::nullopt;
  }
  const auto spread = spread_of(report, chart.figure, planner, world);
  if (!spread) return std::nullopt;
  const double low = spread->mean - spread->deviation;
  return Drawn{spread->mean, chart.logarithmic && low <= 0 ? spread->mean : std::max(low, 0.0),
               spread->mean + spread->deviation};
}

/// What the paper has of a planner there; of wall times over the first planner's.
std::optional<double> paper_of(const StudyReport& report, const StudyChart& chart, std::size_t planner,
                               std::optional<std::size_t> world) {
  std::optional<double> value, first;
  for (const PaperFigure& paper : report.paper) {
    if (paper.figure != chart.figure || paper.world != world) continue;
    if (paper.planner == planner) value = paper.value;
    if (paper.planner == 0) first = paper.value;
  }
  if (!report.figures[chart.figure].wall_time || !value) return value;
  return first ? std::optional(*value / *first) : std::nullopt;
}

std::string in_quotes(std::string_view text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') all += '\\';
    all += c;
  }
  return all + "\"";
}

/// On two lines where it has a comma.
std::string in_quotes_on_lines(const std::string& text) {
  const std::size_t comma = text.find(", ");
  if (comma == std::string::npos) return in_quotes(text);
  const std::string first = in_quotes(text.substr(0, comma + 1)), second = in_quotes(text.substr(comma + 2));
  return first.substr(0, first.size() - 1) + "\\n" + second.substr(1);
}

std::string axis_title(const StudyReport& report, const StudyChart& chart) {
  const StudyFigure& figure = report.figures[chart.figure];
  if (figure.wall_time) return filled("{1}, {2} = 1", {std::string(figure.label), report.planners.front()});
  if (figure.unit.empty()) return std::string(figure.label);
  return filled("{1} ({2})", {std::string(figure.label), std::string(figure.unit)});
}

/// The worlds that bars are grouped by: one group of all where they are taken together.
std::vector<std::optional<std::size_t>> groups_of(const StudyReport& report) {
  if (!report.worlds_apart) return {std::nullopt};
  std::vector<std::optional<std::size_t>> groups;
  for (std::size_t w = 0; w < report.worlds.size(); ++w) groups.emplace_back(w);
  return groups;
}

std::string number(double value) {
  return told(value, 6);
}

/// x, value, low, high of one planner; and x, value of the paper's.
struct Series {
  std::string ours, papers;
  double least = std::numeric_limits<double>::infinity(), most = 0;  // of all that is drawn
  void reach(double value) {
    if (value > 0) least = std::min(least, value);
    most = std::max(most, value);
  }
};

template <class Place>
Series series_of(const StudyReport& report, const StudyChart& chart, std::size_t planner,
                 const std::vector<std::optional<std::size_t>>& worlds, const Place& place) {
  Series series;
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    const std::string x = number(place(i));
    if (const auto drawn = drawn_of(report, chart, planner, worlds[i])) {
      series.ours +=
          x + " " + number(drawn->value) + " " + number(drawn->low) + " " + number(drawn->high) + "\n";
      series.reach(drawn->low);
      series.reach(drawn->high);
    }
    if (const auto paper = paper_of(report, chart, planner, worlds[i])) {
      series.papers += x + " " + number(*paper) + "\n";
      series.reach(*paper);
    }
  }
  return series;
}

std::string block(const std::string& name, const std::string& lines) {
  return "$" + name + " << EOD\n" + lines + "EOD\n";
}

struct Plotted {
  std::string data;
  std::vector<std::string> plots;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  void take_reach(const Series& series) {
    least = std::min(least, series.least);
    most = std::max(most, series.most);
  }
  void add(const std::string& name, const std::string& lines, const std::string& how) {
    if (lines.empty()) return;
    data += block(name, lines);
    plots.push_back("$" + name + " " + how);
  }
};

std::string plot_command(const Plotted& plotted) {
  std::string text = "plot ";
  for (const std::string& plot : plotted.plots) {
    if (&plot != plotted.plots.data()) text += ", \\\n     ";
    text += plot;
  }
  return text + "\n";
}

std::string tics(const std::vector<std::pair<std::string, double>>& names) {
  std::string text = "set xtics (";
  for (const auto& [name, at] : names) {
    if (&name != &names.front().first) text += ", ";
    text += name + " " + number(at);
  }
  return text + ")\n";
}

std::string bars(const StudyReport& report, const StudyChart& chart, Plotted& plotted) {
  const auto groups = groups_of(report);
  const auto count = static_cast<double>(report.planners.size());
  std::string papers;
  for (std::size_t p = 0; p < report.planners.size(); ++p) {
    const auto place = [&](std::size_t group) {
      return static_cast<double>(group) * (count + 1) + static_cast<double>(p);
    };
    const Series series = series_of(report, chart, p, groups, place);
    const std::string name = "planner" + std::to_string(p), colour = in_quotes(look_of(p).colour);
    const std::string title = groups.size() > 1 ? "title " + in_quotes(report.planners[p]) : "notitle";
    plotted.add(name, series.ours,
                "using 1:2 with boxes fillstyle solid noborder linecolor rgb " + colour + " " + title);
    papers += series.papers;
    plotted.take_reach(series);
  }
  for (std::size_t p = 0; p < report.planners.size(); ++p)
    if (plotted.data.find("$planner" + std::to_string(p) + " ") != std::string::npos)
      plotted.plots.push_back(
          "$planner" + std::to_string(p) +
          " using 1:3:(0):($4-$3) with vectors heads size screen 0.006,90 linewidth 1.5 linecolor "
          "rgb \"#303030\" notitle");
  plotted.add("paper", papers,
              "using 1:2 with points pointtype 12 pointsize 1.6 linewidth 2 linecolor rgb \"#000000\" title "
              "\"the paper's\"");
  std::vector<std::pair<std::string, double>> names;
  if (groups.size() > 1) {
    for (std::size_t g = 0; g < groups.size(); ++g)
      names.emplace_back(in_quotes_on_lines(report.worlds[g]),
                         static_cast<double>(g) * (count + 1) + (count - 1) / 2);
  } else {
    for (std::size_t p = 0; p < report.planners.size(); ++p)
      names.emplace_back(in_quotes_on_lines(report.planners[p]), static_cast<double>(p));
  }
  const double end = static_cast<double>(groups.size()) * (count + 1) - 1.3;
  return "set boxwidth 0.8\nset xrange [-0.7:" + number(end) + "]\n" + tics(names);
}

std::string lines(const StudyReport& report, const StudyChart& chart, Plotted& plotted) {
  std::vector<std::optional<std::size_t>> worlds;
  std::vector<std::pair<std::string, double>> names;
  for (std::size_t w = 0; w < report.worlds.size(); ++w) {
    worlds.emplace_back(w);
    names.emplace_back(in_quotes_on_lines(report.worlds[w]), static_cast<double>(w));
  }
  for (std::size_t p = 0; p < report.planners.size(); ++p) {
    // Symbols of several planners in one world stand beside each other, so that none hides another.
    const double aside =
        0.06 * (static_cast<double>(p) - static_cast<double>(report.planners.size() - 1) / 2);
    const Series series =
        series_of(report, chart, p, worlds, [&](std::size_t w) { return static_cast<double>(w) + aside; });
    plotted.take_reach(series);
    plotted.add("planner" + std::to_string(p), series.ours,
                "using 1:2:3:4 with yerrorlines pointtype " + std::to_string(look_of(p).symbol) +
                    " pointsize 0.9 linewidth 1.5 linecolor rgb " + in_quotes(look_of(p).colour) + " title " +
                    in_quotes(report.planners[p]));
  }
  return "set xrange [-0.5:" + number(static_cast<double>(report.worlds.size()) - 0.5) + "]\n" + tics(names);
}

std::string y_axis(const StudyChart& chart, const Plotted& plotted) {
  if (!chart.logarithmic) return "set yrange [0:" + number(1.05 * std::max(plotted.most, 1e-6)) + "]\n";
  return "set logscale y\nset yrange [" + number(plotted.least / 1.5) + ":" + number(plotted.most * 1.5) +
         "]\n";
}

}  // namespace

bool can_be_drawn(const StudyReport& report, const StudyChart& chart) {
  return std::any_of(report.runs.begin(), report.runs.end(),
                     [&](const StudyRun& run) { return run.values[chart.figure].has_value(); });
}

std::string chart_script(const StudyReport& report, const StudyChart& chart, std::string_view stem) {
  Plotted plotted;
  const std::string shape =
      chart.form == StudyChart::Form::bars ? bars(report, chart, plotted) : lines(report, chart, plotted);
  const std::string name(stem);
  std::string text = "# Draws " + name + ".svg and " + name + ".png: gnuplot " + name + ".gp\n" +
                     plotted.data + "set ylabel " + in_quotes(axis_title(report, chart)) +
                     " noenhanced\nset key outside top center horizontal noenhanced\nset xtics noenhanced\n"
                     "set border 3\nset bmargin 3.5\nset tics nomirror out\nset grid ytics linecolor rgb "
                     "\"#d8d8d8\" linewidth 0.7\n" +
                     shape + y_axis(chart, plotted);
  for (const auto& [terminal, ending] :
       {std::pair{"svg size 760,460 dynamic font \"Helvetica,14\" background rgb \"white\"", ".svg"},
        {"pngcairo size 2280,1380 fontscale 1.0 font \"Helvetica,36\" linewidth 3 pointscale 3 background "
         "rgb \"white\"",
         ".png"}})
    text += std::string("set terminal ") + terminal + "\nset output " + in_quotes(name + ending) + "\n" +
            plot_command(plotted);
  return text + "set output\n";
}

}  // namespace replan

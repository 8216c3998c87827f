#include "ui/shell/dialogs/preview_pane.hpp"

#include <algorithm>
#include <array>

#include "core/world/json_reader.hpp"
#include "core/world/map_file.hpp"
#include "ui/icons.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr float kPictureHeight = 176;

bool is_world(const FileEntry& entry) {
  return entry.kind == FileKind::scenario || entry.kind == FileKind::map || entry.kind == FileKind::picture;
}

bool is_batch(FileKind kind) {
  return kind == FileKind::experiment || kind == FileKind::results;
}

/// What there is something to be told of beforehand.
bool is_read(const FileEntry& entry) {
  return is_world(entry) || is_batch(entry.kind);
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : ", ") + word;
  return line;
}

/// A height that the reader chooses as long as nobody moves it from its usual place.
void height_slider(const Look& look, const char* label, const char* help, double usual, double span,
                   std::optional<double>& height) {
  double value = height.value_or(usual);
  const bool changed = slider(look,
                              {.label = label,
                               .min = usual - span,
                               .max = usual + span,
                               .initial = usual,
                               .decimals = span > 100 ? 0 : 2},
                              value, {label, "", help});
  if (changed) height = value == usual ? std::nullopt : std::optional(value);
}

}  // namespace

void PreviewPane::show(const std::string& folder, const FileEntry* entry) {
  const std::string path = entry == nullptr ? "" : typed_from(folder, entry->name);
  if (path == path_ && (entry == nullptr || *entry == entry_)) return;
  path_ = path;
  entry_ = entry == nullptr ? FileEntry{} : *entry;
  reading_ = {};
  preview_ = {};
  heights_.reset();
  picture_.clear();
  job_.cancel();
  if (entry != nullptr && is_read(entry_)) begin();
}

void PreviewPane::begin() {
  // Cannot be cut up; files above kMostPreviewBytes are not read.
  job_.start([path = path_, kind = entry_.kind, reading = reading_](const StopToken& stop) {
    return is_batch(kind) ? preview_of_batch(path) : make_preview(path, reading, stop);
  });
}

void PreviewPane::draw(const Look& look) {
  if (std::optional<Preview> made = job_.take()) {
    preview_ = std::move(*made);
    if (preview_.heights) heights_ = preview_.heights;
    picture_.show(std::move(preview_.thumbnail));
  }
  if (path_.empty()) {
    empty_state(look, icon::map, "Nothing chosen", "Choose a file to see what is in it.");
    return;
  }
  if (is_world(entry_) && preview_.error.empty()) {
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, look.px(kPictureHeight));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(min, {min.x + size.x, min.y + size.y}, look.theme.background, look.px.radius);
    if (job_.busy() && preview_.width == 0)
      draw_text_centred(list, look.fonts.ui, min, {min.x + size.x, min.y + size.y}, look.theme.faint,
                        "Reading…");
    const float inset = look.px(8);
    picture_.draw(look, list, {min.x + inset, min.y + inset},
                  {min.x + size.x - inset, min.y + size.y - inset});
    ImGui::Dummy(size);
    ImGui::Dummy({0, look.px.xs});
  }
  draw_facts(look);
  if (is_world(entry_)) draw_reading(look);
}

void PreviewPane::draw_facts(const Look& look) {
  const std::string& title = preview_.name.empty() ? entry_.name : preview_.name;
  text_line(look, look.fonts.title, look.theme.text, title, ImGui::GetContentRegionAvail().x);
  if (!preview_.error.empty()) paragraph(look.fonts.ui, look.theme.bad, as_sentence(preview_.error));
  for (const std::string& note : preview_.notes) paragraph(look.fonts.ui, look.theme.dim, as_sentence(note));
  if (!preview_.caption.empty()) paragraph(look.fonts.ui, look.theme.dim, preview_.caption);
  ImGui::Dummy({0, look.px(2)});
  fact(look, "Kind", kind_text(entry_));
  if (preview_.width > 0) {
    const double cells = static_cast<double>(preview_.width) * preview_.height * preview_.depth;
    fact(look, "Cells",
         grouped(std::size_t(preview_.width)) + " × " + grouped(std::size_t(preview_.height)) +
             (preview_.depth > 1 ? " × " + grouped(std::size_t(preview_.depth)) : ""));
    fact(look, "Obstacles",
         grouped(preview_.obstacles) + " (" +
             fixed(100 * static_cast<double>(preview_.obstacles) / cells, 0) + " %)");
  }
  if (preview_.resolution != 1) fact(look, "Resolution", fixed(preview_.resolution, 3) + " / cell");
  if (!preview_.planners.empty()) fact(look, "Planners", joined(preview_.planners));
}

/// Which of the numbers in the file is the obstacle.
void PreviewPane::draw_numbers(const Look& look) {
  std::vector<std::string> words = {"as usual"};
  int chosen = 0;
  for (const double number : preview_.numbers) {
    if (reading_.occupied == number) chosen = static_cast<int>(words.size());
    words.push_back(plain_number(number).dump());
  }
  std::vector<const char*> shown;
  for (const std::string& word : words) shown.push_back(word.c_str());
  text(look.fonts.ui, look.theme.dim, "Obstacle number");
  ImGui::SameLine(0, look.px.s);
  combo(look, "##occupied", shown, chosen);
  hint(look, {"Obstacle number", "",
              "The cells are numbers. As usual 1 is the obstacle, or of 0 and another number that one; the "
              "others are free."});
  reading_.occupied = std::nullopt;
  if (chosen > 0) reading_.occupied = preview_.numbers[static_cast<std::size_t>(chosen - 1)];
}

void PreviewPane::draw_picture(const Look& look) {
  bool height_map = reading_.heights.has_value();
  if (toggle(look, "It is a height map", height_map)) {
    reading_.heights = height_map ? std::optional<HeightReading>(HeightReading{}) : std::nullopt;
    reading_.image = {};
  }
  hint(look, {"Height map", "",
              "On: brightness is height, and the world has layers, with a floor of hills. Off: dark is an "
              "obstacle in the "
              "plane."});
  if (height_map) {
    toggle(look, "Dark is high", reading_.image.invert);
    return draw_heights(look);
  }
  double threshold = reading_.image.threshold;
  slider(look,
         {.label = "Darker than this is an obstacle", .min = 1, .max = 255, .initial = 128, .decimals = 0},
         threshold);
  reading_.image.threshold = static_cast<int>(threshold);
  toggle(look, "Brighter is an obstacle instead", reading_.image.invert);
}

/// How heights become layers. What stands in the file itself is told by the note above.
void PreviewPane::draw_heights(const Look& look) {
  HeightReading reading = reading_.heights.value_or(HeightReading{});
  const HeightReading before = reading;
  double layers = reading.layers;
  slider(look,
         {.label = "Layers",
          .min = kLeastHeightLayers,
          .max = kMostHeightLayers,
          .initial = HeightReading{}.layers,
          .decimals = 0,
          .logarithmic = true},
         layers, {"Layers", "", "How finely the heights are told apart."});
  reading.layers = static_cast<int>(layers);
  double columns = std::max(1, reading.reduce);
  slider(
      look,
      {.label = "Columns read as one", .min = 1, .max = 32, .initial = 1, .unit = "each way", .decimals = 0},
      columns,
      {"Columns read as one", "", "As high as the highest of them. Fewer columns make a smaller world."});
  reading.reduce = columns > 1 ? static_cast<int>(columns) : 0;
  if (heights_) {
    const double span = std::max(heights_->high - heights_->low, 1.0),
                 top = heights_->low < 0 ? 0 : heights_->high;
    height_slider(look, "Lowest height", "The bottom of the lowest layer.", heights_->low, span, reading.low);
    height_slider(look, "Highest height",
                  "The top of the highest layer; what rises above it is an obstacle in all.", top, span,
                  reading.high);
  }
  if (reading != before) reading_.heights = reading;
}

/// Pictures, ROS maps and numbers leave something to the reader's judgement; the picture above shows what
/// comes of it.
void PreviewPane::draw_reading(const Look& look) {
  const MapFormat* format = find_map_format(entry_.name);
  const bool numbers = format != nullptr && format->numbers && !preview_.numbers.empty();
  if (format == nullptr || (!format->picture && !format->heights && !format->unknown && !numbers)) return;
  const MapReading before = reading_;
  ImGui::Dummy({0, look.px.s});
  section_title(look, "How it is read");
  if (format->picture) {
    draw_picture(look);
  } else if (format->heights) {
    draw_heights(look);
  } else if (numbers) {
    draw_numbers(look);
  } else {
    constexpr std::array<const char*, 3> kUnknown = {"obstacles", "free", "unmapped"};
    int unknown = static_cast<int>(reading_.unknown);
    text(look.fonts.ui, look.theme.dim, "Unknown cells become");
    ImGui::SameLine(0, look.px.s);
    combo(look, "##unknown", kUnknown, unknown);
    hint(look, {"Unknown cells", "",
                "Unmapped cells are obstacles that the robot takes for free until its sensor sees them."});
    reading_.unknown = static_cast<UnknownCells>(unknown);
  }
  if (reading_ != before) begin();
}

}  // namespace replan::ui

#include "ui/shell/dialogs/preview_pane.hpp"

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

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : ", ") + word;
  return line;
}

}  // namespace

void PreviewPane::show(const std::string& folder, const FileEntry* entry) {
  const std::string path = entry == nullptr ? "" : typed_from(folder, entry->name);
  if (path == path_ && (entry == nullptr || *entry == entry_)) return;
  path_ = path;
  entry_ = entry == nullptr ? FileEntry{} : *entry;
  reading_ = {};
  preview_ = {};
  picture_.clear();
  job_.cancel();
  if (entry != nullptr && is_world(entry_)) begin();
}

void PreviewPane::begin() {
  job_.start([path = path_, reading = reading_](const std::stop_token& stop) {
    return make_preview(path, reading, stop);
  });
}

void PreviewPane::draw(const Look& look) {
  if (std::optional<Preview> made = job_.take()) {
    preview_ = std::move(*made);
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

/// Pictures, ROS maps and numbers leave something to the reader's judgement; the picture above shows what
/// comes of it.
void PreviewPane::draw_reading(const Look& look) {
  const MapFormat* format = find_map_format(entry_.name);
  const bool numbers = format != nullptr && format->numbers && !preview_.numbers.empty();
  if (format == nullptr || (!format->picture && !format->unknown && !numbers)) return;
  const MapReading before = reading_;
  ImGui::Dummy({0, look.px.s});
  section_title(look, "How it is read");
  if (format->picture) {
    double threshold = reading_.image.threshold;
    slider(look,
           {.label = "Darker than this is an obstacle", .min = 1, .max = 255, .initial = 128, .decimals = 0},
           threshold);
    reading_.image.threshold = static_cast<int>(threshold);
    toggle(look, "Brighter is an obstacle instead", reading_.image.invert);
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

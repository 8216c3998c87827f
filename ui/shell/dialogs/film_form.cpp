#include "ui/shell/dialogs/film_form.hpp"

#include <algorithm>
#include <vector>

#include "core/base/file.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

struct Size {
  int width, height;
};
/// The first is that of what is filmed, the last the user's own.
constexpr std::array kSizes = {Size{0, 0}, Size{1280, 720}, Size{1920, 1080}, Size{640, 360}, Size{0, 0}};
constexpr int kOwn = static_cast<int>(kSizes.size()) - 1;
constexpr int kSmallestSide = 64, kLargestSide = 4096;

constexpr std::array kRates = {30, 10, 20, 25, 50};

struct Speed {
  FilmSpeed speed;
  const char* words;
};
constexpr std::array kSpeeds = {Speed{{}, "automatic"},
                                Speed{{FilmSpeed::Kind::expansion, 0}, "an expansion per frame"},
                                Speed{{FilmSpeed::Kind::move, 0}, "a robot move per frame"},
                                Speed{{FilmSpeed::Kind::moves_per_second, 2}, "2 robot moves per second"},
                                Speed{{FilmSpeed::Kind::moves_per_second, 5}, "5 robot moves per second"},
                                Speed{{FilmSpeed::Kind::moves_per_second, 10}, "10 robot moves per second"}};

std::string size_words(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height);
}

std::vector<const char*> pointers(const std::vector<std::string>& words) {
  std::vector<const char*> all;
  for (const std::string& each : words) all.push_back(each.c_str());
  return all;
}

/// A dim word over a choice, in a column of its own.
bool column(const Look& look, const char* name, const Hint& what, const std::vector<std::string>& items,
            int& current, float width) {
  ImGui::BeginGroup();
  text(look.fonts.small, look.theme.dim, name);
  ImGui::PushID(name);
  const bool changed = combo(look, "##choice", pointers(items), current, width);
  ImGui::PopID();
  hint(look, what);
  ImGui::EndGroup();
  return changed;
}

void side_field(const Look& look, const char* id, std::int64_t& side) {
  ImGui::SetNextItemWidth(look.px(64));
  number_field(look, id, ImGuiDataType_S64, &side);
  side = std::clamp<std::int64_t>(side, kSmallestSide, kLargestSide);
}

}  // namespace

void FilmForm::begin(const Session& session, bool window, const PixelArea& area) {
  session_ = &session;
  window_ = window;
  width_ = static_cast<int>(area.max.x - area.min.x);
  height_ = static_cast<int>(area.max.y - area.min.y);
  count_.reset();
}

FilmChoice FilmForm::choice() const {
  FilmChoice choice{.part = part_, .fps = kRates[static_cast<std::size_t>(rate_)]};
  if (part_ == FilmPart::live) return choice;
  choice.speed = kSpeeds[static_cast<std::size_t>(speed_)].speed;
  const Size size = kSizes[static_cast<std::size_t>(size_)];
  choice.width = size_ == kOwn ? static_cast<int>(own_width_) : size.width;
  choice.height = size_ == kOwn ? static_cast<int>(own_height_) : size.height;
  return choice;
}

void FilmForm::draw(const Look& look) {
  const std::string replan = part_words(FilmPart::replan, session_->run());
  const std::array<const char*, 3> parts = {"As I play it, live", replan.c_str(), "The whole run"};
  int part = static_cast<int>(part_);
  if (segments(look, "part", parts, part)) part_ = static_cast<FilmPart>(part);
  ImGui::Dummy({0, look.px(2)});
  // Each column begins at the same height, whatever stands in the one before it.
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float whole = ImGui::GetContentRegionAvail().x, gap = look.px.m;
  const float rate = look.px(136), rest = (whole - rate - 2 * gap) * 0.5f;
  const auto at = [&](float x) { ImGui::SetCursorScreenPos({origin.x + x, origin.y}); };
  std::vector<std::string> rates;
  for (const int each : kRates) rates.push_back(std::to_string(each) + " per second");
  column(look, "Frames",
         {"Frames per second", "", "More are smoother and make a larger file. None is dropped."}, rates,
         rate_, rate);
  at(rate + gap);
  if (part_ == FilmPart::live) {
    ImGui::BeginGroup();
    text(look.fonts.small, look.theme.dim, "Size and speed");
    ImGui::AlignTextToFramePadding();
    paragraph(look.fonts.ui, look.theme.dim,
              window_ ? "As in the window while you play." : "As on the canvas while you play.");
    ImGui::EndGroup();
  } else {
    draw_size(look, rest);
    at(rate + gap + rest + gap);
    std::vector<std::string> speeds;
    for (const Speed& each : kSpeeds) speeds.emplace_back(each.words);
    column(
        look, "Speed",
        {"Speed", "",
         "How much of the run goes by from frame to frame. Automatic: a search in about two seconds, then a "
         "robot move per frame."},
        speeds, speed_, rest);
  }
  ImGui::SetCursorScreenPos({origin.x, origin.y + look.px.control + look.px(34)});
}

void FilmForm::draw_size(const Look& look, float width) {
  std::vector<std::string> sizes = {std::string(window_ ? "as the window, " : "as the canvas, ") +
                                    size_words(width_, height_)};
  for (std::size_t i = 1; i + 1 < kSizes.size(); ++i)
    sizes.push_back(size_words(kSizes[i].width, kSizes[i].height));
  sizes.emplace_back("of your own");
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float own = size_ == kOwn ? look.px(64 * 2 + 32) : 0;
  column(look, "Size", {"Size", "", "Of the film, in pixels."}, sizes, size_, width - own);
  if (size_ == kOwn) {
    ImGui::SetCursorScreenPos(
        {origin.x + width - own + look.px.s, ImGui::GetItemRectMax().y - look.px.control});
    draw_own_size(look);
  }
}

void FilmForm::draw_own_size(const Look& look) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(look.px.s, (look.px.control - look.fonts.mono->FontSize) * 0.5f));
  side_field(look, "##width", own_width_);
  ImGui::SameLine(0, look.px.xs);
  text(look.fonts.ui, look.theme.dim, "×");
  ImGui::SameLine(0, look.px.xs);
  side_field(look, "##height", own_height_);
  ImGui::PopStyleVar();
}

/// How many frames it has: worked out anew where something else is chosen or the run has gone on.
const FilmForm::Count& FilmForm::count() {
  const FilmChoice now = choice();
  const Run& run = session_->run();
  const std::size_t events = run.timeline().size();
  if (count_ && count_->of == now && count_->events == events) return *count_;
  count_ = Count{now, events};
  if (is_complete(now.part, run))
    if (const auto frames = film_frames(now, run)) count_->frames = frames->size();
  return *count_;
}

void FilmForm::draw_facts(const Look& look, const std::string& name) {
  const FilmChoice now = choice();
  text_line(look, look.fonts.title, look.theme.text, name.empty() ? "Film" : file_name(name),
            ImGui::GetContentRegionAvail().x);
  paragraph(look.fonts.ui, look.theme.dim,
            now.part == FilmPart::live ? "Starts when you press Record and runs until you stop it."
                                       : part_words(now.part, session_->run()) +
                                             ", made frame by frame. The status bar tells how far it is.");
  ImGui::Dummy({0, look.px(2)});
  fact(look, "Size", size_words(now.width > 0 ? now.width : width_, now.height > 0 ? now.height : height_));
  if (now.part == FilmPart::live) {
    fact(look, "Frames", std::to_string(now.fps) + " per second");
    fact(look, "Length", "until you stop it");
    return;
  }
  const Count& counted = count();
  fact(look, "Frames", counted.frames ? grouped(*counted.frames) : "not known yet");
  fact(look, "Length",
       counted.frames ? fixed(static_cast<double>(*counted.frames) / now.fps, 1) + " s" : "not known yet");
  if (!counted.frames)
    paragraph(look.fonts.ui, look.theme.dim,
              "The run goes on to its end first: it has not come that far yet.");
}

}  // namespace replan::ui

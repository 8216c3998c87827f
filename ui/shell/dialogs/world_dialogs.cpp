#include "ui/shell/dialogs/world_dialogs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <imgui_stdlib.h>

#include "core/base/random.hpp"
#include "core/world/generators/list.hpp"
#include "ui/icons.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/dialogs/world_views.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/term_hint.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr const char* kPopup = "world dialog";
/// A preview of more cells than this waits until the mouse lets go of a slider.
constexpr std::int64_t kQuickCells = 300'000;
constexpr std::uint32_t kSeeds = 100'000;  // of the dice: short enough to be told to somebody

/// One declared parameter as the control that fits it.
bool parameter_control(const Look& look, const Parameter& parameter, double longest, Settings& settings) {
  const std::string label(parameter.label), unit(parameter.unit), help(parameter.help);
  const Hint what{label.c_str(), "", help.c_str()};
  double value = settings.get(parameter);
  bool changed = false;
  if (parameter.type == ParameterType::toggle) {
    bool on = value != 0;
    changed = toggle(look, label.c_str(), on);
    hint(look, what);
    value = on ? 1 : 0;
  } else {
    const bool is_whole = parameter.type != ParameterType::real;
    const double high = is_whole && parameter.high > longest ? longest : parameter.high;
    changed = slider(look,
                     {.label = label.c_str(),
                      .min = parameter.low,
                      .max = std::max(high, parameter.low + 1e-9),
                      .initial = parameter.initial,
                      .unit = unit.c_str(),
                      .decimals = is_whole ? 0 : 2,
                      .logarithmic = is_whole && parameter.low > 0 && high > 100},
                     value, what);
  }
  if (changed) settings.set(parameter.key, value);
  return changed;
}

}  // namespace

void WorldDialogs::show_resize(const Session& session, const WorkPlace& place) {
  GridMap map = session.world();
  kind_ = Kind::resize;
  size_ = {map.width, map.height, Side::low, Side::low, false, map.depth, Side::low};
  sketched_depth_ = map.depth;
  sketch_ = front_ = MapSketch();
  error_.clear();
  preview_ = std::make_unique<Background<Preview>>(place);
  preview_->start([map = std::move(map)](const StopToken&) {
    return Preview{MapSketch(map), MapSketch(map, Axis::y), "", map.box()};
  });
}

void WorldDialogs::show_generate(const Session& session, const WorkPlace& place) {
  kind_ = Kind::generate;
  preview_ = std::make_unique<Background<Preview>>(place);
  stale_ = true;
  wanted_.width = session.scenario().map.width;
  wanted_.height = session.scenario().map.height;
  const Box world = session.scenario().map.box();
  if (world.solid() && !generator_info().solid) wanted_.generator = "boxes", wanted_.settings = {};
  wanted_.layers = generator_info().solid ? world.depth() : 1;
}

const GeneratorInfo& WorldDialogs::generator_info() const {
  return **require_generator(wanted_.generator);
}

void WorldDialogs::draw(const Look& look, const Session& session, std::vector<Command>& commands) {
  if (kind_ == Kind::none) return;
  if (!ImGui::IsPopupOpen(kPopup)) ImGui::OpenPopup(kPopup);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(look.px(680), screen.x - look.px(32));
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.45f}, ImGuiCond_Always, {0.5f, 0.45f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - look.px(32)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(24), look.px(20)));
  const bool shown =
      ImGui::BeginPopupModal(kPopup, nullptr,
                             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar();
  if (!shown) return;
  if (kind_ == Kind::resize)
    resize(look, session, commands);
  else
    generate(look, commands);
  if (kind_ == Kind::none) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

bool WorldDialogs::generator_settings(const Look& look) {
  bool changed = false;
  std::vector<const char*> names;
  int current = 0;
  for (const GeneratorInfo& info : generators()) {
    if (info.id == wanted_.generator) current = static_cast<int>(names.size());
    names.push_back(info.name.data());  // literals, so they end with a zero
  }
  if (combo(look, "##generator", names, current, ImGui::GetContentRegionAvail().x)) {
    wanted_.generator = generators()[static_cast<std::size_t>(current)].id;
    wanted_.settings = {};
    const GeneratorInfo& chosen = generator_info();
    if (!chosen.solid || wanted_.layers == 1) wanted_.layers = chosen.layers;
    changed = true;
  }
  hint(look, {"Generator", "", "What kind of world. Each has settings of its own below."});
  const GeneratorInfo& info = generators()[static_cast<std::size_t>(current)];
  paragraph(look.fonts.ui, look.theme.dim, info.summary);
  changed |= size_slider(look, "Width", 61, wanted_.width);
  changed |= size_slider(look, "Height", 41, wanted_.height);
  if (info.solid) changed |= layers_slider(look, info.layers, wanted_.layers);
  const double longest = std::max({wanted_.width, wanted_.height, 2});
  for (const Parameter& parameter : info.parameters)
    changed |= parameter_control(look, parameter, longest, wanted_.settings);
  return changed;
}

/// Begins one where the wishes have changed, and takes over what has come of it. A large one is not begun anew for
/// every pixel that a slider is dragged.
void WorldDialogs::make_preview() {
  const std::int64_t cells = std::int64_t{wanted_.width} * wanted_.height * wanted_.layers;
  if (stale_ && (cells <= kQuickCells || !ImGui::IsMouseDown(0))) {
    stale_ = false;
    // A generator cannot be cut up.
    preview_->start([wanted = wanted_](const StopToken&) {
      const Box size(wanted.width, wanted.height, wanted.layers);
      const Result<GridMap> map = replan::generate(wanted.generator, wanted.settings, size, wanted.seed);
      if (!map) return Preview{{}, {}, map.error(), size};
      return Preview{MapSketch(*map), size.solid() ? MapSketch(*map, Axis::y) : MapSketch(), "", size};
    });
  }
  take_preview();
}

void WorldDialogs::take_preview() {
  auto made = preview_->take();
  if (!made) return;
  sketch_ = std::move(made->sketch);
  front_ = std::move(made->front);
  error_ = std::move(made->error);
  drawn_ = made->size;
}

void WorldDialogs::generate_view(const Look& look, const MapSketch& sketch, int rows, ImVec2 size) const {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const auto [min, max] = fitted(origin, size, wanted_.width, rows);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // One of other sides would be drawn out of shape.
  if (drawn_ == Box(wanted_.width, wanted_.height, wanted_.layers)) {
    sketch.draw(look, list, min, max);
  } else if (preview_->busy()) {
    const char* words = "Drawing…";
    draw_text(list, look.fonts.ui,
              {(min.x + max.x - text_width(look.fonts.ui, words)) * 0.5f,
               (min.y + max.y - look.fonts.ui->FontSize) * 0.5f},
              look.theme.dim, words);
  }
  list.AddRect(min, max, look.theme.line, 0, 0, look.px.hair);
  ImGui::Dummy(size);
}

/// The world from above, and one of several layers from the front too.
void WorldDialogs::generate_preview(const Look& look, ImVec2 size) const {
  if (wanted_.layers == 1) return generate_view(look, sketch_, wanted_.height, size);
  two_views(
      look, size, [&](ImVec2 part) { generate_view(look, sketch_, wanted_.height, part); },
      [&](ImVec2 part) { generate_view(look, front_, wanted_.layers, part); });
}

void WorldDialogs::seed_field(const Look& look) {
  ImGui::AlignTextToFramePadding();
  text(look.fonts.ui, look.theme.dim, "Seed");
  ImGui::SameLine(0, look.px.s);
  ImGui::SetNextItemWidth(look.px(110));
  auto seed = static_cast<std::uint64_t>(wanted_.seed);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px.s, look.px.xs));
  const bool typed = number_field(look, "##seed", ImGuiDataType_U64, &seed);
  ImGui::PopStyleVar();
  hint(look, term_hint("seed"));
  ImGui::SameLine(0, look.px.xs);
  const bool rolled = small_button(
      look, "dice",
      {.icon = icon::random, .hint = {"Another seed", "", "The same seed gives the same world."}});
  if (rolled) seed = 1 + Random(wanted_.seed).below(kSeeds);
  if (typed || rolled) wanted_.seed = seed, stale_ = true;
}

void WorldDialogs::generate(const Look& look, std::vector<Command>& commands) {
  heading(look, "Generate a world");
  settings_and_picture(
      look, 360, [&] { stale_ |= generator_settings(look); },
      [&](ImVec2 size) {
        make_preview();
        generate_preview(look, {size.x, size.y - look.px(44)});
        ImGui::Dummy({0, look.px.xs});
        seed_field(look);
      });
  if (!error_.empty()) paragraph(look.fonts.ui, look.theme.bad, as_sentence(error_));
  const Answer answer = confirm(look, "Create");
  if (answer == Answer::yes && !error_.empty()) return;
  if (answer == Answer::yes) commands.emplace_back(wanted_);
  if (answer != Answer::none) kind_ = Kind::none;
}

}  // namespace replan::ui

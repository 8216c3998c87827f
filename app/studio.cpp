#include "app/studio.hpp"

#include <algorithm>
#include <utility>

#include "app/about.hpp"
#include "core/world/library.hpp"
#include "ui/documents/files.hpp"

namespace replan::app {
namespace {

// What an action opens takes time: a dialog reads its files and draws thumbnails one by one.
constexpr int kActionFrames = 60;

}  // namespace

Result<std::unique_ptr<Studio>> Studio::open(const StudioSettings& settings, const Session& session,
                                             ui::ViewState state) {
  auto studio = std::unique_ptr<Studio>(new Studio(settings, std::move(state)));
  auto offscreen = Offscreen::create({settings.width, settings.height, static_cast<float>(settings.scale)});
  if (!offscreen) return Error{offscreen.error()};
  studio->offscreen_ = std::move(*offscreen);
  studio->offscreen_->stage().set_theme(studio->state_.dark ? ui::dark() : ui::light());
  if (std::string words = ui::uncommon_words(session); !words.empty())
    studio->offscreen_->stage().set_language(std::move(words), false);
  return studio;
}

Studio::~Studio() {
  if (!offscreen_) return;
  // Their textures can only be given back while the context is current.
  offscreen_->frame([this] {
    panes_.reset();
    shell_.reset();
  });
}

ui::Image Studio::shoot(Session& session) {
  draw(session);
  if (settings_.window && !std::exchange(settled_, true)) {
    do_actions(session);
    // Windows that are sized by their content settle in the second frame.
    draw(session);
  }
  return offscreen_->picture();
}

void Studio::draw(Session& session) {
  offscreen_->frame([&] { settings_.window ? draw_window(session) : draw_canvas(session); },
                    static_cast<float>(settings_.seconds));
}

/// Each sees what the one before it has led to: its frame tells the session, and what the session does in the
/// background is waited for.
void Studio::do_actions(Session& session) {
  if (settings_.actions.empty() && settings_.dialog.empty()) return;
  shell_->documents().settle_in(session, {{}, library_folder(), {}});
  for (const ui::ActionId action : settings_.actions) {
    shell_->perform_next(action);
    draw(session);
    session.settle();
    draw(session);
  }
  if (!settings_.dialog.empty()) shell_->show_dialog(settings_.dialog, session);
  for (int i = 0; i < kActionFrames; ++i) draw(session);
}

void Studio::draw_window(Session& session) {
  ui::Stage& stage = offscreen_->stage();
  if (!shell_) {
    shell_ = std::make_unique<ui::Shell>(stage.renderer());
    shell_->view() = std::move(state_);  // which is drawn by it from now on
    shell_->panels().panes = settings_.panes;
    shell_->panels().about = about_lines();
  }
  stage.set_fingers(shell_->view().large_targets);
  shell_->draw(stage.look(), session, settings_.seconds);
}

void Studio::draw_canvas(const Session& session) {
  ui::Stage& stage = offscreen_->stage();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  ImGui::Begin("canvas", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  const std::size_t count = std::clamp<std::size_t>(settings_.panes, 1, session.runs().size());
  if (!panes_) panes_ = std::make_unique<ui::Panes>(stage.renderer());
  std::vector<Command> none;
  panes_->draw(stage.look(), session, count, state_, {0, 0}, size, false, none);
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace replan::app

#include "app/render.hpp"

#include <algorithm>

#include "app/film/film.hpp"
#include "app/studio.hpp"
#include "core/base/file.hpp"
#include "core/scene/svg.hpp"
#include "core/trace/log_hash.hpp"
#include "ui/canvas/draw.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/gallery.hpp"
#include "ui/shell/links.hpp"
#include "ui/tools/cells.hpp"

namespace replan::app {
namespace {

constexpr int kMaxSide = 16384;

/// What a run could not do is no picture.
Result<void> check(const Session& session) {
  if (std::string failure = session.failure(); !failure.empty()) return Error{std::move(failure)};
  return {};
}

/// Whether the run has come to the event of a link by the same way as the one that it was copied from.
Result<void> check_link_moment(const Run& run, const LinkView& link, const RenderRequest& request) {
  constexpr const char* kOtherwise =
      "this version of Replan plans the world of the link otherwise than the one that the link is from";
  const std::size_t event = *link.event;
  if (event > run.timeline().size())
    return Error{"the link leads to event " + std::to_string(event) + ", and the run ends after " +
                 std::to_string(run.timeline().size()) + ": " + kOtherwise};
  LogHash hash(event);
  hash.advance(run.timeline(), Deadline::never());
  if (link.log && hash.short_value() != link.log && request.note)
    request.note(std::string(kOtherwise) + ": the moment may be another");
  return {};
}

/// The panes as the link has them; their runs are over.
Result<void> go_to_link(Session& session, const RenderRequest& request) {
  const LinkView& link = *request.link;
  if (const auto good = check_link_moment(session.run(), link, request); !good) return good;
  return session.apply(Seek{*link.event});
}

/// Has the panes led as the link says.
Result<void> lead_by_link(Session& session, const RenderRequest& request) {
  if (!request.link) return {};
  const std::size_t last = session.runs().size() - 1;  // other planners may have been asked for
  if (const auto led = session.apply(Lead{std::min(request.link->lead, last)}); !led) return led;
  return request.link->lockstep ? session.apply(SetLockstep{*request.link->lockstep}) : Result<void>();
}

/// Goes to the moment of a still.
Result<void> go_to(Session& session, const RenderRequest& request) {
  const auto* named = std::get_if<Moment>(&request.at);
  if (const auto led = lead_by_link(session, request); !led) return led;
  if (named != nullptr && *named == Moment::plan) {
    session.settle();
    return check(session);
  }
  if (const auto done = session.apply(RunToEnd{}); !done) return done;
  for (const auto& run : session.runs()) run->finish(Target::end());
  session.update(0);
  if (auto sound = check(session); !sound || named != nullptr) return sound;
  if (std::holds_alternative<LinkMoment>(request.at)) return go_to_link(session, request);
  const auto* words = std::get_if<std::string>(&request.at);
  const auto position = moment_position(
      session.run(), words != nullptr ? *words : std::to_string(std::get<std::size_t>(request.at)));
  if (!position) return Error{position.error()};
  return session.apply(Seek{*position});
}

Error unknown_action(const std::string& name) {
  std::vector<std::string_view> names;
  for (const ui::Action& each : ui::actions()) names.emplace_back(each.name);
  const std::string_view nearest = nearest_name(name, names);
  return Error{"the window has no action '" + name + "'" +
               (nearest.empty() ? "; 'replan list actions' shows them"
                                : "; did you mean '" + std::string(nearest) + "'?")};
}

bool is_window_still(const RenderRequest& request) {
  return request.window && file_extension(request.output) == ".png";
}

Result<void> check_dialog(const RenderRequest& request) {
  if (request.dialog.empty()) return {};
  if (!is_window_still(request))
    return Error{"a dialog shows in a picture of the window alone: give a name that ends in .png"};
  std::string known;
  for (const std::string_view name : ui::gallery_names()) {
    if (name == request.dialog) return {};
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  return Error{"the window has no dialog '" + request.dialog + "'; there are " + known};
}

/// The window's actions that a request names.
Result<std::vector<ui::ActionId>> requested_actions(const RenderRequest& request) {
  std::vector<ui::ActionId> found;
  if (request.actions.empty()) return found;
  if (!is_window_still(request))
    return Error{
        "an action of the window shows in a picture of the window alone: give a name that ends in .png"};
  for (const std::string& name : request.actions) {
    const ui::Action* action = ui::find_action(name);
    if (action == nullptr) return unknown_action(name);
    found.push_back(action->id);
  }
  return found;
}

StudioSettings studio_settings(const RenderRequest& request) {
  return {request.width,
          request.height,
          request.scale,
          request.window,
          request.panes.value_or(request.window ? 0 : 1),
          1.0 / request.film.fps,
          {},
          request.dialog};
}

Result<void> render_film(const RenderRequest& request, Session& session, ui::ViewState state) {
  const auto finish_runs = [&] {
    for (const auto& run : session.runs()) run->finish(Target::end());
  };
  finish_runs();
  session.update(0);
  if (Result<void> sound = check(session); !sound) return sound;
  const Result<std::vector<FilmFrame>> frames = plan_film(session.run(), request.film);
  if (!frames) return Error{frames.error()};
  auto studio = Studio::open(studio_settings(request), session, std::move(state));
  if (!studio) return Error{studio.error()};
  auto film = Film::open({request.output, request.width, request.height, request.film.fps});
  if (!film) return Error{film.error()};
  for (std::size_t i = 0; i < frames->size(); ++i) {
    if (Result<void> sought = session.apply(Seek{(*frames)[i].position, (*frames)[i].travel}); !sought)
      return sought;
    finish_runs();  // seeking may have asked the background for more; a frame shall not depend on when
    if (Result<void> added = (*film)->add((*studio)->shoot(session)); !added) return added;
    if (request.progress) request.progress(i + 1, frames->size());
  }
  return (*film)->finish();
}

}  // namespace

bool is_film(const std::string& output) {
  return is_frame_folder(output) || film_format(output).has_value();
}

FrameSize written_size(const RenderRequest& request) {
  const FrameSize frames{request.width, request.height};
  return is_frame_folder(request.output) ? frames : film_size(request.output, frames);
}

Result<void> write_drawing(const std::string& path, const Run& run, const ui::ViewState& state,
                           std::size_t pane, Viewport size) {
  const Palette palette = ui::scene_palette(state.dark ? ui::dark() : ui::light(), state.colours);
  View view = state.view;
  view.slice = state.slices.of(pane);
  if (state.slices.follows_robot) view.slice.layer = coordinate(ui::robot_cell(run), view.slice.along);
  view.camera = state.shown_camera(view.slice.along);
  return write_file_atomically(path, scene_svg(build_scene(run, view, size, palette), palette));
}

std::string drawing_note(const Run& run, const ui::ViewState& state, std::size_t pane) {
  if (!run.lattice().solid() || !state.slices.orbits(pane)) return "";
  return "an .svg has no 3D, so this one shows the slice; a .png shows the world from outside";
}

namespace {

/// Which layers of a world of several are shown, and from where.
void show_layers(const RenderRequest& request, const LinkView& link, ui::ViewState& state) {
  state.slices.set_all(Slice{Axis::z, request.scenario.start.z});
  ui::show_link_layers(link, state);
  if (request.slice) state.slices.set_all(*request.slice);
  if (request.slice || request.follows_robot) state.slices.follows_robot = request.follows_robot;
  if (!request.orbit) return;
  state.orbit = *request.orbit;
  state.solid.cut = request.cut;
  state.solid.see_through = request.glass;
  for (std::size_t pane = 0; pane < 4; ++pane) state.slices.set_orbits(pane, true);
}

}  // namespace

Result<ui::ViewState> requested_view(const RenderRequest& request) {
  ui::ViewState state;
  const ViewSetup& setup = request.scenario.view;
  const LinkView link = request.link.value_or(LinkView{});
  if (request.overlays || link.overlays) {
    state.view.overlays = request.overlays ? *request.overlays : *link.overlays;
  } else if (!setup.overlays.empty()) {
    const auto parsed = parse_overlays(setup.overlays);
    if (!parsed) return Error{parsed.error()};
    state.view.overlays = *parsed;
  }
  if (const auto& camera = request.camera ? request.camera : link.camera ? link.camera : setup.camera)
    state.camera(request.slice.value_or(Slice{}).along) = {camera->x, camera->y,
                                                           camera->zoom * request.scale};
  const std::string theme = request.theme ? *request.theme
                            : link.dark   ? (*link.dark ? "dark" : "light")
                                          : setup.theme.value_or("dark");
  if (theme != "dark" && theme != "light")
    return Error{"there is no theme '" + theme + "'; take 'dark' or 'light'"};
  state.dark = theme == "dark";
  state.view.pinned = request.pinned ? request.pinned : link.pin;
  state.tab = link.tab;
  state.view.motion = request.motion;
  show_layers(request, link, state);
  state.view.scale = request.scale;
  state.view.range = request.range;
  state.legend = request.legend;
  state.colours = request.colours;
  state.minimap = false;  // where it is asked for, by its action
  state.live = false;
  return state;
}

Result<void> render(const RenderRequest& request) {
  if (request.width < 16 || request.height < 16 || request.width > kMaxSide || request.height > kMaxSide)
    return Error{"a picture's sides must lie between 16 and " + std::to_string(kMaxSide) + " pixels"};
  if (!(request.scale >= 0.5 && request.scale <= 4)) return Error{"the scale must lie between 0.5 and 4"};
  Result<ui::ViewState> state = requested_view(request);
  if (!state) return Error{state.error()};
  auto actions = requested_actions(request);
  if (!actions) return Error{actions.error()};
  if (const auto known = check_dialog(request); !known) return known;
  const std::string extension = file_extension(request.output);
  Session session(request.scenario);
  if (is_film(request.output)) return render_film(request, session, std::move(*state));
  if (extension != ".png" && extension != ".svg")
    return Error{request.output +
                 ": a picture's name ends in .png or .svg, a film's in .gif, .webp or .mp4, a folder for "
                 "frames in /"};
  if (const auto there = go_to(session, request); !there) return there;
  if (extension == ".svg")
    return write_drawing(request.output, session.run(), *state, session.lead(),
                         {request.width, request.height});
  StudioSettings settings = studio_settings(request);
  settings.actions = std::move(*actions);
  auto studio = Studio::open(settings, session, std::move(*state));
  if (!studio) return Error{studio.error()};
  return ui::write_png(request.output, (*studio)->shoot(session));
}

}  // namespace replan::app

#include "ui/shell/gallery.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/world/library.hpp"
#include "ui/documents/choosing.hpp"
#include "ui/documents/questions.hpp"
#include "ui/icons.hpp"
#include "ui/tabs/log.hpp"

namespace replan::ui {
namespace {

using Room = GalleryRoom;

constexpr const char* kFolder = "/home/ann/worlds";
/// Noon of a day long gone: the same date in every time zone, and never told as a time of today.
constexpr std::int64_t kDay = 24 * 60 * 60, kThen = 1580472000;

FixedFolder fixed_folder() {
  return {kFolder,
          {{"drafts", FileKind::folder, 0, kThen},
           {"boxes.json", FileKind::scenario, 2310, kThen - kDay},
           {"demo.json", FileKind::scenario, 4127, kThen},
           {"dynamic.json", FileKind::scenario, 3804, kThen - 9 * kDay},
           {"hall.map", FileKind::map, 25088, kThen - 31 * kDay},
           {"floor plan.png", FileKind::picture, 88410, kThen - 40 * kDay},
           {"notes.txt", FileKind::other, 912, kThen - 2 * kDay}},
          library_folder()};
}

FileDialogSpec at_home(FileDialogSpec spec, const std::string& name) {
  spec.saving = spec.saving || spec.title.empty();
  spec.fixed = fixed_folder();
  spec.path = std::string(kFolder) + "/" + name;
  spec.places = {{icon::home, "Home", "/home/ann"},
                 {icon::map, "Worlds", "/usr/share/replan/maps"},
                 {icon::clock, "worlds", kFolder}};
  return spec;
}

void choose(const Room& room, FileDialogSpec spec, const std::string& name) {
  room.dialogs.choose_file(at_home(std::move(spec), name), {});
}

void film(const Room& room, bool window, FilmPart part) {
  room.dialogs.choose_part(part);
  const PixelArea area{{0, 0}, {window ? 1440.0f : 1020.0f, window ? 900.0f : 704.0f}};
  room.dialogs.ask_film(room.session, window, area, at_home({}, "replan-20200131-120000.gif"), {});
}

void picture(const Room& room) {
  room.dialogs.ask_picture(false, at_home({}, "replan-20200131-120000.png"), {});
}

void recover(const Room& room) {
  room.dialogs.offer({{.file = "/home/ann/worlds/demo.json",
                       .name = "Demo",
                       .edits = 12,
                       .edited_at = kThen,
                       .scripted = 0,
                       .map_file = {}},
                      {.file = "",
                       .name = "Long corridor",
                       .edits = 1,
                       .edited_at = kThen - kDay,
                       .scripted = 0,
                       .map_file = {}}});
}

void about(const Room& room) {
  room.dialogs.show_about({{"Replan", "1.0.0"},
                           {"Dear ImGui", "1.86"},
                           {"GLFW", "3.3.8"},
                           {"JSON for Modern C++", "3.11.2"},
                           {"Compiler", "GCC 12.2.0"}});
}

void link(const Room& room) {
  room.dialogs.show_link("https://example.org/replan.html");
  const std::string world =
      "eNq1VUtv2zAMvu9XELrskgR5tOl6HLbtssOwYzEEskXbQmTJkOg2QdH_PkqO"
      "nXRJsRx2iGB-5Pch8rF8FaSaQu5EaRtJpFUBJaKCjWsUfDRa4R7-Q8mM";
  room.dialogs.take_link(
      "#v=1&at=12345&log=3fa09c1e&panes=2&lockstep=expansions&theme=dark&overlays=path,trail"
      "&tab=cell&pin=12,40&world=" +
      world + world + world + world);
}

void menu(const Room& room, Menu which) {
  room.panels.open_menu = which;
}

/// A batch that is half done, of made up figures.
void batch_results(const Room& room) {
  const std::string file = kept_world_file("field");
  const std::array<RunName, 3> names = {
      RunName{.world = file, .planner = "dstar-lite"},
      RunName{.world = file, .planner = "weighted-astar", .settings = "weight=1.5"},
      RunName{.world = file, .planner = "rrt-star"}};
  std::vector<RunResult> results;
  for (std::int64_t run = 0; run < 36; ++run) {
    RunResult result;
    result.run = run;
    result.name = names[static_cast<std::size_t>(run / 12)];
    result.name.seed = static_cast<std::uint64_t>(run % 12 + 1);
    result.name.surprises = "3 blocks of 2, 6 ahead";
    result.succeeded = run % 17 != 13;
    result.status = result.succeeded ? "arrived" : "no-path";
    const double part = static_cast<double>(run * 7919 % 101) / 101;
    for (const ResultColumn& column : result_columns())
      result.figures.push_back(column.name == "travelled_cells"       ? std::optional(9 + part * 4)
                               : column.name == "turns"               ? std::optional(std::floor(part * 9))
                               : column.name == "min_clearance_cells" ? std::optional(0.5 + part)
                               : column.name == "expansions" ? std::optional(std::floor(40 + part * 900))
                               : column.name == "replans"    ? std::optional(std::floor(part * 5))
                                                             : std::nullopt);
    result.plan_ms = {0.2 + part};
    result.replan_ms = {part * 2};
    results.push_back(std::move(result));
  }
  BatchRequest request;
  request.what.experiment.name = "field";
  request.what.world = room.session.snapshot();
  request.folder = std::string(kFolder) + "/field-batch";
  room.batch.show(room.session, request.folder, {});
  room.batch.exhibit(std::move(request), results, {36, 60, 95});
}

struct Exhibit {
  std::string_view name;
  void (*show)(const Room& room);
};

constexpr std::array kExhibits = {
    Exhibit{"new_world", [](const Room& room) { room.dialogs.show(DialogKind::new_world); }},
    Exhibit{"open", [](const Room& room) { choose(room, spec_to_open(), "demo.json"); }},
    Exhibit{"worlds",
            [](const Room& room) {
              if (WorldLibrary* library = room.documents.library()) room.dialogs.choose_world(*library);
            }},
    Exhibit{"opening", [](const Room& room) { room.dialogs.wait_for("demo.json"); }},
    Exhibit{"save_as",
            [](const Room& room) { choose(room, spec_to_save(room.session.snapshot()), "demo.json"); }},
    Exhibit{"figures", [](const Room& room) { choose(room, spec_to_save_figures(), "figures.csv"); }},
    Exhibit{"film", [](const Room& room) { film(room, false, FilmPart::live); }},
    Exhibit{"film_window", [](const Room& room) { film(room, true, FilmPart::replan); }},
    Exhibit{"film_run", [](const Room& room) { film(room, false, FilmPart::whole); }},
    Exhibit{"picture", picture},
    Exhibit{"trace",
            [](const Room& room) {
              room.dialogs.ask_trace({52407, 1204, 403000}, at_home({}, "demo.trace.yaml"), {});
            }},
    Exhibit{"unsaved",
            [](const Room& room) { room.dialogs.ask(unsaved_question("demo.json", 3, "2020-01-31")); }},
    Exhibit{"changed",
            [](const Room& room) { room.dialogs.ask(changed_question("demo.json", "demo.json", false, 2)); }},
    Exhibit{"overwrite", [](const Room& room) { room.dialogs.ask(overwrite_question("demo.json")); }},
    Exhibit{"recover", recover},
    Exhibit{"generate", [](const Room& room) { room.world_dialogs.show_generate(room.session, {}); }},
    Exhibit{"resize", [](const Room& room) { room.world_dialogs.show_resize(room.session, {}); }},
    Exhibit{
        "batch",
        [](const Room& room) { room.batch.show(room.session, std::string(kFolder) + "/field-batch", {}); }},
    Exhibit{"batch_results", batch_results},
    Exhibit{"edits", [](const Room& room) { show_edits(room.view, room.panels); }},
    Exhibit{"keys", [](const Room& room) { room.dialogs.show(DialogKind::keys); }},
    Exhibit{"link", link},
    Exhibit{"about", about},
    Exhibit{"menu_file", [](const Room& room) { menu(room, Menu::file); }},
    Exhibit{"menu_edit", [](const Room& room) { menu(room, Menu::edit); }},
    Exhibit{"menu_world", [](const Room& room) { menu(room, Menu::world); }},
    Exhibit{"menu_planner", [](const Room& room) { menu(room, Menu::planner); }},
    Exhibit{"menu_run", [](const Room& room) { menu(room, Menu::run); }},
    Exhibit{"menu_view", [](const Room& room) { menu(room, Menu::view); }},
    Exhibit{"menu_overlays", [](const Room& room) { menu(room, Menu::overlays); }},
    Exhibit{"menu_tabs", [](const Room& room) { menu(room, Menu::tabs); }},
    Exhibit{"menu_panes", [](const Room& room) { menu(room, Menu::panes); }},
    Exhibit{"menu_record", [](const Room& room) { menu(room, Menu::record); }},
    Exhibit{"menu_help", [](const Room& room) { menu(room, Menu::help); }},
};

}  // namespace

std::vector<std::string_view> gallery_names() {
  std::vector<std::string_view> names;
  for (const Exhibit& each : kExhibits) names.push_back(each.name);
  return names;
}

bool show_from_gallery(std::string_view name, const Room& room) {
  const auto found = std::find_if(kExhibits.begin(), kExhibits.end(),
                                  [&](const Exhibit& each) { return each.name == name; });
  if (found == kExhibits.end()) return false;
  found->show(room);
  return true;
}

}  // namespace replan::ui

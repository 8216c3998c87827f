#include "ui/documents/choosing.hpp"

#include <algorithm>
#include <filesystem>

#include "core/base/file.hpp"
#include "core/experiment/world_experiment.hpp"
#include "core/world/map_file.hpp"
#include "ui/documents/documents.hpp"
#include "ui/documents/files.hpp"
#include "ui/icons.hpp"
#include "ui/tabs/figures.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

std::vector<FileFilter> filters_to_open() {
  FileFilter worlds{"Worlds: scenarios and maps", {".json"}}, maps{"Maps", {}}, pictures{"Pictures", {}};
  for (const MapFormat& format : map_formats()) {
    if (format.solid) continue;
    worlds.extensions.emplace_back(format.extension);
    (format.picture ? pictures : maps).extensions.emplace_back(format.extension);
  }
  return {worlds, {"Scenarios (.json)", {".json"}}, maps, pictures, {"All files", {}}};
}

std::vector<FileFilter> filters_to_save() {
  std::vector<FileFilter> filters = {{"Scenario (.json)", {".json"}}};
  for (const MapFormat& format : map_formats()) {
    // .yml is the same as .yaml.
    if (format.write == nullptr || format.solid || format.extension == ".yml") continue;
    std::string name(format.name);
    if (name.front() >= 'a' && name.front() <= 'z')
      name.front() = static_cast<char>(name.front() - 'a' + 'A');
    filters.push_back({name + " (" + std::string(format.extension) + ")", {std::string(format.extension)}});
  }
  return filters;
}

}  // namespace

FileDialogSpec spec_to_open() {
  return {.title = "Open",
          .action = "Open",
          .filters = filters_to_open(),
          .path = {},
          .places = {},
          .losses = {}};
}

FileDialogSpec spec_to_save(std::shared_ptr<const Scenario> scenario) {
  return {.saving = true,
          .title = "Save as",
          .action = "Save",
          .filters = filters_to_save(),
          .path = {},
          .places = {},
          .losses = [scenario = std::move(scenario)](const std::string& extension) {
            return lost_in(extension, *scenario);
          }};
}

FileDialogSpec spec_for_experiment(bool saving) {
  return {.saving = saving,
          .title = saving ? "Save as an experiment" : "Open an experiment",
          .action = saving ? "Save" : "Open",
          .filters = {{"Experiments (.json)", {".json"}}},
          .path = {},
          .places = {},
          .losses = {},
          .aside = [](const Look& look, const std::string&) {
            paragraph(
                look.fonts.ui, look.theme.dim,
                "An experiment says which planners run in which worlds, with which seeds and surprises. "
                "\"replan batch\" runs it on the command line too.");
          }};
}

FileDialogSpec spec_for_batch_folder() {
  return {.folders = true,
          .title = "Folder of the results",
          .action = "Choose",
          .filters = {{"Folders", {"/"}}},  // which no file ends in
          .path = {},
          .places = {},
          .losses = {},
          .aside = [](const Look& look, const std::string& folder) {
            text(look.fonts.title, look.theme.text, "Results go to");
            paragraph(look.fonts.mono, look.theme.text, folder);
            ImGui::Dummy({0, look.px.xs});
            paragraph(
                look.fonts.ui, look.theme.dim,
                "A folder that is typed and not there yet is made when the batch begins. One that holds "
                "results gives its experiment, which goes on with them.");
          }};
}

FileDialogSpec spec_to_save_figures() {
  std::vector<FileFilter> filters;
  for (const FiguresFormatInfo& format : figures_formats())
    filters.push_back({std::string(format.name) + " (" + format.extension + ")", {format.extension}});
  return {.saving = true,
          .title = "Save the figures",
          .action = "Save",
          .filters = std::move(filters),
          .path = {},
          .places = {},
          .losses = {}};
}

/// Where a file that has no place yet is likely to go.
std::string Documents::last_folder() const {
  if (const std::string& folder = window_.dialogs.folder(); !folder.empty()) return folder;
  const std::vector<std::string> folders = recent_.folders();
  return folders.empty() ? "." : folders.front();
}

std::vector<Place> Documents::places() const {
  std::vector<Place> places;
  if (const std::string home = typed_path("~"); home != "~") places.push_back({icon::home, "Home", home});
  places.push_back(
      {icon::terminal, "Current folder", typed_from("/", std::filesystem::current_path().string())});
  if (library_) places.push_back({icon::map, "Worlds", library_->folder()});
  for (const std::string& folder : recent_.folders()) {
    const bool known =
        std::any_of(places.begin(), places.end(), [&](const Place& p) { return p.path == folder; });
    if (!known && places.size() < 10) places.push_back({icon::clock, file_name(folder), folder});
  }
  return places;
}

FileDialogSpec Documents::place_for(const std::string& name, const std::string& folder) const {
  return {.saving = true,
          .title = {},
          .action = {},
          .filters = {},
          .path = (folder.empty() ? last_folder() : folder) + "/" + name,
          .places = places(),
          .losses = {}};
}

std::string Documents::batch_folder(const Session& session) const {
  const bool own = !session.file().empty() && !session.other_world();
  const std::string& state = surroundings_.state_folder;
  const std::string first = own ? file_folder(session.file()) + "/" + file_stem(session.file()) + "-batch"
                                : (state.empty() ? last_folder() : state + "/batches") + "/" +
                                      file_stem(kept_world_file(session.scenario().name));
  std::string folder = first;
  for (int next = 2; std::filesystem::exists(folder + "/results.csv"); ++next)
    folder = first + "-" + std::to_string(next);
  return std::filesystem::absolute(folder).lexically_normal().string();
}

void Documents::choose_open(const Session& session, const std::string& path) {
  const std::string file = session.file().empty() ? "" : file_folder(session.file());
  FileDialogSpec spec = spec_to_open();
  spec.path = !path.empty() ? path : !window_.dialogs.folder().empty() ? window_.dialogs.folder() : file;
  spec.places = places();
  window_.dialogs.choose_file(std::move(spec), surroundings_.work);
}

void Documents::choose_save(const Session& session) {
  write_ = [this](Session& its, const std::string& path) { save_and_go_on(its, path); };
  std::string name = session.other_world() ? "" : session.file();
  if (name.empty()) {
    name =
        last_folder() + "/" + (session.scenario().name.empty() ? "world" : session.scenario().name) + ".json";
  } else if (!saves_in_place(session)) {
    name = file_folder(name) + "/" + file_stem(name) + ".json";
  }
  FileDialogSpec spec = spec_to_save(session.snapshot());
  spec.path = std::move(name);
  spec.places = places();
  window_.dialogs.choose_file(std::move(spec), surroundings_.work);
}

void Documents::choose_figures_file() {
  write_ = [this](Session& session, const std::string& path) { save_figures(session, path); };
  FileDialogSpec spec = spec_to_save_figures();
  spec.path = last_folder() + "/figures.csv";
  spec.places = places();
  window_.dialogs.choose_file(std::move(spec), surroundings_.work);
}

/// In the format that the name ends in.
void Documents::save_figures(const Session& session, const std::string& path) {
  for (const FiguresFormatInfo& format : figures_formats()) {
    if (file_extension(path) != format.extension) continue;
    const auto done = write_file_atomically(
        path, figures_text(format.format, window_.panels.tabs.get<FiguresTab>().now(session, window_.view)));
    if (!done) return complain(done.error());
    window_.dialogs.close();
    return window_.message.tell("Saved " + file_name(path), false);
  }
  complain("the name of the figures' file must end in .csv, .json, .md or .tex");
}

}  // namespace replan::ui

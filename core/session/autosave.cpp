#include "core/session/autosave.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/base/file.hpp"
#include "core/base/folders.hpp"

namespace replan {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t kLongestNote = 1 << 16;
constexpr const char* kWorldKey = "\"scenario\": ";

std::string lock_path(const std::string& path) {
  return fs::path(path).replace_extension(".lock").string();
}

Error damaged(const std::string& path) {
  return {"'" + path + "' is no whole autosave; discard it"};
}

Result<AutosaveNote> parse_note(const std::string& line, const std::string& path) {
  // The line is the beginning of a JSON object: {"autosave": {...},
  const std::size_t comma = line.rfind(',');
  if (comma == std::string::npos) return damaged(path);
  const Json json = Json::parse(line.substr(0, comma) + "}", nullptr, false);
  if (!json.is_object() || !json.contains("autosave") || !json["autosave"].is_object()) return damaged(path);
  const Json& note = json["autosave"];
  const auto words = [&note](const char* key) {
    const auto found = note.find(key);
    return found != note.end() && found->is_string() ? found->get<std::string>() : "";
  };
  const auto number = [&note](const char* key) {
    const auto found = note.find(key);
    return found != note.end() && found->is_number_integer()
               ? std::max<std::int64_t>(found->get<std::int64_t>(), 0)
               : 0;
  };
  return AutosaveNote{.file = words("file"),
                      .name = words("name"),
                      .edits = static_cast<std::size_t>(number("edits")),
                      .edited_at = number("edited_at"),
                      .scripted = static_cast<std::size_t>(number("scripted")),
                      .map_file = words("map_file")};
}

}  // namespace

std::string autosave_text(const AutosaveNote& note, const Scenario& scenario) {
  const Json json = {{"file", note.file},           {"name", note.name},         {"edits", note.edits},
                     {"edited_at", note.edited_at}, {"scripted", note.scripted}, {"map_file", note.map_file}};
  std::string text = "{\"autosave\": " + json.dump(-1, ' ', false, Json::error_handler_t::replace) + ",\n";
  text += kWorldKey;
  if (scenario.map_file.empty()) return text + scenario_text(scenario) + "}\n";
  // The file of the map may be another one by the time that the work is taken up.
  Scenario whole = scenario;
  whole.map_file.clear();
  whole.map_reading = {};
  return text + scenario_text(whole) + "}\n";
}

Result<AutosaveNote> read_autosave_note(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line(kLongestNote, '\0');
  file.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t end = line.find('\n');
  if (end == std::string::npos) return damaged(path);
  return parse_note(line.substr(0, end), path);
}

Result<ReplaceScenario> read_autosave(const std::string& path) {
  const Result<AutosaveNote> note = read_autosave_note(path);
  if (!note) return Error{note.error()};
  Result<std::string> text = read_file(path);
  if (!text) return Error{text.error()};
  const std::size_t begin = text->find(kWorldKey), end = text->rfind('}');
  if (begin == std::string::npos || end == std::string::npos || end < begin) return damaged(path);
  const std::size_t world = begin + std::string_view(kWorldKey).size();
  Result<Scenario> scenario = parse_scenario(text->substr(world, end - world), path, file_folder(path));
  if (!scenario) return Error{scenario.error()};
  scenario->map_file = note->map_file;
  return ReplaceScenario{*std::move(scenario), note->file, std::max<std::size_t>(note->edits, 1),
                         note->scripted};
}

std::vector<Orphan> find_orphans(const std::string& folder) {
  std::vector<Orphan> orphans;
  std::error_code failed;
  for (fs::directory_iterator each(folder, failed); !failed && each != fs::directory_iterator();
       each.increment(failed)) {
    const std::string path = each->path().string();
    if (file_extension(path) != ".json") continue;
    std::optional<LockFile> lock = LockFile::try_lock(lock_path(path));
    if (!lock) continue;  // its program lives
    Result<AutosaveNote> note = read_autosave_note(path);
    if (note) orphans.push_back({*std::move(note), path, *std::move(lock)});
  }
  std::sort(orphans.begin(), orphans.end(), [](const Orphan& a, const Orphan& b) {
    return std::pair(-a.note.edited_at, a.path) < std::pair(-b.note.edited_at, b.path);
  });
  return orphans;
}

void discard(Orphan orphan) {
  std::error_code ignored;
  fs::remove(orphan.path, ignored);
  orphan.lock.remove();
}

Autosaver::Autosaver(std::string folder, WorkPlace place) : folder_(std::move(folder)) {
  job_.emplace(std::move(place));
}

Autosaver::~Autosaver() = default;

void Autosaver::take_result() {
  if (const std::optional<Result<void>> done = job_->take(); done && !*done)
    failure_ = "the unsaved edits could not be put aside: " + done->error();
}

void Autosaver::tick(const Session& session, double seconds, bool in_stroke) {
  if (folder_.empty()) return;
  take_result();
  if (job_->busy()) return;
  if (!session.modified()) {
    seen_.reset();
    if (written_) remove();
    return;
  }
  const std::uint64_t state = session.document_state();
  if (state == written_) return;
  if (state != seen_) {
    if (!seen_ || seen_ == written_) first_edit_ = seconds;
    seen_ = state;
    last_edit_ = seconds;
    edited_at_ = static_cast<std::int64_t>(std::time(nullptr));
  }
  const bool due = seconds - last_edit_ >= kQuietSeconds || seconds - first_edit_ >= kLongestSeconds;
  if (due && !in_stroke) write(session);
}

void Autosaver::write(const Session& session) {
  written_ = seen_;  // also after a failure: the next attempt comes with the next edit
  if (!lock_) {
    if (const Result<void> made = make_private_folder(folder_); !made) {
      failure_ = made.error();
      return;
    }
    path_ = (fs::path(folder_) /
             (std::to_string(std::time(nullptr)) + "-" + std::to_string(::getpid()) + ".json"))
                .string();
    lock_ = LockFile::try_lock(lock_path(path_));
  }
  const std::shared_ptr<const Scenario> scenario = session.snapshot();
  AutosaveNote note{.file = session.file(),
                    .name = scenario->name,
                    .edits = session.unsaved_edits(),
                    .edited_at = edited_at_,
                    .scripted = session.scripted(),
                    .map_file = scenario->map_reading == MapReading() ? scenario->map_file : ""};
  // Cannot be cut up: in step it takes a frame in which no stroke is under way.
  job_->start([path = path_, note = std::move(note), scenario, debug = session.debug()](const StopToken&) {
    Scenario whole = *scenario;
    whole.debug = debug;
    return write_file_atomically(path, autosave_text(note, whole));
  });
  take_result();
}

void Autosaver::adopt(Orphan orphan, const Session& session) {
  if (folder_.empty()) return;
  remove();
  path_ = std::move(orphan.path);
  lock_.emplace(std::move(orphan.lock));
  edited_at_ = orphan.note.edited_at;
  written_ = seen_ = session.document_state();
}

void Autosaver::remove() {
  job_->wait();
  take_result();
  std::error_code ignored;
  if (!path_.empty()) fs::remove(path_, ignored);
  if (lock_) lock_->remove();
  lock_.reset();
  written_.reset();
  seen_.reset();
  path_.clear();
}

}  // namespace replan

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>

#include "core/base/file.hpp"
#include "core/base/markdown.hpp"
#include "core/lesson/lesson.hpp"
#include "core/plan/pages.hpp"
#include "core/plan/parameters.hpp"
#include "core/session/command_name.hpp"

namespace replan {
namespace {

constexpr std::string_view kFence = "```", kReference = "<!-- scenario:";
constexpr std::int64_t kMaxLessonBytes = 1 << 20;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// "`g(5, 2) == 0`" without its marks.
std::string_view without_ticks(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text.front() == '`' && text.back() == '`') return text.substr(1, text.size() - 2);
  return text;
}

/// Whether the text is a whole number and no more; it is then in `number`.
bool is_number(std::string_view text, std::int64_t& number) {
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failed == std::errc{} && end == text.data() + text.size();
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& origin, const std::string& folder)
      : rest_(text), origin_(origin), folder_(folder) {}

  Result<Lesson> read() {
    std::string_view line;
    while (next(line))
      if (const Result<void> done = take(line); !done) return Error{done.error()};
    if (const Result<void> done = end_step(); !done) return Error{done.error()};
    if (lesson_.title.empty()) return Error{origin_ + ": the lesson has no heading; begin it with '# Name'"};
    if (lesson_.summary.empty())
      return Error{origin_ +
                   ": the lesson does not say what it is about; write a sentence below its heading"};
    if (lesson_.steps.empty())
      return Error{origin_ + ": the lesson has no steps; each begins with '## What it is about'"};
    return std::move(lesson_);
  }

 private:
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return true;
  }
  [[nodiscard]] Error error(const std::string& what) const { return error_at(number_, what); }
  [[nodiscard]] Error error_at(int line, const std::string& what) const {
    return Error{origin_ + ":" + std::to_string(line) + ": " + what};
  }

  Result<void> take(std::string_view line) {
    if (line.starts_with(kFence)) return take_block(trimmed(line.substr(kFence.size())));
    if (line.starts_with(kReference)) return take_reference(line.substr(kReference.size()));
    if (line.starts_with("## ")) return begin_step(trimmed(line.substr(3)));
    if (line.starts_with("# "))
      lesson_.title = std::string(trimmed(line.substr(2)));
    else if (line.starts_with("- "))
      return take_item(line.substr(2));
    else
      take_words(trimmed(line));
    return {};
  }

  void take_words(std::string_view words) {
    if (words.empty()) {
      goes_on_ = false;
      return;
    }
    if (lesson_.steps.empty()) {
      lesson_.summary += (lesson_.summary.empty() ? "" : " ") + std::string(words);
      return;
    }
    std::vector<std::string>& paragraphs = lesson_.steps.back().paragraphs;
    if (goes_on_ && !paragraphs.empty())
      paragraphs.back() += " " + std::string(words);
    else
      paragraphs.emplace_back(words);
    goes_on_ = true;
  }

  /// The scenario, in the lesson itself.
  Result<void> take_block(std::string_view language) {
    if (language != "scenario")
      return error("a block of a lesson holds its scenario: begin it with ```scenario");
    // With as many empty lines before it as there are here, so that errors name the lesson's lines.
    std::string text(static_cast<std::size_t>(number_), '\n');
    std::string_view line;
    bool closed = false;
    while (!closed && next(line)) {
      closed = line.starts_with(kFence);
      if (!closed) text += std::string(line) + "\n";
    }
    if (!closed) return error("the scenario's block is not closed; end it with ```");
    return take_scenario(parse_scenario(text, origin_, folder_));
  }

  Result<void> take_reference(std::string_view text) {
    const std::string path(trimmed(text.substr(0, text.find("-->"))));
    const Result<Scenario> scenario =
        read_scenario((std::filesystem::path(folder_) / path).lexically_normal().string());
    if (!scenario) return error(scenario.error());
    return take_scenario(scenario);
  }

  Result<void> take_scenario(const Result<Scenario>& scenario) {
    if (!scenario) return Error{scenario.error()};
    if (has_scenario_) return error("a lesson has one scenario, and this is a second one");
    if (!lesson_.steps.empty()) return error("the scenario stands before the first step");
    lesson_.scenario = scenario.value();
    has_scenario_ = true;
    return {};
  }

  Result<void> begin_step(std::string_view title) {
    if (!has_scenario_)
      return error("the scenario is missing: put a block that begins with ```scenario before the first step");
    if (const Result<void> done = end_step(); !done) return done;
    lesson_.steps.push_back({.title = std::string(title)});
    step_line_ = number_;
    goes_on_ = false;
    return {};
  }

  /// Whether the last step is whole.
  Result<void> end_step() {
    if (lesson_.steps.empty()) return {};
    const LessonStep& step = lesson_.steps.back();
    if (step.paragraphs.empty())
      return error_at(step_line_, "the step says nothing; write a sentence below it");
    if (!step.until && step.given.empty())
      return error_at(step_line_,
                      "the step asks for nothing; add '- until: `CONDITION`' or '- given: `COMMAND`'");
    if (!step.until && step.deeds.empty())
      return error_at(step_line_, "the step cannot be done for the learner; add '- do: `DEED`'");
    return {};
  }

  /// "until: `CONDITION`" and its like.
  Result<void> take_item(std::string_view item) {
    goes_on_ = false;
    if (lesson_.steps.empty()) return error("what is asked for stands in a step, below a '## ' heading");
    const std::size_t colon = std::min(item.find(':'), item.size());
    const std::string_view key = trimmed(item.substr(0, colon));
    const std::string_view value = without_ticks(item.substr(std::min(colon + 1, item.size())));
    if (value.empty())
      return error("'" + std::string(key) + "' has no value; write '- " + std::string(key) + ": `...`'");
    static constexpr std::string_view kKeys[] = {"until", "given", "do", "cell", "touches"};
    LessonStep& step = lesson_.steps.back();
    if (key == "until") return take_condition(step, value);
    if (key == "given") return take_given(step, value);
    if (key == "do") return take_deed(step, value);
    if (key == "cell") return take_cell(step, value);
    if (key == "touches") return take_claim(step, value);
    const std::string_view nearest = nearest_name(key, kKeys);
    return error("a step has no '" + std::string(key) + "'" +
                 (nearest.empty() ? "; give until, given, do, cell or touches"
                                  : "; did you mean '" + std::string(nearest) + "'?"));
  }

  Result<void> take_condition(LessonStep& step, std::string_view text) {
    if (step.until) return error("a step has one 'until'; join two with &&");
    Result<Condition> condition = parse_condition(text, box());
    if (!condition) return error(condition.error());
    step.until = std::move(condition.value());
    return {};
  }

  /// Commands begin with a capital letter; actions are known to a window alone.
  Result<void> take_given(LessonStep& step, std::string_view name) {
    const auto names = command_names();
    const bool command = std::isupper(static_cast<unsigned char>(name.front())) != 0;
    if (command && std::find(names.begin(), names.end(), name) == names.end()) {
      const std::string_view nearest = nearest_name(name, names);
      return error("there is no command '" + std::string(name) + "'" +
                   (nearest.empty() ? "; core/session/commands.def has them"
                                    : "; did you mean '" + std::string(nearest) + "'?"));
    }
    step.given.emplace_back(name);
    return {};
  }

  Result<void> take_deed(LessonStep& step, std::string_view text) {
    Result<Deed> deed = parse_deed(text, box());
    if (!deed) return error(deed.error());
    step.deeds.push_back(std::move(deed.value()));
    return {};
  }

  Result<void> take_cell(LessonStep& step, std::string_view text) {
    const Result<Cell> cell = parse_lesson_cell(text, box());
    if (!cell) return error(cell.error());
    step.cell = *cell;
    return {};
  }

  Result<void> take_claim(LessonStep& step, std::string_view text) {
    constexpr std::string_view kOf = " of ";
    TouchClaim claim;
    const std::size_t of = std::min(text.find(kOf), text.size());
    if (!is_number(text.substr(0, of), claim.repair) ||
        !is_number(text.substr(std::min(of + kOf.size(), text.size())), claim.scratch))
      return error("'" + std::string(text) + "' does not say how many cells are touched; write 3 of 36");
    step.touches = claim;
    return {};
  }

  [[nodiscard]] Box box() const { return lesson_.scenario.map.box(); }

  std::string_view rest_;
  const std::string& origin_;
  const std::string& folder_;
  Lesson lesson_;
  int number_ = 0, step_line_ = 0;
  bool has_scenario_ = false;
  bool goes_on_ = false;  // the next words belong to the last paragraph
};

/// The name without a number and a hyphen before it.
std::string id_of(std::string name) {
  const std::size_t end = name.find_first_not_of("0123456789");
  if (end != 0 && end != std::string::npos && name[end] == '-') name.erase(0, end + 1);
  return name;
}

}  // namespace

std::vector<LessonFile> lesson_files() {
  std::vector<LessonFile> files;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(assets_folder() + "/lessons", failed)) {
    const std::string path = entry.path().string();
    if (file_extension(path) == ".md") files.push_back({id_of(file_stem(path)), path});
  }
  std::sort(files.begin(), files.end(),
            [](const LessonFile& a, const LessonFile& b) { return a.path < b.path; });
  return files;
}

Result<Lesson> parse_lesson(std::string_view text, const std::string& origin, const std::string& folder) {
  return Reader(text, origin, folder).read();
}

Result<Lesson> read_lesson(const LessonFile& file) {
  const Result<std::string> text = read_file(file.path, kMaxLessonBytes);
  if (!text) return Error{text.error()};
  Result<Lesson> lesson = parse_lesson(*text, file.path, file_folder(file.path));
  if (!lesson) return lesson;
  lesson.value().id = file.id;
  return lesson;
}

Result<Lesson> read_lesson(std::string_view id) {
  const std::vector<LessonFile> files = lesson_files();
  std::vector<std::string_view> ids;
  for (const LessonFile& file : files) {
    if (file.id == id) return read_lesson(file);
    ids.push_back(file.id);
  }
  const std::string_view nearest = nearest_name(id, ids);
  return Error{"there is no lesson '" + std::string(id) + "'" +
               (nearest.empty() ? "; 'replan list lessons' shows those there are"
                                : "; did you mean '" + std::string(nearest) + "'?")};
}

}  // namespace replan

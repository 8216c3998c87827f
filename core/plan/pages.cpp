#include "core/plan/pages.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>

#include "core/base/file.hpp"

namespace replan {
namespace {

constexpr std::string_view kFence = "```";
constexpr std::string_view kReference = "<!-- pseudo:";
constexpr std::int64_t kMaxPageBytes = 1 << 20;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Takes a number off the front; nothing if there is none.
bool take_number(std::string_view& text, int& number) {
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& origin, const std::string& folder)
      : rest_(text), origin_(origin), folder_(folder) {}

  Result<PlannerPage> read() {
    std::string_view line;
    while (next(line)) {
      const Result<void> done = take(line);
      if (!done) return Error{done.error()};
    }
    if (page_.title.empty()) return Error{origin_ + ": the page has no heading; begin it with '# Name'"};
    if (page_.code.empty())
      return Error{origin_ + ": the page has no pseudo-code; add a block that begins with ```pseudo"};
    return std::move(page_);
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
  [[nodiscard]] Error error(const std::string& what) const {
    return Error{origin_ + ":" + std::to_string(number_) + ": " + what};
  }

  Result<void> take(std::string_view line) {
    if (line.starts_with(kFence)) return take_block(line.substr(kFence.size()));
    if (line.starts_with(kReference)) return take_reference(line.substr(kReference.size()));
    const std::string_view words = trimmed(line);
    if (line.starts_with("## "))
      page_.sections.push_back({std::string(trimmed(line.substr(3))), {}});
    else if (line.starts_with("# "))
      page_.title = std::string(trimmed(line.substr(2)));
    else if (words.empty())
      open_ = false;
    else if (!page_.sections.empty())
      take_words(words);
    return {};
  }

  void take_words(std::string_view words) {
    std::vector<std::string>& paragraphs = page_.sections.back().paragraphs;
    const bool item = words.starts_with("- ");
    if (item) words.remove_prefix(2);
    if (!open_ || item || paragraphs.empty())
      paragraphs.push_back((item ? "• " : "") + std::string(words));
    else
      paragraphs.back() += " " + std::string(words);
    open_ = true;
  }

  Result<void> take_block(std::string_view head) {
    open_ = false;
    head = trimmed(head);
    const bool wanted = head.starts_with("pseudo");
    int base = 0;
    PseudoBlock block;
    if (wanted) {
      head = trimmed(head.substr(6));
      if (!take_number(head, base))
        return error("after ```pseudo comes the number that is added to its lines: ```pseudo 0 Title");
      block.title = std::string(trimmed(head));
    }
    std::string_view line;
    while (next(line) && !line.starts_with(kFence))
      if (wanted)
        if (const Result<void> done = take_line(line, base, block); !done) return done;
    if (wanted) page_.code.push_back(std::move(block));
    return {};
  }

  Result<void> take_line(std::string_view line, int base, PseudoBlock& block) {
    std::string_view text = line.substr(std::min(line.find_first_not_of(' '), line.size()));
    PseudoLine pseudo;
    if (int number = 0; take_number(text, number) && text.starts_with(':')) {
      pseudo.number = base + number;
      text.remove_prefix(1);
      if (text.starts_with(' ')) text.remove_prefix(1);
      if (pseudo.number < 1 || pseudo.number > 255) return error("line numbers go from 1 to 255");
    } else {
      if (block.lines.empty()) return error("a block's first line needs a number: '1: text'");
      text = line;
      const std::size_t margin = std::min<std::size_t>(4, text.size());
      if (text.substr(0, margin) == std::string_view("    ").substr(0, margin)) text.remove_prefix(margin);
    }
    pseudo.text = std::string(text);
    block.lines.push_back(std::move(pseudo));
    return {};
  }

  Result<void> take_reference(std::string_view text) {
    text = text.substr(0, text.find("-->"));
    const std::string id(trimmed(text));
    const std::string path = folder_ + "/" + id + ".md";
    if (path == origin_) return error("a page cannot take its pseudo-code from itself");
    const Result<std::string> bytes = read_file(path, kMaxPageBytes);
    if (!bytes) return error(bytes.error());
    if (bytes->find(kReference) != std::string::npos)
      return error("'" + id + "' takes its pseudo-code from elsewhere itself");
    Result<PlannerPage> other = parse_page(*bytes, path, folder_);
    if (!other) return Error{other.error()};
    for (PseudoBlock& block : other->code) page_.code.push_back(std::move(block));
    return {};
  }

  std::string_view rest_;
  const std::string& origin_;
  const std::string& folder_;
  PlannerPage page_;
  int number_ = 0;
  bool open_ = false;  // the next words belong to the last paragraph
};

/// The folder of the program, or empty.
std::filesystem::path program_folder() {
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? std::filesystem::path() : program.parent_path();
}

}  // namespace

const PageSection* PlannerPage::section(std::string_view name) const {
  const auto found =
      std::find_if(sections.begin(), sections.end(), [&](const PageSection& s) { return s.title == name; });
  return found == sections.end() ? nullptr : &*found;
}

const PseudoBlock* PlannerPage::block_of(int number) const {
  for (const PseudoBlock& block : code)
    for (const PseudoLine& line : block.lines)
      if (line.number == number && number != 0) return &block;
  return nullptr;
}

const PseudoLine* PlannerPage::line(int number) const {
  if (const PseudoBlock* block = block_of(number))
    for (const PseudoLine& line : block->lines)
      if (line.number == number) return &line;
  return nullptr;
}

std::string assets_folder() {
  if (const char* named = std::getenv("REPLAN_ASSETS"); named != nullptr && named[0] != '\0') return named;
  std::error_code failed;
  for (const std::filesystem::path& folder :
       {std::filesystem::path(REPLAN_SOURCE_ASSETS), program_folder() / "../share/replan/assets"})
    if (std::filesystem::is_directory(folder, failed)) return folder.lexically_normal().string();
  return "";
}

Result<PlannerPage> parse_page(std::string_view text, const std::string& origin, const std::string& folder) {
  return Reader(text, origin, folder).read();
}

Result<PlannerPage> read_page(std::string_view planner) {
  const std::string assets = assets_folder();
  if (assets.empty())
    return Error{"the planner pages were not found; set REPLAN_ASSETS to the folder 'assets' of the program"};
  const std::string folder = assets + "/planners";
  const std::string path = folder + "/" + std::string(planner) + ".md";
  const Result<std::string> text = read_file(path, kMaxPageBytes);
  if (!text) return Error{text.error()};
  return parse_page(*text, path, folder);
}

Result<PlannerPage> read_page(std::string_view pilot, std::string_view planner) {
  Result<PlannerPage> page = read_page(pilot);
  if (!page) return page;
  const Result<PlannerPage> other = read_page(planner);
  if (!other) return other;
  page->code.insert(page->code.end(), other->code.begin(), other->code.end());
  return page;
}

}  // namespace replan

#include "core/export/trace_file.hpp"

#include <array>
#include <limits>

#include "core/base/file.hpp"
#include "core/export/json_lines.hpp"
#include "core/export/posthoc.hpp"

namespace replan {
namespace {

struct Ending {
  std::string_view text;
  TraceFormat format;
};
constexpr std::array<Ending, 4> kEndings = {{{".jsonl", TraceFormat::json_lines},
                                             {".trace.yaml", TraceFormat::posthoc_yaml},
                                             {".trace.yml", TraceFormat::posthoc_yaml},
                                             {".trace.json", TraceFormat::posthoc_json}}};

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;

const Ending* ending_of(std::string_view path) {
  for (const Ending& ending : kEndings)
    if (path.size() > ending.text.size() && path.ends_with(ending.text)) return &ending;
  return nullptr;
}

std::unique_ptr<TraceEncoder> encoder_for(TraceFormat format, const TraceRun& run) {
  if (format == TraceFormat::json_lines) return std::make_unique<JsonLines>(run);
  return std::make_unique<PosthocTrace>(run, format == TraceFormat::posthoc_yaml);
}

}  // namespace

std::string_view trace_ending(std::string_view path) {
  const Ending* ending = ending_of(path);
  return ending == nullptr ? std::string_view() : ending->text;
}

Result<TraceFormat> trace_format(std::string_view path) {
  if (const Ending* ending = ending_of(path)) return ending->format;
  const std::string extension = file_extension(path);
  std::string mend = "end its name in .jsonl (JSON Lines), or in .trace.yaml or .trace.json (Posthoc)";
  if (extension == ".json" || extension == ".yaml" || extension == ".yml")
    mend = "Posthoc takes '" + file_stem(path) + ".trace" + extension +
           "'; for JSON Lines end the name in .jsonl";
  return Error{"cannot tell the format of the trace '" + std::string(path) + "': " + mend};
}

Result<TraceFormat> trace_format(std::string_view path, const Box& world) {
  Result<TraceFormat> format = trace_format(path);
  if (!format || *format == TraceFormat::json_lines || !world.solid()) return format;
  return Error{"Posthoc draws planes, and this world has " + std::to_string(world.depth()) +
               " layers: end the name of '" + std::string(path) + "' in .jsonl"};
}

Result<std::unique_ptr<TraceFile>> TraceFile::create(const std::string& path, TraceRun run) {
  const Result<TraceFormat> format = trace_format(path, run.view.lattice);
  if (!format) return Error{format.error()};
  Result<PendingFile> file = PendingFile::create(path);
  if (!file) return Error{file.error()};
  return std::unique_ptr<TraceFile>(new TraceFile(std::move(*file), std::move(run), *format));
}

TraceFile::TraceFile(PendingFile file, TraceRun run, TraceFormat format)
    : file_(std::move(file)),
      run_(std::move(run)),
      encoder_(encoder_for(format, run_)),
      state_(run_.view.log.state_at(0)),
      size_(run_.view.log.size()) {}

Result<bool> TraceFile::advance(std::size_t events) {
  const auto flush = [this](std::size_t from) -> Result<void> {
    if (buffer_.size() < from) return {};
    const auto written = file_.write(buffer_);
    buffer_.clear();
    return written;
  };
  const Timeline& log = run_.view.log;
  for (; events > 0 && done() < total(); --events) {
    if (part_ < encoder_->head_parts()) {
      encoder_->head(buffer_, part_++);
    } else {
      const Event& event = log.event(position_);
      encoder_->event(buffer_, position_, event, state_);
      state_.apply(event);
      ++position_;
    }
    if (const auto written = flush(kBufferBytes); !written) return Error{written.error()};
  }
  if (done() < total()) return false;
  encoder_->tail(buffer_, state_);
  if (const auto written = flush(0); !written) return Error{written.error()};
  if (const auto named = file_.commit(); !named) return Error{named.error()};
  return true;
}

Result<void> write_trace(const std::string& path, TraceRun run) {
  auto file = TraceFile::create(path, std::move(run));
  if (!file) return Error{file.error()};
  const auto done = (*file)->advance(std::numeric_limits<std::size_t>::max());
  if (!done) return Error{done.error()};
  return {};
}

}  // namespace replan

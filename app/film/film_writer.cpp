#include "app/film/film_writer.hpp"

#include <array>
#include <utility>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

#include "app/film/child_process.hpp"
#include "app/film/film_check.hpp"
#include "core/base/file.hpp"

namespace replan::app {
namespace {

using Words = std::vector<std::string>;

// Numbers under which FFmpeg finds its files.
constexpr int kFilm = 3, kKept = 4, kPalette = 5;
constexpr int kFastestGif = 50;

std::string as_path(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

Words& operator+=(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The program with what holds for every call: no questions, errors only, nothing in the file that tells
/// when or by which version it was made.
Words ffmpeg() {
  return {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y"};
}
Words reproducible() {
  return {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-threads", "4"};
}

Words raw_frames(const FilmSettings& film) {
  return {"-f",
          "rawvideo",
          "-pixel_format",
          "rgb0",
          "-video_size",
          std::to_string(film.width) + "x" + std::to_string(film.height),
          "-framerate",
          std::to_string(film.fps),
          "-i",
          "pipe:0"};
}

/// Every player shows it: even sizes, colours at half resolution, and the table of contents in front.
Words mp4(const FilmSettings& film) {
  const FrameSize size = film_size(film.path, {film.width, film.height});
  const std::string frames =
      "pad=" + std::to_string(size.width) + ":" + std::to_string(size.height) +
      ",scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p";
  Words words = {"-vf", frames};
  words += {"-c:v", "libx264", "-preset", "veryfast", "-tune", "animation", "-crf", "18"};
  words += {"-colorspace", "bt709", "-color_primaries", "bt709"};
  words += {"-color_trc", "bt709", "-color_range", "tv"};
  words += {"-movflags", "+faststart", "-f", "mp4"};
  return words;
}

/// Without loss: flat colours and letters stay sharp, and the file is not larger for it.
Words webp() {
  Words words = {"-vf", "format=bgra", "-c:v", "libwebp_anim", "-lossless", "1", "-compression_level", "3"};
  words += {"-loop", "0", "-f", "webp"};
  return words;
}

void close_if_open(int& descriptor) {
  if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

}  // namespace

std::optional<FilmFormat> film_format(const std::string& path) {
  const std::string extension = file_extension(path);
  if (extension == ".gif") return FilmFormat::gif;
  if (extension == ".webp") return FilmFormat::webp;
  if (extension == ".mp4") return FilmFormat::mp4;
  return std::nullopt;
}

FrameSize film_size(const std::string& path, FrameSize frames) {
  if (film_format(path) != FilmFormat::mp4) return frames;
  return {frames.width + frames.width % 2, frames.height + frames.height % 2};
}

Result<std::unique_ptr<FilmWriter>> FilmWriter::open(const FilmSettings& settings) {
  const std::optional<FilmFormat> format = film_format(settings.path);
  if (!format) return Error{settings.path + ": a film's name ends in .gif, .webp or .mp4"};
  if (*format == FilmFormat::gif && settings.fps > kFastestGif)
    return Error{settings.path + ": a GIF shows at most " + std::to_string(kFastestGif) +
                 " frames per second; take fewer, or .webp or .mp4"};
  if (!ChildProcess::is_installed("ffmpeg"))
    return Error{
        "a film needs the program ffmpeg, which is not installed; install the package 'ffmpeg', or "
        "give a folder (its name ends in /) to get the frames as pictures"};
  Result<PendingFile> file = PendingFile::create(settings.path);
  if (!file) return Error{file.error()};
  std::unique_ptr<FilmWriter> writer(new FilmWriter(settings, *format, std::move(*file)));
  if (const Result<void> started = *format == FilmFormat::gif ? writer->start_gathering() : writer->start();
      !started)
    return Error{started.error()};
  return writer;
}

FilmWriter::FilmWriter(FilmSettings settings, FilmFormat format, PendingFile file)
    : settings_(std::move(settings)), format_(format), file_(std::move(file)) {}

FilmWriter::~FilmWriter() {
  encoder_.reset();
  close_if_open(kept_);
  close_if_open(palette_);
}

Result<void> FilmWriter::start() {
  Words words = ffmpeg();
  words += raw_frames(settings_);
  words += format_ == FilmFormat::mp4 ? mp4(settings_) : webp();
  words += reproducible();
  words.push_back(as_path(kFilm));
  const std::array files = {std::pair{file_.descriptor(), kFilm}};
  auto started = ChildProcess::start(words, files);
  if (!started) return failed(started.error());
  encoder_ = std::move(*started);
  return {};
}

/// The first pass of a GIF.
Result<void> FilmWriter::start_gathering() {
  const Result<int> scratch = open_scratch_file(file_folder(settings_.path));
  if (!scratch) return failed(scratch.error());
  kept_ = *scratch;
  palette_ = ::memfd_create("palette", MFD_CLOEXEC);
  Words words = ffmpeg();
  words += raw_frames(settings_);
  words += {"-filter_complex", "split[all][colours];[colours]palettegen=stats_mode=full[palette]"};
  words += {"-map", "[all]", "-c:v", "libx264rgb", "-preset", "ultrafast", "-qp", "0", "-f", "nut"};
  words += {as_path(kKept)};
  words += {"-map", "[palette]", "-c:v", "png", "-f", "image2pipe", as_path(kPalette)};
  const std::array files = {std::pair{kept_, kKept}, std::pair{palette_, kPalette}};
  auto started = ChildProcess::start(words, files);
  if (!started) return failed(started.error());
  encoder_ = std::move(*started);
  return {};
}

/// The second pass of a GIF. Ordered dithering stands still from frame to frame, so little changes.
Result<void> FilmWriter::make_gif() {
  Words words = ffmpeg();
  words += {"-f", "nut", "-i", as_path(kKept), "-f", "png_pipe", "-i", as_path(kPalette)};
  words += {"-filter_complex", "paletteuse=dither=bayer:bayer_scale=5:diff_mode=rectangle"};
  words += {"-c:v", "gif", "-loop", "0", "-f", "gif"};
  words += reproducible();
  words.push_back(as_path(kFilm));
  const std::array files = {std::pair{file_.descriptor(), kFilm}, std::pair{kept_, kKept},
                            std::pair{palette_, kPalette}};
  auto started = ChildProcess::start(words, files);
  if (!started) return failed(started.error());
  encoder_ = std::move(*started);
  if (const Result<void> done = encoder_->finish(); !done) return failed(done.error());
  return {};
}

Result<void> FilmWriter::add(const ui::Image& frame) {
  if (frame.width != settings_.width || frame.height != settings_.height)
    return failed("a frame has another size than the film");
  if (encoder_->feed(frame.rgba)) return {};
  const Result<void> ended = encoder_->finish();
  return failed(ended ? "ffmpeg stopped before the film's end" : ended.error());
}

Result<void> FilmWriter::finish() {
  if (const Result<void> done = encoder_->finish(); !done) return failed(done.error());
  if (format_ == FilmFormat::gif)
    if (Result<void> made = make_gif(); !made) return made;
  if (!is_whole_film(file_.descriptor(), format_))
    return failed("ffmpeg said that all went well, but the film is not whole; is the disk full?");
  return file_.commit();
}

/// FFmpeg knows its files by number; the user by name.
Error FilmWriter::failed(const std::string& why) const {
  const auto put = [](std::string text, const std::string& number, const std::string& name) {
    for (std::size_t at = 0; (at = text.find(number, at)) != std::string::npos; at += name.size())
      text.replace(at, number.size(), name);
    return text;
  };
  const std::string words = put(put(why, as_path(kFilm), settings_.path), as_path(kKept), "the frames' file");
  return {"cannot make the film '" + settings_.path + "': " + words};
}

}  // namespace replan::app

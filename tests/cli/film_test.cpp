// 'replan render' to a film: what the file holds, and that it is whole or absent whatever goes wrong.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <sys/stat.h>

#include "tests/cli/child.hpp"

namespace replan::test::film_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScenario = R"({
  "replan": 1,
  "map": {"rows": ["......", "..@...", "......"]},
  "start": [0, 1], "goal": [5, 1],
  "planners": [{"id": "dld-star-lite"}]
})";

bool has(const char* program) {
  return std::system((std::string("command -v ") + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// What a shell command prints.
std::string printed(const std::string& command) {
  const TemporaryFolder folder;
  EXPECT_EQ(std::system((command + " >" + folder.file("out") + " 2>/dev/null").c_str()), 0) << command;
  return whole_file(folder.file("out"));
}

/// Puts a folder in front of PATH, or in its place, for a test.
class Path {
 public:
  explicit Path(const std::string& path) : before_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

 private:
  std::string before_;
};

class Film : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has("ffmpeg") || !has("ffprobe")) GTEST_SKIP() << "ffmpeg is not installed";
  }

  [[nodiscard]] std::vector<std::string> arguments(const std::string& name) const {
    return {"render", scenario_, "-o",     out_.file(name), "--size",  "101x75", "--canvas-only",
            "--fps",  "20",      "--hold", "0.2",           "--speed", "move"};
  }
  /// Frames of a folder that is rendered with the same options.
  [[nodiscard]] std::ptrdiff_t frame_count() const {
    const TemporaryFolder folder;
    std::vector<std::string> to_folder = arguments("x");
    to_folder[3] = folder.path();
    EXPECT_EQ(run_program(to_folder).code, 0);
    return folder.entries();
  }
  /// A program of the name ffmpeg that does this; the folder that it lies in.
  [[nodiscard]] std::string fake(const std::string& script) const {
    const std::string file = fakes_.with("ffmpeg", "#!/bin/sh\n" + script + "\n");
    chmod(file.c_str(), 0755);
    return fakes_.path() + ":" + std::getenv("PATH");
  }
  [[nodiscard]] std::string probe(const std::string& name) const {
    return printed(
        "ffprobe -v error -count_frames -of csv=p=0 -show_entries "
        "stream=width,height,avg_frame_rate,nb_read_frames " +
        out_.file(name));
  }

  TemporaryFolder input_, out_, fakes_;
  std::string scenario_ = input_.with("small.json", kScenario);
};

TEST_F(Film, hasFramesSizeAndRateAskedFor) {
  const std::string frames = std::to_string(frame_count());
  for (const char* name : {"x.mp4", "x.gif"}) {
    const Outcome outcome = run_program(arguments(name));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << "no progress in a pipe";
    EXPECT_NE(outcome.out.find(frames + " frames into"), std::string::npos) << outcome.out;
    const std::string even = name == std::string("x.mp4") ? "102,76" : "101,75";
    EXPECT_EQ(probe(name), even + ",20/1," + frames + "\n") << name;
  }
  EXPECT_EQ(out_.entries(), 2) << "nothing beside the films";
}

/// FFmpeg cannot read animated WebP, so its chunks are counted here.
TEST_F(Film, webpIsAnimatedAndRepeats) {
  ASSERT_EQ(run_program(arguments("x.webp")).code, 0);
  const std::string bytes = whole_file(out_.file("x.webp"));
  const auto number = [&](std::size_t at, int count) {
    std::size_t value = 0;
    while (count-- > 0)
      value = value * 256 + static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(count)));
    return value;
  };
  ASSERT_GT(bytes.size(), 30u);
  EXPECT_EQ(bytes.substr(0, 4) + bytes.substr(8, 8), "RIFFWEBPVP8X");
  EXPECT_EQ(number(4, 4) + 8, bytes.size());
  EXPECT_EQ(number(24, 3) + 1, 101u);
  EXPECT_EQ(number(27, 3) + 1, 75u);
  std::size_t milliseconds = 0;
  for (std::size_t at = 12; at + 8 <= bytes.size(); at += 8 + (number(at + 4, 4) + 1) / 2 * 2) {
    if (bytes.substr(at, 4) == "ANMF") milliseconds += number(at + 8 + 12, 3);
    if (bytes.substr(at, 4) == "ANIM") {
      EXPECT_EQ(number(at + 8 + 4, 2), 0u) << "for ever";
    }
  }
  EXPECT_EQ(milliseconds, static_cast<std::size_t>(frame_count()) * 50);
}

TEST_F(Film, isTheSameEachTime) {
  for (const char* kind : {".mp4", ".gif", ".webp"}) {
    ASSERT_EQ(run_program(arguments(std::string("a") + kind)).code, 0);
    ASSERT_EQ(run_program(arguments(std::string("b") + kind)).code, 0);
    EXPECT_TRUE(whole_file(out_.file(std::string("a") + kind)) ==
                whole_file(out_.file(std::string("b") + kind)))
        << kind;
  }
}

TEST_F(Film, showsTheFramesOfTheFolder) {
  std::vector<std::string> to_folder = arguments("frames/");
  ASSERT_EQ(run_program(to_folder).code, 0);
  ASSERT_EQ(run_program(arguments("x.gif")).code, 0);
  // Mean difference of all pixels: a GIF's palette may round colours, not move shapes.
  const std::string text = printed(
      "ffmpeg -v error -i " + out_.file("x.gif") + " -framerate 20 -i " + out_.file("frames/%06d.png") +
      " -lavfi '[0]format=rgb24[a];[1]format=rgb24[b];[a][b]psnr=stats_file=-' -f null -");
  EXPECT_NE(text.find("psnr_avg:"), std::string::npos) << text;
  for (std::size_t at = 0; (at = text.find("psnr_avg:", at)) != std::string::npos; ++at) {
    const std::string value = text.substr(at + 9, 6);
    EXPECT_TRUE(value.starts_with("inf") || std::stod(value) > 30) << value;
  }
}

TEST_F(Film, takesThePlaceOfAnOldFileAndItsRights) {
  const std::string file = out_.with("x.gif", "old");
  chmod(file.c_str(), 0640);
  ASSERT_EQ(run_program(arguments("x.gif")).code, 0);
  EXPECT_TRUE(whole_file(file).starts_with("GIF89a"));
  struct stat info {};
  ASSERT_EQ(stat(file.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640u);
  EXPECT_EQ(out_.entries(), 1);
}

TEST_F(Film, aFailureLeavesTheOldFileAndShowsItsWords) {
  const std::string file = out_.with("x.mp4", "old");
  struct Case {
    const char* script;
    const char* words;
  };
  for (const Case& each :
       {Case{"echo 'Unknown encoder libx264' >&2; exit 3", "Unknown encoder libx264"},
        Case{"head -c 1000 >/dev/null; echo 'gone midway' >&2; exit 1", "gone midway"},
        Case{"head -c 1000 >/dev/null; kill -9 $$", "signal (Killed)"},
        Case{"cat >/dev/null; echo 'No space left on device' >&2; exit 1", "No space left"},
        Case{"cat >/dev/null", "not whole"}, Case{"cat >/proc/self/fd/3", "not whole"},
        Case{"exit 0", "before the film's end"}}) {
    const Path path(fake(each.script));
    expect_complaint(arguments("x.mp4"), {"x.mp4", each.words});
    EXPECT_EQ(whole_file(file), "old") << each.script;
    EXPECT_EQ(out_.entries(), 1) << each.script;
  }
}

TEST_F(Film, theSecondPassOfAGifMayFailToo) {
  const Path path(
      fake("case \"$*\" in *paletteuse*) echo 'no memory' >&2; exit 1 ;; *) cat >/dev/null ;; esac"));
  expect_complaint(arguments("x.gif"), {"x.gif", "no memory"});
  EXPECT_EQ(out_.entries(), 0);
}

TEST_F(Film, aFullDiskLeavesNothing) {
  for (const char* name : {"x.mp4", "x.gif", "x.webp"}) {
    const TemporaryFolder folder;
    // As on a disk that fills up: the next bytes do not fit.
    std::string command = "trap '' XFSZ; ulimit -f 1; exec " REPLAN_PROGRAM;
    for (const std::string& argument : arguments(name))
      command += " '" + (argument == "101x75" ? "640x480" : argument) + "'";
    const int code = std::system(("bash -c \"" + command + "\" >/dev/null 2>" + folder.file("err")).c_str());
    EXPECT_NE(code, 0) << name;
    EXPECT_NE(whole_file(folder.file("err")).find(name), std::string::npos) << whole_file(folder.file("err"));
    EXPECT_EQ(out_.entries(), 0) << name;
  }
}

/// Starts the program, waits until it feeds a fake FFmpeg, and ends it by a signal.
void interrupt(const std::vector<std::string>& arguments, const std::string& begun, int signal) {
  const int null = open("/dev/null", O_WRONLY);
  const pid_t child = fork();
  if (child == 0) become_program(arguments, null, null);
  close(null);
  for (int i = 0; i < 500 && !fs::exists(begun); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(fs::exists(begun)) << "it never began";
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "it was over before it was interrupted";
}

TEST_F(Film, anInterruptedFilmLeavesTheOldFile) {
  const std::string file = out_.with("x.gif", "old");
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const TemporaryFolder marks;
    const Path path(
        fake("head -c 1000 >/dev/null; touch " + marks.file("begun") + "; sleep 5; cat >/dev/null"));
    interrupt(arguments("x.gif"), marks.file("begun"), signal);
    EXPECT_EQ(whole_file(file), "old");
    EXPECT_EQ(out_.entries(), 1) << "signal " << signal;
  }
}

TEST_F(Film, withoutFfmpegItSaysWhatToDo) {
  const Path path(fakes_.path());
  expect_complaint(arguments("x.gif"), {"package 'ffmpeg'", "folder"});
  std::vector<std::string> to_folder = arguments("frames/");
  EXPECT_EQ(run_program(to_folder).code, 0) << "frames need no ffmpeg";
}

TEST_F(Film, badInput) {
  const auto with = [&](const char* name, const std::vector<std::string>& more) {
    std::vector<std::string> all = {"render", scenario_, "-o", out_.file(name), "--size", "64x64"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect_complaint(with("x.gif", {"--fps", "0"}), {"--fps cannot be '0'", "1 to 60"});
  expect_complaint(with("x.gif", {"--fps", "61"}), {"--fps"});
  expect_complaint(with("x.gif", {"--fps", "60"}), {"GIF", "50"});
  expect_complaint(with("x.gif", {"--speed", "quick"}), {"--speed", "'quick'", "auto"});
  expect_complaint(with("x.gif", {"--hold", "long"}), {"--hold cannot be 'long'"});
  expect_complaint(with("x.gif", {"--hold", "-1"}), {"0 to 60 seconds"});
  expect_complaint(with("x.gif", {"--from", "lunch"}), {"no moment 'lunch'"});
  expect_complaint(with("x.gif", {"--from", "end", "--to", "plan"}), {"end before"});
  expect_complaint(with("x.gif", {"--to", "replan:7"}), {"no replan 7"});
  expect_complaint(with("x.gif", {"--panes", "none"}), {"--panes cannot be 'none'"});
  expect_complaint(with("no/such/x.gif", {}), {"no/such/x.gif", "No such file"});
  expect_complaint(with("x.png", {"--fps", "20"}), {"--fps is for films"});
  expect_complaint(with("x.svg", {"--from", "plan"}), {"--from is for films"});
  expect_complaint(with("x.svg", {"--panes", "2"}), {"--panes is not for .svg"});
  expect_complaint(with("x.gif", {"--at-end"}), {"--from and --to"});
  fs::create_directory(out_.file("folder.gif"));
  EXPECT_EQ(run_program(with("folder.gif", {"--to", "plan"})).code, 0) << "a folder, whatever its name";
}

TEST_F(Film, theSizeThatIsToldIsTheFiles) {
  for (const auto& [name, size] :
       {std::pair{"a.mp4", "102 x 76"}, {"a.gif", "101 x 75"}, {"a.webp", "101 x 75"}}) {
    const Outcome outcome = run_program(arguments(name));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(", " + std::string(size) + " pixels\n"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("note: an .mp4 has even sides") != std::string::npos,
              std::string(name) == "a.mp4");
  }
  EXPECT_EQ(printed("ffprobe -v error -show_entries stream=width,height -of csv=p=0 " + out_.file("a.mp4")),
            "102,76\n");
}

}  // namespace
}  // namespace replan::test::film_test

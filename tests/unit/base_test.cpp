#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/cell.hpp"
#include "core/base/cost.hpp"
#include "core/base/file.hpp"
#include "core/base/hash.hpp"
#include "core/base/pending_file.hpp"
#include "core/base/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::base_test {
namespace {

__extension__ using Wide = unsigned __int128;

/// The root by bisection in whole numbers.
std::int64_t root_by_bisection(std::int64_t squared) {
  const Wide target = static_cast<Wide>(squared) << 60;
  Wide low = 0, high = static_cast<Wide>(1) << 56;
  while (high - low > 1) {
    const Wide middle = (low + high) / 2;
    (middle * middle <= target ? low : high) = middle;
  }
  return static_cast<std::int64_t>(low);
}

TEST(Cost, EuclideanFloorAndCeilAreExact) {
  std::vector<std::int64_t> cases;
  for (std::int64_t i = 0; i < 5000; ++i) cases.push_back(i);
  for (std::int64_t side = 1; side < (std::int64_t{1} << 25); side = side * 3 + 1)
    for (const std::int64_t off : {-1, 0, 1}) cases.push_back(side * side + off);
  Random random(7);
  for (int i = 0; i < 20000; ++i) cases.push_back(static_cast<std::int64_t>(random.next() >> (15 + i % 40)));
  for (const std::int64_t squared : cases) {
    if (squared >= (std::int64_t{1} << 50)) continue;
    const std::int64_t floor = root_by_bisection(squared);
    ASSERT_EQ(euclidean_floor(squared).raw, floor) << squared;
    const bool exact = static_cast<Wide>(floor) * static_cast<Wide>(floor) == static_cast<Wide>(squared)
                                                                                  << 60;
    ASSERT_EQ(euclidean_ceil(squared).raw, floor + (exact ? 0 : 1)) << squared;
    const long double root =
        std::sqrt(static_cast<long double>(squared)) * static_cast<long double>(Cost::kScale);
    ASSERT_NEAR(static_cast<double>(root - static_cast<long double>(floor)), 0.5, 0.51) << squared;
  }
}

TEST(Cost, StepsAreRoundedUp) {
  for (const int axes : {0, 1, 2, 3}) EXPECT_EQ(kStepCost[axes], euclidean_ceil(axes)) << axes;
}

TEST(Cost, SumsSaturateAtInfinity) {
  EXPECT_TRUE((Cost::infinity() + Cost::infinity()).is_infinite());
  EXPECT_EQ(Cost::infinity() + Cost::cells(5), Cost::infinity());
  EXPECT_EQ(Cost::cells(2) + Cost::cells(3), Cost::cells(5));
  EXPECT_FALSE((Cost::cells(kMaxCells) + Cost::cells(19)).is_infinite());
  EXPECT_EQ(Cost::cells(5).to_double(), 5.0);
  EXPECT_EQ(Cost::infinity().to_double(), HUGE_VAL);
  EXPECT_LT(Cost::cells(5), Cost::infinity());
}

TEST(Cell, DistancesAreRightInTheWidestWorlds) {
  const Cell a{0, 0}, b{60'000, 40}, far{1 << 26, 0};
  EXPECT_EQ(squared_distance(a, b), 3'600'001'600);
  EXPECT_EQ(squared_distance(b, a), 3'600'001'600);
  EXPECT_EQ(squared_distance(a, far), std::int64_t{1} << 52);
  EXPECT_EQ(scalar_product(a, b, b), 3'600'001'600);
  EXPECT_EQ(scalar_product(b, a, {b.x, 0}), 40 * 40);
  EXPECT_EQ(distance(a, {3, 4}), 5);
  EXPECT_EQ(distance(a, far), 1 << 26);
}

TEST(Random, IsTheSameEverywhere) {
  Random random(42);
  const std::array<std::uint64_t, 4> drawn = {random.next(), random.next(), random.next(), random.next()};
  // splitmix64's published sequence for the seed 42.
  const std::array<std::uint64_t, 4> expected = {13679457532755275413ull, 2949826092126892291ull,
                                                 5139283748462763858ull, 6349198060258255764ull};
  EXPECT_EQ(drawn, expected);
}

TEST(Random, DrawsEvenlyWithinItsRange) {
  Random random(1);
  std::array<int, 7> count{};
  for (int i = 0; i < 70000; ++i) ++count.at(static_cast<std::size_t>(random.between(-3, 3) + 3));
  for (const int c : count) EXPECT_NEAR(c, 10000, 500);
  for (int i = 0; i < 1000; ++i) {
    const double unit = random.unit();
    ASSERT_TRUE(unit >= 0 && unit < 1);
    ASSERT_EQ(random.below(1), 0u);
  }
  EXPECT_FALSE(Random(3).chance(0));
  EXPECT_TRUE(Random(3).chance(1));
}

TEST(Hash, IsThePublishedOneAndMindsTheOrder) {
  EXPECT_EQ(hash_bytes(""), 0xCBF29CE484222325ull);
  EXPECT_EQ(hash_bytes("a"), 0xAF63DC4C8601EC8Cull);
  EXPECT_EQ(hash_bytes("foobar"), 0x85944171F73967E8ull);
  EXPECT_NE(hash_combine(hash_combine(0, 1), 2), hash_combine(hash_combine(0, 2), 1));
}

TEST(File, WritesAndReadsBytesWhole) {
  const test::TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xFF", 6);
  ASSERT_TRUE(write_file_atomically(folder.file("x"), bytes).ok());
  EXPECT_EQ(*read_file(folder.file("x")), bytes);
  ASSERT_TRUE(write_file_atomically(folder.file("x"), "").ok());
  EXPECT_EQ(*read_file(folder.file("x")), "");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(File, RefusesWhatIsTooLargeOrNoFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.with("x", "12345");
  EXPECT_TRUE(read_file(path, 5).ok());
  EXPECT_EQ(read_file(path, 4).error(), "cannot read '" + path + "': it has more than the allowed 4 bytes");
  EXPECT_EQ(read_file("/dev/zero", 1000).error(),
            "cannot read '/dev/zero': it has more than the allowed 1000 bytes");
  EXPECT_EQ(read_file(folder.path()).error(), "cannot read '" + folder.path() + "': it is a folder");
  EXPECT_EQ(read_file("/no/x").error(), "cannot read '/no/x': No such file or directory");
}

TEST(File, AFailedWriteLeavesTheOldFileAndNothingElse) {
  const test::TemporaryFolder folder;
  const std::string path = folder.with("x", "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};  // the next bytes do not fit: as on a disk that fills up
  setrlimit(RLIMIT_FSIZE, &small);
  const Result<void> written = write_file_atomically(path, std::string(5000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error(), "cannot write '" + path + "': File too large");
  EXPECT_EQ(*read_file(path), "old");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(File, SaysWhyItCannotWrite) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(write_file_atomically("/dev/full", "x").error(),
            "cannot write '/dev/full': No space left on device");
  EXPECT_EQ(write_file_atomically(folder.file("no/x"), "x").error(),
            "cannot write '" + folder.file("no/x") + "': No such file or directory");
  EXPECT_EQ(write_file_atomically(folder.path(), "x").error(),
            "cannot write '" + folder.path() + "': it is a folder");
  EXPECT_FALSE(write_file_atomically("", "x").ok());
  EXPECT_TRUE(write_file_atomically("/dev/null", "x").ok());  // straight to it, not renamed over it
  struct stat info {};
  ASSERT_EQ(stat("/dev/null", &info), 0);
  EXPECT_TRUE(S_ISCHR(info.st_mode));
}

TEST(File, ANewOneHasTheRightsThatTheProcessLeaves) {
  const test::TemporaryFolder folder;
  const std::string made = folder.file("made");
  const mode_t before = ::umask(027);
  EXPECT_TRUE(write_file_atomically(made, "new").ok());
  ::umask(before);
  struct stat info {};
  ASSERT_EQ(stat(made.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640u);
}

TEST(File, KeepsRightsAndFollowsLinks) {
  const test::TemporaryFolder folder;
  const std::string path = folder.with("x", "old"), link = folder.file("link");
  chmod(path.c_str(), 0640);
  std::filesystem::create_symlink("x", link);
  ASSERT_TRUE(write_file_atomically(link, "new").ok());
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(*read_file(path), "new");
  struct stat info {};
  ASSERT_EQ(stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640u);
}

TEST(File, TakesItsNameOnceItIsComplete) {
  const test::TemporaryFolder folder;
  const std::string path = folder.with("x", "old");
  {
    auto file = PendingFile::create(path);
    ASSERT_TRUE(file.ok()) << file.error();
    EXPECT_EQ(write(file->descriptor(), "new", 3), 3);
    EXPECT_EQ(*read_file(path), "old");
    EXPECT_EQ(folder.entries(), 1) << "nothing is to be seen of it";
    PendingFile moved = std::move(file).value();
    ASSERT_TRUE(moved.commit().ok());
  }
  EXPECT_EQ(*read_file(path), "new");
  { const auto given_up = PendingFile::create(folder.file("y")); }
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(PendingFile::create("/dev/null").error(), "cannot write '/dev/null': it is not a plain file");
  EXPECT_FALSE(PendingFile::create("").ok());
}

/// On systems without files that have no name.
TEST(File, HasAPartsNameUntilItIsComplete) {
  const test::TemporaryFolder folder;
  const std::string path = folder.with("x", "old"), part = path + ".part";
  chmod(path.c_str(), 0640);
  std::filesystem::create_symlink("x", folder.file("link"));
  folder.with("x.part", "left behind by a program that was ended");
  {
    auto file = PendingFile::create(folder.file("link"), PendingFile::Until::part);
    ASSERT_TRUE(file.ok()) << file.error();
    ASSERT_TRUE(file->write("new").ok());
    EXPECT_EQ(*read_file(path), "old");
    EXPECT_EQ(*read_file(part), "new");
    PendingFile moved = std::move(file).value();
    ASSERT_TRUE(moved.commit().ok());
  }
  EXPECT_EQ(*read_file(path), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  struct stat info {};
  ASSERT_EQ(stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640u);
  {
    const auto given_up = PendingFile::create(folder.file("y"), PendingFile::Until::part);
    EXPECT_TRUE(std::filesystem::exists(folder.file("y.part")));
  }
  EXPECT_EQ(folder.entries(), 2) << "x and the link to it";
}

TEST(File, TakesNamesApart) {
  EXPECT_EQ(file_extension("a/B.MAP"), ".map");
  EXPECT_EQ(file_extension("a.b/c"), "");
  EXPECT_EQ(file_stem("a/x.map.scen"), "x.map");
  EXPECT_EQ(file_name("maps\\dao/arena.map"), "arena.map");
  EXPECT_EQ(file_folder("a/b/c"), "a/b");
  EXPECT_EQ(file_folder("c"), ".");
}

}  // namespace
}  // namespace replan::base_test

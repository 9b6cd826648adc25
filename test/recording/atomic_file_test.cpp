#include "ratchet_sieve/recording/atomic_file.h"

#include <cerrno>

#include <gtest/gtest.h>

#include "errors.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

TEST(AtomicFile, AppearsWholeAtItsCommitAndNotWithoutIt)
{
  const ScratchDirectory directory;
  const std::string path = directory / "out.txt";
  for (const char* older : {"", "old"})
  {
    if (*older != '\0')
      std::ofstream(path) << older;
    {
      AtomicFile file(path);
      file.stream() << "half";
    }
    EXPECT_EQ(contents(path), older);
    EXPECT_EQ(directory.empty(), *older == '\0');
    AtomicFile file(path);
    file.stream() << "new";
    file.commit();
    EXPECT_EQ(contents(path), "new");
    std::filesystem::remove(path);
  }
}

TEST(AtomicFile, RefusesAPathThatCannotBe)
{
  const ScratchDirectory directory;
  const std::string path = directory / "none/out.txt";
  EXPECT_EQ(errorOf<OutputError>([&] { AtomicFile file(path); }),
            path + ": cannot be written: No such file or directory");
  EXPECT_THROW(AtomicFile file(directory / ""), OutputError);
}

TEST(AtomicFile, WritesToADeviceAndDoesNotReplaceIt)
{
  AtomicFile file("/dev/null");
  file.stream() << "gone";
  file.commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicFile, WritesWhatALinkNamesAndKeepsTheLink)
{
  const ScratchDirectory directory;
  namespace fs = std::filesystem;
  fs::create_directory(directory / "there");
  fs::create_symlink("there/out.txt", directory / "second");
  fs::create_symlink("second", directory / "first");
  for (const char* text : {"new", "newer"})
  {
    AtomicFile file(directory / "first");
    file.stream() << text;
    file.commit();
    EXPECT_EQ(contents(directory / "there/out.txt"), text);
    EXPECT_TRUE(fs::is_symlink(directory / "first"));
    EXPECT_TRUE(fs::is_symlink(directory / "second"));
  }
}

/// One that a killed program has left; only the lock tells it from one that is being written.
TEST(AtomicFile, TakesAPartThatIsLeftAndNoneThatIsWritten)
{
  const ScratchDirectory directory;
  const std::string path = directory / "out.txt";
  std::ofstream(path + ".sieve_part") << "left by a killed program";
  AtomicFile first(path);
  first.stream() << "first";
  AtomicFile second(path);
  second.stream() << "second";
  first.commit();
  EXPECT_EQ(contents(path), "first");
  second.commit();
  EXPECT_EQ(contents(path), "second");
  std::filesystem::remove(path);
  EXPECT_TRUE(directory.empty());
}

/// By whichever name: a bag that is recorded, a results file.
TEST(AtomicFile, ReplacesNoFileThatIsWrittenUnderItsOwnName)
{
  const ScratchDirectory directory;
  const std::string path = directory / "run.bag.active";
  const std::string link = directory / "link";
  std::filesystem::create_symlink(path, link);
  const std::string error = path + ": cannot be written: another program is writing it";
  AtomicFile before(link);
  {
    const LockedFile written(path);
    ASSERT_EQ(written.error(), 0);
    EXPECT_EQ(LockedFile(link).error(), EAGAIN);
    EXPECT_EQ(errorOf<OutputError>([&] { AtomicFile file(link); }), error);
    EXPECT_EQ(errorOf<OutputError>([&] { before.commit(); }), error);
  }
  AtomicFile(link).commit();
}

TEST(AtomicFile, SaysWhenTheDiskIsFull)
{
  AtomicFile file("/dev/full");
  file.stream() << std::string(1 << 20, 'x');
  EXPECT_THROW(file.commit(), OutputError);
}

}  // namespace
}  // namespace ratchet_sieve

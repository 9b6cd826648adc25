#include "ratchet_sieve/recording/progress_bar.h"

#include <cstdlib>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace ratchet_sieve
{
namespace
{

TEST(ProgressBar, NamesADurationAsPeopleDo)
{
  EXPECT_EQ(durationText(7.2), "0:07");
  EXPECT_EQ(durationText(3723.0), "1:02:03");
  EXPECT_EQ(durationText(10 * 86400.0), "10 days");
  EXPECT_EQ(durationText(3.2 * 365.25 * 86400.0), "3.2 years");
}

TEST(ProgressText, SaysHowFarHowFastAndHowLongYet)
{
  const std::string quarter =
      "[######..................]  25.0 %  25.00 of 100 s simulated  1.50 M events/s  0:06 to go";
  EXPECT_EQ(progressText(25.0, 100.0, {25.0, 3000000, 2.0}), quarter);
  EXPECT_EQ(progressText(25.0, 100.0, {25.0, 3000000, 2.0, 1.74}),
            quarter + "  error 1.7 x the requested one");
  EXPECT_EQ(progressText(1.0, 100.0, {1.0, 0, 100.0}),
            "[........................]   1.0 %  1.00 of 100 s simulated  0.00 M events/s  2:45:00 to go");
  EXPECT_EQ(progressText(75.0, 100.0, {25.0, 3000000, 2.0}),
            "[##################......]  75.0 %  75.00 of 100 s simulated  1.50 M events/s  0:02 to go")
      << "of a resumed run";
  EXPECT_EQ(progressText(0.0, 100.0, {}), "[........................]   0.0 %  0.00 of 100 s simulated");
  EXPECT_EQ(progressText(0.0, 0.0, {}), "[########################] 100.0 %  0.00 of 0 s simulated");
}

TEST(ProgressText, HasABarOfWhatIsLeftOfTheWidth)
{
  const Progress progress = {25.0, 3000000, 2.0};
  const std::string figures = "  25.0 %  25.00 of 100 s simulated  1.50 M events/s  0:06 to go";
  EXPECT_EQ(progressText(25.0, 100.0, progress, 79), "[###...........]" + figures);
  EXPECT_EQ(progressText(25.0, 100.0, progress, 79).size(), 79u);
  EXPECT_EQ(progressText(25.0, 100.0, progress, 10), "[]" + figures);
}

/// A terminal breaks a longer line, and each redraw leaves a part of it behind.
TEST(ProgressBar, FitsItsTerminal)
{
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_TRUE(grantpt(terminal) == 0 && unlockpt(terminal) == 0);
  const int screen = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  const winsize size = {24, 40, 0, 0};
  ASSERT_EQ(ioctl(screen, TIOCSWINSZ, &size), 0);
  const int errors = dup(STDERR_FILENO);
  dup2(screen, STDERR_FILENO);
  ProgressBar().show(std::string(100, 'x'));
  dup2(errors, STDERR_FILENO);
  const std::string expected = "\r" + std::string(39, 'x') + "\x1b[K\r\x1b[K";
  std::string text(expected.size(), ' ');
  for (std::size_t size = 0; size < text.size();)
  {
    const ssize_t count = read(terminal, &text[size], text.size() - size);
    ASSERT_GT(count, 0);
    size += static_cast<std::size_t>(count);
  }
  EXPECT_EQ(text, expected);
  for (const int descriptor : {terminal, screen, errors})
    close(descriptor);
}

}  // namespace
}  // namespace ratchet_sieve

#include "ratchet_sieve/recording/progress_bar.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace ratchet_sieve

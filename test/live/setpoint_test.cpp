#include "ratchet_sieve/live/setpoint.h"

#include <limits>

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
const Setpoint INCLINATION{Quantity::INCLINATION, {-0.25, 0.5}};

TEST(Setpoint, isTakenWithinItsLimits)
{
  for (const double value : {-0.25, 0.0, 0.5})
    EXPECT_FALSE(INCLINATION.refusal(value)) << value;
}

TEST(Setpoint, isRefusedOutsideWithTheNumbers)
{
  EXPECT_EQ(INCLINATION.refusal(0.75),
            "inclination_setpoint 0.75 rad refused: must be from -0.25 to 0.5 rad");
  EXPECT_TRUE(INCLINATION.refusal(-0.2500001));
}

TEST(Setpoint, isRefusedWhereNotFinite)
{
  EXPECT_EQ(INCLINATION.refusal(-std::numeric_limits<double>::quiet_NaN()),
            "inclination_setpoint nan rad refused: must be from -0.25 to 0.5 rad");
  EXPECT_TRUE(INCLINATION.refusal(std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(INCLINATION.refusal(-std::numeric_limits<double>::infinity()));
}
}  // namespace
}  // namespace ratchet_sieve

#include <cmath>

#include <gtest/gtest.h>

#include "sieve_client.h"

namespace ratchet_sieve
{
namespace
{
/// Mean and standard error, over the disks, of the displacement between two frames.
struct Current
{
  double mean = 0.0;     ///< [m]
  double stderr_ = 0.0;  ///< [m]
};

Current currentBetween(const ParticleFrame& before, const ParticleFrame& after)
{
  const std::size_t count = before.disks.size();
  EXPECT_EQ(after.disks.size(), count);
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    EXPECT_EQ(after.disks[k].id, before.disks[k].id);
    const double way = after.disks[k].displacement - before.disks[k].displacement;
    sum += way;
    squares += way * way;
  }
  const double n = static_cast<double>(count);
  const double mean = sum / n;
  return {mean, std::sqrt((squares / n - mean * mean) / (n - 1.0))};
}

/// A sign is significant if it is this many standard errors from zero.
constexpr double BEYOND_DOUBT = 5.0;

/// Fig. 3 and Fig. 4 of the paper: single disks move right on a level base, left at theta = 0.209.
TEST(Current, isTurnedByTheInclinationThatIsCommanded)
{
  SieveClient sieve("/sieve");
  ASSERT_TRUE(sieve.connect());
  const ParticleFrame start = sieve.particles.frames.back();
  ASSERT_GE(start.disks.size(), 500u);
  sieve.stepAndSee(3.0);
  const Current level = currentBetween(start, sieve.particles.frames.back());
  EXPECT_GT(level.mean, BEYOND_DOUBT * level.stderr_);

  sieve.publish("inclination", 0.209);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == 0.209; }));
  sieve.stepAndSee(3.0);
  ASSERT_EQ(sieve.base.frames.back().base.inclination, 0.209);
  const ParticleFrame inclined = sieve.particles.frames.back();
  sieve.stepAndSee(3.0);
  const Current uphill = currentBetween(inclined, sieve.particles.frames.back());
  EXPECT_LT(uphill.mean, -BEYOND_DOUBT * uphill.stderr_);
}

/// Below A (2 pi f)^2 = g no disk is thrown up, and the current vanishes.
TEST(Current, endsWhereTheFrequencyIsCommandedTooLow)
{
  SieveClient sieve("/sieve");
  ASSERT_TRUE(sieve.connect());
  ASSERT_TRUE(sieve.reset().success);
  sieve.stepAndSee(1.0);
  const ParticleFrame shaken = sieve.particles.frames.back();
  sieve.stepAndSee(2.0);
  const Current thrown = currentBetween(shaken, sieve.particles.frames.back());

  sieve.publish("frequency", 5.0);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_frequency == 5.0; }));
  sieve.stepAndSee(3.0);
  ASSERT_EQ(sieve.base.frames.back().base.frequency, 5.0);
  const ParticleFrame calmed = sieve.particles.frames.back();
  sieve.stepAndSee(2.0);
  const Current lying = currentBetween(calmed, sieve.particles.frames.back());
  EXPECT_GT(thrown.mean, BEYOND_DOUBT * thrown.stderr_);
  EXPECT_LT(std::abs(lying.mean), 0.1 * thrown.mean);
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "current_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}

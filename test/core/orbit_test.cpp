#include "model/orbit.h"
#include "ratchet_sieve/core/drive_of_scene.h"

#include <cmath>

#include <gtest/gtest.h>

#include "constants.h"
#include "model/base_motion.h"
#include "scenes.h"

/// A drive with a horizontal part and harmonics.
namespace ratchet_sieve
{
namespace
{

/// D with the C library's sine, for `scale` = A over the scene's A.
Eigen::Vector2d placeByHand(const BaseDefinition& base, double phase, double scale)
{
  Eigen::Vector2d place(base.horizontal_amplitude * std::sin(phase + base.horizontal_phase),
                        base.amplitude * std::sin(phase));
  for (const HarmonicDefinition& harmonic : base.harmonics)
  {
    const double turned = harmonic.multiple * phase;
    place += Eigen::Vector2d(harmonic.horizontal_amplitude * std::sin(turned + harmonic.horizontal_phase),
                             harmonic.amplitude * std::sin(turned + harmonic.phase));
  }
  return scale * place;
}

/// Along the axes of the world or of an inclined base.
BaseDefinition inclinedOrbit(DriveFrame frame)
{
  BaseDefinition base = test::onAnOrbit(test::mixture(1)).base;
  base.inclination = 0.4;
  base.drive_frame = frame;
  return base;
}

TEST(Orbit, IsTheSumOfItsSines)
{
  BaseDefinition base = test::onAnOrbit(test::mixture(1)).base;
  base.phase = 0.3;
  const BaseMotion motion(base);
  for (const double time : {0.0, 0.013, 0.7})
  {
    const double phase = base.phase + 2.0 * PI * base.frequency * time;
    EXPECT_LT((motion.at(time).displacement - placeByHand(base, phase, 1.0)).norm(), 1e-15);
    const DriveState state = motion.state(time);
    EXPECT_EQ(state.horizontal_displacement, motion.at(time).displacement.x());
    EXPECT_EQ(state.horizontal_velocity, motion.at(time).velocity.x());
    EXPECT_EQ(state.displacement, motion.at(time).displacement.y());
  }
}

/// Whole turns in the phases cost no precision.
TEST(Orbit, OfManyTurnsIsTheSame)
{
  BaseDefinition base = test::onAnOrbit(test::mixture(1)).base;
  base.horizontal_phase = 0.25 * PI;
  BaseDefinition turned = base;
  turned.horizontal_phase = 0.25 * PI * (1.0 + 8.0 * 0x1p17);
  const double step = 1e-7;
  for (int i = 0; i < 100; ++i)
  {
    const double time = i * step;
    const double off =
        BaseMotion(base).at(time).displacement.x() - BaseMotion(turned).at(time).displacement.x();
    const double at_start =
        BaseMotion(base).at(0.0).displacement.x() - BaseMotion(turned).at(0.0).displacement.x();
    EXPECT_NEAR(off, at_start, 1e-15);
  }
}

/// Velocity and acceleration compared with finite differences, also on ramps.
TEST(Orbit, MovesAtItsVelocityWithinItsBounds)
{
  for (const DriveFrame frame : {DriveFrame::WORLD, DriveFrame::BASE})
    for (const bool ramps : {false, true})
    {
      BaseMotion motion(inclinedOrbit(frame));
      if (ramps)
      {
        motion.setSlewRates({1.0, 10.0, 0.002}, 0.0);
        motion.command(Quantity::INCLINATION, 1.4, 0.0);
        motion.command(Quantity::AMPLITUDE, 0.004, 0.0);
        motion.command(Quantity::FREQUENCY, 60.0, 0.0);
        ASSERT_GT(*motion.nextChange(), 0.9);
      }
      const double step = 1e-7;
      for (int i = 1; i < 2000; ++i)
      {
        const double t = i * 4.3e-4;
        const FrameOfBase before = motion.at(t - step), now = motion.at(t), after = motion.at(t + step);
        ASSERT_LT((now.velocity - (after.displacement - before.displacement) / (2.0 * step)).norm(), 1e-6);
        const Eigen::Vector2d acceleration = (after.velocity - before.velocity) / (2.0 * step);
        ASSERT_TRUE((acceleration.cwiseAbs().array() <= motion.accelerationBound().array() + 1e-6).all());
        ASSERT_TRUE((now.displacement.cwiseAbs().array() <= motion.displacementBound().array()).all());
        ASSERT_LE(now.velocity.norm(), motion.speedBound());
      }
    }
}

TEST(Orbit, IsScaledWithTheAmplitude)
{
  const BaseDefinition base = test::onAnOrbit(test::mixture(1)).base;
  BaseMotion motion(base);
  motion.command(Quantity::AMPLITUDE, 0.001, 0.0);
  motion.beginSegment(*motion.nextChange());
  ASSERT_FALSE(motion.nextChange());
  const BaseMotion half(withAmplitude(base, 0.001));
  for (const double time : {0.51, 0.53, 1.7})
    EXPECT_LT((motion.at(time).displacement - half.at(time).displacement).norm(), 1e-16) << time;
  motion.command(Quantity::AMPLITUDE, 0.0, 2.0);
  motion.beginSegment(*motion.nextChange());
  EXPECT_TRUE(motion.at(3.1).displacement.isZero(0.0));
  EXPECT_FALSE(motion.swings());
}

TEST(Orbit, WithoutAnAmplitudeOfTheSceneStandsByItself)
{
  BaseDefinition base = test::onAnOrbit(test::mixture(1)).base;
  base.amplitude = 0.0;
  BaseMotion motion(base);
  EXPECT_TRUE(motion.swings());
  motion.command(Quantity::AMPLITUDE, 0.001, 0.0);
  motion.beginSegment(*motion.nextChange());
  const double time = 0.73;
  const double phase = 2.0 * PI * base.frequency * time;
  const Eigen::Vector2d expected =
      placeByHand(base, phase, 1.0) + Eigen::Vector2d(0.0, 0.001 * std::sin(phase));
  EXPECT_LT((motion.at(time).displacement - expected).norm(), 1e-15);
}

}  // namespace
}  // namespace ratchet_sieve

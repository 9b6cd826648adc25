#include "model/sawtooth.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{

TEST(Sawtooth, NormalsPointOutOfTheBase)
{
  const Sawtooth sawtooth(BaseDefinition(), Boundary::PERIODIC);
  // a w = 6 mm, h = 6 mm: the left slope rises at 45 degrees.
  EXPECT_NEAR(sawtooth.left().normal.x(), -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(sawtooth.left().normal.y(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(sawtooth.right().normal.x(), 6.0 / std::hypot(6.0, 14.0), 1e-15);
  EXPECT_NEAR(sawtooth.right().normal.y(), 14.0 / std::hypot(6.0, 14.0), 1e-15);
  // The ratio of the slopes' lengths, which the paper compares with the ratio of contacts.
  EXPECT_NEAR(sawtooth.left().length / sawtooth.right().length, 0.557, 5e-4);
}

TEST(Sawtooth, VerticalFacesFaceOutwards)
{
  BaseDefinition base;
  base.asymmetry = 0.0;
  const Sawtooth rising(base, Boundary::PERIODIC);
  EXPECT_EQ(rising.left().normal.x(), -1.0);
  EXPECT_EQ(rising.left().normal.y(), 0.0);
  base.asymmetry = 1.0;
  const Sawtooth falling(base, Boundary::PERIODIC);
  EXPECT_EQ(falling.right().normal.x(), 1.0);
  EXPECT_EQ(falling.right().normal.y(), 0.0);
}

TEST(Sawtooth, HeightAboveIsTheDistanceToTheNearestPointOfTheOutline)
{
  for (const double asymmetry : {0.0, 0.3, 1.0})
  {
    BaseDefinition base;
    base.asymmetry = asymmetry;
    base.tooth_height = 0.015;
    const Sawtooth sawtooth(base, Boundary::PERIODIC);
    for (int i = 0; i < 40; ++i)
    {
      const double s = 0.1 + i * 0.00071;
      const double n = 0.016 + 0.0003 * i;
      double nearest = 1.0;
      for (int k = 0; k <= 40000; ++k)  // points every 2.5 um along 0.04 m of outline on either side
      {
        const double along = k / 40000.0 * 6.0;
        const int tooth = static_cast<int>(along);
        const double share = along - tooth;
        const double local =
            share < 0.5 ? 2.0 * share * asymmetry : asymmetry + (2.0 * share - 1.0) * (1.0 - asymmetry);
        const double height = share < 0.5 ? 2.0 * share * 0.015 : (2.0 - 2.0 * share) * 0.015;
        nearest = std::min(nearest, std::hypot(s - (0.06 + (tooth + local) * 0.02), n - height));
      }
      EXPECT_NEAR(sawtooth.heightAbove(s, n), nearest, 3e-6);
    }
  }
}

TEST(Sawtooth, BelowTheSurfaceHeightIsNegative)
{
  const Sawtooth sawtooth(BaseDefinition(), Boundary::PERIODIC);
  EXPECT_LT(sawtooth.heightAbove(0.006, 0.005), 0.0);
  EXPECT_GT(sawtooth.heightAbove(0.006, 0.007), 0.0);
  EXPECT_LT(sawtooth.heightAbove(0.0, -0.001), 0.0);
}

TEST(Sawtooth, OnlyAPeriodicBaseGoesOnBeyondItsEnds)
{
  const Sawtooth periodic(BaseDefinition(), Boundary::PERIODIC);
  const Sawtooth open(BaseDefinition(), Boundary::OPEN);
  EXPECT_TRUE(periodic.hasTooth(-1));
  EXPECT_EQ(periodic.toothAt(-0.001), -1);
  EXPECT_FALSE(open.hasTooth(-1));
  EXPECT_FALSE(open.hasTooth(20));
  EXPECT_EQ(open.toothAt(0.5), 19);
}

}  // namespace
}  // namespace ratchet_sieve

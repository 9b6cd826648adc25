#include "model/base_shape.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{

TEST(BaseShape, NormalsPointOutOfTheBase)
{
  const BaseShape shape(BaseDefinition(), Boundary::PERIODIC);
  // a w = 6 mm, h = 6 mm: the left slope rises at 45 degrees.
  EXPECT_NEAR(shape.faces()[0].normal.x(), -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(shape.faces()[0].normal.y(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(shape.faces()[1].normal.x(), 6.0 / std::hypot(6.0, 14.0), 1e-15);
  EXPECT_NEAR(shape.faces()[1].normal.y(), 14.0 / std::hypot(6.0, 14.0), 1e-15);
  // The ratio of the slopes' lengths, which the paper compares with the ratio of contacts.
  EXPECT_NEAR(shape.faces()[0].length / shape.faces()[1].length, 0.557, 5e-4);
}

TEST(BaseShape, VerticalFacesFaceOutwards)
{
  BaseDefinition base;
  base.asymmetry = 0.0;
  const BaseShape rising(base, Boundary::PERIODIC);
  EXPECT_EQ(rising.faces()[0].normal.x(), -1.0);
  EXPECT_EQ(rising.faces()[0].normal.y(), 0.0);
  base.asymmetry = 1.0;
  const BaseShape falling(base, Boundary::PERIODIC);
  EXPECT_EQ(falling.faces()[1].normal.x(), 1.0);
  EXPECT_EQ(falling.faces()[1].normal.y(), 0.0);
}

TEST(BaseShape, HeightAboveIsTheDistanceToTheNearestPointOfTheOutline)
{
  for (const double asymmetry : {0.0, 0.3, 1.0})
  {
    BaseDefinition base;
    base.asymmetry = asymmetry;
    base.tooth_height = 0.015;
    const BaseShape shape(base, Boundary::PERIODIC);
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
      EXPECT_NEAR(shape.heightAbove(s, n), nearest, 3e-6);
    }
  }
}

TEST(BaseShape, BelowTheSurfaceHeightIsNegative)
{
  const BaseShape shape(BaseDefinition(), Boundary::PERIODIC);
  EXPECT_LT(shape.heightAbove(0.006, 0.005), 0.0);
  EXPECT_GT(shape.heightAbove(0.006, 0.007), 0.0);
  EXPECT_LT(shape.heightAbove(0.0, -0.001), 0.0);
}

TEST(BaseShape, OnlyAPeriodicBaseGoesOnBeyondItsEnds)
{
  const BaseShape periodic(BaseDefinition(), Boundary::PERIODIC);
  const BaseShape open(BaseDefinition(), Boundary::OPEN);
  EXPECT_TRUE(periodic.hasTooth(-1));
  EXPECT_EQ(periodic.toothAt(-0.001), -1);
  EXPECT_FALSE(open.hasTooth(-1));
  EXPECT_FALSE(open.hasTooth(20));
  EXPECT_EQ(open.toothAt(0.5), 19);
}

}  // namespace
}  // namespace ratchet_sieve

#include "model/base_shape.h"

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

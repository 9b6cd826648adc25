#include "ratchet_sieve/ros/frame_names.h"

#include <gtest/gtest.h>

#include "ratchet_sieve/ros/transform_publisher.h"

namespace ratchet_sieve
{
namespace
{
TEST(FrameNames, areThePinnedOnesForTheSieveAlone)
{
  const FrameNames names = frameNames(defaultFramePrefix("/sieve"), false);
  EXPECT_EQ(names.world, "world");
  EXPECT_EQ(names.mount, "sieve_mount");
  EXPECT_EQ(names.base, "sieve_base");
}

TEST(FrameNames, haveTheNameOfEveryOtherSieve)
{
  EXPECT_EQ(defaultFramePrefix("/s1"), "s1");
  EXPECT_EQ(defaultFramePrefix("/plant1/sieve"), "plant1/sieve");
  EXPECT_EQ(defaultFramePrefix("/"), "");
  const FrameNames names = frameNames("plant1/sieve", true);
  EXPECT_EQ(names.world, "plant1/sieve/sieve_world");
  EXPECT_EQ(names.mount, "plant1/sieve/sieve_mount");
  EXPECT_EQ(names.base, "plant1/sieve/sieve_base");
}

TEST(FrameNames, refuseAPrefixThatNoFrameCanHave)
{
  for (const char* good : {"", "s1", "plant1/sieve", "S_2"})
    EXPECT_EQ(framePrefixError(good), "") << good;
  for (const char* bad : {"/s1", "s1/", "1s", "~s1", "s 1", "s-1"})
    EXPECT_NE(framePrefixError(bad), "") << bad;
}

TEST(FrameNames, standInTheTransforms)
{
  const FrameNames names = frameNames("s1", true);
  const auto moving = baseTransforms(BaseFrame(), names);
  ASSERT_EQ(moving.size(), 2u);
  EXPECT_EQ(moving[0].header.frame_id, "s1/sieve_world");
  EXPECT_EQ(moving[0].child_frame_id, "s1/sieve_mount");
  EXPECT_EQ(moving[1].header.frame_id, "s1/sieve_mount");
  EXPECT_EQ(moving[1].child_frame_id, "s1/sieve_base");
  const auto own = ownWorldTransform({1.0, 2.0, -3.0}, names);
  EXPECT_EQ(own.header.frame_id, "world");
  EXPECT_EQ(own.child_frame_id, "s1/sieve_world");
  EXPECT_EQ(own.transform.translation.x, 1.0);
  EXPECT_EQ(own.transform.translation.y, 2.0);
  EXPECT_EQ(own.transform.translation.z, -3.0);
}
}  // namespace
}  // namespace ratchet_sieve

#include "ratchet_sieve/recording/wall_warnings.h"

#include <gtest/gtest.h>

#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// A walled base 2 m wide: it may turn at 0.858 rad/s.
SceneDefinition wideScene()
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 100;
  scene.boundary = Boundary::WALLED;
  scene.base.wall_height = 0.5;
  return scene;
}

TEST(WallWarnings, NameTheRateTheWidthAndTheLimit)
{
  EXPECT_EQ(
      fastTurnText(wideScene(), 3.0),
      "limits/inclination/slew_rate = 3 rad/s: a walled base 2 m wide that turns faster than 0.858 rad/s may "
      "throw its disks over the walls, 0.5 m high");
}

TEST(WallWarnings, AreOfWalledBasesThatTurnTooFastAlone)
{
  EXPECT_EQ(fastTurnText(wideScene(), 0.857), "");
  SceneDefinition scene = wideScene();
  scene.base.teeth = 1;
  EXPECT_EQ(fastTurnText(scene, 3.0), "");
  for (const Boundary boundary : {Boundary::OPEN, Boundary::PERIODIC})
  {
    scene = wideScene();
    scene.boundary = boundary;
    EXPECT_EQ(fastTurnText(scene, 3.0), "");
  }
}
}  // namespace
}  // namespace ratchet_sieve

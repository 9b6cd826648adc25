#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "runs.h"
#include "scenes.h"

/// When a disk on a turning periodic base is wrapped: when its centre reaches an end of the base, with the
/// velocity of the image, and at no other time (legal_scenes_test.cpp). See
/// docs/development/architecture.md, "The seam of a periodic base".
namespace ratchet_sieve
{
namespace
{
enum class Loop
{
  PAIRS,
  SINGLES,
  STEPS
};

constexpr double STEP = 0.0001;  ///< [s]

SceneDefinition advancedBy(Loop loop, SceneDefinition scene)
{
  scene.contact.pair_collisions = loop != Loop::SINGLES;
  scene.accuracy.method = loop == Loop::STEPS ? Method::STEPS : Method::EVENTS;
  scene.accuracy.step = STEP;
  return scene;
}

/// A disk high over a base that turns at a constant rate from time 0 on, computed from the rule alone.
class FreeMotion
{
public:
  FreeMotion(const SceneDefinition& scene, double rate)
      : scene_(scene),
        rate_(rate),
        x_(scene.initial[0].x),
        y_(scene.initial[0].y),
        vx_(scene.initial[0].vx),
        vy_(scene.initial[0].vy)
  {
  }

  void advanceTo(double end)
  {
    constexpr double LOOK = 1e-4;
    while (time_ < end)
    {
      double next = std::min(time_ + LOOK, end);
      const int side = beyond(next);
      if (side != 0)
      {
        double inside = time_;
        while (next - inside > 1e-15)
          (beyond(0.5 * (inside + next)) == 0 ? inside : next) = 0.5 * (inside + next);
      }
      fly(next);
      if (side != 0)
        becomeImage(-side);
    }
  }

  double x() const { return x_; }
  double y() const { return y_; }
  double vx() const { return vx_; }
  double vy() const { return vy_; }
  int crossings() const { return crossings_; }

private:
  /// The end beyond which the disk is at `time`: -1, 1, or 0 for neither.
  int beyond(double time) const
  {
    const double t = time - time_;
    const double theta = rate_ * time;
    const double lift = scene_.base.amplitude * std::sin(2.0 * M_PI * scene_.base.frequency * time);
    const double s = std::cos(theta) * (x_ + vx_ * t) +
                     std::sin(theta) * (y_ + (vy_ - 0.5 * scene_.gravity * t) * t - lift);
    return s < 0.0 ? -1 : s > scene_.base.width() ? 1 : 0;
  }

  void fly(double time)
  {
    const double t = time - time_;
    x_ += vx_ * t;
    y_ += (vy_ - 0.5 * scene_.gravity * t) * t;
    vy_ -= scene_.gravity * t;
    time_ = time;
  }

  void becomeImage(int widths)
  {
    const double theta = rate_ * time_;
    const double way = widths * scene_.base.width();
    x_ += way * std::cos(theta);
    y_ += way * std::sin(theta);
    vx_ -= way * rate_ * std::sin(theta);
    vy_ += way * rate_ * std::cos(theta);
    ++crossings_;
  }

  SceneDefinition scene_;
  double rate_;
  double x_, y_, vx_, vy_;
  double time_ = 0.0;
  int crossings_ = 0;
};

TEST(TurningSeam, LiesAtTheEndsOfTheBaseInAllLoops)
{
  constexpr double RATE = 2.0;
  for (const Loop loop : {Loop::PAIRS, Loop::SINGLES, Loop::STEPS})
    for (const int teeth : {1, 2, 7})
      for (const double speed : {-3.0, 0.4, 2.0})
      {
        SCOPED_TRACE(std::to_string(static_cast<int>(loop)) + ": " + std::to_string(teeth) + " teeth, " +
                     std::to_string(speed) + " m/s");
        SceneDefinition scene = advancedBy(loop, test::mixture(0));
        scene.base.teeth = teeth;
        scene.initial = {{0, 0.3 * scene.base.width(), 2.0, speed, 0.0, 0.0}};
        Simulation simulation(scene);
        simulation.setSlewRates({RATE, 10.0, 0.002});
        simulation.command(Quantity::INCLINATION, 1.0);
        FreeMotion expected(scene, RATE);
        for (const double time : {0.1, 0.2, 0.3, 0.4})
        {
          simulation.advanceTo(time);
          expected.advanceTo(time);
          const DiskState disk = simulation.disks().at(0);
          EXPECT_NEAR(disk.x, expected.x(), 1e-10);
          EXPECT_NEAR(disk.y, expected.y(), 1e-10);
          EXPECT_NEAR(disk.vx, expected.vx(), 1e-10);
          EXPECT_NEAR(disk.vy, expected.vy(), 1e-10);
        }
        EXPECT_GT(expected.crossings(), 1);
        EXPECT_EQ(simulation.collisions().total(), 0u);
      }
}

/// The ends of the base swing by its width, over cells that stand: images then differ anywhere in the cells.
TEST(TurningSeam, NoContactIsMissedWhereTheBaseSwingsByItsWidth)
{
  SceneDefinition scene = test::mixture(8);
  scene.base.teeth = 1;
  scene.base.tooth_height = 0.001;
  scene.base.inclination = 1.2;
  scene.base.amplitude = scene.base.width();
  scene.base.frequency = 5.0;
  for (SpeciesDefinition& species : scene.species)
    species.radius = 0.001;
  for (scene.seed = 1; scene.seed <= 20; ++scene.seed)
  {
    Simulation simulation(scene);
    simulation.setSlewRates({0.5, 20.0, 0.01});
    simulation.command(Quantity::INCLINATION, -0.3);
    for (int k = 1; k <= 20; ++k)
    {
      simulation.advanceTo(0.05 * k);
      test::expectNoOverlap(simulation);
    }
  }
}

}  // namespace
}  // namespace ratchet_sieve

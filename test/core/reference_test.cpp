// The loops with queues, cells and lazy search against the loop that tests everything, contact by contact.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "profiles.h"
#include "ratchet_sieve/core/simulation.h"
#include "reference_loop.h"
#include "scenes.h"
#include "state/placement.h"

namespace ratchet_sieve::reference  // tests are joined in one source
{
namespace
{

struct ReferenceCase
{
  std::string name;
  SceneDefinition scene;
  std::size_t contacts = 200;  ///< that must be the same
  double turn_rate = 0.0;      ///< of the base; 0: it stays [rad/s]
  int images = 1;              ///< of a disk on a ring, on either side, that the reference tests
  double turn_to = 0.3;        ///< [rad]
};

void PrintTo(const ReferenceCase& one, std::ostream* out)
{
  *out << one.name;
}

SceneDefinition on(int teeth, SceneDefinition scene, Boundary boundary = Boundary::PERIODIC)
{
  scene.base.teeth = teeth;
  scene.boundary = boundary;
  return scene;
}

SceneDefinition inclined(double inclination, SceneDefinition scene)
{
  scene.base.inclination = inclination;
  return scene;
}

SceneDefinition inFrame(DriveFrame frame, SceneDefinition scene)
{
  scene.base.drive_frame = frame;
  return scene;
}

/// One disk 20 times as large as the others, out of a table.
SceneDefinition wideTable()
{
  SceneDefinition scene = on(4, test::mixture(30));
  scene.species[0].size = {SizeDistribution::TABLE, 0.0, 3.0, {0.0005, 0.01}, {30.0, 1.0}, SizeShare::NUMBER};
  scene.seed = 2;
  return scene;
}

/// Two disks of 15 mm on a ring of 20 mm: each collides with the other on both sides.
SceneDefinition ringOfOneCell()
{
  SceneDefinition scene = on(1, test::mixture(1));
  scene.species[0].radius = 0.0075;
  scene.species[1].radius = 0.0060;
  return scene;
}

/// Nested cells: 60 of Fig. 3's disks, and others so many times as large.
SceneDefinition nested(const std::vector<double>& ratios, Boundary boundary = Boundary::PERIODIC)
{
  SceneDefinition scene;
  scene.species = {test::disksOfSize(1.0, 60)};
  for (const double ratio : ratios)
    scene.species.push_back(test::disksOfSize(ratio, 1));
  scene.pour.drop_height = 0.002;
  scene.pour.speed = 0.3;
  return on(3, scene, boundary);
}

/// Pairs that meet across the ends of the base while it turns and their images rise by several rows of cells,
/// the faster the higher they are; and others far from the ends, so that cells are as small as in a layer.
SceneDefinition meetingsAcrossTheEnds(double rate, double height)
{
  SceneDefinition scene = test::mixture(0);
  const double width = scene.base.width();
  for (int k = 0; k < 12; ++k)
  {
    // The one at the left has an image that keeps the height of the one at the right, and comes towards it.
    const double y = height + 0.0045 * k;
    scene.initial.push_back({0, width - 0.004 - 0.001 * k, y, 0.2 + 0.01 * k, 0.0, 0.0});
    scene.initial.push_back({1, 0.006 + 0.0013 * k, y + 0.001, -0.25, -rate * width, 0.0});
  }
  for (int k = 0; k < 300; ++k)
    scene.initial.push_back({1, 0.05 + 0.0045 * (k % 60), 0.1 + 0.0045 * (k / 60), 0.0, 0.0, 0.0});
  return scene;
}

SceneDefinition onCastle(SceneDefinition scene)
{
  scene.base.profile = test::castle();
  return scene;
}

/// With steps so short that hardly a contact is missed.
SceneDefinition bySteps(SceneDefinition scene)
{
  scene.accuracy.method = Method::STEPS;
  scene.accuracy.step = 1e-5;
  return scene;
}

std::vector<ReferenceCase> referenceCases()
{
  const Boundary open = Boundary::OPEN, walled = Boundary::WALLED;
  const DriveFrame base = DriveFrame::BASE, world = DriveFrame::WORLD;
  const std::vector<double> many = {0.3, 0.3, 0.5, 2.1, 3.0, 4.5, 6.0};
  std::vector<ReferenceCase> all = {
      {"periodic", on(3, test::mixture(30)), 300},
      {"inclined", inclined(0.2, on(2, test::mixture(25)))},
      {"open", on(4, test::openMixture(25), open)},
      {"walled", on(2, test::mixture(25), walled)},
      {"sizes", on(3, test::withSizes(test::mixture(30))), 300},
      {"sizes, walled", on(3, test::withSizes(test::mixture(30)), walled)},
      {"sizes, open", on(6, test::withSizes(test::openMixture(25)), open)},
      {"wide table", wideTable()},
      {"ring of one cell", ringOfOneCell(), 8, 0.0, 3},
      {"nested, many sizes", nested(many)},
      {"nested, many sizes, walled", nested(many, walled)},
      {"nested, by steps", bySteps(nested({2.5, 8.0})), 80},
      {"nested, by steps, open", bySteps(nested({2.5, 8.0}, open)), 80},
  };
  for (const Boundary boundary : {Boundary::PERIODIC, open, walled})
  {
    const std::string at = ", boundary " + std::to_string(static_cast<int>(boundary));
    for (const double ratio : {4.0, 6.0, 10.0})
      all.push_back({"nested 1:" + std::to_string(ratio) + at, nested({ratio}, boundary)});
    for (const DriveFrame frame : {world, base})
    {
      const std::string how = at + (frame == base ? ", frame of the base" : "");
      all.push_back(
          {"nested, orbit, profile" + how,
           inFrame(frame, inclined(0.2, onCastle(test::onAnOrbit(nested({0.4, 2.5, 8.0}, boundary))))), 150});
      all.push_back({"orbit" + how,
                     inFrame(frame, inclined(0.1, test::onAnOrbit(on(3, test::mixture(6), boundary)))), 20});
    }
  }
  for (const double rate : {0.3, 2.0})
    for (const Boundary boundary : {Boundary::PERIODIC, open})
      all.push_back({"nested, turning", nested({2.5, 7.0}, boundary), 200, rate});
  for (const double rate : {0.1, 1.0, 5.0})
    all.push_back({"turning", on(2, test::mixture(4)), 40, rate, 3});
  for (const double rate : {-0.5, 0.1})
    for (const double height : {0.012, 1.0})
      all.push_back({"meetings across the ends", meetingsAcrossTheEnds(rate, height), 6, std::abs(rate), 1,
                     std::copysign(0.3, rate)});
  return all;
}

class Reference : public testing::TestWithParam<ReferenceCase>
{
};

std::vector<CollisionRecord> fastCollisions(const ReferenceCase& one, double end)
{
  std::vector<CollisionRecord> records;
  Simulation simulation(one.scene);
  simulation.observeCollisions([&](const CollisionRecord& record) { records.push_back(record); });
  if (one.turn_rate > 0.0)
  {
    simulation.setSlewRates({one.turn_rate, 10.0, 0.002});
    simulation.command(Quantity::INCLINATION, one.turn_to);
  }
  simulation.advanceTo(end);
  return records;
}

std::vector<CollisionRecord> slowCollisions(const ReferenceCase& one, double end)
{
  std::vector<CollisionRecord> records;
  test::Bench bench(one.scene);
  bench.state.observers().observeCollisions([&](const CollisionRecord& record)
                                            { records.push_back(record); });
  placeInitialDisks(bench.state, 0.0);
  Random random(one.scene.seed);
  pourDisks(bench.state, pourOrder(one.scene.species, random), Stretch(), 0.0, random);
  test::ReferenceLoop reference(bench, one.images);
  if (one.turn_rate > 0.0)
    test::turn(bench.state, one.turn_rate, one.turn_to, 0.0);
  reference.advanceTo(end);
  return records;
}

/// The two run the same physics with different rounding, and the system is chaotic: an error of 1e-16 grows
/// about tenfold with each collision of a disk. Over the first ten or so collisions of every disk they must
/// agree.
TEST_P(Reference, MeetsTheSameContacts)
{
  constexpr double TOLERANCE = 1e-7;  // [s]
  const std::size_t contacts = GetParam().contacts;
  // As long as there are enough of them.
  double end = 0.04;
  while (fastCollisions(GetParam(), end).size() <= contacts)
    end *= 1.2;
  const std::vector<CollisionRecord> fast = fastCollisions(GetParam(), end);
  const std::vector<CollisionRecord> slow = slowCollisions(GetParam(), fast[contacts - 1].time + TOLERANCE);
  ASSERT_GE(slow.size(), contacts);
  const auto disks = [](const CollisionRecord& r)
  { return std::make_pair(std::min(r.i, r.j.value_or(r.i)), std::max(r.i, r.j.value_or(r.i))); };
  for (std::size_t k = 0; k < contacts; ++k)
  {
    ASSERT_NEAR(fast[k].time, slow[k].time, TOLERANCE) << "collision " << k;
    ASSERT_EQ(fast[k].kind, slow[k].kind) << "collision " << k;
    ASSERT_EQ(disks(fast[k]), disks(slow[k])) << "collision " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Reference, testing::ValuesIn(referenceCases()));

}  // namespace
}  // namespace ratchet_sieve::reference

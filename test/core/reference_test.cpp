// The loops with queues, cells and lazy search against the loop that tests everything, contact by contact.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "profiles.h"
#include "ratchet_sieve/core/simulation.h"
#include "reference_loop.h"
#include "runs.h"
#include "scenes.h"

namespace ratchet_sieve::reference  // tests are joined in one source
{
namespace
{

struct ReferenceCase
{
  std::string name;
  SceneDefinition scene;
  std::size_t contacts = 200;  ///< that must be the same
  test::Turn turn = {};
  int images = 1;  ///< of a disk on a ring, on either side, that the reference tests
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

std::vector<ReferenceCase> referenceCases()
{
  constexpr double SHORT = 1e-5;  ///< a step in which hardly a contact is missed [s]
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
      {"ring of one cell", ringOfOneCell(), 8, {}, 3},
      {"nested, many sizes", nested(many)},
      {"nested, many sizes, walled", nested(many, walled)},
      {"ring of one cell, by steps", test::bySteps(ringOfOneCell(), SHORT), 8, {}, 3},
      {"nested, by steps", test::bySteps(nested({2.5, 8.0}), SHORT), 80},
      {"nested, by steps, open", test::bySteps(nested({2.5, 8.0}, open), SHORT), 80},
  };
  for (const Boundary boundary : {Boundary::PERIODIC, open, walled})
  {
    const std::string at = ", boundary " + std::to_string(static_cast<int>(boundary));
    for (const double ratio : {4.0, 6.0, 10.0})
      all.push_back({"nested 1:" + std::to_string(ratio) + at, nested({ratio}, boundary), 180});
    for (const DriveFrame frame : {world, base})
    {
      const std::string how = at + (frame == base ? ", frame of the base" : "");
      all.push_back(
          {"nested, orbit, profile" + how,
           inFrame(frame, inclined(0.2, test::onProfile(test::onAnOrbit(nested({0.4, 2.5, 8.0}, boundary)),
                                                        test::castle()))),
           150});
      all.push_back({"orbit" + how,
                     inFrame(frame, inclined(0.1, test::onAnOrbit(on(3, test::mixture(6), boundary)))), 20});
    }
  }
  for (const double rate : {0.3, 2.0})
    for (const Boundary boundary : {Boundary::PERIODIC, open})
      all.push_back({"nested, turning", nested({2.5, 7.0}, boundary), 200, {rate, 0.3}});
  for (const double rate : {0.1, 1.0, 5.0})
    all.push_back({"turning", on(2, test::mixture(4)), 40, {rate, 0.3}, 3});
  for (const double rate : {-0.5, 0.1})
    for (const double height : {0.012, 1.0})
      all.push_back({"meetings across the ends",
                     meetingsAcrossTheEnds(rate, height),
                     6,
                     {std::abs(rate), std::copysign(0.3, rate)}});
  return all;
}

class Reference : public testing::TestWithParam<ReferenceCase>
{
};

std::vector<CollisionRecord> fastCollisions(const ReferenceCase& one, double end)
{
  Simulation simulation(one.scene);
  if (one.turn.rate > 0.0)
  {
    simulation.setSlewRates(one.turn.slewRates());
    simulation.command(Quantity::INCLINATION, one.turn.inclination);
  }
  return test::collisionsUntil(simulation, end);
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
  std::vector<CollisionRecord> fast = fastCollisions(GetParam(), end), slow;
  test::runReference(
      GetParam().scene, fast[contacts - 1].time + TOLERANCE,
      [&](const CollisionRecord& record) { slow.push_back(record); }, GetParam().turn, GetParam().images);
  ASSERT_GE(slow.size(), contacts);
  fast.resize(contacts);
  slow.resize(contacts);
  test::expectSameContacts(fast, slow, TOLERANCE);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Reference, testing::ValuesIn(referenceCases()));

}  // namespace
}  // namespace ratchet_sieve::reference

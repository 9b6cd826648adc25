// Scenes that are legal and cannot be meant: each is said, in one line with its figure, and nothing else is.
#include "ratchet_sieve/scene/implausibilities.h"

#include <cmath>

#include <gtest/gtest.h>

#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

std::string configFile(const std::string& name)
{
  return std::string(CONFIG_DIRECTORY) + "/" + name;
}

/// The mixture of Fig. 8 with a mistake in it.
struct Mistake
{
  std::vector<std::string> overrides;
  std::vector<std::string> lines;
};

const std::vector<Mistake>& mistakes()
{
  static const std::vector<Mistake> ALL = {
      {{"species.0.radius=1", "species.1.radius=2"},
       {"no disk at all: every species.N.count is 0, initial is empty and feed.rate is 0; a density gives a "
        "disk where it times the base's width, 0.4 m, comes to the disks' diameters, the largest 4 m",
        "species.0.radius = 1 m: a disk's diameter, 2 m, is larger than the base's width, 0.4 m; meant 0.001 "
        "m?",
        "species.1.radius = 2 m: a disk's diameter, 4 m, is larger than the base's width, 0.4 m; meant 0.002 "
        "m?"}},
      {{"species.1.radius=0.02"},
       {"species.1.radius = 0.02 m: a disk's diameter, 0.04 m, is larger than a tooth's valley, "
        "base.tooth_width = 0.02 m"}},
      {{"accuracy.step=0.001"}, {"accuracy.step = 0.001 s: of no effect, for accuracy.method is events"}},
      {{"accuracy.method=steps", "contact.pair_collisions=false"},
       {"accuracy.method = steps: of no effect, for disks that do not see each other are advanced from event "
        "to "
        "event"}},
      {{"accuracy.method=steps", "accuracy.step=0.05"},
       {"accuracy.step = 0.05 s: within which a disk moves by up to 0.06293 m, 31.46 of the smallest "
        "diameters: many "
        "contacts are missed; meant 5e-05 s?"}},
      {{"base.tooth_height=0", "species.1.radius=0.15"},
       {"the counts of all species come to 10 disks: at rest a layer of 1.078 m, 3.592 of the largest "
        "diameters thick, on a base 0.4 m wide; a smaller density, smaller counts or larger radii meant?"}},
      {{"density=0.001"},
       {"no disk at all: every species.N.count is 0, initial is empty and feed.rate is 0; a density gives a "
        "disk where it times the base's width, 0.4 m, comes to the disks' diameters, the largest 0.004 m"}},
      {{"base.amplitude=2"},
       {"base.amplitude = 2 m: 100 times base.tooth_width, and at base.frequency = 23 Hz the base moves at "
        "up to 289 m/s and 41768 m/s^2, 4258 times gravity; meant 0.002 m?"}},
      {{"base.amplitude=0.2"},
       {"base.amplitude = 0.2 m: 10 times base.tooth_width, and at base.frequency = 23 Hz the base moves at "
        "up to 28.9 m/s and 4177 m/s^2, 425.8 times gravity"}},
      {{"base.frequency=1380"},
       {"base.frequency = 1380 Hz: with base.amplitude = 0.002 m the base moves at up to 17.34 m/s and "
        "150365 m/s^2, 15328 times gravity; meant 23 Hz?"}},
      {{"base.frequency=144.5"},
       {"base.frequency = 144.5 Hz: with base.amplitude = 0.002 m the base moves at up to 1.816 m/s and 1649 "
        "m/s^2, 168.1 times gravity; meant 23 Hz?"}},
      {{"base.frequency=0.023"},
       {"base.frequency = 0.023 Hz: with base.amplitude = 0.002 m the base moves at up to 0.000289 m/s and "
        "4.177e-05 m/s^2, 4.258e-06 times gravity, and no disk leaves it; meant 23 Hz?"}},
      {{"base.amplitude=2", "base.frequency=0"},
       {"base.amplitude = 2 m: 100 times base.tooth_width, and at base.frequency = 0 Hz the base moves at up "
        "to 0 m/s and 0 m/s^2, 0 times gravity"}},
      {{"base.inclination=1"}, {"base.inclination = 1 rad: 57.3 degrees; meant 0.01745 rad?"}},
      {{"base.phase=90"}, {"base.phase = 90 rad: 14.32 turns of the drive; meant 1.571 rad?"}},
      {{"base.tooth_width=20", "density=0.01"},
       {"base.tooth_width = 20 m: 5000 times the diameter of the largest disks, 0.004 m; meant 0.02 m?"}},
      {{"base.tooth_height=6"},
       {"base.tooth_height = 6 m: needles, 300 times as high as base.tooth_width = 0.02 m; meant 0.006 m?"}},
      {{"gravity=981"}, {"gravity = 981 m/s^2: 100 times that of the earth; meant 9.81 m/s^2?"}},
      {{"gravity=9810"}, {"gravity = 9810 m/s^2: 1000 times that of the earth; meant 9.81 m/s^2?"}},
      {{"density=393"},
       {"the counts of all species come to 52400 disks: at rest a layer of 1.255 m, 313.7 of the largest "
        "diameters thick, on a base 0.4 m wide; a smaller density, smaller counts or larger radii meant?"}},
      {{"pour.drop_height=20"},
       {"pour.drop_height = 20 m: 1000 times base.tooth_width; disks come down at 19.81 m/s; meant 0.02 m?"}},
      {{"pour.speed=500"},
       {"pour.speed = 500 m/s: 25 times base.tooth_width in a millisecond; meant 0.5 m/s?"}},
      {{"contact.min_rebound_speed=50"},
       {"contact.min_rebound_speed = 50 m/s: faster than fall, pour and drive together make a disk, 1.259 "
        "m/s: every contact throws disks apart; meant 0.05 m/s?"}},
      {{"contact.contact_duration=1"},
       {"contact.contact_duration = 1 s: longer than the machine's time scale, 0.04348 s: hardly any contact "
        "loses energy; meant 0.001 s?"}},
      {{"feed.rate=40000"},
       {"feed.rate = 40000 1/s: raises the layer by 0.9578 m/s, 10.41 disks within the machine's time scale "
        "of 0.04348 s; meant 40 1/s?"}},
      {{"species.0.mass=10"},
       {"species.0.mass = 10 kg: with species.0.radius = 0.001 m a sphere of 2.387e+09 kg/m^3, where osmium "
        "has 22590; meant 0.01 kg?"}},
      {{"duration=100000"}, {"duration = 100000 s: 27.78 hours, 2300000 drive periods; meant 100 s?"}},
  };
  return ALL;
}

TEST(Implausibilities, OfEachMistakeAreItsFigureAndWhatWasMeant)
{
  for (const Mistake& mistake : mistakes())
  {
    SCOPED_TRACE(mistake.overrides.front());
    EXPECT_EQ(loadSceneFile(configFile("paper_fig8.yaml"), mistake.overrides).warnings, mistake.lines);
  }
}

TEST(Implausibilities, OfDisksPlacedByHandAreSaidOfTheFirst)
{
  SceneDefinition scene = loadSceneFile(configFile("paper_fig8.yaml")).definition;
  for (SpeciesDefinition& species : scene.species)
    species.count = 0;
  scene.initial = {
      {0, 0.1, 0.05, 1.0, -1.0, 10.0}, {0, 0.1, 50.0, 300.0, 0.0, 1e6}, {0, 0.2, 50.0, 0.0, 0.0, 0.0}};
  EXPECT_EQ(implausibilities(scene),
            (std::vector<std::string>{
                "initial.1.y = 50 m: 50 m above the base, 2500 times base.tooth_width; meant 0.05 m?",
                "initial.1: a speed of 300 m/s (vx, vy): given in mm/s?",
                "initial.1.spin = 1000000 rad/s: the disk's rim goes at 1000 m/s"}));
  scene.initial.resize(1);
  EXPECT_EQ(implausibilities(scene), std::vector<std::string>());
}

/// As large as a house or as small as a chip: where all lengths are scaled, and times as falls take, nothing
/// is wrong.
TEST(Implausibilities, AreNoneOfAMachineOfAnotherSize)
{
  for (const char* name : {"paper_fig3.yaml", "paper_fig8.yaml", "paper_fig9.yaml", "demo.yaml", "seek.yaml"})
    for (int exponent = -10; exponent <= 10; ++exponent)
    {
      SCOPED_TRACE(std::string(name) + " times 2^" + std::to_string(exponent));
      SceneDefinition scene = loadSceneFile(configFile(name)).definition;
      const double length = std::ldexp(1.0, exponent);
      const double time = std::sqrt(length);
      for (double* value : {&scene.base.tooth_width, &scene.base.tooth_height, &scene.base.amplitude,
                            &scene.pour.drop_height})
        *value *= length;
      for (SpeciesDefinition& species : scene.species)
      {
        species.radius *= length;
        species.mass *= length * length * length;
      }
      scene.base.frequency /= time;
      scene.feed.rate /= time;
      scene.contact.min_rebound_speed *= length / time;
      scene.duration *= time;
      EXPECT_EQ(implausibilities(scene), std::vector<std::string>());
    }
}

}  // namespace
}  // namespace ratchet_sieve

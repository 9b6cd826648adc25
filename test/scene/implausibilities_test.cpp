// Scenes that are legal and cannot be meant: each is said, in one line with its figure, and nothing else is.

#include <cmath>
#include <string>
#include <vector>

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
       {"no disks: every species.N.count is 0, initial is empty and feed has neither a rate nor a disk; a "
        "density, if given, is too small: the base is 0.4 m wide and the largest diameter is 4 m [no-disks]",
        "species.0.radius = 1 m: the largest diameter, 2 m, is larger than the room for a disk, 0.02 m: a "
        "tooth's width, or a flat base's; did you mean 0.001 m? [large-disk]",
        "species.1.radius = 2 m: the largest diameter, 4 m, is larger than the room for a disk, 0.02 m: a "
        "tooth's width, or a flat base's; did you mean 0.002 m? [large-disk]"}},
      {{"species.1.size={distribution: table, radii: [0.001, 0.002, 0.003, 0.004], weights: [0, 20, 65, "
        "100]}"},
       {"species.1.size.weights: they grow to 100, as cumulative shares do; each weight is the share between "
        "its radius and the one before, and these sum to 185 [cumulative-weights]"}},
      {{"species.1.size={distribution: table, radii: [0.001, 0.002, 0.003], weights: [0, 0, 1]}"}, {}},
      {{"feed.from=0.1"}, {"feed.rate = 0 1/s: feed.from and feed.to have no effect [unused-feed]"}},
      {{"feed.to=0.1", "feed.rate=1"}, {}},
      {{"feed.rate=10", "feed.even=true", "base.frequency=30"},
       {"feed.rate = 10 1/s: with feed.even, disks enter at 1 phase(s) of the drive of 30 Hz, on which "
        "results depend; without it, at random times [even-feed]"}},
      {{"feed.rate=10", "feed.even=true", "base.frequency=29.97"}, {}},
      {{"feed.rate=10", "base.frequency=30"}, {}},
      {{"base.frequency=10"},
       {"the drive's peak acceleration downwards, 7.896 m/s^2, is 0.8049 times gravity; below 1 it throws no "
        "disk up, and disks that are poured or fed pile up [no-lift]",
        "contact.min_rebound_speed = 0.05 m/s: the base itself moves at 0.1257 m/s at most: slow contacts "
        "drive the disks; use at most 0.041 m/s [high-floor]"}},
      {{"base.frequency=10", "base.harmonics=[{multiple: 2, amplitude: 0.0003}]"}, {}},
      {{"accuracy.step=0.001"},
       {"accuracy.step = 0.001 s: has no effect, because accuracy.method is events [unused-step]"}},
      {{"accuracy.method=steps", "contact.pair_collisions=false"},
       {"accuracy.method = steps: has no effect, because contact.pair_collisions is false [unused-steps]"}},
      {{"accuracy.method=steps", "accuracy.step=0.004"}, {}},
      // A violent drive: energies come out a third too high (docs/accuracy.md).
      {{"accuracy.method=steps", "accuracy.step=0.001", "base.amplitude=0.0188"},
       {"accuracy.step = 0.001 s: a disk moves by up to 0.00306 m within a step, 1.53 of the smallest "
        "diameters: many contacts are missed; use at most 0.000915 s [long-step]"}},
      {{"accuracy.method=steps", "accuracy.step=0.0005", "base.amplitude=0.0188"}, {}},
      {{"accuracy.method=steps", "accuracy.step=0.000001"},
       {"accuracy.step = 1e-06 s: 1000000 steps per simulated second take about 16 s of processor time: "
        "slower than method events, which is exact; did you mean 0.001 s? [short-step]"}},
      {{"accuracy.mean_vx=100"},
       {"accuracy.mean_vx = 100 m/s: too coarse for disks whose speeds reach 0.6321 m/s; did you mean 0.1 "
        "m/s? [coarse-mean]"}},
      {{"accuracy.mean_vx=0.01", "boundary=open"},
       {"accuracy.mean_vx = 0.01 m/s: an open base that is not fed empties, and has no steady <V_x>; "
        "boundary must be periodic or feed.rate above 0 [mean-of-none]"}},
      {{"accuracy.mean_vx=0.01", "boundary=open", "feed.rate=10"}, {}},
      {{"accuracy.quality=0.02"},
       {"accuracy.quality = 0.02: cannot be reached, because no disk leaves a periodic base; boundary must "
        "be open or walled [quality-of-none]"}},
      {{"accuracy.quality=0.02", "boundary=open"}, {}},
      {{"base.tooth_height=0", "species.1.radius=0.15"},
       {"the counts of all species sum to 10 disks: at rest a layer 1.078 m thick, 3.592 of the largest "
        "diameters, on a base 0.4 m wide; did you mean a smaller density, smaller counts or larger radii? "
        "[thick-layer]"}},
      {{"base.amplitude=2"},
       {"base.amplitude = 2 m: 100 times a tooth's width, and at base.frequency = 23 Hz the base reaches 289 "
        "m/s and 41768 m/s^2, 4258 times gravity; did you mean 0.002 m? [wide-stroke]"}},
      {{"base.frequency=1380"},
       {"base.frequency = 1380 Hz: with an amplitude of 0.002 m the base reaches 17.34 m/s and 150365 m/s^2, "
        "15328 times gravity; did you mean 23 Hz? [hard-drive]"}},
      {{"base.frequency=0.023"},
       {"base.frequency = 0.023 Hz: with an amplitude of 0.002 m the base reaches 0.000289 m/s and 4.177e-05 "
        "m/s^2, 4.258e-06 times gravity, too weak to lift a disk; did you mean 23 Hz? [soft-drive]"}},
      {{"base.amplitude=2", "base.frequency=0"},
       {"base.amplitude = 2 m: 100 times a tooth's width, and at base.frequency = 0 Hz the base reaches 0 "
        "m/s and 0 m/s^2, 0 times gravity; did you mean 0.002 m? [wide-stroke]"}},
      {{"base.inclination=1"}, {"base.inclination = 1 rad: 57.3 degrees; did you mean 0.01745 rad? [steep]"}},
      {{"base.phase=90"}, {"base.phase = 90 rad: 14.32 turns of the drive; did you mean 1.571 rad? [turns]"}},
      {{"base.tooth_width=20", "density=0.01"},
       {"base.tooth_width = 20 m: 5000 times the diameter of the largest disks, 0.004 m; did you mean 0.02 "
        "m? [wide-teeth]"}},
      {{"base.tooth_height=6"},
       {"base.tooth_height = 6 m: 300 times a tooth's width, 0.02 m; did you mean 0.006 m? [tall-teeth]"}},
      {{"gravity=9810"},
       {"gravity = 9810 m/s^2: 1000 times that of the earth; did you mean 9.81 m/s^2? [strong-gravity]"}},
      {{"gravity=0.00981"},
       {"gravity = 0.00981 m/s^2: 0.001 times that of the earth, and the base reaches 41.77 m/s^2; did you "
        "mean 9.81 m/s^2? [weak-gravity]"}},
      {{"density=393"},
       {"the counts of all species sum to 52400 disks: at rest a layer 1.255 m thick, 313.7 of the largest "
        "diameters, on a base 0.4 m wide; did you mean a smaller density, smaller counts or larger radii? "
        "[thick-layer]"}},
      {{"pour.drop_height=20"},
       {"pour.drop_height = 20 m: 1000 times a tooth's width; disks land at 19.81 m/s; did you mean 0.02 m? "
        "[high-drop]"}},
      {{"pour.speed=500"},
       {"pour.speed = 500 m/s: 25 times a tooth's width per millisecond; did you mean 0.5 m/s? [fast-pour]"}},
      {{"contact.min_rebound_speed=50"},
       {"contact.min_rebound_speed = 50 m/s: higher than any speed from fall, pour and drive, 1.259 m/s: "
        "every contact accelerates the disks; did you mean 0.05 m/s? [fast-rebound]"}},
      {{"contact.contact_duration=1"},
       {"contact.contact_duration = 1 s: longer than the machine's time scale, 0.04348 s: almost no contact "
        "loses energy; did you mean 0.001 s? [long-contact]"}},
      {{"feed.rate=40000"},
       {"feed.rate = 40000 1/s: raises the layer by 0.9578 m/s, 10.41 of the largest diameters within the "
        "machine's time scale, 0.04348 s; did you mean 40 1/s? [fast-feed]"}},
      {{"species.0.mass=10"},
       {"species.0.mass = 10 kg: a disk of radius 0.001 m and mass 10 kg would have the density 2.387e+09 "
        "kg/m^3 as a sphere; osmium has 22590 kg/m^3; did you mean 0.01 kg? [dense-disk]"}},
      {{"species.0.radius=0.000001"},
       {"species.0.radius = 1e-06 m: a disk of radius 1e-06 m and mass 0.01 kg would have the density "
        "2.387e+15 kg/m^3 as a sphere; osmium has 22590 kg/m^3; did you mean 0.001 m? [dense-disk]"}},
      // Of disks of several sizes: the density of the smallest, or of the largest.
      {{"species.1.size={distribution: lognormal, spread: 0.5, mass_exponent: 0}", "species.1.mass=0.01"},
       {"species.1.mass = 0.01 kg: a disk of radius 0.0004463 m and mass 0.01 kg would have the density "
        "26862509 kg/m^3 as a sphere; osmium has 22590 kg/m^3; did you mean 1e-05 kg? [dense-disk]"}},
      {{"species.1.size={distribution: uniform, spread: 0.9, mass_exponent: 10}", "species.1.mass=0.01"},
       {"species.1.mass = 0.01 kg: a disk of radius 0.0038 m and mass 6.131 kg would have the density "
        "26674520 kg/m^3 as a sphere; osmium has 22590 kg/m^3; did you mean 1e-05 kg? [dense-disk]"}},
      {{"species.1.size={distribution: uniform, spread: 0.5}", "species.1.radius=0.008"},
       {"species.1.size: the largest diameter, 0.024 m, is larger than the room for a disk, 0.02 m: a "
        "tooth's width, or a flat base's [large-disk]"}},
      {{"species.1.size={distribution: uniform, spread: 0.9}"}, {}},
      {{"duration=100000"},
       {"duration = 100000 s: 27.78 hours, 2300000 drive periods; did you mean 100 s? [long-run]"}},
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

/// Small machines at the default floor, whose drifts depend on it. The number that is named is low enough.
TEST(Implausibilities, OfAReboundFloorThatDrivesTheDisksHaveTheNumberToSet)
{
  const auto warnings_at = [](std::vector<std::string> machine, const std::string& floor)
  {
    machine.push_back("contact.min_rebound_speed=" + floor);
    return loadSceneFile(configFile("paper_fig8.yaml"), machine).warnings;
  };
  const std::vector<std::string> teeth_of_1_mm = {
      "base.tooth_width=0.001", "base.tooth_height=0.0003", "base.amplitude=45e-6",
      "base.frequency=150",     "species.0.radius=50e-6",   "species.1.radius=50e-6",
      "species.0.mass=1.3e-9",  "species.1.mass=1.3e-9",    "pour.drop_height=0.001"};
  EXPECT_EQ(warnings_at(teeth_of_1_mm, "0.05"),
            std::vector<std::string>{
                "contact.min_rebound_speed = 0.05 m/s: too much for disks of radius 5e-05 m: slow contacts "
                "drive them; use at most 0.013 m/s [high-floor]"});
  EXPECT_EQ(warnings_at(teeth_of_1_mm, "0.013"), std::vector<std::string>());
  std::vector<std::string> teeth_of_2_mm = {
      "base.tooth_width=0.002", "base.tooth_height=0.0006", "base.amplitude=0.0002", "base.frequency=100",
      "species.0.radius=1e-4",  "species.1.radius=2e-4",    "species.0.mass=1e-8",   "species.1.mass=1e-8"};
  EXPECT_EQ(warnings_at(teeth_of_2_mm, "0.05").size(), 1u);
  EXPECT_EQ(warnings_at(teeth_of_2_mm, "0.018"), std::vector<std::string>());
  teeth_of_2_mm[2] = "base.amplitude=3e-5";  // the base itself is slow
  EXPECT_EQ(warnings_at(teeth_of_2_mm, "0.0063").size(), 1u);
  EXPECT_EQ(warnings_at(teeth_of_2_mm, "0.0062"), std::vector<std::string>());
  EXPECT_EQ(warnings_at({"base.amplitude=0", "gravity=0"}, "0.05"), std::vector<std::string>());
}

/// A mistake with units that goes through many keys: the factors of lengths of the base, those of disks,
/// masses, speeds and counts.
struct Slip
{
  double base, disks, masses, speeds, counts;
  std::string given, text, meant;
};

TEST(Implausibilities, OfAMistakeThatGoesThroughAllKeysIsOneLine)
{
  const std::string base = "base.tooth_width = 20 m, base.amplitude = 2 m";
  const std::string meant = "0.02 m, 0.002 m";
  for (const Slip& slip :
       std::vector<Slip>{{1e3, 1e3, 1, 1, 1, ", species.0.radius = 1 m", "in mm", ", 0.001 m"},
                         {1e3, 1e3, 1e3, 1, 1, ", species.0.radius = 1 m, species.0.mass = 10 kg",
                          "in mm and masses in g", ", 0.001 m, 0.01 kg"},
                         {1e3, 1e3, 1, 1e3, 1, ", species.0.radius = 1 m, gravity = 9810 m/s^2",
                          "in mm, speeds in mm/s and gravity in mm/s^2", ", 0.001 m, 9.81 m/s^2"},
                         {1e3, 1, 1, 1, 1, "", "of the base in mm", ""},
                         // As many as the density then asks for.
                         {1e3, 1, 1, 1, 1e3, "", "of the base in mm", ""}})
  {
    SceneDefinition scene = loadSceneFile(configFile("paper_fig8.yaml")).definition;
    for (double* length : {&scene.base.tooth_width, &scene.base.tooth_height, &scene.base.amplitude})
      *length *= slip.base;
    scene.pour.drop_height *= slip.disks;
    for (SpeciesDefinition& species : scene.species)
    {
      species.radius *= slip.disks;
      species.mass *= slip.masses;
      species.count = static_cast<int>(species.count * slip.counts);
    }
    scene.gravity *= slip.speeds;
    scene.contact.min_rebound_speed *= slip.speeds;
    EXPECT_EQ(implausibilities(scene),
              std::vector<std::string>{base + slip.given +
                                       ": the base is 400 m wide and reaches 289 m/s; are lengths " +
                                       slip.text + "? Did you mean " + meant + slip.meant + "? [units]"});
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
                "initial.1.y = 50 m: 50 m above the base, 2500 times a tooth's width; did you mean 0.05 m? "
                "[high-disk]",
                "initial.1: the speed (vx, vy) is 300 m/s; is it in mm/s? [fast-disk]",
                "initial.1.spin = 1000000 rad/s: the rim of the disk moves at 1000 m/s [fast-spin]"}));
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

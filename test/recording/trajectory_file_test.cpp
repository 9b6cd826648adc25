// What a trajectory holds, in text; trajectory_test.py reads those of sieve_run with ASE and compares them
// with bags.
#include "ratchet_sieve/recording/trajectory_file.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "errors.h"
#include "file_size_limit.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

/// Hands one instant over as the sampler does: the base before the disks.
void give(TrajectoryFile& file, double time, const DriveState& base, const std::vector<DiskState>& disks)
{
  file.take(BaseFrame{time, base});
  file.take(ParticleFrame{time, disks});
}

/// The text of the disks, and that of the base.
std::pair<std::string, std::string> textsOf(const SceneDefinition& scene, const DriveState& base,
                                            const std::vector<DiskState>& disks)
{
  const ScratchDirectory directory;
  TrajectoryFile file(directory / "run.xyz");
  file.take(makeSceneFrame(Simulation(scene)));
  give(file, 0.5, base, disks);
  file.commit();
  return {contents(directory / "run.xyz"), contents(directory / "run_base.xyz")};
}

TEST(TrajectoryFile, HasEveryNumberOfADiskAndTheCornersOfALevelSawtooth)
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 2;
  scene.species[1].size.spread = 0.2;
  DriveState base;
  base.displacement = 0.125;
  base.horizontal_displacement = 0.5;
  const DiskState small{1, 1, 1.0 / 3.0, -0.5, 0.25, 5e-324, -0.0, 1e300, -3.0, 0.0015};
  const auto [disks, corners] = textsOf(scene, base, {small, {2, 0}});
  const std::string head =
      "Lattice=\"0.04 0 0 -0 0.04 0 0 0 0.0072\" Origin=\"0.5 0.125 -0.0036\" "
      "pbc=\"F F F\" Time=0.5 Properties=type:S:1:pos:R:3";
  EXPECT_EQ(disks, "2\n" + head +
                       ":id:I:1:velo:R:3:radius:R:1:mass:R:1:angle:R:1:omega:R:3:displacement:R:1\n"
                       "B 0.3333333333333333 -0.5 0 1 5e-324 -0 0 0.0015 0.000125 0.25 0 0 1e+300 -3\n"
                       "A 0 0 0 2 0 0 0 0.001 0.01 0 0 0 0 0\n");
  EXPECT_EQ(corners, "5\n" + head +
                         ":radius:R:1\n"
                         "base 0.5 0.125 0 0.0004\nbase 0.502 0.131 0 0.0004\nbase 0.52 0.125 0 0.0004\n"
                         "base 0.522 0.131 0 0.0004\nbase 0.54 0.125 0 0.0004\n");
}

TEST(TrajectoryFile, HasTheCornersAndWallsOfAProfileThatIsInclined)
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 1;
  scene.base.profile = {{0.0, 0.0}, {0.0, 0.5}, {0.5, 0.5}, {1.0, 0.0}};
  scene.base.wall_height = 2.0;
  scene.boundary = Boundary::WALLED;
  DriveState base;
  base.inclination = 2.0 * std::atan(1.0);
  std::istringstream text(textsOf(scene, base, {}).second);
  std::string rows, head, name;
  std::getline(text, rows);
  std::getline(text, head);
  EXPECT_EQ(rows, "6");
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{
           {-2.0, 0.0}, {0.0, 0.0}, {-0.5, 0.0}, {-0.5, 0.5}, {0.0, 1.0}, {-2.0, 1.0}})
  {
    double read_x = 0.0, read_y = 0.0, z = 0.0, radius = 0.0;
    text >> name >> read_x >> read_y >> z >> radius;
    EXPECT_NEAR(read_x, x, 1e-15);
    EXPECT_NEAR(read_y, y, 1e-15);
  }
  scene.base.wall_height = 0.0;
  scene.boundary = Boundary::PERIODIC;
  const std::string without = textsOf(scene, base, {}).second;
  EXPECT_EQ(without.substr(0, 2), "4\n") << "walls need a height";
  EXPECT_NE(without.find("pbc=\"T F F\""), std::string::npos);
}

TEST(TrajectoryFile, NeedsTheSceneAndTheBaseAtTheTimeOfTheDisks)
{
  const ScratchDirectory directory;
  TrajectoryFile file(directory / "run.extxyz");
  EXPECT_THROW(give(file, 0.0, {}, {}), std::invalid_argument);
  file.take(makeSceneFrame(Simulation(smallMixture())));
  give(file, 0.0, {}, {});
  EXPECT_THROW(file.take(ParticleFrame{0.1, {}}), std::invalid_argument);
}

TEST(TrajectoryFile, NamesTheEndingsThatThereAre)
{
  const ScratchDirectory directory;
  for (const char* name : {"run.abc", "run", "run.XYZ", ".xyz"})
    EXPECT_EQ(errorOf<OutputError>([&] { TrajectoryFile file(directory / name); }),
              directory / name +
                  ": unknown format of a trajectory; the file's ending must be one of .xyz, .extxyz");
  EXPECT_EQ(errorOf<OutputError>([&] { TrajectoryFile file(directory / "run.pvd"); }),
            directory / "run.pvd" +
                ": for ParaView use run.write(\"FILE.pvd\") of the Python package; the file's "
                "ending must be one of .xyz, .extxyz");
  EXPECT_TRUE(directory.empty());
}

TEST(TrajectoryFile, SaysThatTheDiskIsFullAndKeepsTheEarlierOne)
{
  const ScratchDirectory directory;
  const auto write = [&](std::size_t disks)
  {
    TrajectoryFile file(directory / "run.xyz");
    file.take(makeSceneFrame(Simulation(smallMixture())));
    give(file, 0.0, {}, std::vector<DiskState>(disks));
    file.commit();
  };
  write(1);
  const std::string before = contents(directory / "run.xyz");
  const FileSizeLimit limit(20000);
  const std::string error = errorOf<OutputError>([&] { write(1000); });
  EXPECT_NE(error.find(": cannot be written: "), std::string::npos) << error;
  EXPECT_EQ(contents(directory / "run.xyz"), before);
}

}  // namespace
}  // namespace ratchet_sieve

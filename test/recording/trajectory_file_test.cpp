#include "ratchet_sieve/recording/trajectory_file.h"

#include <cmath>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "file_size_limit.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "small_scenes.h"
#include "trajectory_reading.h"

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

std::unique_ptr<TrajectoryFile> opened(const std::string& path, const SceneDefinition& scene)
{
  std::unique_ptr<TrajectoryFile> file = openTrajectory(path);
  file->take(makeSceneFrame(Simulation(scene)));
  return file;
}

std::vector<XyzFrame> xyzOf(const SceneDefinition& scene, const DriveState& base,
                            const std::vector<DiskState>& disks, const std::string& name = "run.xyz")
{
  const ScratchDirectory directory;
  const auto file = opened(directory / "run.xyz", scene);
  give(*file, 0.5, base, disks);
  file->commit();
  return xyzFrames(contents(directory / name));
}

/// Every file of a directory tree, by its path below it.
std::map<std::string, std::string> filesIn(const std::string& directory)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
    if (entry.is_regular_file())
      files[std::filesystem::relative(entry.path(), directory).string()] = contents(entry.path().string());
  return files;
}

std::string errorOf(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const OutputError& error)
  {
    return error.what();
  }
  return "";
}

/// Numbers as the format has them: every double that is finite.
std::vector<DiskState> anyDisks()
{
  const auto number = [] { return *rc::gen::suchThat<double>([](double x) { return std::isfinite(x); }); };
  std::vector<DiskState> disks(*rc::gen::inRange<std::size_t>(0, 8));
  for (DiskState& disk : disks)
    disk = {*rc::gen::inRange<std::uint32_t>(0, 1u << 31),
            *rc::gen::inRange<std::uint32_t>(0, 2),
            number(),
            number(),
            number(),
            number() / 3.0,
            number() * 0.1,
            number(),
            number(),
            std::abs(number())};
  return disks;
}

std::vector<double> each(const std::vector<DiskState>& disks,
                         const std::function<double(const DiskState&)>& of)
{
  std::vector<double> numbers(disks.size());
  std::transform(disks.begin(), disks.end(), numbers.begin(), of);
  return numbers;
}

struct NamedColumn
{
  const char* name;
  std::size_t column;
  std::function<double(const DiskState&)> value;
};

/// Every number of a disk.
std::vector<NamedColumn> columnsOf(const SceneDefinition& scene)
{
  const auto radius = [scene](const DiskState& disk) { return radiusOf(disk, scene.species); };
  const auto mass = [scene, radius](const DiskState& disk)
  { return scene.species[disk.species].massOf(radius(disk)); };
  const auto nothing = [](const DiskState&) { return 0.0; };
  return {{"id", 0, [](const DiskState& disk) { return disk.id; }},
          {"pos", 0, [](const DiskState& disk) { return disk.x; }},
          {"pos", 1, [](const DiskState& disk) { return disk.y; }},
          {"pos", 2, nothing},
          {"velo", 0, [](const DiskState& disk) { return disk.vx; }},
          {"velo", 1, [](const DiskState& disk) { return disk.vy; }},
          {"velo", 2, nothing},
          {"angle", 0, [](const DiskState& disk) { return disk.angle; }},
          {"omega", 2, [](const DiskState& disk) { return disk.spin; }},
          {"displacement", 0, [](const DiskState& disk) { return disk.displacement; }},
          {"radius", 0, radius},
          {"mass", 0, mass}};
}

RC_GTEST_PROP(TrajectoryFile, HoldsNumbersThatReadBackBitForBit, ())
{
  const SceneDefinition scene = smallMixture();
  const std::vector<DiskState> disks = anyDisks();
  const std::vector<XyzFrame> frames = xyzOf(scene, {}, disks);
  RC_ASSERT(frames.size() == 1u);
  RC_ASSERT(frames[0].rows == disks.size());
  RC_ASSERT(frames[0].head.at("Time") == "0.5");
  for (std::size_t k = 0; k < disks.size(); ++k)
    RC_ASSERT(frames[0].columns_of.at("type")[k][0] == scene.species[disks[k].species].name);
  for (const NamedColumn& column : columnsOf(scene))
    RC_ASSERT(sameBits(frames[0].numbers(column.name, column.column), each(disks, column.value)));
}

TEST(TrajectoryFile, GivesEachDiskItsOwnRadiusAndMass)
{
  SceneDefinition scene = smallMixture();
  scene.species[1].size.spread = 0.2;
  const DiskState small{1, 1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.003 / 2.0};
  const DiskState of_the_species{2, 0};
  const XyzFrame frame = xyzOf(scene, {}, {small, of_the_species}).at(0);
  EXPECT_EQ(frame.numbers("radius"), (std::vector<double>{0.0015, 0.001}));
  EXPECT_DOUBLE_EQ(frame.numbers("mass")[0], scene.species[1].mass / 8.0);
  EXPECT_EQ(frame.numbers("mass")[1], 0.010);
}

TEST(TrajectoryFile, IsPeriodicAlongAPeriodicBaseAlone)
{
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED})
  {
    SceneDefinition scene = smallMixture();
    scene.boundary = boundary;
    EXPECT_EQ(xyzOf(scene, {}, {}).at(0).head.at("pbc"), boundary == Boundary::PERIODIC ? "T F F" : "F F F");
  }
}

TEST(TrajectoryFile, HasACellInThePoseOfTheBase)
{
  const SceneDefinition scene = smallMixture();
  DriveState base;
  base.inclination = std::atan2(3.0, 4.0);
  base.displacement = 0.002;
  base.horizontal_displacement = -0.001;
  const XyzFrame frame = xyzOf(scene, base, {}).at(0);
  const std::vector<double> cell = frame.headNumbers("Lattice");
  const std::vector<double> expected = {0.064, 0.048, 0.0, -0.048, 0.064, 0.0, 0.0, 0.0, 0.006};
  ASSERT_EQ(cell.size(), 9u);
  for (std::size_t k = 0; k < 9; ++k)
    EXPECT_NEAR(cell[k], expected[k], 1e-16) << k;
  EXPECT_EQ(frame.headNumbers("Origin"), (std::vector<double>{-0.001, 0.002, -0.003}));
}

/// The corners of the base: x and y of each in turn.
std::vector<double> cornersOf(const SceneDefinition& scene, const DriveState& base)
{
  const XyzFrame frame = xyzOf(scene, base, {}, "run_base.xyz").at(0);
  std::vector<double> corners;
  for (std::size_t k = 0; k < frame.rows; ++k)
    corners.insert(corners.end(), {frame.numbers("pos", 0)[k], frame.numbers("pos", 1)[k]});
  return corners;
}

void expectCorners(const std::vector<double>& corners, const std::vector<double>& expected)
{
  ASSERT_EQ(corners.size(), expected.size());
  for (std::size_t k = 0; k < corners.size(); ++k)
    EXPECT_NEAR(corners[k], expected[k], 1e-16) << k;
}

TEST(TrajectoryFile, HasTheCornersOfALevelSawtooth)
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 2;
  DriveState base;
  base.displacement = 0.001;
  base.horizontal_displacement = 0.5;
  expectCorners(cornersOf(scene, base), {0.5, 0.001, 0.502, 0.007, 0.52, 0.001, 0.522, 0.007, 0.54, 0.001});
}

TEST(TrajectoryFile, HasTheCornersOfAProfileThatIsInclined)
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 1;
  scene.base.profile = {{0.0, 0.0}, {0.0, 0.005}, {0.01, 0.005}, {0.02, 0.0}};
  DriveState base;
  base.inclination = std::atan2(3.0, 4.0);
  expectCorners(cornersOf(scene, base), {0.0, 0.0, -0.003, 0.004, 0.005, 0.010, 0.016, 0.012});
}

TEST(TrajectoryFile, HasWallsOfTheHeightThatTheSceneGives)
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 1;
  scene.boundary = Boundary::WALLED;
  const std::vector<double> corners = {0.0, 0.0, 0.002, 0.006, 0.02, 0.0};
  expectCorners(cornersOf(scene, {}), corners);
  scene.base.wall_height = 0.1;
  expectCorners(cornersOf(scene, {}), {0.0, 0.1, 0.0, 0.0, 0.002, 0.006, 0.02, 0.0, 0.02, 0.1});
}

TEST(TrajectoryFile, NeedsTheSceneAndTheBaseAtTheTimeOfTheDisks)
{
  const ScratchDirectory directory;
  const auto file = openTrajectory(directory / "run.xyz");
  EXPECT_THROW(give(*file, 0.0, {}, {}), std::invalid_argument);
  file->take(makeSceneFrame(Simulation(smallMixture())));
  give(*file, 0.0, {}, {});
  EXPECT_THROW(file->take(ParticleFrame{0.1, {}}), std::invalid_argument);
}

TEST(TrajectoryFile, NamesTheEndingsThatThereAre)
{
  const ScratchDirectory directory;
  for (const char* name : {"run.abc", "run", "run.XYZ", ".xyz"})
    EXPECT_EQ(errorOf([&] { openTrajectory(directory / name); }),
              directory / name +
                  ": unknown format of a trajectory; the file's ending must be one of .xyz, "
                  ".extxyz");
  EXPECT_EQ(errorOf([&] { openTrajectory(directory / "run.pvd"); }),
            directory / "run.pvd" +
                ": for ParaView use run.write(\"FILE.pvd\") of the Python package; the file's "
                "ending must be one of .xyz, .extxyz");
  EXPECT_TRUE(directory.empty());
}

TEST(TrajectoryFile, AppearsWhenItIsComplete)
{
  for (const char* name : {"run.xyz", "run.extxyz"})
  {
    const ScratchDirectory directory;
    {
      const auto abandoned = opened(directory / name, smallMixture());
      give(*abandoned, 0.0, {}, {{}});
    }
    EXPECT_TRUE(directory.empty()) << name;
    const auto file = opened(directory / name, smallMixture());
    give(*file, 0.0, {}, {{}});
    EXPECT_FALSE(std::filesystem::exists(directory / name));
    file->commit();
    EXPECT_EQ(filesIn(directory / "").count(name), 1u);
  }
}

TEST(TrajectoryFile, SaysThatTheDiskIsFullAndKeepsTheEarlierOne)
{
  const ScratchDirectory directory;
  const auto write = [&](std::size_t disks)
  {
    const auto file = opened(directory / "run.xyz", smallMixture());
    give(*file, 0.0, {}, std::vector<DiskState>(disks));
    file->commit();
  };
  write(1);
  const auto before = filesIn(directory / "");
  const FileSizeLimit limit(20000);
  const std::string error = errorOf([&] { write(1000); });
  EXPECT_NE(error.find(": cannot be written: "), std::string::npos) << error;
  EXPECT_EQ(filesIn(directory / ""), before);
}

TEST(TrajectoryFile, HasTheFramesOfARunAtItsOwnRate)
{
  const ScratchDirectory directory;
  SceneDefinition scene = smallMixture();
  scene.duration = 1.0;
  Simulation simulation(scene);
  const auto xyz = openTrajectory(directory / "run.xyz");
  const auto ends = openTrajectory(directory / "ends.xyz");
  RunWatchers watchers;
  watchers.frames = {{xyz.get(), trajectoryRates(10.0)}, {ends.get(), trajectoryRates(0.0)}};
  runToEnd(simulation, watchers);
  xyz->commit();
  ends->commit();
  const std::vector<XyzFrame> frames = xyzFrames(contents(directory / "run.xyz"));
  const std::vector<XyzFrame> bases = xyzFrames(contents(directory / "run_base.xyz"));
  ASSERT_EQ(frames.size(), 11u);
  ASSERT_EQ(bases.size(), 11u);
  for (std::size_t k = 0; k < frames.size(); ++k)
  {
    const double time = static_cast<double>(k) / 10.0;
    EXPECT_EQ(frames[k].headNumbers("Time"), std::vector<double>{time});
    EXPECT_NEAR(bases[k].numbers("pos", 1)[0], driveStateAt(scene.base, time).displacement, 1e-15);
  }
  EXPECT_GT(frames.front().rows, frames.back().rows);
  EXPECT_GT(frames.back().rows, 0u);
  EXPECT_EQ(frames.back().numbers("pos", 0),
            each(simulation.disks(), [](const auto& disk) { return disk.x; }));
  EXPECT_EQ(xyzFrames(contents(directory / "ends.xyz")).size(), 2u);
}

}  // namespace
}  // namespace ratchet_sieve

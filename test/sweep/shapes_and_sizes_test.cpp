// Sweeps over the outline of a tooth and over the spread of a species' sizes.
#include <set>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep_run.h"
#include "sweep_files.h"

namespace ratchet_sieve
{
namespace
{
using Json = nlohmann::ordered_json;

/// Runs the sweep, twice: the second time nothing is left to run. @return the rows in the sweep's order,
/// after comparing each with a run of its own
std::vector<std::map<std::string, std::string>> rowsOf(const std::string& text)
{
  const ScratchDirectory directory;
  const Sweep sweep = loadSweep(written(directory, "s.yaml", SMALL_SCENE + text));
  const std::string results = directory / "r.db";
  runSweep(sweep, results, {});
  const auto table = tableOf(results);
  runSweep(sweep, results, {});
  EXPECT_EQ(tableOf(results), table);
  std::vector<std::map<std::string, std::string>> rows;
  CaseBuilder builder(sweep);
  for (std::size_t k = 0; k < table.size(); ++k)
  {
    const SweepCase& one = builder.at(k);
    rows.push_back(table.at(runHash(one.scene) + ' ' + std::to_string(PHYSICS_VERSION)));
    Json alone = runCase(one, {})->summary;
    alone.erase("wall_time");
    EXPECT_EQ(rows.back().at("summary"), alone.dump());
  }
  return rows;
}

/// The scene's own sawtooth steps back.
TEST(ShapesAndSizes, OutlinesOfATooth)
{
  const auto rows = rowsOf(
      "grid:\n"
      "  base.profile: [[[0, 0], [0.002, 0.006], [0.02, 0]], [[0, 0], [0.005, 0.004], [0.01, 0.004], [0.03, "
      "0]]]\n"
      "  base.inclination: [0, 0.1]\n");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].at("base.profile"), "[[0, 0], [0.002, 0.006], [0.02, 0]]");
  EXPECT_EQ(rows[3].at("base.inclination"), "0.1");
  EXPECT_EQ(rows[1].at("collisions.level"), "0");
  EXPECT_NE(rows[3].at("collisions.level"), "0");
  EXPECT_EQ(Json::parse(rows[0].at("summary"))["contacts_by_face"]["faces"].size(), 2u);
  EXPECT_EQ(Json::parse(rows[3].at("summary"))["contacts_by_face"]["faces"].size(), 3u);
}

TEST(ShapesAndSizes, HeightsOfOneCorner)
{
  const auto rows = rowsOf(
      "set: {base.profile: [[0, 0], [0.005, 0.004], [0.01, 0.004], [0.03, 0]]}\n"
      "grid: {base.profile.1.1: [0.004, 0.006]}\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NE(rows[0].at("events"), rows[1].at("events"));
  EXPECT_NE(rows[0].at("collisions.level"), "0");
  EXPECT_EQ(rows[1].at("collisions.level"), "0");  // the plateau has become a slope
}

TEST(ShapesAndSizes, SpreadsOfASpecies)
{
  const auto rows = rowsOf(
      "set: {species.0.size: {distribution: lognormal, spread: 0.1}}\n"
      "grid: {species.0.size.spread: [0, 0.2, 0.4]}\n");
  ASSERT_EQ(rows.size(), 3u);
  std::set<std::string> hashes;
  std::set<std::string> events;
  for (const auto& row : rows)
  {
    hashes.insert(row.at("scene_hash"));
    events.insert(row.at("events"));
  }
  EXPECT_EQ(hashes.size(), 3u);
  EXPECT_EQ(events.size(), 3u);
  EXPECT_EQ(rows[2].at("species.0.size.spread"), "0.4");
  EXPECT_FALSE(Json::parse(rows[0].at("summary"))["species"][0].contains("size_classes"));
  EXPECT_EQ(Json::parse(rows[2].at("summary"))["species"][0]["size_classes"].size(), 4u);
}
}  // namespace
}  // namespace ratchet_sieve

// The runs and the report of a check of the minimum rebound speed.
#include "ratchet_sieve/sweep/floor_check.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_run.h"
#include "sweep_files.h"

namespace ratchet_sieve
{
namespace
{

class FloorCheck : public testing::Test
{
protected:
  nlohmann::ordered_json summaryAt(SweepCase sweep_case, double floor) const
  {
    sweep_case.scene.contact.min_rebound_speed = floor;
    return runCase(sweep_case, {})->summary;
  }

  ScratchDirectory directory_;
  std::string results_ = directory_ / "r.db";
  Sweep sweep_ = loadSweep(written(directory_, "s.yaml",
                                   SMALL_SCENE + std::string("set: {duration: 10, contact.min_rebound_speed: "
                                                             "0.08}\ngrid: {base.inclination: [0.1, 0.2]}\n"
                                                             "seed: {first: 1, count: 3}\n")));
};

TEST_F(FloorCheck, RunsASceneAtAHalfAndAQuarterOfItsFloor)
{
  CaseBuilder builder(sweep_);
  const SweepCase& own = builder.at(0);
  const nlohmann::ordered_json summary = summaryAt(own, 0.08);
  const auto runs = runAtLowerFloors(own.scene, summary, {});
  ASSERT_TRUE(runs);
  const nlohmann::ordered_json json = floorCheckJson(*runs);
  ASSERT_EQ(json.size(), 3u);
  const std::vector<double> floors = {0.08, 0.04, 0.02};
  for (std::size_t k = 0; k < floors.size(); ++k)
  {
    const nlohmann::ordered_json expected = summaryAt(own, floors[k]);
    EXPECT_EQ(json[k]["min_rebound_speed"], floors[k]);
    EXPECT_EQ(json[k]["error"], nullptr);
    EXPECT_EQ(json[k]["processed"]["value"], expected["processed"]);
    EXPECT_EQ(json[k]["mean_vx.B"]["value"],
              expected["species"][1]["mean_vx"]);  // the run is too short for more
    EXPECT_EQ(json[k]["quality"]["value"], expected["accuracy"]["quality"]["value"]);
    EXPECT_EQ(json[k]["quality"]["half_width"], expected["accuracy"]["quality"]["half_width"]);
    EXPECT_EQ(json[k]["processed"]["difference"].get<double>(),
              expected["processed"].get<double>() - summary["processed"].get<double>());
  }
  EXPECT_NE(json[2]["mean_vx.B"]["value"], json[0]["mean_vx.B"]["value"]);
  EXPECT_FALSE(runAtLowerFloors(own.scene, summary, [] { return true; }));
}

TEST_F(FloorCheck, SaysWhatMovesByMoreThanItsErrorAndWhatDoesNot)
{
  const auto run = [](double floor, double quality, double drift) -> FloorRun
  {
    return {floor,
            "",
            {},
            {{"quality", quality, 0.03}, {"processed", 1.0, std::nullopt}, {"mean_vx.A", drift, 0.004}}};
  };
  const std::vector<std::string> lines =
      floorCheckLines({run(0.05, 0.625, 0.01), run(0.025, 0.6, 0.01), run(0.0125, 0.52, 0.011)});
  const auto has = [&lines](const std::string& line)
  { return std::find(lines.begin(), lines.end(), line) != lines.end(); };
  EXPECT_TRUE(
      has("quality changes by -0.105 +- 0.042 from 0.05 to 0.0125 m/s: it depends on "
          "contact.min_rebound_speed"));
  EXPECT_TRUE(
      has("mean_vx.A changes by +0.001 +- 0.0057 from 0.05 to 0.0125 m/s: no significant dependence on "
          "contact.min_rebound_speed; a change of up to 0.0067 is not excluded"));
  EXPECT_EQ(lines.size(), 7u);
  FloorRun failed = {0.0125, "it stalls", {}, {}};
  EXPECT_EQ(floorCheckLines({run(0.05, 0.6, 0.01), failed}).back(),
            "no error is known, so a dependence on contact.min_rebound_speed cannot be tested");
}

TEST_F(FloorCheck, RunsTheSeedsOfASettingIntoTheResultsFileOnce)
{
  runSweep(sweep_, results_, {});
  const auto before = tableOf(results_);
  const auto means = runSettingAtLowerFloors(sweep_, 1, results_, {});
  ASSERT_TRUE(means);
  EXPECT_EQ(tableOf(results_).size(), before.size() + 6);
  CaseBuilder builder(sweep_);
  const std::vector<double> floors = {0.08, 0.04, 0.02};
  for (std::size_t k = 0; k < floors.size(); ++k)
  {
    double quality = 0.0;
    for (std::uint64_t seed = 0; seed < 3; ++seed)
      quality += summaryAt(builder.at(3 + seed), floors[k])["separation"].get<double>() / 3.0;
    EXPECT_EQ((*means)[k].floor, floors[k]);
    EXPECT_EQ((*means)[k].mean->seeds, 3u);
    EXPECT_NEAR((*means)[k].mean->separation, quality, 1e-12);
  }
  runSettingAtLowerFloors(sweep_, 1, results_, {});
  EXPECT_EQ(tableOf(results_).size(), before.size() + 6);
}

TEST_F(FloorCheck, ComparesTheMeansOverSeedsByStudentsT)
{
  const auto at = [](double floor, double quality, double error)
  {
    SettingMean mean;
    mean.seeds = 4;
    mean.separation = quality;
    mean.error = error;
    return FloorMean{floor, mean};
  };
  // Student's t with 3 degrees of freedom is 3.182: 3.182 sqrt(0.03^2 + 0.04^2) = 0.159
  EXPECT_EQ(
      floorCheckLines({at(0.05, 0.6, 0.03), at(0.0125, 0.4, 0.04)}).back(),
      "quality changes by -0.2 +- 0.16 from 0.05 to 0.0125 m/s: it depends on contact.min_rebound_speed "
      "(half-width of 95 %)");
  EXPECT_EQ(floorCheckLines({at(0.05, 0.6, 0.03), {0.0125, std::nullopt}}).back(),
            "no error is known, so a dependence on contact.min_rebound_speed cannot be tested");
}

}  // namespace
}  // namespace ratchet_sieve

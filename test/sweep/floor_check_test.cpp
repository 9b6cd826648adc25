// The runs and the report of a check of the minimum rebound speed.
#include "ratchet_sieve/sweep/floor_check.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "ratchet_sieve/sweep/case.h"
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
  const nlohmann::ordered_json json = floorCheck(own.scene, summary, {});
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
  EXPECT_TRUE(floorCheck(own.scene, summary, [] { return true; }).is_null());
}

TEST_F(FloorCheck, SaysWhatMovesByMoreThanItsErrorAndWhatDoesNot)
{
  using Json = nlohmann::ordered_json;
  const auto result = [](double value, const Json& half_width, double difference, const Json& of_difference)
  {
    return Json{{"value", value},
                {"half_width", half_width},
                {"difference", difference},
                {"difference_half_width", of_difference}};
  };
  const auto run = [&](double floor, double quality, double drift) -> Json
  {
    return {{"min_rebound_speed", floor},
            {"error", nullptr},
            {"warnings", Json::array()},
            {"quality", result(quality, 0.03, quality - 0.625, 0.0424)},
            {"processed", result(1.0, nullptr, 0.0, nullptr)},
            {"mean_vx.A", result(drift, 0.004, drift - 0.01, 0.00566)}};
  };
  const std::vector<std::string> lines =
      floorCheckLines(Json::array({run(0.05, 0.625, 0.01), run(0.025, 0.6, 0.01), run(0.0125, 0.52, 0.011)}));
  const auto has = [&lines](const std::string& line)
  { return std::find(lines.begin(), lines.end(), line) != lines.end(); };
  EXPECT_TRUE(
      has("quality changes by -0.105 ± 0.042 from 0.05 to 0.0125 m/s: it depends on "
          "contact.min_rebound_speed"));
  EXPECT_TRUE(
      has("mean_vx.A changes by +0.001 ± 0.0057 from 0.05 to 0.0125 m/s: no significant dependence on "
          "contact.min_rebound_speed; a change of up to 0.0067 is not excluded"));
  EXPECT_EQ(lines.size(), 7u);
  const Json failed = {{"min_rebound_speed", 0.0125}, {"error", "it stalls"}, {"warnings", Json::array()}};
  EXPECT_EQ(floorCheckLines(Json::array({run(0.05, 0.6, 0.01), failed})).back(),
            "no error is known, so a dependence on contact.min_rebound_speed cannot be tested");
}

}  // namespace
}  // namespace ratchet_sieve

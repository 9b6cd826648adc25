#include "ratchet_sieve/analysis/analysis_report.h"

#include <gtest/gtest.h>

#include "hand_made_result.h"

namespace ratchet_sieve
{
namespace
{

TEST(ReportText, IsATableToRead)
{
  EXPECT_EQ(reportText(handMadeResult()),
            "scene 0123456789abcdef, seed 7, version 1.2.3: 0 s to 2.5 s, 151 frames of particles\n"
            "\n"
            "species     disks    left   right  on base         <V_x> [mm/s]   T_g [uJ]\n"
            "A              10       1       3        6       +12.50 +- 0.50        150\n"
            "long-name       1       1       0        0 -250.00 +- undefined  undefined\n"
            "\n"
            "s = -0.750, Q = 0.750, P = 0.500\n"
            "contacts: 100 disk-disk, 20 left slope, 40 right slope, 3 apex, 0 wall, 0 level\n"
            "short to long slope: 0.500\n"
            "accumulated by the engine:\n"
            "  A: mean_vx 0.5 m/s, mean_vx_stderr undefined, kinetic_translational undefined, "
            "kinetic_rotational undefined, collision_rate 40 1/s\n"
            "  long-name: mean_vx undefined, mean_vx_stderr undefined, kinetic_translational undefined, "
            "kinetic_rotational undefined, collision_rate undefined\n");
}

TEST(ReportText, SaysThatARunWentBySteps)
{
  RunResult result = handMadeResult();
  result.scene.accuracy.method = Method::STEPS;
  result.scene.accuracy.step = 0.0005;
  EXPECT_EQ(reportText(result).find(
                "scene 0123456789abcdef, seed 7, version 1.2.3: 0 s to 2.5 s by steps of 0.5 ms, "
                "151 frames of particles\n"),
            0u);
  EXPECT_EQ(reportJson(result)["plan"]["steps"], true);
  EXPECT_EQ(reportJson(handMadeResult())["plan"]["steps"], false);
}

TEST(ReportText, HasNoBinsWhereNothingLeft)
{
  RunResult result = handMadeResult();
  for (BinFrame& frame : result.bins)
    frame.bins = {{0, 0, 10}, {0, 0, 1}};
  result.scene.boundary = Boundary::WALLED;
  const std::string text = reportText(result);
  EXPECT_NE(text.find("\n\n"
                      "species     disks         <V_x> [mm/s]   T_g [uJ]\n"
                      "A              10       +12.50 +- 0.50        150\n"
                      "long-name       1 -250.00 +- undefined  undefined\n"
                      "\n"
                      "no disk can leave this base: no bins, no Q, no P\n"
                      "contacts: "),
            std::string::npos)
      << text;
}

TEST(ReportText, CountsWhatWentOverTheWalls)
{
  RunResult result = handMadeResult();
  result.scene.boundary = Boundary::WALLED;
  EXPECT_EQ(reportText(result), reportText(handMadeResult()));
}

TEST(ReportText, SaysWhatIsNotDefined)
{
  RunResult result = handMadeResult();
  result.bins.clear();
  result.base.clear();
  result.statistics.clear();
  result.particle_frames = 0;
  const std::string text = reportText(result);
  EXPECT_NE(text.find("A               -       -       -        - "), std::string::npos) << text;
  EXPECT_NE(text.find("s, Q and P: undefined\n"
                      "contacts: undefined\n"
                      "not recorded: particles (no <V_x>, no displacements)\n"
                      "not recorded: bins (no counts, no Q, no P)\n"
                      "not recorded: base (no inclination, frequency and amplitude over time)\n"
                      "not recorded: statistics (no temperatures, no contacts)\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

TEST(ReportText, ListsPairsOfMoreThanTwoSpecies)
{
  RunResult result = handMadeResult();
  result.species = {"A", "B", "C"};
  result.velocities.resize(3);
  result.granular_temperatures.resize(3);
  result.bins = {{1.0, result.species, {{4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, 1.0, 2.0 / 3.0, 1.0}};
  const std::string text = reportText(result);
  EXPECT_NE(text.find("  s of A and B = 1.000\n  s of A and C = undefined\n"), std::string::npos) << text;
}

TEST(ReportJson, SaysNullForWhatIsNotDefined)
{
  RunResult result = handMadeResult();
  result.bins.clear();
  result.statistics.clear();
  const auto json = reportJson(result);
  for (const char* key : {"quality", "processed", "short_to_long", "collisions", "max_overlap"})
    EXPECT_TRUE(json[key].is_null()) << key;
  EXPECT_TRUE(json["species"][0]["left"].is_null());
  EXPECT_EQ(json["not_recorded"], (std::vector<std::string>{"bins", "statistics"}));
}

}  // namespace
}  // namespace ratchet_sieve

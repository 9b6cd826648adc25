#include "ratchet_sieve/analysis/analysis_report.h"

#include <gtest/gtest.h>

#include "hand_made_result.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "recording/small_scenes.h"

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
            "A              10       1       3        6      +500.00 ± 20.00        150\n"
            "long-name       1       1       0        0            undefined  undefined\n"
            "<V_x> of the frames, without each disk's way before its first and after its last one:\n"
            "  A: +12.50 ± 0.50 mm/s\n"
            "  long-name: -250.00 ± undefined mm/s\n"
            "\n"
            "s = -0.750, Q = 0.750, P = 0.500\n"
            "contacts: 100 disk-disk, 20 left slope, 40 right slope, 3 apex, 0 wall, 0 level\n"
            "short to long slope: 0.500\n"
            "accumulated by the engine:\n"
            "  A: mean_vx 0.5 m/s, mean_vx_stderr 0.02 m/s, kinetic_translational undefined, "
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

TEST(ReportText, SaysWhatALateRecordingIsOf)
{
  RunResult result = handMadeResult();
  result.first_frame = 2.0;
  EXPECT_NE(reportText(result).find("\nrecorded from 2 s on: T_g and <V_x> of the frames are of this part, "),
            std::string::npos);
  EXPECT_EQ(reportJson(result)["first_frame_time"], 2.0);
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
                      "A              10      +500.00 ± 20.00        150\n"
                      "long-name       1            undefined  undefined\n"
                      "<V_x> of the frames, "),
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
  result.statistics.back().species.resize(3);
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

class AnalysisTables : public testing::Test
{
protected:
  AnalysisTables() { writeTables(handMadeResult(), directory_ / "new/sub"); }

  std::string table(const std::string& name) const { return contents(directory_ / "new/sub/" + name); }

  ScratchDirectory directory_;
};

TEST_F(AnalysisTables, HoldTheBins)
{
  EXPECT_EQ(table("bins.csv"),
            "time [s],species,left,right,on_base,left_mass [kg],right_mass [kg]\n"
            "0,A,0,0,10,0,0\n0,long-name,0,0,1,0,0\n2.5,A,1,3,6,0.01,0.03\n2.5,long-name,1,0,0,0.002,0\n");
}

TEST_F(AnalysisTables, HoldWhatWasObserved)
{
  EXPECT_EQ(table("observed.csv"),
            "observable,place,species,number,unit,value\n"
            "mass_flow,left,A,mean,kg/s,0.5\nmass_flow,left,A,stderr,kg/s,\n"
            "height_profile,,long-name,mean_height,m,0.25\n");
  EXPECT_EQ(table("mass_flow.csv"), "place,species,time [s],flow [kg/s]\nleft,A,1.5,0.75\nleft,A,2.5,\n");
  RunResult result = handMadeResult();
  result.observed.clear();
  writeTables(result, directory_ / "new/sub");
  EXPECT_FALSE(std::filesystem::exists(directory_ / "new/sub/observed.csv"));
}

TEST_F(AnalysisTables, LeaveEmptyWhatIsNotDefined)
{
  EXPECT_EQ(table("segregation.csv"), "time [s],quality,processed,separation\n0,,,\n2.5,0.75,0.5,-0.75\n");
  EXPECT_EQ(table("velocities.csv"),
            "species,disks,mean_vx [m/s],mean_vx_stderr [m/s]\nA,10,0.0125,0.0005\nlong-name,1,-0.25,\n");
  EXPECT_EQ(table("statistics.csv"),
            "time [s],species,mean_vx [m/s],mean_vx_stderr [m/s],kinetic_translational [J],"
            "kinetic_rotational [J],collision_rate [1/s],window_start [s],window_end [s],"
            "granular_temperature [J]\n"
            "2.5,A,0.5,0.02,,,40,2.25,2.375,0.25\n2.5,long-name,,,,,,2.25,2.375,\n");
}

TEST_F(AnalysisTables, HoldTheRunItsDriveContactsAndDisplacements)
{
  EXPECT_EQ(table("run.csv"),
            "scene_hash,seed,version,open_ends,start [s],end [s]\n0123456789abcdef,7,1.2.3,1,0,2.5\n");
  EXPECT_EQ(table("drift.csv"),
            "time [s],species,disks,displacement [m]\n"
            "0,A,10,0\n0,long-name,1,0\n2.5,A,6,0.03\n2.5,long-name,0,\n");
  EXPECT_EQ(table("drive.csv"),
            "time [s],inclination [rad],commanded_inclination [rad],frequency [Hz],commanded_frequency [Hz],"
            "amplitude [m],commanded_amplitude [m]\n0.5,0.125,0.25,23,30,0.002,0.003\n");
  EXPECT_EQ(
      table("contacts.csv"),
      "time [s],disk_disk,left_slope,right_slope,apex,wall,level,short_to_long,window_start [s],window_end "
      "[s],"
      "disk_disk_rate [1/s],left_slope_rate [1/s],right_slope_rate [1/s],apex_rate [1/s],wall_rate [1/s],"
      "level_rate [1/s],collision_rate [1/s]\n"
      "2.5,100,20,40,3,0,0,0.5,2.25,2.375,50,5,10,0.5,0,0,65.5\n");
  EXPECT_EQ(table("displacements.csv"),
            "time [s],species,from [m],to [m],count,density [1/m]\n"
            "2.5,long-name,-0.5,-0.25,1,1\n2.5,long-name,-0.25,0,3,3\n");
}

TEST(AnalysisTablesIntoAFile, AreRefused)
{
  const ScratchDirectory directory;
  std::ofstream(directory / "file") << "x";
  EXPECT_THROW(writeTables(handMadeResult(), directory / "file"), OutputError);
}

}  // namespace
}  // namespace ratchet_sieve

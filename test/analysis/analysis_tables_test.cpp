#include "ratchet_sieve/analysis/analysis_tables.h"

#include <gtest/gtest.h>

#include "hand_made_result.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "recording/small_scenes.h"

namespace ratchet_sieve
{
namespace
{

class AnalysisTables : public testing::Test
{
protected:
  AnalysisTables() : paths_(writeTables(handMadeResult(), directory_ / "new/sub")) {}

  std::string table(const std::string& name) const { return contents(directory_ / "new/sub/" + name); }

  ScratchDirectory directory_;
  std::vector<std::string> paths_;
};

TEST_F(AnalysisTables, StandWhereTheyAreSaidToBe)
{
  EXPECT_EQ(paths_.size(), 7u);
  for (const std::string& path : paths_)
    EXPECT_TRUE(std::filesystem::is_regular_file(path)) << path;
}

TEST_F(AnalysisTables, HoldTheBins)
{
  EXPECT_EQ(table("bins.csv"),
            "time,species,left,right,on_base\n"
            "0,A,0,0,10\n0,long-name,0,0,1\n2.5,A,1,3,6\n2.5,long-name,1,0,0\n");
}

TEST_F(AnalysisTables, LeaveEmptyWhatIsNotDefined)
{
  EXPECT_EQ(table("segregation.csv"), "time,quality,processed\n0,,\n2.5,0.75,0.5\n");
  EXPECT_EQ(table("velocities.csv"),
            "species,disks,mean_vx,mean_vx_stderr\nA,10,0.0125,0.0005\nlong-name,1,-0.25,\n");
  EXPECT_EQ(table("statistics.csv"),
            "time,species,mean_vx,mean_vx_stderr,granular_temperature\n"
            "2.5,A,0.5,,0.25\n2.5,long-name,,,0\n");
}

TEST_F(AnalysisTables, HoldDriveContactsAndDisplacements)
{
  EXPECT_EQ(table("drive.csv"),
            "time,inclination,commanded_inclination,frequency,commanded_frequency,amplitude,"
            "commanded_amplitude\n0.5,0.125,0.25,23,30,0.002,0.003\n");
  EXPECT_EQ(table("contacts.csv"),
            "time,disk_disk,left_slope,right_slope,apex,wall,short_to_long,collision_rate\n"
            "2.5,100,20,40,3,0,0.5,65.5\n");
  EXPECT_EQ(table("displacements.csv"),
            "time,species,from,to,count,density\n"
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

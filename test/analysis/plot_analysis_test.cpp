// The plotting programs of the Python package, run on tables written by writeTables().
#include <cstdlib>

#include <gtest/gtest.h>

#include "hand_made_result.h"
#include "ratchet_sieve/analysis/analysis_tables.h"
#include "recording/small_scenes.h"

namespace ratchet_sieve
{
namespace
{

int draw(const std::string& directory, const std::string& output, const std::string& name = "analysis",
         const std::string& options = "")
{
  return std::system(("/usr/bin/python3 -m ratchet_sieve.plots." + name + " " + directory + options + " >" +
                      output + " 2>&1")
                         .c_str());
}

/// Whether a file is a PNG of a reasonable size, by its signature and the width and height in its header.
bool isPicture(const std::string& path)
{
  const std::string bytes = contents(path);
  if (bytes.size() < 24 || bytes.substr(0, 8) != "\x89PNG\r\n\x1a\n")
    return false;
  const auto number = [&bytes](std::size_t at)
  {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = 256 * value + static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return number(16) > 500 && number(20) > 300;
}

/// @param result_picture the picture of bins and segregation, or of the drift if no disk can leave
void expectPictures(const RunResult& result, const char* result_picture)
{
  const ScratchDirectory directory;
  writeTables(result, directory / "");
  ASSERT_EQ(draw(directory / "", directory / "output"), 0) << contents(directory / "output");
  for (const char* name :
       {result_picture, "displacements.png", "velocities.png", "temperature.png", "contacts.png"})
  {
    EXPECT_TRUE(isPicture(directory / name)) << name;
    EXPECT_NE(contents(directory / "output").find(name), std::string::npos);
  }
  for (const Observed& observed : result.observed)
    EXPECT_TRUE(isPicture(directory / (observed.name + ".png"))) << observed.name;
}

TEST(PlotAnalysis, DrawsAResult)
{
  expectPictures(handMadeResult(), "segregation.png");
}

TEST(PlotAnalysis, DrawsTheDriftWhereNoDiskCanLeave)
{
  RunResult result = handMadeResult();
  result.scene.boundary = Boundary::PERIODIC;
  result.observed.clear();
  for (BinFrame& frame : result.bins)
    frame.bins = {{0, 0, 10}, {0, 0, 1}};
  expectPictures(result, "drift.png");
}

TEST(PlotAnalysis, DrawsARunInWhichNothingIsDefined)
{
  RunResult result = handMadeResult();
  result.scene.boundary = Boundary::PERIODIC;
  result.velocities = {{}, {}};
  result.displacement_distributions.clear();
  result.bins.clear();
  result.base.clear();
  result.statistics.clear();
  result.drift.clear();
  for (Observed& observed : result.observed)
    for (ObservedRow& row : observed.rows)
      for (ObservedColumn& column : row.table)
        column.values.clear();
  expectPictures(result, "drift.png");
}

TEST(PlotAnalysis, SaysWhichTableIsMissing)
{
  for (const char* name : {"analysis", "seek"})
  {
    const ScratchDirectory directory;
    EXPECT_NE(draw(directory / "none", directory / "output", name), 0);
    const std::string output = contents(directory / "output");
    EXPECT_NE(output.find(".csv"), std::string::npos) << output;
    EXPECT_EQ(output.find("Traceback"), std::string::npos) << output;
  }
}

TEST(PlotSeek, DrawsASearch)
{
  RunResult without_bins = handMadeResult();
  without_bins.bins.clear();
  for (const RunResult& result : {handMadeResult(), without_bins})
  {
    const ScratchDirectory directory;
    writeTables(result, directory / "");
    ASSERT_EQ(draw(directory / "", directory / "output", "seek", " --window 0.1 --best 0 1 0.1 0.5"), 0)
        << contents(directory / "output");
    EXPECT_TRUE(isPicture(directory / "seek.png"));
  }
}

}  // namespace
}  // namespace ratchet_sieve

// sieve_analyze run as a program, on a bag recorded by sieve_run.
#include <algorithm>
#include <cstdlib>

#include <sys/wait.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "recording/small_scenes.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::json;

class SieveAnalyze : public testing::Test
{
protected:
  /// Runs a program named by an environment variable. @param limits shell commands before it
  /// @return its exit status
  int run(const char* program, const std::string& arguments, const std::string& limits = "") const
  {
    const std::string command = "(" + limits + std::string(std::getenv(program)) + " " + arguments + ") >" +
                                (directory_ / "output") + " 2>" + (directory_ / "errors");
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// A run on a short base.
  std::string record(const std::string& arguments) const
  {
    const std::string bag = directory_ / "run.bag";
    const std::string scene = std::string(std::getenv("CONFIG_DIRECTORY")) + "/paper_fig9.yaml";
    EXPECT_EQ(run("SIEVE_RUN", scene + " --set base.teeth=40 --set density=2 --bag " + bag + " --summary " +
                                   (directory_ / "run.json") + " " + arguments),
              0)
        << contents(directory_ / "errors");
    return bag;
  }

  std::string output() const { return contents(directory_ / "output"); }
  std::string errors() const { return contents(directory_ / "errors"); }
  Json json(const std::string& name) const { return Json::parse(contents(directory_ / name)); }

  ScratchDirectory directory_;
};

TEST_F(SieveAnalyze, FindsInTheBagWhatTheRunSummedUp)
{
  const std::string bag = record("--duration 10");
  ASSERT_EQ(run("SIEVE_ANALYZE", bag + " --summary " + (directory_ / "bag.json")), 0) << errors();
  const Json summary = json("run.json");
  const Json analysis = json("bag.json");
  ASSERT_FALSE(summary["quality"].is_null());
  for (const char* key : {"scene_hash", "seed", "version", "simulated_time", "quality", "processed",
                          "collisions", "short_to_long", "max_overlap"})
    EXPECT_EQ(analysis[key], summary[key]) << key;
  for (std::size_t i = 0; i < 2; ++i)
  {
    for (const char* key : {"name", "count", "left", "right", "collision_rate", "kinetic_translational"})
      EXPECT_EQ(analysis["species"][i][key], summary["species"][i][key]) << key;
    // Disks that left were last seen up to one frame before.
    EXPECT_NEAR(analysis["species"][i]["mean_vx"].get<double>(),
                summary["species"][i]["mean_vx"].get<double>(),
                summary["species"][i]["mean_vx_stderr"].get<double>());
  }
}

TEST_F(SieveAnalyze, WritesAPageOfWhatItFinds)
{
  const std::string page = directory_ / "run.html";
  ASSERT_EQ(run("SIEVE_ANALYZE",
                record("--duration 1") + " --html " + page + " --summary " + (directory_ / "bag.json")),
            0)
      << errors();
  EXPECT_NE(output().find("\nPage: " + page + "\n"), std::string::npos) << output();
  const std::string html = contents(page);
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = html.find(begin) + begin.size();
  const Json data = Json::parse(html.substr(from, html.find("</script>", from) - from));
  EXPECT_EQ(data["title"], "run.bag");
  EXPECT_EQ(data["results"], json("bag.json"));
}

TEST_F(SieveAnalyze, FindsInTheBagWhatTheSceneObservesAndPrintsATableAndThePathsOfTheFiles)
{
  const std::string bag = record(
      "--duration 4 --set 'observe=[residence_times, height_profile, mass_flow]' "
      "--set 'species.1.size={distribution: uniform, spread: 0.3}'");
  ASSERT_EQ(run("SIEVE_ANALYZE",
                bag + " --summary " + (directory_ / "bag.json") + " --out " + (directory_ / "out")),
            0)
      << errors();
  const std::string text = output();
  EXPECT_NE(text.find("<V_x> [mm/s]"), std::string::npos) << text;
  std::istringstream lines(text.substr(text.find("Tables and plots:\n")));
  std::size_t files = 0;
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line); ++files)
    EXPECT_TRUE(std::filesystem::is_regular_file(line)) << line;
  EXPECT_EQ(files, 23u);

  const Json summary = json("run.json");
  const Json analysis = json("bag.json");
  for (const char* key : {"residence_times", "height_profile", "mass_flow"})
  {
    EXPECT_EQ(analysis[key], summary[key]) << key;
    for (const char* end : {".csv", ".png"})
      EXPECT_TRUE(std::filesystem::exists(directory_ / ("out/" + std::string(key) + end))) << key << end;
  }
  const Json& classes = summary["species"][1]["size_classes"];
  const Json& table = analysis["size_classes"][0]["table"];
  EXPECT_EQ(analysis["size_classes"][0]["size_quality"], summary["species"][1]["size_quality"]);
  ASSERT_EQ(table["left"].size(), classes.size());
  for (std::size_t k = 0; k < classes.size(); ++k)
    for (const char* key : {"left", "right", "mean_vx"})
      EXPECT_EQ(table[key][k], classes[k][key]) << key;
  EXPECT_TRUE(std::filesystem::exists(directory_ / "out/size_classes.png"));
  EXPECT_EQ(run("SIEVE_RESIMULATE", bag), 0) << errors();
}

/// A limit on the file size has the same effect as a full disk [blocks of 512 bytes].
TEST_F(SieveAnalyze, NamesTheFileForWhichThereIsNoRoom)
{
  const std::string bag = record("--duration 1");
  const std::string out = directory_ / "out";
  EXPECT_EQ(run("SIEVE_ANALYZE", bag + " --out " + out, "ulimit -f 2; trap '' XFSZ; "), 1);
  EXPECT_EQ(errors().rfind("sieve_analyze: " + out + "/", 0), 0u) << errors();
  EXPECT_NE(errors().find(".csv: cannot be written: "), std::string::npos) << errors();
  EXPECT_EQ(output().find("Tables and plots"), std::string::npos);
  EXPECT_EQ(run("SIEVE_ANALYZE", bag + " --out " + out, "ulimit -f 60; "), 1);
  EXPECT_EQ(errors(), "ratchet_sieve.plots.analysis: " + out + "/segregation.png: File too large\n");
  EXPECT_EQ(run("SIEVE_ANALYZE", bag + " >/dev/full"), 1);
  EXPECT_EQ(errors(), "sieve_analyze: standard output: cannot be written: No space left on device\n");
}

TEST_F(SieveAnalyze, WritesTheOtherFilesWhereOneFails)
{
  const std::string bag = record("--duration 1");
  EXPECT_EQ(run("SIEVE_ANALYZE", bag + " --html /dev/full --summary " + (directory_ / "bag.json") +
                                     " --out " + (directory_ / "out")),
            1);
  EXPECT_EQ(errors(), "sieve_analyze: /dev/full: cannot be written: No space left on device\n");
  EXPECT_EQ(json("bag.json")["scene_hash"], json("run.json")["scene_hash"]);
  EXPECT_TRUE(std::filesystem::exists(directory_ / "out/segregation.png"));
}

TEST_F(SieveAnalyze, RefusesToWriteOverTheBagOrAnotherFile)
{
  const std::string bag = record("--duration 0");
  const std::string recorded = contents(bag);
  for (const char* output : {"--summary", "--html"})
  {
    EXPECT_EQ(run("SIEVE_ANALYZE", bag + ' ' + output + ' ' + bag), 2);
    EXPECT_EQ(errors(),
              "sieve_analyze: " + (output + (' ' + bag)) + ": is the file of BAG; must be another one\n");
  }
  const std::string table = directory_ / "run.csv";
  EXPECT_EQ(run("SIEVE_ANALYZE", bag + " --summary " + table + " --out " + (directory_ / "")), 2);
  EXPECT_EQ(errors().rfind("sieve_analyze: --out ", 0), 0u) << errors();
  EXPECT_EQ(contents(bag), recorded);
  EXPECT_FALSE(std::filesystem::exists(table));
}

TEST_F(SieveAnalyze, RefusesWhatIsNoBag)
{
  std::ofstream(directory_ / "no.bag") << "not a bag";
  for (const std::string& bag : {directory_ / "no.bag", directory_ / "missing.bag"})
  {
    EXPECT_EQ(run("SIEVE_ANALYZE", bag + " --summary " + (directory_ / "bag.json")), 1);
    EXPECT_EQ(errors().rfind("sieve_analyze: " + bag, 0), 0u) << errors();
    EXPECT_EQ(output(), "");
    const std::string text = errors();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
    EXPECT_FALSE(std::filesystem::exists(directory_ / "bag.json"));
  }
}

TEST_F(SieveAnalyze, RefusesBadArguments)
{
  EXPECT_EQ(run("SIEVE_ANALYZE", ""), 2);
  EXPECT_EQ(errors(), "sieve_analyze: BAG is required; see --help\n");
  EXPECT_EQ(run("SIEVE_ANALYZE", "--help"), 0);
  EXPECT_NE(output().find("--out"), std::string::npos);
  EXPECT_EQ(run("SIEVE_ANALYZE", "--version"), 0);
  EXPECT_EQ(output().rfind("sieve_analyze ", 0), 0u) << output();
}

}  // namespace
}  // namespace ratchet_sieve

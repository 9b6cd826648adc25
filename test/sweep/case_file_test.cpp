#include "ratchet_sieve/sweep/case_file.h"

#include <gtest/gtest.h>

#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/sweep/case_run.h"
#include "ratchet_sieve/sweep/sweep.h"
#include "sweep_files.h"

namespace ratchet_sieve
{
namespace
{

class CaseFile : public testing::Test
{
protected:
  CaseFile()
  {
    const Sweep sweep =
        loadSweep(written(directory_, "s.yaml",
                          std::string(SMALL_SCENE) + "grid: {base.inclination: [0.1, 0.2]}\n"
                                                     "set: {base.phase: 1000, duration: 0.1}\n"
                                                     "seed: {first: 18446744073709551615, count: 1}\n"));
    CaseBuilder builder(sweep);
    cases_ = {builder.at(0), builder.at(1)};
    writeCaseFile(path_, cases_);
  }

  std::string complaint(const std::string& text) const
  {
    std::ofstream(path_) << text;
    try
    {
      runCaseFile(path_, {});
    }
    catch (const CaseFileError& error)
    {
      return error.what();
    }
    return "taken";
  }

  ScratchDirectory directory_;
  std::string path_ = directory_ / "0.case";
  std::vector<SweepCase> cases_;
};

TEST_F(CaseFile, GivesTheResultsThatTheCasesHave)
{
  EXPECT_TRUE(runCaseFile(path_, {}));
  const std::vector<CaseResult> results = readResultFile(directory_ / "0.results");
  ASSERT_EQ(results.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k)
  {
    nlohmann::ordered_json here = runCase(cases_[k], {})->summary;
    nlohmann::ordered_json there = results[k].summary;
    EXPECT_FALSE(there["warnings"].empty());  // about the phase
    here.erase("wall_time");
    there.erase("wall_time");
    EXPECT_EQ(there, here);
    EXPECT_EQ(results[k].run_hash, runHash(cases_[k].scene));
    EXPECT_EQ(results[k].host, hostName());
  }
}

TEST_F(CaseFile, IsNotRunTwice)
{
  std::ofstream(directory_ / "0.results") << "there";
  EXPECT_TRUE(runCaseFile(path_, {}));
  EXPECT_EQ(contents(directory_ / "0.results"), "there");
}

TEST_F(CaseFile, LeavesNothingWhereItIsStopped)
{
  EXPECT_FALSE(runCaseFile(path_, [] { return true; }));
  EXPECT_FALSE(std::filesystem::exists(directory_ / "0.results"));
}

TEST_F(CaseFile, IsRefusedWhereItIsNotWholeOrNotOfThisVersion)
{
  const std::string whole = contents(path_);
  EXPECT_NE(complaint("").find("cannot be read"), std::string::npos);
  EXPECT_NE(complaint(whole.substr(0, whole.size() - 10)).find("is damaged"), std::string::npos);
  EXPECT_NE(complaint(whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1))
                .find("is no complete file of cases"),
            std::string::npos);
  std::string other_version = whole;
  other_version.replace(other_version.find("\"version\":\"") + 11, 1, "9");
  EXPECT_NE(complaint(other_version).find("is no complete file of cases of version"), std::string::npos);
  std::string other_scene = whole;
  other_scene.replace(other_scene.find("gravity: 9.81"), 13, "gravity: 9.82");
  EXPECT_NE(complaint(other_scene).find("the hash of a scene does not match"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(directory_ / "0.results"));
}

}  // namespace
}  // namespace ratchet_sieve

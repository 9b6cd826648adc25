// The selection of a sweep's best setting. The results are written by hand into the table of a completed
// sweep.
#include "ratchet_sieve/sweep/best_setting.h"

#include <cmath>

#include <gtest/gtest.h>

#include "ratchet_sieve/sweep/sweep_report.h"
#include "ratchet_sieve/sweep/sweep_run.h"
#include "sweep_files.h"

namespace ratchet_sieve
{
namespace
{

class BestSetting : public testing::Test
{
protected:
  BestSetting()
  {
    runSweep(sweep_, results_, {});
    give("0", {0.95, 0.1, 0.15}, 1.0, 200);
    give("0.1", {0.5, 0.6, 0.55}, 0.9, 100);
    give("0.2", {0.3, 0.3, 0.3}, 1.0, 200);
    give("0.3", {1.0, 1.0, 1.0}, 1.0, 4);
    give("0.4", {0.9, 0.9, 0.9}, 0.04, 100);
  }

  void change(const std::string& sql) { Database(results_, Database::Access::WRITE).execute(sql); }

  void give(const std::string& inclination, const std::vector<double>& qualities, double processed,
            int counted)
  {
    for (std::size_t k = 0; k < qualities.size(); ++k)
      change("UPDATE cases SET separation = " + std::to_string(-qualities[k]) +
             ", processed = " + std::to_string(processed) + ", counted = " + std::to_string(counted) +
             " WHERE \"base.inclination\" = " + inclination + " AND seed = " + std::to_string(k + 1));
  }

  std::optional<SettingMean> best(const BestCriteria& criteria = {})
  {
    ResultStore store(results_, Database::Access::READ);
    return bestSetting(store, *SweepPlan::find(store.database(), sweep_), sweep_, criteria);
  }

  ScratchDirectory directory_;
  std::string results_ = directory_ / "r.db";
  Sweep sweep_ =
      loadSweep(written(directory_, "s.yaml",
                        SMALL_SCENE + std::string("grid: {base.inclination: [0, 0.1, 0.2, 0.3, 0.4]}\n"
                                                  "set: {duration: 0.01}\n"
                                                  "seed: {first: 1, count: 3}\n")));
};

TEST_F(BestSetting, IsOfTheHighestMeanNotOfOneLuckySeed)
{
  const std::optional<SettingMean> found = best();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->point, 1u);
  EXPECT_EQ(found->seeds, 3u);
  EXPECT_EQ(found->separated(), true);
  EXPECT_NEAR(found->quality(), 0.55, 1e-12);
  EXPECT_NEAR(*found->error, 0.05 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(found->processed, 0.9, 1e-12);
  EXPECT_NEAR(found->counted, 100.0, 1e-12);
}

TEST_F(BestSetting, LeavesOutWhatHasTooFewDisksOrTooLowAP)
{
  BestCriteria criteria;
  criteria.least_counted = 0.0;
  EXPECT_EQ(best(criteria)->point, 3u);
  criteria.least_counted = 50.0;
  criteria.least_processed = 0.0;
  EXPECT_EQ(best(criteria)->point, 4u);
  criteria.least_counted = 1000.0;
  EXPECT_FALSE(best(criteria));
  EXPECT_NE(statusText(sweep_, results_, criteria)
                .find("no best Q: no setting with all seeds completed has a mean P >= 0 and a mean of 1000 "
                      "counted disks (--least-processed, --least-counted)\n"),
            std::string::npos)
      << statusText(sweep_, results_, criteria);
}

TEST_F(BestSetting, LeavesOutWhatIsNotDoneYetAndCasesThatFailed)
{
  change("DELETE FROM cases WHERE \"base.inclination\" = 0.1 AND seed = 2");
  EXPECT_EQ(best()->point, 0u);
  change("UPDATE cases SET status = 'failed' WHERE \"base.inclination\" = 0 AND seed = 1");
  EXPECT_EQ(best()->point, 2u);
  EXPECT_EQ(best()->seeds, 3u);
}

TEST_F(BestSetting, CountsDisksOfRowsThatHaveNoSuchColumnByTheirSummary)
{
  change(
      "UPDATE cases SET counted = NULL, summary = json_set(summary, '$.species[0].left', 30, "
      "'$.species[1].right', 30)");
  EXPECT_EQ(best()->counted, 60.0);
}

TEST_F(BestSetting, IsAmongTheValuesThatAreAskedFor)
{
  BestCriteria criteria;
  criteria.where = {{"base.inclination", "0.20"}};
  EXPECT_EQ(best(criteria)->point, 2u);
  criteria.where = {{"base.inclination", "0.7"}};
  EXPECT_FALSE(best(criteria));
}

TEST_F(BestSetting, TellsOfTheGridsEdge)
{
  EXPECT_EQ(keysAtEdge(sweep_, 0, {}), std::vector<std::string>{"base.inclination"});
  EXPECT_EQ(keysAtEdge(sweep_, 4, {}), std::vector<std::string>{"base.inclination"});
  EXPECT_TRUE(keysAtEdge(sweep_, 1, {}).empty());
  EXPECT_TRUE(keysAtEdge(sweep_, 0, {{"base.inclination", "0"}}).empty());
  const Sweep two = loadSweep(written(directory_, "t.yaml",
                                      SMALL_SCENE + std::string("grid: {gravity: [8, 9], boundary: [open, "
                                                                "walled, periodic]}\n")));
  EXPECT_TRUE(keysAtEdge(two, 0, {}).empty());
}

TEST_F(BestSetting, IsSaidWithItsErrorAndWithoutOneOfOneSeed)
{
  EXPECT_NE(
      statusText(sweep_, results_)
          .find("best mean Q 0.550 +- 0.029 over 3 seeds, P 0.90, 100 disks counted: base.inclination=0.1\n"),
      std::string::npos)
      << statusText(sweep_, results_);
  change("UPDATE cases SET separation = separation * (2 - seed)");
  EXPECT_NE(statusText(sweep_, results_)
                .find("not separated: the interval of 95 % contains 0 even at the largest mean Q, 0."),
            std::string::npos)
      << statusText(sweep_, results_);
  change("UPDATE cases SET separation = NULL WHERE seed > 1");
  EXPECT_NE(statusText(sweep_, results_)
                .find("best mean Q 0.950 over 1 seed (error unknown), P 1.00, 200 disks counted: "
                      "base.inclination=0; at the grid's edge in base.inclination\n"),
            std::string::npos)
      << statusText(sweep_, results_);
}

}  // namespace
}  // namespace ratchet_sieve

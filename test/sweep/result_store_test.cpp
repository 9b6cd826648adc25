#include "ratchet_sieve/sweep/result_store.h"

#include <gtest/gtest.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/version.h"
#include "recording/errors.h"
#include "sweep_files.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

CaseResult resultOf(const std::string& run_hash)
{
  CaseResult result;
  result.run_hash = run_hash;
  result.scene_hash = "abc";
  result.seed = 3;
  result.host = "here";
  result.summary = {{"quality", 0.1}, {"processed", nullptr}, {"events", 12}, {"reached", true}};
  return result;
}

class ResultStoreTest : public testing::Test
{
protected:
  void record(const CaseResult& result)
  {
    Transaction transaction(store_.database());
    store_.record(result);
    transaction.commit();
  }
  std::string text(const std::string& query) { return textOf(path_, query); }

  ScratchDirectory directory_;
  std::string path_ = directory_ / "r.db";
  ResultStore store_{path_, Database::Access::WRITE};
};

TEST_F(ResultStoreTest, KeepsValuesAsWhatTheyAre)
{
  CaseResult result = resultOf("1");
  result.values = {{"a.b", "0.1"}, {"c", "20"}, {"d \"e\"", "open"}, {"f", std::nullopt}, {"g", "1e400"}};
  record(result);
  EXPECT_EQ(text("SELECT typeof(\"a.b\") || typeof(c) || typeof(\"d \"\"e\"\"\") || typeof(f) || typeof(g) "
                 "FROM cases"),
            "realintegertextnulltext");
  EXPECT_EQ(text("SELECT \"a.b\" = 0.1 AND c = 20 AND quality = 0.1 AND processed IS NULL AND events = 12 "
                 "AND reached = 1 FROM cases"),
            "1");
  EXPECT_EQ(text("SELECT status || seed || host || version || physics FROM cases"),
            std::string("done3here") + version() + std::to_string(PHYSICS_VERSION));
  EXPECT_EQ(text("SELECT json_extract(summary, '$.events') FROM cases"), "12");
}

TEST_F(ResultStoreTest, CountsACaseOnce)
{
  record(resultOf("1"));
  CaseResult again = resultOf("1");
  again.error = "should not be seen";
  record(again);
  record(resultOf("2"));
  EXPECT_EQ(text("SELECT COUNT(*) || ' ' || SUM(status = 'done') FROM cases"), "2 2");
}

TEST_F(ResultStoreTest, GrowsColumnsWithWhatComes)
{
  CaseResult done = resultOf("1");
  done.values = {{"a", "5"}};
  record(done);
  CaseResult failed = resultOf("2");
  failed.error = "it stalls";
  failed.summary = nullptr;
  failed.values = {{"A.c", "x"}};
  record(failed);
  EXPECT_EQ(text("SELECT \"A.c\" || error || (summary IS NULL) || (quality IS NULL) FROM cases WHERE "
                 "run_hash = '2'"),
            "xit stalls11");
}

TEST_F(ResultStoreTest, KeepsARowWhoseSummaryHasMoreThanATableHolds)
{
  CaseResult result = resultOf("1");
  for (int k = 0; k < 3000; ++k)
    result.summary["key" + std::to_string(k)] = k;
  result.summary["Status"] = 3;
  result.summary["Quality"] = 4;
  result.summary[""] = 5;
  result.summary[std::string("a\0b", 3)] = 6;
  result.summary[std::string(1000, 'x')] = 7;
  result.values = {{"a", "5"}};
  record(result);
  EXPECT_EQ(text("SELECT a || status || quality || key900 FROM cases"), "5done0.1900");
  EXPECT_EQ(text("SELECT json_extract(summary, '$.key2999') FROM cases"), "2999");
  CaseResult other_keys = resultOf("2");
  other_keys.values = {{"b", "6"}};
  record(other_keys);
  EXPECT_EQ(text("SELECT b FROM cases WHERE run_hash = '2'"), "6");
}

TEST_F(ResultStoreTest, IsAFile)
{
  for (const char* path : {"/dev/null", ":memory:"})
    EXPECT_THROW(Database(path, Database::Access::WRITE), DatabaseError);
  EXPECT_FALSE(std::filesystem::exists(":memory:"));
}

TEST_F(ResultStoreTest, CommitsToNoFileThatIsGoneOrAnother)
{
  record(resultOf("1"));
  std::filesystem::rename(path_, directory_ / "other.db");
  EXPECT_THROW(record(resultOf("2")), DatabaseError);
  const ResultStore new_one(path_, Database::Access::WRITE);
  EXPECT_THROW(record(resultOf("3")), DatabaseError);
}

TEST_F(ResultStoreTest, RefusesAFileThatIsNone)
{
  const auto complaint = [](const std::string& path)
  { return errorOf<DatabaseError>([&] { const ResultStore store(path, Database::Access::WRITE); }); };
  const std::string text_file = written(directory_, "text", std::string(5000, 'x'));
  EXPECT_EQ(complaint(text_file), text_file + ": file is not a database");
  const std::string foreign = directory_ / "foreign.db";
  Database(foreign, Database::Access::WRITE).execute("CREATE TABLE cases (a)");
  EXPECT_EQ(complaint(foreign), foreign + ": is no results file of sieve_sweep");
  const std::string later = directory_ / "later.db";
  ResultStore(later, Database::Access::WRITE).database().execute("PRAGMA user_version = 999");
  EXPECT_EQ(complaint(later),
            later + ": is a results file of format 999, but ratchet_sieve " + version() + " reads format 1");
}

TEST(SummaryColumns, AreTheScalars)
{
  const Json summary = {
      {"seed", 3},
      {"quality", nullptr},
      {"collisions", {{"apex", 2}, {"wall", 0}}},
      {"species",
       {{{"name", "A"},
         {"mean_vx", 0.5},
         {"left", 3},
         {"right", 4},
         {"size_classes", {{{"radius", {0.1, 0.2}}, {"left", 1}}, {{"radius", {0.2, 0.3}}, {"left", 2}}}}},
        {{"name", "B"}, {"mean_vx", nullptr}, {"left", 0}, {"right", 5}}}},
      {"accuracy",
       {{"reached", true},
        {"mean_vx", {{{"name", "A"}, {"half_width", 0.1}}, {{"name", "B"}, {"half_width", nullptr}}}},
        {"quality", {{"value", 0.25}}}}},
      {"height_profile", {{{"name", "A"}, {"mean_height", 0.01}, {"table", {{"from", {0.0}}}}}}},
      {"mass_flow", {{"left", {{{"name", "B"}, {"mean", 0.02}}}}}},
      {"steady",
       {{"inside", {{"value", 3.5}}},
        {"purity", {{"left", {{{"name", "A"}, {"mass", {{"value", 0.5}, {"half_width", 0.125}}}}}}}}}},
      {"steady_reason", nullptr},
      {"base_impulse", {1.0, 2.0}},
      {"plan", {{"pairs", true}}},
      {"warnings", {"one", "two"}}};
  Json columns = Json::object();
  for (const auto& [name, value] : summaryColumns(summary))
    columns[name] = value;
  EXPECT_EQ(
      columns.dump(),
      R"({"quality":null,"collisions.apex":2,"collisions.wall":0,"mean_vx.A":0.5,"left.A":3,"right.A":4,)"
      R"("mean_vx.B":null,"left.B":0,"right.B":5,"counted":12,)"
      R"("accuracy.reached":true,"accuracy.mean_vx.half_width.A":0.1,"accuracy.mean_vx.half_width.B":null,)"
      R"("accuracy.quality.value":0.25,"height_profile.mean_height.A":0.01,"mass_flow.left.mean.B":0.02,)"
      R"("steady.inside.value":3.5,"steady.purity.left.mass.value.A":0.5,)"
      R"("steady.purity.left.mass.half_width.A":0.125,"steady_reason":null,)"
      R"("base_impulse.x":1.0,"base_impulse.y":2.0,"warnings":2,)"
      R"("warning_text":"one | two","size_classes.1.left.A":1,"size_classes.2.left.A":2})");
}

TEST(SummaryColumns, OfAMachineThatIsNotSteadyHaveTheReason)
{
  const SummaryColumns columns = summaryColumns({{"steady", nullptr}, {"steady_reason", "no feed"}});
  ASSERT_EQ(columns.size(), 1u);
  EXPECT_EQ(columns[0].first, "steady_reason");
  EXPECT_EQ(columns[0].second, "no feed");
}

TEST(SummaryColumns, TellSpeciesApartThatSqlDoesNot)
{
  const auto columns = [](const Json& species)
  {
    Json names = Json::object();
    for (const auto& [name, value] : summaryColumns({{"species", species}}))
      names[name] = value;
    return names;
  };
  const Json small = {{"name", "a"}, {"left", 1}};
  const Json large = {{"name", "A"}, {"left", 2}};
  EXPECT_EQ(columns(Json::array({small, large})), Json({{"left.a (2)", 1}, {"left.A", 2}, {"counted", 3}}));
  EXPECT_EQ(columns(Json::array({large, small})), Json({{"left.A", 2}, {"left.a (2)", 1}, {"counted", 3}}));
  EXPECT_EQ(columns(Json::array({small})), Json({{"left.a", 1}, {"counted", 1}}));
}

}  // namespace
}  // namespace ratchet_sieve

#include "ratchet_sieve/sweep/result_store.h"

#include <gtest/gtest.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/version.h"
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
  result.summary = {{"quality", 0.1}, {"processed", nullptr}, {"events", 12}};
  return result;
}

class ResultStoreTest : public testing::Test
{
protected:
  void record(const std::vector<std::string>& keys, const CaseResult& result)
  {
    Transaction transaction(store_.database());
    store_.record(keys, result);
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
  result.values = {"0.1", "20", "open", std::nullopt, "1e400"};
  record({"a.b", "c", "d \"e\"", "f", "g"}, result);
  EXPECT_EQ(text("SELECT typeof(\"a.b\") || typeof(c) || typeof(\"d \"\"e\"\"\") || typeof(f) || typeof(g) "
                 "FROM cases"),
            "realintegertextnulltext");
  EXPECT_EQ(text("SELECT \"a.b\" = 0.1 AND c = 20 AND quality = 0.1 AND processed IS NULL AND events = 12 "
                 "FROM cases"),
            "1");
  EXPECT_EQ(text("SELECT status || seed || host || version || physics FROM cases"),
            std::string("done3here") + version() + std::to_string(PHYSICS_VERSION));
  EXPECT_EQ(text("SELECT json_extract(summary, '$.events') FROM cases"), "12");
}

TEST_F(ResultStoreTest, CountsACaseOnce)
{
  record({}, resultOf("1"));
  CaseResult again = resultOf("1");
  again.error = "should not be seen";
  record({}, again);
  record({}, resultOf("2"));
  EXPECT_EQ(text("SELECT COUNT(*) || ' ' || SUM(status = 'done') FROM cases"), "2 2");
}

TEST_F(ResultStoreTest, GrowsColumnsWithWhatComes)
{
  CaseResult done = resultOf("1");
  done.values = {"5"};
  record({"a"}, done);
  CaseResult failed = resultOf("2");
  failed.error = "it stalls";
  failed.summary = nullptr;
  failed.values = {"x"};
  record({"A.c"}, failed);
  EXPECT_EQ(text("SELECT \"A.c\" || error || (summary IS NULL) || (quality IS NULL) FROM cases WHERE "
                 "run_hash = '2'"),
            "xit stalls11");
}

TEST_F(ResultStoreTest, ToleratesColumnsOfAnotherProcess)
{
  ResultStore other(path_, Database::Access::WRITE);
  CaseResult first = resultOf("1");
  first.values = {"4"};
  record({"a"}, first);
  {
    Transaction transaction(other.database());
    CaseResult result = resultOf("2");
    result.values = {"5"};
    other.record({"a"}, result);
    transaction.commit();
  }
  EXPECT_EQ(text("SELECT a FROM cases WHERE run_hash = '2'"), "5");
}

TEST_F(ResultStoreTest, UndoesColumnsWithTheTransaction)
{
  CaseResult result = resultOf("1");
  result.values = {"5"};
  {
    const Transaction transaction(store_.database());
    store_.record({"a"}, result);
  }
  store_.forgetColumns();
  EXPECT_FALSE(store_.hasColumn("a"));
  record({"a"}, result);
  EXPECT_EQ(text("SELECT SUM(a) || COUNT(*) FROM cases"), "51");
}

TEST_F(ResultStoreTest, RefusesAFileThatIsNone)
{
  const auto complaint = [](const std::string& path) -> std::string
  {
    try
    {
      const ResultStore store(path, Database::Access::WRITE);
    }
    catch (const DatabaseError& error)
    {
      return error.what();
    }
    return "taken";
  };
  const std::string text_file = written(directory_, "text", std::string(5000, 'x'));
  EXPECT_EQ(complaint(text_file), text_file + ": file is not a database");
  const std::string foreign = directory_ / "foreign.db";
  Database(foreign, Database::Access::WRITE).execute("CREATE TABLE cases (a)");
  EXPECT_EQ(complaint(foreign), foreign + ": is no results file of sieve_sweep");
  store_.database().execute("PRAGMA user_version = 999");
  EXPECT_EQ(complaint(path_), path_ + ": is a results file of another format");
}

TEST(SummaryColumns, AreTheScalars)
{
  const Json summary = {
      {"seed", 3},
      {"quality", nullptr},
      {"collisions", {{"apex", 2}, {"wall", 0}}},
      {"species", {{{"name", "A"}, {"mean_vx", 0.5}}, {{"name", "B"}, {"mean_vx", nullptr}}}},
      {"accuracy",
       {{"reached", true},
        {"mean_vx", {{{"name", "A"}, {"half_width", 0.1}}, {{"name", "B"}, {"half_width", nullptr}}}},
        {"quality", {{"value", 0.25}}}}},
      {"base_impulse", {1.0, 2.0}},
      {"plan", {{"pairs", true}}},
      {"warnings", {"one", "two"}}};
  Json columns = Json::object();
  for (const auto& [name, value] : summaryColumns(summary))
    columns[name] = value;
  EXPECT_EQ(
      columns.dump(),
      R"({"quality":null,"collisions.apex":2,"collisions.wall":0,"mean_vx.A":0.5,"mean_vx.B":null,)"
      R"("accuracy.reached":true,"accuracy.mean_vx.half_width.A":0.1,"accuracy.mean_vx.half_width.B":null,)"
      R"("accuracy.quality.value":0.25,"base_impulse.x":1.0,"base_impulse.y":2.0})");
}

TEST(SummaryColumns, LeaveSpeciesOutThatSqlCannotTellApart)
{
  EXPECT_TRUE(
      summaryColumns({{"species", {{{"name", "a"}, {"left", 1}}, {{"name", "A"}, {"left", 2}}}}}).empty());
}

}  // namespace
}  // namespace ratchet_sieve

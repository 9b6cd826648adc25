#include "ratchet_sieve/page/run_page.h"

#include <gtest/gtest.h>

#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "recording/file_size_limit.h"
#include "recording/small_scenes.h"

namespace ratchet_sieve
{
namespace
{

/// Hands a whole run to a page.
void runInto(RunPage& page, const SceneDefinition& scene, double rate = PAGE_RATE)
{
  Simulation simulation(scene);
  RunWatchers watchers;
  watchers.frames = {{&page, pageRates(rate)}};
  runToEnd(simulation, watchers);
}

std::string pageOf(const RunPage& page, const std::string& title,
                   const nlohmann::ordered_json& summary = nlohmann::ordered_json::object())
{
  const ScratchDirectory directory;
  page.write(directory / "run.html", title, summary);
  return contents(directory / "run.html");
}

/// The data of a page that can be read without its script.
nlohmann::json dataOf(const std::string& page)
{
  const std::size_t begin = page.find('>', page.find(" id=\"data\">")) + 1;
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(RunPage, HoldsWhatTheAnalysisFinds)
{
  const SceneDefinition scene = smallMixture();
  RunPage page;
  runInto(page, scene);
  const nlohmann::json json =
      dataOf(pageOf(page, "a run", {{"warnings", {"a warning"}}, {"steady_reason", "no feed"}}));
  EXPECT_EQ(json["title"], "a run");
  EXPECT_EQ(json["warnings"][0], "a warning");
  EXPECT_EQ(json["results"]["steady_reason"], "no feed");
  EXPECT_EQ(json["results"]["quality"].is_null(), !page.analysis().result().lastBins()->quality.has_value());
  EXPECT_EQ(json["machine"]["boundary"], "open");
  EXPECT_EQ(json["machine"]["species"][1]["name"], "B");
  EXPECT_EQ(json["motion"]["frames"], 481u);
}

TEST(RunPage, TakesTextsForData)
{
  const std::string bad = "</script><script>alert(1)</script>";
  RunPage page;
  page.take(makeSceneFrame(Simulation(smallRing())));
  const std::string html = pageOf(page, "a & b </title><b>", {{"warnings", {bad}}});
  EXPECT_EQ(html.find(bad), std::string::npos);
  EXPECT_NE(html.find("<title>a &amp; b &lt;/title&gt;&lt;b&gt;</title>"), std::string::npos);
  EXPECT_EQ(dataOf(html)["warnings"][0], bad);
}

TEST(RunPage, KeepsToItsSize)
{
  SceneDefinition scene = smallRing();
  scene.species[0].count = scene.species[1].count = 9;
  scene.base.teeth = 20;
  scene.duration = 40.0;
  RunPage whole_page, small_page(SMALLEST_PAGE);
  runInto(whole_page, scene);
  runInto(small_page, scene);
  const std::string whole = pageOf(whole_page, "run");
  const std::string thinned = pageOf(small_page, "run");
  EXPECT_GT(whole.size(), SMALLEST_PAGE);
  EXPECT_LE(thinned.size(), SMALLEST_PAGE);
  EXPECT_GT(thinned.size(), SMALLEST_PAGE / 2);
}

TEST(RunPage, BeginsAnewWithAScene)
{
  RunPage page;
  runInto(page, smallMixture());
  runInto(page, smallRing(), 10.0);
  const nlohmann::json json = dataOf(pageOf(page, "run"));
  EXPECT_EQ(json["motion"]["frames"], 11u);
  EXPECT_EQ(json["machine"]["boundary"], "periodic");
}

TEST(RunPage, NeedsAScene)
{
  RunPage page;
  EXPECT_THROW(page.take(ParticleFrame()), AnalysisError);
  const ScratchDirectory directory;
  EXPECT_THROW(page.write(directory / "run.html", "run"), AnalysisError);
  EXPECT_TRUE(directory.empty());
}

TEST(RunPage, IsWrittenWholeOrNotAtAll)
{
  const ScratchDirectory directory;
  RunPage page;
  runInto(page, smallRing());
  {
    const FileSizeLimit limit(100'000);
    EXPECT_THROW(page.write(directory / "run.html", "run"), OutputError);
  }
  EXPECT_TRUE(directory.empty());
  EXPECT_THROW(page.write(directory / "no/run.html", "run"), OutputError);
}

}  // namespace
}  // namespace ratchet_sieve

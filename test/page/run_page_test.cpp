#include "ratchet_sieve/page/run_page.h"

#include <regex>

#include <gtest/gtest.h>

#include "html_page.h"
#include "motion_reading.h"
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

std::string pageOf(const SceneDefinition& scene, std::size_t size = USUAL_PAGE,
                   const std::vector<std::string>& warnings = {})
{
  const ScratchDirectory directory;
  RunPage page(size);
  runInto(page, scene);
  page.write(directory / "run.html", "run", warnings);
  return contents(directory / "run.html");
}

/// The text of an element that carries data.
std::string dataOf(const std::string& page, const std::string& id)
{
  const std::size_t begin = page.find('>', page.find(" id=\"" + id + "\">")) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

TEST(RunPage, HoldsWhatTheAnalysisFinds)
{
  const SceneDefinition scene = smallMixture();
  RunPage page;
  runInto(page, scene);
  const ScratchDirectory directory;
  page.write(directory / "run.html", "a run", {"a warning"});
  const auto json = nlohmann::json::parse(dataOf(contents(directory / "run.html"), "data"));
  EXPECT_EQ(json["title"], "a run");
  EXPECT_EQ(json["warnings"][0], "a warning");
  EXPECT_EQ(json["results"]["quality"].is_null(), !page.analysis().result().lastBins()->quality.has_value());
  EXPECT_EQ(json["machine"]["boundary"], "open");
  EXPECT_EQ(json["machine"]["species"][1]["name"], "B");
  EXPECT_EQ(json["motion"]["frames"], 481u);
}

TEST(RunPage, AllowsItsOwnScriptAlone)
{
  const std::string page = pageOf(smallRing());
  const std::regex policy(
      "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-[^ ]+'; "
      "style-src 'sha256-[^ ]+'; base-uri 'none'; form-action 'none'\"");
  EXPECT_TRUE(std::regex_search(page, policy));
  for (const char* outside : {" src=", "<link ", "@import", "url("})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

TEST(RunPage, TakesTextsForData)
{
  const std::string bad = "</script><script>alert(1)</script>";
  RunPage page;
  Simulation simulation(smallRing());
  SceneFrame scene = makeSceneFrame(simulation);
  scene.version = scene.scene_hash = bad;
  page.take(scene);
  page.take(makeParticleFrame(simulation));
  const ScratchDirectory directory;
  page.write(directory / "run.html", "run", {bad});
  const std::string html = contents(directory / "run.html");
  EXPECT_EQ(html.find(bad), std::string::npos);
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  const auto json = nlohmann::json::parse(dataOf(html, "data"));
  EXPECT_EQ(json["scene"]["version"], bad);
  EXPECT_EQ(json["warnings"][0], bad);
}

TEST(RunPage, TakesATitleForText)
{
  const ScratchDirectory directory;
  RunPage page;
  runInto(page, smallRing());
  page.write(directory / "run.html", "a & b </title><b>", {});
  EXPECT_NE(contents(directory / "run.html").find("<title>a &amp; b &lt;/title&gt;&lt;b&gt;</title>"),
            std::string::npos);
}

TEST(RunPage, KeepsToItsSize)
{
  SceneDefinition scene = smallRing();
  scene.species[0].count = scene.species[1].count = 9;
  scene.base.teeth = 20;
  scene.duration = 40.0;
  const std::string whole = pageOf(scene);
  const std::string thinned = pageOf(scene, SMALLEST_PAGE);
  EXPECT_GT(whole.size(), SMALLEST_PAGE);
  EXPECT_LE(thinned.size(), SMALLEST_PAGE);
  EXPECT_GT(thinned.size(), SMALLEST_PAGE / 2);
}

TEST(RunPage, FollowsTheDriveOfASceneWithoutStatesOfTheBase)
{
  const ScratchDirectory directory;
  const SceneDefinition scene = smallRing();
  RunPage page;
  const Simulation simulation(scene);
  page.take(makeSceneFrame(simulation));
  page.take(makeParticleFrame(simulation));
  page.write(directory / "run.html", "run", {});
  const auto series = nlohmann::json::parse(inflated(
      [&]
      {
        // The page's base64 is read by its own alphabet, without a library.
        const std::string text = dataOf(contents(directory / "run.html"), "series");
        const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string bytes;
        unsigned bits = 0;
        int count = 0;
        for (const char c : text)
        {
          const std::size_t value = alphabet.find(c);
          if (value == std::string::npos)
            break;
          bits = bits << 6U | static_cast<unsigned>(value);
          count += 6;
          if (count >= 8)
            bytes += static_cast<char>(bits >> static_cast<unsigned>(count -= 8) & 0xFFU);
        }
        return bytes;
      }()));
  EXPECT_EQ(series["drive"]["recorded"], false);
  EXPECT_EQ(series["drive"]["frequency"][0], scene.base.frequency);
  EXPECT_EQ(series["bins"]["time"].size(), 0u);
}

TEST(RunPage, BeginsAnewWithAScene)
{
  RunPage page;
  runInto(page, smallMixture());
  runInto(page, smallRing(), 10.0);
  const ScratchDirectory directory;
  page.write(directory / "run.html", "run", {});
  const auto json = nlohmann::json::parse(dataOf(contents(directory / "run.html"), "data"));
  EXPECT_EQ(json["motion"]["frames"], 11u);
  EXPECT_EQ(json["machine"]["boundary"], "periodic");
}

TEST(RunPage, NeedsAScene)
{
  RunPage page;
  EXPECT_THROW(page.take(ParticleFrame()), AnalysisError);
  const ScratchDirectory directory;
  EXPECT_THROW(page.write(directory / "run.html", "run", {}), AnalysisError);
  EXPECT_TRUE(directory.empty());
}

TEST(RunPage, IsWrittenWholeOrNotAtAll)
{
  const ScratchDirectory directory;
  RunPage page;
  runInto(page, smallRing());
  {
    const FileSizeLimit limit(100'000);
    EXPECT_THROW(page.write(directory / "run.html", "run", {}), OutputError);
  }
  EXPECT_TRUE(directory.empty());
  EXPECT_THROW(page.write(directory / "no/run.html", "run", {}), OutputError);
}

}  // namespace
}  // namespace ratchet_sieve

#include "ratchet_sieve/recording/checkpoint.h"

#include <gtest/gtest.h>

#include "errors.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

/// The summary without wall times.
nlohmann::ordered_json resultOf(Simulation& simulation, const RunProgress& so_far,
                                const RunWatchers& watchers = {})
{
  nlohmann::ordered_json summary = summarize(simulation, runToEnd(simulation, watchers, so_far));
  summary.erase("wall_time");
  return summary;
}

class CheckpointFile : public testing::Test
{
protected:
  /// Saves a run of the scene at its end.
  void save(const SceneDefinition& scene) const
  {
    Simulation simulation(scene);
    RunWatchers watchers;
    watchers.save = [this](const Simulation& now, const RunProgress& progress)
    { writeCheckpoint(path_, now, progress); };
    runToEnd(simulation, watchers);
  }

  void expectRefusal(const SceneDefinition& scene, const std::string& reason) const
  {
    EXPECT_EQ(errorOf<CheckpointError>([&] { readCheckpoint(path_, scene); }),
              path_ + ": cannot be resumed from: " + reason);
  }

  ScratchDirectory directory_;
  std::string path_ = directory_ / "run.checkpoint";
};

TEST_F(CheckpointFile, IsWrittenNowAndThenAndAtTheEndWithoutChangingTheRun)
{
  Simulation alone(smallRing()), saved(smallRing());
  std::vector<double> times;
  RunWatchers watchers;
  watchers.save_period = 0.0;
  watchers.save = [&times](const Simulation& now, const RunProgress&) { times.push_back(now.time()); };
  EXPECT_EQ(resultOf(saved, firstProgress(saved), watchers), resultOf(alone, firstProgress(alone)));
  EXPECT_GT(times.size(), 2u);
  EXPECT_EQ(times.back(), saved.scene().duration);
}

TEST_F(CheckpointFile, IsNotWrittenOfAnEnsembleThatHasStalledAndGoesOnToAnEpochsEnd)
{
  SceneDefinition scene = smallRing();
  scene.base.amplitude = 0.0;
  scene.contact.pair_collisions = false;
  scene.contact.min_rebound_speed = 0.0;
  scene.contact.collapse_events = 1000;
  RunWatchers watchers;
  watchers.save_period = 0.0;
  int saves = 0;
  watchers.save = [&saves](const Simulation& now, const RunProgress&)
  {
    ++saves;
    EXPECT_FALSE(now.stalled()) << now.time();
  };
  Simulation simulation(scene);
  EXPECT_EQ(runToEnd(simulation, watchers).end, RunEnd::STALLED);
  EXPECT_GT(saves, 1);
}

TEST_F(CheckpointFile, OfAnotherRunIsRefused)
{
  save(smallRing());
  SceneDefinition scene = smallRing();
  scene.seed = 77;
  expectRefusal(scene, "its seed is " + std::to_string(smallRing().seed) + ", but this scene's is 77");
  scene = smallRing();
  scene.settle = 0.25;
  expectRefusal(scene, "its settle is 0, but this scene's is 0.25");
  scene = smallRing();
  scene.duration = 0.75;
  expectRefusal(scene, "it is at 1.0 s, beyond this run's duration");
  scene = smallRing();
  scene.species.at(1).radius *= 2.0;
  expectRefusal(scene, "its species.1.radius is 0.003, but this scene's is 0.006");
  scene = smallRing();
  scene.base.harmonics.push_back({});
  expectRefusal(scene,
                "its base.harmonics is absent, but this scene's is [{multiple: 2, amplitude: 0, phase: 0, "
                "horizontal_amplitude:...");
  scene = smallRing();
  scene.species.pop_back();
  EXPECT_THROW(readCheckpoint(path_, scene), CheckpointError);
}

TEST_F(CheckpointFile, ThatIsNoneIsRefused)
{
  EXPECT_THROW(readCheckpoint(std::filesystem::temp_directory_path().string(), smallRing()), CheckpointError);
  expectRefusal(smallRing(), "no such file");
  std::ofstream(path_) << "base: {teeth: 3}\n";
  expectRefusal(smallRing(), "it is no checkpoint");
  for (const char* rest : {"6\nabc", "6"})
  {
    std::ofstream(path_) << "ratchet_sieve checkpoint " << rest;
    expectRefusal(smallRing(), std::string("its format is 6, but ratchet_sieve ") + version() + " reads 9");
  }
}

TEST_F(CheckpointFile, OfAPatchIsResumedAndOfAnotherVersionRefused)
{
  save(smallRing());
  const std::string whole = contents(path_);
  const std::size_t checksum = whole.find('\n') + 1;
  const std::string own = version();
  const auto save_as = [&](const std::string& other)
  {
    std::string content = whole.substr(whole.find('\n', checksum) + 1);
    content.replace(content.find('"' + own + '"'), own.size() + 2, '"' + other + '"');
    std::ofstream(path_, std::ios::binary) << whole.substr(0, checksum) << hashText(content) << '\n'
                                           << content;
  };
  save_as(own.substr(0, own.rfind('.')) + ".77");
  EXPECT_EQ(readCheckpoint(path_, smallRing()).simulation.time(), smallRing().duration);
  for (const std::string& other : {'1' + own, own.substr(0, own.rfind('.')) + "7.0"})
  {
    save_as(other);
    expectRefusal(smallRing(), "its version is \"" + other + "\", but this program's is \"" + own + '"');
  }
}

TEST_F(CheckpointFile, ThatIsDamagedAnywhereIsRefused)
{
  save(smallRing());
  const std::string whole = contents(path_);
  for (std::size_t place = whole.find('\n') + 1; place < whole.size(); place += 1 + whole.size() / 200)
  {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x10);
    std::ofstream(path_, std::ios::binary) << damaged;
    expectRefusal(smallRing(), "it is damaged");
    std::ofstream(path_, std::ios::binary) << whole.substr(0, place);
    expectRefusal(smallRing(), "it is damaged");
  }
}

}  // namespace
}  // namespace ratchet_sieve

// Scenes at random, each legal but for one thing: each is refused, and the refusal names it.
#include <set>

#include <gtest/gtest.h>

#include "draws.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "scene_keys.h"
#include "scene_spoilers.h"
#include "scene_texts.h"
#include "thousands.h"

namespace ratchet_sieve
{
namespace
{

bool holds(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// FILE:LINE, one line, the key, the value where one is wrong, and the hint.
bool saysWhatIsWrong(const std::string& refusal, const Expected& expected)
{
  if (refusal.rfind("s.yaml", 0) != 0 || holds(refusal, "\n") || !holds(refusal, expected.hint))
    return false;
  if (!expected.value.empty())
    return holds(refusal, ": " + expected.key + " = " + expected.value + ": ");
  return expected.key.empty() || holds(refusal, ": " + expected.key + ": ") ||
         holds(refusal, ": " + expected.key + " = ");
}

TEST(IllegalScenes, AreRefusedByTheKeyThatIsWrong)
{
  // Every way to spoil a scene, on each of these scenes.
  const auto one_scene = []
  {
    const SceneTree legal = *rc::gen::exec(drawnWideScene);
    RC_ASSERT(refusalOf(legal.text()) == "");
    for (const Spoiler& spoiler : sceneSpoilers())
    {
      SceneTree scene = legal;
      const Expected expected = spoiler.spoil(scene);
      const std::string refusal = refusalOf(scene.text());
      if (!saysWhatIsWrong(refusal, expected))
        RC_FAIL(spoiler.way + ": must name " + expected.key + " = " + expected.value + "\nsaid: " + refusal);
    }
  };
  EXPECT_GT(sceneSpoilers().size(), 300u);
  EXPECT_TRUE(checkManyTimes(0.2, "spoilt scenes", one_scene));
}

/// What is said against a scene that reads well and cannot start.
std::string refusalToStart(const SceneDefinition& scene)
{
  try
  {
    const Simulation simulation(scene);
    return "";
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

TEST(IllegalScenes, DoNotStartWithADiskWhereNoneCanBe)
{
  EXPECT_TRUE(checkManyTimes(
      5, "misplaced disks",
      []
      {
        const auto how = drawnOf({Misplaced::OVERLAPPING, Misplaced::BURIED, Misplaced::OUTSIDE});
        const MisplacedScene misplaced = *rc::gen::exec([how] { return drawnMisplacedScene(how); });
        const Scene scene = sceneFromText(misplaced.scene.tree.text(), "s.yaml");
        const std::string refusal = refusalToStart(scene.definition);
        for (const std::string& word : misplaced.words)
          if (!holds(refusal, word))
            RC_FAIL("must say " + word + "\nsaid: " + refusal);
      }));
}

void collectKeys(const YAML::Node& node, const std::string& part, std::set<std::string>& keys)
{
  for (const auto& item : node)
  {
    if (node.IsSequence())
      collectKeys(item, part, keys);
    else if (part.empty() && (item.second.IsMap() || item.second.IsSequence()))
      collectKeys(item.second, item.first.Scalar(), keys);
    else
      keys.insert(part + "." + item.first.Scalar());
  }
}

TEST(IllegalScenes, AreMadeOfEveryKeyThereIs)
{
  SceneDefinition full;
  full.species.resize(2);
  full.pairs.resize(1);
  full.initial.resize(1);
  // Written only where they are set.
  full.base.wall_height = 1.0;
  full.base.horizontal_amplitude = 1.0;
  full.base.horizontal_phase = 1.0;
  full.base.drive_frame = DriveFrame::BASE;
  full.pour.stretch = full.feed.stretch = {0.1, 0.2};
  full.feed.even = true;
  full.feed.on_choke = ChokeAction::STOP;
  full.contact.restitution_speed = 1.0;
  full.contact.restitution_exponent = 0.5;
  full.height_profile = {0.001, 4};
  full.accuracy = {Method::STEPS, 0.001, 0.001, 0.02, 0.9};
  std::set<std::string> written = {".density"};
  collectKeys(YAML::Load(canonicalYaml(full)), "", written);
  std::set<std::string> known;
  for (const SceneKey& key : sceneKeys())
    known.insert(key.part + "." + key.name);
  EXPECT_EQ(known, written);
}

}  // namespace
}  // namespace ratchet_sieve

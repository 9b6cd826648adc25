// Random scenes as input of the program: a legal one runs, an illegal one is refused and nothing is written.
#include <cstdlib>

#include <sys/wait.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "draws.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "scene_spoilers.h"
#include "small_scenes.h"
#include "thousands.h"

namespace ratchet_sieve
{
namespace
{

struct Result
{
  int status = -1;
  std::string output;
  std::string errors;
  bool summary = false;   ///< whether the file was written
  std::string left_over;  ///< a file that should not be there
};

std::string scenePath(const ScratchDirectory& directory)
{
  return directory / "scene.yaml";
}

/// Runs the scene. @param with_file whether the summary goes to a file
Result run(const ScratchDirectory& streams, const std::string& text, bool with_file)
{
  const ScratchDirectory written;
  std::ofstream(scenePath(streams)) << text;
  const std::string summary = with_file ? " --summary " + (written / "s.json") : "";
  const std::string command = std::string(std::getenv("SIEVE_RUN")) + " " + scenePath(streams) + summary +
                              " >" + (streams / "output") + " 2>" + (streams / "errors");
  const int status = std::system(command.c_str());
  Result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(streams / "output"),
                contents(streams / "errors"), std::filesystem::exists(written / "s.json"), ""};
  for (const auto& entry : std::filesystem::directory_iterator(written / ""))
    if (entry.path().filename() != "s.json")
      result.left_over = entry.path();
  return result;
}

TEST(ProgramScenes, ThatAreLegalRun)
{
  const ScratchDirectory streams;
  EXPECT_TRUE(checkManyTimes(0.4, "legal scenes",
                             [&]
                             {
                               const RandomScene random = *rc::gen::exec(drawnRunnableScene);
                               const Result result = run(streams, random.tree.text(), false);
                               RC_LOG() << result.errors;
                               const nlohmann::json json = nlohmann::json::parse(result.output);
                               const bool stalled =
                                   result.status == 1 && json["warnings"].size() > 0 &&
                                   result.errors.find("\nsieve_run: warning: ") != std::string::npos;
                               RC_ASSERT(result.status == 0 || stalled);
                               RC_ASSERT(result.errors.rfind("sieve_run: plan: ", 0) == 0u);
                               RC_ASSERT(json["through_base"] == 0);
                               RC_ASSERT(stalled || json["simulated_time"] == random.definition.duration);
                             }));
}

/// Refused with one line that begins with `start` and contains the words; nothing is written.
void checkRefused(const Result& result, const std::string& start, const std::vector<std::string>& words)
{
  RC_LOG() << "status " << result.status << ", said: " << result.errors;
  RC_ASSERT(result.status == 2);
  RC_ASSERT(result.output == "");
  RC_ASSERT(!result.summary);
  RC_ASSERT(result.left_over == "");
  RC_ASSERT(result.errors.find('\n') == result.errors.size() - 1);
  RC_ASSERT(result.errors.rfind(start, 0) == 0u);
  for (const std::string& word : words)
    RC_ASSERT(result.errors.find(word) != std::string::npos);
}

TEST(ProgramScenes, ThatAreIllegalAreRefusedByTheKey)
{
  const ScratchDirectory streams;
  EXPECT_TRUE(checkManyTimes(
      0.6, "illegal scenes",
      [&]
      {
        SceneTree tree = *rc::gen::exec(drawnWideScene);
        const Spoiler& spoiler = sceneSpoilers()[drawnIndex<std::size_t>(0, sceneSpoilers().size())];
        const Expected expected = spoiler.spoil(tree);
        RC_LOG() << spoiler.way << "\n" << tree.text() << "\n";
        const std::string value = expected.value.empty() ? "" : " = " + expected.value + ": ";
        checkRefused(run(streams, tree.text(), drawnChance(50)), "sieve_run: " + scenePath(streams) + ":",
                     {expected.key + value, expected.hint});
      }));
}

TEST(ProgramScenes, WhoseDisksAreMisplacedAreRefusedByTheDisk)
{
  const ScratchDirectory streams;
  EXPECT_TRUE(checkManyTimes(
      0.15, "misplaced disks",
      [&]
      {
        const auto how = drawnOf({Misplaced::OVERLAPPING, Misplaced::BURIED, Misplaced::OUTSIDE});
        const MisplacedScene misplaced = *rc::gen::exec([how] { return drawnMisplacedScene(how); });
        checkRefused(run(streams, misplaced.scene.tree.text(), drawnChance(50)),
                     "sieve_run: " + scenePath(streams) + ": ", misplaced.words);
      }));
}

}  // namespace
}  // namespace ratchet_sieve

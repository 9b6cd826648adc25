// Properties of any sweep: the number of cases, their order, and that only new cases are run.
#include <algorithm>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/sweep_run.h"
#include "sweep_files.h"

namespace ratchet_sieve
{
namespace
{

const std::vector<std::string> KEYS = {"base.inclination", "base.frequency", "gravity", "base.phase"};

std::string listText(const std::vector<int>& values)
{
  std::string text;
  for (const int value : values)
    text += (text.empty() ? "[" : ", ") + std::to_string(value);
  return text + ']';
}

/// `key: [1, 2, ..]` for each size.
std::string gridText(const std::vector<int>& sizes)
{
  std::string text;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    std::vector<int> values(static_cast<std::size_t>(sizes[i]));
    std::iota(values.begin(), values.end(), 1);
    text += (i == 0 ? "" : ", ") + KEYS[i] + ": " + listText(values);
  }
  return "grid: {" + text + "}\n";
}

/// The same by counting up, as nested loops do.
std::vector<std::string> expectedNames(const std::vector<int>& sizes, int seeds)
{
  std::vector<std::string> names = {""};
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    std::vector<std::string> longer;
    for (const std::string& name : names)
      for (int value = 1; value <= sizes[i]; ++value)
        longer.push_back(name + KEYS[i] + '=' + std::to_string(value) + ' ');
    names = longer;
  }
  std::vector<std::string> all;
  for (const std::string& name : names)
    for (int seed = 1; seed <= seeds; ++seed)
      all.push_back(name + "seed=" + std::to_string(seed));
  return all;
}

RC_GTEST_PROP(SweepProperties, CountsUpAsNestedLoopsDo, ())
{
  const auto axes = *rc::gen::inRange<std::size_t>(1, KEYS.size() + 1);
  const auto sizes = *rc::gen::container<std::vector<int>>(axes, rc::gen::inRange(1, 5));
  const int seeds = *rc::gen::inRange(1, 4);
  const ScratchDirectory directory;
  const Sweep sweep = loadSweep(
      written(directory, "s.yaml",
              SMALL_SCENE + gridText(sizes) + "seed: {first: 1, count: " + std::to_string(seeds) + "}\n"));
  const std::vector<std::string> expected = expectedNames(sizes, seeds);
  RC_ASSERT(sweep.size() == expected.size());
  const CaseBuilder builder(sweep);
  for (std::size_t k = 0; k < expected.size(); ++k)
    RC_ASSERT(builder.name(k) == expected[k]);
}

/// Values of an inclination in hundredths and a range of seeds, as a sweep of runs of a few collisions.
Sweep smallSweep(const ScratchDirectory& directory, const std::set<int>& hundredths, int seeds)
{
  std::string values;
  for (const int value : hundredths)
    values += (values.empty() ? "" : ", ") + std::to_string(0.01 * value);
  return loadSweep(written(directory, "s.yaml",
                           std::string(SMALL_SCENE) + "set: {duration: 0.02}\ngrid: {base.inclination: [" +
                               values + "]}\nseed: {first: 1, count: " + std::to_string(seeds) + "}\n"));
}

using Rows = std::map<std::string, std::string>;

/// The wall time of each row: it would differ, had the case been run again.
Rows wallTimes(const std::string& results)
{
  const Database database(results, Database::Access::READ);
  Statement select(database, "SELECT run_hash, printf('%.17g', wall_time) FROM cases");
  Rows rows;
  while (select.step())
    rows[select.text(0)] = select.text(1);
  return rows;
}

RC_GTEST_PROP(SweepProperties, GrownRunsOnlyWhatIsNew, ())
{
  const auto values = rc::gen::nonEmpty(rc::gen::container<std::set<int>>(rc::gen::inRange(-20, 20)));
  const std::set<int> some = *values;
  std::set<int> more = *values;
  more.insert(some.begin(), some.end());
  const int seeds = *rc::gen::inRange(1, 3);
  const int more_seeds = seeds + *rc::gen::inRange(0, 3);
  const ScratchDirectory directory;
  const std::string results = directory / "r.db";
  runSweep(smallSweep(directory, some, seeds), results, {});
  const Rows before = wallTimes(results);
  RC_ASSERT(before.size() == some.size() * static_cast<std::size_t>(seeds));
  const Sweep grown = smallSweep(directory, more, more_seeds);
  runSweep(grown, results, {});
  const Rows after = wallTimes(results);
  RC_ASSERT(after.size() == more.size() * static_cast<std::size_t>(more_seeds));
  RC_ASSERT(std::includes(after.begin(), after.end(), before.begin(), before.end()));
  runSweep(grown, directory / "at_once.db", {});
  RC_ASSERT(tableOf(results) == tableOf(directory / "at_once.db"));
}

}  // namespace
}  // namespace ratchet_sieve

#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "ratchet_sieve/scene/scalars.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/sweep.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;

constexpr std::size_t MOST_KEYS = 500;  ///< swept keys: each is a column, and SQLite allows 2000

void readScene(const Entry& root, Sweep& sweep)
{
  const Entry scene = root.at("scene");
  if (scene.node().IsMap())
  {
    sweep.scene_text = flowText(scene.node());
    sweep.scene_source = sweep.source + ": scene";
    sweep.scene_is_inside = true;
    return;
  }
  if (!scene.node().IsScalar())
    scene.refuseValue("must be the path of a scene, or the scene itself");
  sweep.scene_source = (fs::path(sweep.source).parent_path() / scene.node().Scalar()).string();
  sweep.scene_text = readYamlText(sweep.scene_source);
}

void readAxes(const Entry& root, Sweep& sweep)
{
  if (root.has("grid"))
  {
    const Entry grid = root.at("grid");
    const std::vector<std::string> keys = grid.keys();
    if (keys.empty())
      grid.refuse("must have one key or more");
    for (const std::string& key : keys)
      sweep.axes.push_back(readGridAxis(grid, key));
  }
  if (root.has("zip"))
    sweep.axes.push_back(readZip(root.at("zip")));
  if (root.has("cases"))
    sweep.axes.push_back(readCases(root.at("cases")));
}

void readListedSeeds(const Entry& entry, Seeds& seeds)
{
  std::set<std::uint64_t> seen;
  for (const Entry& item : entry.list())
  {
    readScalar(item, {}, seeds.listed.emplace_back());
    if (!seen.insert(seeds.listed.back()).second)
      item.refuseValue("is given twice");
  }
  if (seeds.listed.empty())
    entry.refuse("must have one seed or more");
  seeds.count = seeds.listed.size();
}

void readSeeds(const Entry& root, Sweep& sweep)
{
  if (!root.has("seed"))
    return;
  const Entry entry = root.at("seed");
  if (entry.node().IsSequence())
    return readListedSeeds(entry, sweep.seeds);
  entry.requireKeys({"first", "count"}, {"first", "count"});
  readScalar(entry.at("first"), {}, sweep.seeds.first);
  readScalar(entry.at("count"), {}, sweep.seeds.count);
  if (sweep.seeds.count == 0)
    entry.at("count").refuseValue("must be 1 or more");
  if (sweep.seeds.first + (sweep.seeds.count - 1) < sweep.seeds.first)
    entry.refuse("the last seed must be below 2^64");
}

/// Parts of a map or list that is set in every case may be swept. Setting both a key and a part of it is
/// refused otherwise, because one would undo the other.
void requireNoneWithin(const Entry& root, const std::map<std::string, std::string>& places)
{
  for (const auto& [key, place] : places)
    for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1))
    {
      const auto holder = places.find(key.substr(0, dot));
      if (holder != places.end() && (holder->second != "set" || place == "set"))
        root.at(place).refuse(key + " is a part of " + holder->first + ", which is set in " + holder->second +
                              " as well");
    }
}

/// No key may be set in two places, and seeds only in `seed`.
void requireOnce(const Entry& root, const Sweep& sweep)
{
  std::map<std::string, std::string> seen;
  const auto take = [&](const std::string& key, const std::string& place)
  {
    if (key == "seed" && (place != "set" || sweep.seeds.count > 0))
      root.at(place).refuse("seeds are given by the sweep's own key, seed: {first: .., count: ..} or [..]");
    const auto [other, is_new] = seen.emplace(key, place);
    if (!is_new)
      root.at(place).refuse(key + " is set in " + other->second + " as well");
  };
  for (const Assignment& assignment : sweep.fixed)
    take(assignment.key, "set");
  std::size_t k = 0;
  if (root.has("grid"))
    for (; k < root.at("grid").keys().size(); ++k)
      take(sweep.axes[k].keys.front(), "grid");
  for (const char* place : {"zip", "cases"})
    if (root.has(place))
      for (const std::string& key : sweep.axes[k++].keys)
        take(key, place);
  requireNoneWithin(root, seen);
  if (sweep.keys().size() > MOST_KEYS)
    root.refuse("has more than " + std::to_string(MOST_KEYS) + " keys");
}

void requireCountable(const Entry& root, const Sweep& sweep)
{
  std::uint64_t product = sweep.seedCount();
  bool countable = product <= MOST_CASES;
  for (const Axis& axis : sweep.axes)
  {
    countable = countable && axis.size <= MOST_CASES / product;
    if (countable)
      product *= axis.size;
  }
  if (!countable)
    root.refuse("has more than " + std::to_string(MOST_CASES) + " cases");
}

}  // namespace

Sweep loadSweep(const std::string& path)
{
  return sweepFromText(readYamlText(path), path);
}

Sweep sweepFromText(const std::string& text, const std::string& source)
{
  const YAML::Node tree = copyableYaml(text, source);
  const Entry root(tree, source, "sweep");
  root.requireKeys({"scene", "set", "grid", "zip", "cases", "seed"}, {"scene"});
  Sweep sweep;
  sweep.source = source;
  readScene(root, sweep);
  if (root.has("set"))
    sweep.fixed = readAssignments(root.at("set"));
  readAxes(root, sweep);
  readSeeds(root, sweep);
  requireOnce(root, sweep);
  requireCountable(root, sweep);
  return sweep;
}

}  // namespace ratchet_sieve

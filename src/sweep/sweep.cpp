#include "ratchet_sieve/sweep/sweep.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/parsed.h"
#include "ratchet_sieve/scene/scalars.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

constexpr double MOST_VALUES = 1e15;  ///< of one range: below 2^53, so that a double counts them

/// Characters that end a plain scalar within a flow map or list, or might.
constexpr const char* FLOW_MARKS = ",[]{}#:&*!|>'\"%@`\n\t";

std::string quoted(const std::string& text)
{
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << text;
  return emitter.c_str();
}

std::string scalarFlowText(const YAML::Node& node)
{
  const std::string& text = node.Scalar();
  const bool plain =
      node.Tag() != "!" && !text.empty() && text.find_first_of(FLOW_MARKS) == std::string::npos;
  return plain ? text : quoted(text);
}

/// The values of one key: a list, or a range whose values are computed on demand.
struct SweptValues
{
  std::uint64_t count = 0;
  std::function<std::string(std::uint64_t)> at;  ///< YAML text
};

SweptValues readRange(const Entry& entry)
{
  entry.requireKeys({"from", "to", "count"}, {"from", "to", "count"});
  double from = 0.0;
  double to = 0.0;
  std::uint64_t count = 0;
  double checked_count = 0.0;
  readScalar(entry.at("from"), {}, from);
  readScalar(entry.at("to"), {}, to);
  readScalar(entry.at("count"), {1.0, MOST_VALUES, ""}, checked_count);
  readScalar(entry.at("count"), {}, count);
  return {count, [from, to, count](std::uint64_t k) { return scalarText(rangeValue(from, to, count, k)); }};
}

SweptValues readList(const Entry& entry)
{
  const auto values = std::make_shared<std::vector<std::string>>();
  for (const Entry& value : entry.list())
  {
    if (value.node().IsNull())
      value.refuse("must have a value");
    values->push_back(flowText(value.node()));
  }
  if (values->empty())
    entry.refuse("must have one value or more");
  return {values->size(), [values](std::uint64_t k) { return (*values)[k]; }};
}

SweptValues readValues(const Entry& entry)
{
  if (entry.node().IsMap())
    return readRange(entry);
  if (!entry.node().IsSequence())
    entry.refuseValue("must be a list of values, or {from: .., to: .., count: ..}");
  return readList(entry);
}

/// `{KEY: VALUES, ...}`: the lists of these keys, stepped through together.
Axis readTogether(const Entry& map, const std::string& place, const std::vector<std::string>& keys)
{
  std::vector<SweptValues> columns;
  for (const std::string& key : keys)
  {
    columns.push_back(readValues(map.at(key)));
    if (columns.back().count != columns.front().count)
      map.at(key).refuse("has " + std::to_string(columns.back().count) + " values, but " + keys.front() +
                         " has " + std::to_string(columns.front().count) +
                         "; the lists of a zip must be equally long");
  }
  const auto at = [keys, columns](std::uint64_t k)
  {
    std::vector<Assignment> assignments;
    for (std::size_t i = 0; i < keys.size(); ++i)
      assignments.push_back({keys[i], columns[i].at(k)});
    return assignments;
  };
  return {place, keys, columns.front().count, at, flowText(map.node())};
}

/// `{KEY: VALUE, ...}`.
std::vector<Assignment> readAssignments(const Entry& map)
{
  std::vector<Assignment> assignments;
  for (const std::string& key : map.keys())
  {
    if (map.at(key).node().IsNull())
      map.at(key).refuse("must have a value");
    assignments.push_back({key, flowText(map.at(key).node())});
  }
  return assignments;
}

/// `[{KEY: VALUE, ...}, ...]`: one after the other.
Axis readCases(const Entry& cases)
{
  std::vector<std::string> keys;
  const auto steps = std::make_shared<std::vector<std::vector<Assignment>>>();
  for (const Entry& entry : cases.list())
  {
    steps->push_back(readAssignments(entry));
    for (const Assignment& assignment : steps->back())
      if (std::find(keys.begin(), keys.end(), assignment.key) == keys.end())
        keys.push_back(assignment.key);
  }
  if (steps->empty())
    cases.refuse("must have one case or more");
  return {"cases", keys, steps->size(), [steps](std::uint64_t k) { return (*steps)[k]; },
          flowText(cases.node())};
}

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
  for (const std::string place : {"grid", "zip"})
  {
    if (!root.has(place))
      continue;
    const Entry map = root.at(place);
    const std::vector<std::string> keys = map.keys();
    if (keys.empty())
      map.refuse("must have one key or more");
    if (place == "zip")
      sweep.axes.push_back(readTogether(map, place, keys));
    else
      for (const std::string& key : keys)
      {
        sweep.axes.push_back(readTogether(map, place, {key}));
        sweep.axes.back().text = key + ": " + flowText(map.at(key).node());
      }
  }
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

/// No key may be set in two places. Seeds are in `seed`, or else in `set` or `cases`.
void requireOnce(const Entry& root, const Sweep& sweep)
{
  std::map<std::string, std::string> seen;
  const auto take = [&](const std::string& key, const std::string& place)
  {
    if (key == "seed" && (sweep.seeds.count > 0 || (place != "set" && place != "cases")))
      root.at(place).refuse("seeds are given by the sweep's own key, seed: {first: .., count: ..} or [..]");
    const auto [other, is_new] = seen.emplace(key, place);
    if (!is_new)
      root.at(place).refuse(key + " is set in " + other->second + " as well");
  };
  for (const Assignment& assignment : sweep.fixed)
    take(assignment.key, "set");
  for (const Axis& axis : sweep.axes)
    for (const std::string& key : axis.keys)
      take(key, axis.place);
  requireNoneWithin(root, seen);
  if (sweep.keys().size() > MOST_KEYS)
    root.refuse("has more than " + std::to_string(MOST_KEYS) + " keys");
}

void requireCountable(const Entry& root, const Sweep& sweep)
{
  auto cases = static_cast<double>(sweep.seedCount());
  for (const Axis& axis : sweep.axes)
    cases *= static_cast<double>(axis.size);
  if (cases > static_cast<double>(MOST_CASES))
    root.refuse("has more than " + std::to_string(MOST_CASES) + " cases");
}

}  // namespace

std::string flowText(const YAML::Node& node)
{
  if (node.IsScalar())
    return scalarFlowText(node);
  if (!node.IsMap() && !node.IsSequence())
    return "~";
  std::string text;
  for (const auto& item : node)
  {
    text += text.empty() ? "" : ", ";
    text += node.IsMap() ? flowText(item.first) + ": " + flowText(item.second) : flowText(item);
  }
  return node.IsMap() ? '{' + text + '}' : '[' + text + ']';
}

double rangeValue(double from, double to, std::uint64_t count, std::uint64_t k)
{
  if (k + 1 == count && count > 1)
    return to;
  if (k == 0)
    return from;
  const double value = from + (to - from) * (static_cast<double>(k) / static_cast<double>(count - 1));
  return parsed<double>(fmt::format("{:.15g}", value)).value();
}

std::uint64_t Sweep::points() const
{
  std::uint64_t product = 1;
  for (const Axis& axis : axes)
    product *= axis.size;
  return product;
}

std::vector<std::string> Sweep::keys() const
{
  std::vector<std::string> all;
  for (const Axis& axis : axes)
    std::remove_copy(axis.keys.begin(), axis.keys.end(), std::back_inserter(all), "seed");
  return all;
}

std::vector<Assignment> Sweep::point(std::uint64_t point) const
{
  std::vector<std::uint64_t> steps(axes.size());
  for (std::size_t i = axes.size(); i-- > 0;)
  {
    steps[i] = point % axes[i].size;
    point /= axes[i].size;
  }
  std::vector<Assignment> all;
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (Assignment& assignment : axes[i].at(steps[i]))
      all.push_back(std::move(assignment));
  return all;
}

std::set<std::string> Sweep::feedFiles() const
{
  std::set<std::string> files;
  const auto look = [&](const std::vector<Assignment>& step)
  {
    YAML::Node scene = copyableYaml(scene_text, scene_source);
    for (const std::vector<Assignment>& assignments : {fixed, step})
      for (const Assignment& assignment : assignments)
        applyOverride(scene, assignment.key + '=' + assignment.value);
    if (scene.IsMap() && scene["feed"].IsMap() && scene["feed"]["file"].IsScalar())
      files.insert(pathFromScene(scene_source, scene["feed"]["file"].Scalar()));
  };
  look({});
  for (const Axis& axis : axes)
    if (std::any_of(axis.keys.begin(), axis.keys.end(),
                    [](const std::string& key) { return key == "feed" || key == "feed.file"; }))
      for (std::uint64_t k = 0; k < axis.size; ++k)
        look(axis.at(k));
  return files;
}

std::string Sweep::fingerprint() const
{
  std::string text = std::to_string(PHYSICS_VERSION) + '\n' + scene_text + '\n';
  for (const Assignment& assignment : fixed)
    text += assignment.key + '=' + assignment.value + '\n';
  for (const Axis& axis : axes)
    text += axis.text + '\n';
  text += "seeds " + std::to_string(seeds.first) + ' ' + std::to_string(seeds.count);
  for (const std::uint64_t seed : seeds.listed)
    text += ' ' + std::to_string(seed);
  if (part.count > 1)
    text += "\npart " + std::to_string(part.number) + ' ' + std::to_string(part.count);
  return hashText(text);
}

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

#include "ratchet_sieve/sweep/case_builder.h"

#include <sstream>

#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

constexpr std::size_t LONGEST_SHOWN_CASE = 200;  ///< [characters]

/// The value at a dotted path, as text, if the tree has one.
std::optional<std::string> valueAt(const YAML::Node& tree, const std::string& path)
{
  YAML::Node node;
  node.reset(tree);
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '.');)
  {
    const YAML::Node& parent = node;
    if (parent.IsScalar() || !parent.IsDefined())
      return std::nullopt;
    // An element of a list is named by its index; applyOverride() or the scene reader has refused other
    // names.
    const YAML::Node child = parent.IsSequence() ? parent[std::stoul(part)] : parent[part];
    if (!child.IsDefined() || child.IsNull())
      return std::nullopt;
    node.reset(child);
  }
  return flowText(node);
}

}  // namespace

CaseBuilder::CaseBuilder(const Sweep& sweep)
    : sweep_(sweep), keys_(sweep.keys()), base_(copyableYaml(sweep.scene_text, sweep.scene_source))
{
}

const SweepCase& CaseBuilder::at(std::uint64_t position)
{
  const std::uint64_t point = position / sweep_.seedCount();
  if (point_ != point)
  {
    point_.reset();
    try
    {
      build(point);
    }
    catch (const SceneError& error)
    {
      throw SceneError(sweep_.source + ": case " + std::to_string(position + 1) + " (" +
                       shownText(name(position), LONGEST_SHOWN_CASE) + "): " + error.what());
    }
    point_ = point;
  }
  case_.position = position;
  case_.scene.seed = sweep_.seeds.count > 0 ? sweep_.seeds.at(position % sweep_.seeds.count) : own_seed_;
  return case_;
}

void CaseBuilder::build(std::uint64_t point)
{
  YAML::Node tree = copyWithoutLines(base_);
  for (const Assignment& assignment : sweep_.fixed)
    applyOverride(tree, assignment.key + '=' + assignment.value);
  for (const Assignment& assignment : sweep_.point(point))
    applyOverride(tree, assignment.key + '=' + assignment.value);
  Scene scene = sceneFromYaml(tree, sweep_.scene_source);
  case_.scene = std::move(scene.definition);
  case_.warnings = std::move(scene.warnings);
  own_seed_ = case_.scene.seed;
  case_.values.clear();
  for (const std::string& key : keys_)
    case_.values.emplace_back(key, valueAt(tree, key));
}

std::string CaseBuilder::name(std::uint64_t position) const
{
  std::string setting = settingName(position / sweep_.seedCount());
  if (sweep_.seeds.count == 0)
    return setting;
  const std::string seed = "seed=" + std::to_string(sweep_.seeds.at(position % sweep_.seeds.count));
  return keys_.empty() ? seed : setting + ' ' + seed;
}

std::string CaseBuilder::settingName(std::uint64_t point) const
{
  std::string text;
  for (const Assignment& assignment : sweep_.point(point))
    text += (text.empty() ? "" : " ") + assignment.key + '=' + assignment.value;
  return text.empty() ? "the scene itself" : text;
}

}  // namespace ratchet_sieve

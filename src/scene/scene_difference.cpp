#include "ratchet_sieve/scene/scene_difference.h"

#include <algorithm>

#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

std::string shownValue(const YAML::Node& node)
{
  return node.IsDefined() ? shownText(YAML::Dump(node)) : "absent";
}

std::optional<SceneDifference> differenceOf(const std::string& key, const YAML::Node& one,
                                            const YAML::Node& other)
{
  const auto of_part = [&](const auto& part, const std::string& name)
  { return differenceOf(key.empty() ? name : key + '.' + name, one[part], other[part]); };
  if (!one.IsDefined() || !other.IsDefined())
    return SceneDifference{key, shownValue(one), shownValue(other)};
  if (one.IsMap() && other.IsMap())
  {
    for (const YAML::Node& map : {one, other})
      for (const auto& item : map)
        if (auto found = of_part(item.first.Scalar(), item.first.Scalar()))
          return found;
    return std::nullopt;
  }
  if (one.IsSequence() && other.IsSequence())
  {
    for (std::size_t k = 0; k < std::max(one.size(), other.size()); ++k)
      if (auto found = of_part(k, std::to_string(k)))
        return found;
    return std::nullopt;
  }
  if (one.IsScalar() && other.IsScalar() && one.Scalar() == other.Scalar())
    return std::nullopt;
  return SceneDifference{key, shownValue(one), shownValue(other)};
}

}  // namespace

std::optional<SceneDifference> sceneDifference(const std::string& one, const std::string& other)
{
  return one == other ? std::nullopt : differenceOf("", YAML::Load(one), YAML::Load(other));
}

}  // namespace ratchet_sieve

#include "ratchet_sieve/scene/scene_difference.h"

#include <algorithm>

#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

std::string shownValue(const YAML::Node& node)
{
  return node.IsDefined() ? shownText(YAML::Dump(node)) : "absent";
}

std::optional<SceneDifference> differenceOf(const std::string& key, const YAML::Node& saved,
                                            const YAML::Node& present)
{
  const auto of_part = [&](const auto& part, const std::string& name)
  { return differenceOf(key.empty() ? name : key + '.' + name, saved[part], present[part]); };
  if (!saved.IsDefined() || !present.IsDefined())
    return SceneDifference{key, shownValue(saved), shownValue(present)};
  if (saved.IsMap() && present.IsMap())
  {
    for (const YAML::Node& map : {saved, present})
      for (const auto& item : map)
        if (auto found = of_part(item.first.Scalar(), item.first.Scalar()))
          return found;
    return std::nullopt;
  }
  if (saved.IsSequence() && present.IsSequence())
  {
    for (std::size_t k = 0; k < std::max(saved.size(), present.size()); ++k)
      if (auto found = of_part(k, std::to_string(k)))
        return found;
    return std::nullopt;
  }
  if (saved.Type() == present.Type() && saved.Scalar() == present.Scalar())
    return std::nullopt;
  return SceneDifference{key, shownValue(saved), shownValue(present)};
}

}  // namespace

std::optional<SceneDifference> sceneDifference(const std::string& saved, const std::string& present)
{
  return saved == present
             ? std::nullopt
             : differenceOf("", copyableYaml(saved, "the saved scene"), copyableYaml(present, "this scene"));
}

}  // namespace ratchet_sieve

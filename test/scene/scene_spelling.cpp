#include "scene_spelling.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include "draws.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

SceneTree treeOf(const YAML::Node& node)
{
  if (node.IsScalar())
    return node.Tag() == "!" ? '"' + node.Scalar() + '"' : node.Scalar();
  SceneTree tree = node.IsMap() ? SceneTree::map() : SceneTree::list();
  for (const auto& item : node)
  {
    if (node.IsMap())
      tree.force(item.first.Scalar(), treeOf(item.second));
    else
      tree.append(treeOf(item));
  }
  return tree;
}

SceneTree treeOf(const SceneDefinition& scene)
{
  return treeOf(YAML::Load(canonicalYaml(scene)));
}

/// A number as a hand might write it: in full, short, or with an exponent; it reads back to the same.
std::string spelledNumber(double value)
{
  const char* const format = drawnOf({"%.17g", "%.3g", "%.17e"});
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  if (std::strtod(text, nullptr) != value)
    std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// Leaves out some of the keys whose value is the default's, but none of `kept`; spells the others anew.
void vary(SceneTree& map, SceneTree& defaults, const std::string& kept = "")
{
  const SceneTree before = map;
  for (const auto& [key, value] : before.items())
  {
    if (value.sort() != SceneTree::Sort::SCALAR)
      continue;
    const std::string text = value.flowText();
    if (kept.find(" " + key + " ") == std::string::npos && defaults.has(key) &&
        defaults[key].flowText() == text && !drawnChance(40))
      map.remove(key);
    else if (text.find('.') != std::string::npos && text.front() != '"')
      map[key] = SceneTree(spelledNumber(std::strtod(text.c_str(), nullptr)));
  }
}

/// The scene with nothing in it but defaults.
SceneDefinition defaultScene(const SceneDefinition& scene)
{
  SceneDefinition plain;
  plain.species.resize(scene.species.size());
  plain.pairs = scene.pairs;
  for (PairDefinition& pair : plain.pairs)
  {
    SceneDefinition without = scene;
    without.pairs.clear();
    pair.contact = contactBetween(without, pair.first, pair.second);
  }
  plain.initial.resize(scene.initial.size());
  return plain;
}

}  // namespace

SceneTree spelled(const SceneDefinition& scene, std::optional<double> density)
{
  SceneTree tree = treeOf(scene);
  SceneTree defaults = treeOf(defaultScene(scene));
  vary(tree, defaults);
  for (const char* section : {"base", "contact", "pour", "feed", "height_profile"})
  {
    if (!tree.has(section))
      continue;
    vary(tree[section], defaults[section]);
    if (tree[section].items().empty() && !drawnChance(20))
      tree.remove(section);
  }
  const bool counted = !density && scene.initial.empty();
  for (const auto& [list, kept] : {std::pair<std::string, std::string>{"species", " name count radius mass "},
                                   {"pairs", " species "},
                                   {"initial", " species x y "}})
  {
    for (std::size_t i = 0; i < tree[list].items().size(); ++i)
    {
      SceneTree& entry = tree[list].items()[i].second;
      vary(entry, defaults[list].items()[i].second, kept);
      if (list == "species" && !counted && !drawnChance(10))
        entry.remove("count");
    }
    if (tree[list].items().empty() && !drawnChance(20))
      tree.remove(list);
  }
  if (density)
    tree["density"] = SceneTree(spelledNumber(*density));
  auto& items = tree.items();
  std::rotate(items.begin(),
              items.begin() + drawnIndex<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(items.size())),
              items.end());
  return tree;
}

}  // namespace ratchet_sieve

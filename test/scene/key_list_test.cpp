// The list of keys says what the reader accepts.
#include "ratchet_sieve/scene/key_list.h"

#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "ratchet_sieve/scene/canonical_scene.h"
#include "scene_texts.h"

namespace ratchet_sieve
{
namespace
{

/// Every part that the list names is there, each list with an entry.
const char* const EVERY_PART =
    "base: {harmonics: [{multiple: 3}]}\n"
    "species: [{name: A, radius: 0.001, mass: 0.001}, {name: B, radius: 0.002, mass: 0.002}]\n"
    "pairs: [{species: [A, B]}]\n"
    "initial: [{species: A, x: 0.1, y: 0.05}]\n"
    "contact: {}\npour: {}\n"
    "feed: {disks: [{time: 1, species: A, radius: 0.001, mass: 0.001}]}\naccuracy: {}\n";

/// species.N.radius as species.0.radius
std::string atFirst(std::string path)
{
  for (std::size_t at; (at = path.find(".N")) != std::string::npos;)
    path.replace(at, 2, ".0");
  return path;
}

/// Sizes have either a spread or a table.
YAML::Node sceneFor(const std::string& key)
{
  YAML::Node root = YAML::Load(EVERY_PART);
  if (key == "density")
    root.remove("initial");
  const std::string group = "species.N.size.";
  if (key.rfind(group, 0) == 0)
  {
    const bool table = std::set<std::string>{"radii", "weights", "by"}.count(key.substr(group.size())) > 0;
    root["species"][0]["size"] = YAML::Load(table ? "{distribution: table, radii: [0.001], weights: [1]}"
                                                  : "{distribution: uniform, spread: 0}");
  }
  return root;
}

YAML::Node withAssignment(const std::string& key, const std::string& value)
{
  YAML::Node root = sceneFor(key);
  applyOverride(root, atFirst(key) + "=" + value);
  return root;
}

std::string refusalOfTree(const YAML::Node& root)
{
  return refusalBy([&] { sceneFromYaml(root, "s.yaml"); });
}

std::vector<KeyText> allKeys()
{
  std::vector<KeyText> keys;
  for (const KeyGroup& group : sceneKeyGroups())
    keys.insert(keys.end(), group.keys.begin(), group.keys.end());
  return keys;
}

/// What the reader names beside an unknown key.
std::set<std::string> namesKnownAt(const std::string& group)
{
  const std::string refusal = refusalOfTree(withAssignment(group.empty() ? "?" : group + ".?", "1"));
  const std::string before = "must be one of ";
  const std::size_t at = refusal.find(before);
  EXPECT_NE(at, std::string::npos) << refusal;
  std::istringstream list(refusal.substr(at + before.size()));
  std::set<std::string> names;
  for (std::string name; std::getline(list >> std::ws, name, ',');)
    names.insert(name);
  return names;
}

TEST(KeyList, HasEachKeyThatTheReaderKnowsOnce)
{
  for (const KeyGroup& group : sceneKeyGroups())
  {
    SCOPED_TRACE(group.name);
    const std::string prefix = group.name.empty() ? "" : group.name + ".";
    std::set<std::string> names;
    for (const KeyText& key : group.keys)
    {
      ASSERT_EQ(key.key.rfind(prefix, 0), 0u);
      EXPECT_TRUE(names.insert(key.key.substr(prefix.size())).second) << key.key;
    }
    for (const KeyGroup& part : sceneKeyGroups())
      if (part.name.size() > prefix.size() && part.name.rfind(prefix, 0) == 0)
      {
        const std::string rest = part.name.substr(prefix.size());
        names.insert(rest.substr(0, rest.find('.')));
      }
    EXPECT_EQ(names, namesKnownAt(group.name));
  }
}

TEST(KeyList, SaysWhatTheReaderAllows)
{
  for (const KeyText& key : allKeys())
  {
    if (key.key.find(".species") != std::string::npos)
      continue;
    const bool of_list = key.type == "list";
    const std::string refusal = refusalOfTree(withAssignment(key.key, of_list ? "[[]]" : "[]"));
    const std::string end = key.values + (key.unit.empty() ? "" : " " + key.unit);
    const auto is_of = [&](const std::string& name)
    { return refusal.find("s.yaml: " + name + " = a list: must be ") == 0; };
    const std::string name = atFirst(key.key);
    EXPECT_TRUE(is_of(name) != (of_list && is_of(name + ".0"))) << refusal;
    EXPECT_EQ(refusal.substr(refusal.size() - end.size()), end) << refusal;
    const bool type_is_named = key.type != "boolean" && key.type != "choice";
    if (!of_list)
    {
      EXPECT_EQ(refusal.find(" " + key.type + " ") != std::string::npos, type_is_named) << refusal;
    }
  }
}

TEST(KeyList, SaysWhatTheReaderTakesForAMissingKey)
{
  for (const KeyText& key : allKeys())
  {
    SCOPED_TRACE(key.key);
    if (key.default_text == "required")
    {
      YAML::Node root = YAML::Load(EVERY_PART);
      const std::size_t dot = key.key.rfind('.');
      applyOverride(root, atFirst(key.key.substr(0, dot)) + "={}");
      EXPECT_NE(refusalOfTree(root).find(": missing"), std::string::npos);
    }
    else if (key.default_text != "-" && key.default_text != "mean of both")
    {
      const Scene scene = sceneFromYaml(withAssignment(key.key, key.default_text), "s.yaml");
      EXPECT_EQ(canonicalYaml(scene.definition),
                canonicalYaml(sceneFromYaml(sceneFor(key.key), "s.yaml").definition));
    }
  }
}

TEST(KeyList, MeansSomethingWithEachKey)
{
  for (const KeyText& key : allKeys())
  {
    EXPECT_EQ(key.meaning.find(". "), std::string::npos) << key.key << ": one sentence";
    EXPECT_EQ(key.meaning.back(), '.') << key.key;
    EXPECT_EQ(key.meaning.find("  "), std::string::npos) << key.key << ": two spaces end a cell of the table";
  }
}

}  // namespace
}  // namespace ratchet_sieve

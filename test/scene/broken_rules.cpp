#include <cmath>
#include <limits>

#include "draws.h"
#include "scene_spelling.h"
#include "spoiling.h"

namespace ratchet_sieve
{
namespace
{

SceneTree& speciesAt(SceneTree& root, std::size_t i)
{
  return root.listAt("species").items()[i].second;
}

std::size_t speciesCount(SceneTree& root)
{
  return root.listAt("species").items().size();
}

SceneTree nameOf(SceneTree& root, std::size_t i)
{
  return speciesAt(root, i)["name"];
}

void setAll(SceneTree& root, const std::string& key, const std::string& text)
{
  for (auto& item : root.listAt("species").items())
    item.second[key] = SceneTree(text);
}

/// Disks are poured, by their counts.
void requireCounts(SceneTree& root, const std::string& count)
{
  root.remove("density");
  root.remove("initial");
  setAll(root, "count", count);
}

Expected missingCount(SceneTree& root)
{
  requireCounts(root, "1");
  root.remove("feed");
  const auto at = drawnIndex<std::size_t>(0, speciesCount(root));
  speciesAt(root, at).remove("count");
  return {"species." + std::to_string(at) + ".count", "", "missing"};
}

Expected settleBeyondDuration(SceneTree& root)
{
  const double duration = drawnMagnitude(1e-9, 1e8);
  const double settle = drawnChance(50) ? std::nextafter(duration, std::numeric_limits<double>::infinity())
                                        : duration * drawnMagnitude(1.001, 10.0);
  root["duration"] = SceneTree(spelledNumber(duration));
  const std::string text = spelledNumber(settle);
  root["settle"] = SceneTree(text);
  return {"settle", text, ""};
}

Expected feedWithoutShare(SceneTree& root)
{
  root.remove("density");
  setAll(root, "share", "0");
  setAll(root, "count", "0");
  const std::string text = spelledNumber(drawnMagnitude(1e-300, 1e6));
  root.mapAt("feed")["rate"] = SceneTree(text);
  return {"feed.rate", text, ""};
}

Expected densityWithoutShare(SceneTree& root)
{
  root.remove("initial");
  setAll(root, "share", "0");
  const std::string text = spelledNumber(drawnMagnitude(1e-300, 1e6));
  root["density"] = SceneTree(text);
  return {"density", text, ""};
}

Expected densityOfTooMany(SceneTree& root)
{
  root.remove("initial");
  setAll(root, "share", "1");
  setAll(root, "radius", "1e-6");
  root.mapAt("base")["teeth"] = SceneTree("1000");
  root.mapAt("base")["tooth_width"] = SceneTree("1.0");
  // W / (2 r) = 5e8, shared by up to five species.
  const std::string text = spelledNumber(drawnMagnitude(0.2, 1e6));
  root["density"] = SceneTree(text);
  return {"density", text, ""};
}

Expected densityWithInitial(SceneTree& root)
{
  requireInitial(root);
  root["density"] = SceneTree("1.0");
  return {"density", "", "initial"};
}

Expected tooWide(SceneTree& root)
{
  requireCounts(root, "2");
  const double width = drawnMagnitude(1e-6, 1e2);
  root.mapAt("base")["teeth"] = SceneTree("1");
  root.mapAt("base")["tooth_width"] = SceneTree(spelledNumber(width));
  root["boundary"] = SceneTree(drawnOf<const char*>({"periodic", "open", "walled"}));
  if (root["boundary"].flowText() == "periodic")
    root.mapAt("contact")["pair_collisions"] = SceneTree("true");
  setAll(root, "radius", spelledNumber(0.1 * width));
  const auto at = drawnIndex<std::size_t>(0, speciesCount(root));
  const double radius =
      drawnChance(50) ? std::nextafter(0.5 * width, width) : width * drawnMagnitude(0.51, 9.0);
  const std::string text = spelledNumber(radius);
  speciesAt(root, at)["radius"] = SceneTree(text);
  return {"species." + std::to_string(at) + ".radius", text, ""};
}

/// Disks of one size are poured over the default base, as slowly as they can be.
void requirePlainMachine(SceneTree& root, double radius)
{
  requireCounts(root, "1");
  root["boundary"] = SceneTree("periodic");
  root["gravity"] = SceneTree("9.81");
  root["settle"] = SceneTree("0");
  for (const char* section : {"base", "pour", "feed"})
    root[section] = SceneTree::map();
  root.mapAt("contact")["min_rebound_speed"] = SceneTree("0.05");
  setAll(root, "radius", spelledNumber(radius));
}

/// Beyond the right end of the base, or its end before its beginning.
Expected stretchOffTheBase(SceneTree& root)
{
  const std::string part = drawnOf<const char*>({"pour", "feed"});
  requirePlainMachine(root, 0.001);
  if (drawnChance(50))
  {
    const char* key = drawnOf<const char*>({"from", "to"});
    const std::string text = spelledNumber(0.4 * drawnMagnitude(1.001, 1e6));
    root.mapAt(part)[key] = SceneTree(text);
    return {part + "." + key, text, "the base's width"};
  }
  const std::string text = spelledNumber(0.2 * drawnFraction());
  root.mapAt(part)["from"] = SceneTree("0.21");
  root.mapAt(part)["to"] = SceneTree(text);
  return {part + ".to", text, part + ".from"};
}

/// Makes one species too small for the rest of the scene.
Expected tooSmall(SceneTree& root, double radius, const std::string& hint)
{
  const auto at = drawnIndex<std::size_t>(0, speciesCount(root));
  const std::string text = spelledNumber(radius);
  speciesAt(root, at)["radius"] = SceneTree(text);
  return {"species." + std::to_string(at) + ".radius", text, hint};
}

Expected tooFine(SceneTree& root)
{
  const double width = drawnMagnitude(1.0, 1e2);
  requirePlainMachine(root, 0.1 * width);
  root.mapAt("base")["teeth"] = SceneTree("10");
  root.mapAt("base")["tooth_width"] = SceneTree(spelledNumber(0.1 * width));
  return tooSmall(root, std::max(1e-9, width * drawnMagnitude(1e-8, 5e-7)), "the base's width is");
}

Expected tooFast(SceneTree& root)
{
  requirePlainMachine(root, 0.01);
  // A drive of 1 m at 1000 Hz: 6283 m/s, in times that are held to 1.4e-17 s.
  root.mapAt("base")["amplitude"] = SceneTree("1");
  root.mapAt("base")["frequency"] = SceneTree("1000");
  return tooSmall(root, drawnMagnitude(1e-6, 3e-5), "the drive's speed is");
}

Expected speciesTwice(SceneTree& root)
{
  const auto at = drawnIndex<std::size_t>(0, speciesCount(root));
  const SceneTree copy = speciesAt(root, at);
  root.listAt("species").append(copy);
  return {"species." + std::to_string(speciesCount(root) - 1) + ".name", nameOf(root, at).flowText(), ""};
}

Expected noSpecies(SceneTree& root)
{
  if (drawnChance(50))
  {
    root.remove("species");
    return {"species", "", "missing"};
  }
  root["species"] = SceneTree::list();
  return {"species", "", "at least one species"};
}

Expected pairTwice(SceneTree& root)
{
  requirePair(root);
  auto& pairs = root.listAt("pairs").items();
  SceneTree copy = pairs[drawnIndex<std::size_t>(0, pairs.size())].second;
  auto& names = copy.listAt("species").items();
  if (drawnChance(50))
    std::swap(names[0], names[1]);
  root.listAt("pairs").append(copy);
  return {"pairs." + std::to_string(root.listAt("pairs").items().size() - 1) + ".species", "", "already"};
}

/// A pair's species: not a list of two that there are.
Expected wrongPair(SceneTree& root)
{
  const PartPlace place = placeOf(root, "pairs");
  SceneTree& names = (*place.map)["species"];
  const std::string key = place.prefix + "species";
  const auto at = drawnIndex<std::size_t>(0, 2);
  switch (drawnIndex(0, 6))
  {
    case 0:
      names.items().pop_back();
      return {key, "", "two species"};
    case 1:
      names.append(nameOf(root, 0));
      return {key, "", "two species"};
    case 2:
      names.items()[1 - at] = names.items()[at];
      return {key, "", "two different species"};
    case 3:
      names = SceneTree("A");
      return {key, "A", "must be a list"};
    case 4:
      names = SceneTree::map();
      return {key, "a map", "must be a list"};
    default:
      names.items()[at].second = SceneTree("nobody");
      return {key + "." + std::to_string(at), "nobody", "unknown species"};
  }
}

/// What is no scene, whatever its keys.
Expected noScene(SceneTree& root)
{
  switch (drawnIndex(0, 5))
  {
    case 0:
      root = SceneTree(drawnOf<const char*>({"", "7", "[]", "text", "---"}));
      return {"scene", "", "must be a map"};
    case 1:
      root.force("[a]", SceneTree("1"));
      return {"scene", "", "a key must be a word"};
    case 2:
      root["seed"] = SceneTree("1\n---\nseed: 1");
      return {"", "", "a second document"};
    case 3:
      root["base"] = SceneTree(std::string(17, '[') + std::string(17, ']'));
      return {"", "", "nest deeper"};
    default:
      root["base"] = SceneTree(drawnOf<const char*>({"{teeth: 1", "]", "*nowhere"}));
      return {"", "", "not YAML"};
  }
}

}  // namespace

void requirePair(SceneTree& root)
{
  if (speciesCount(root) < 2)
  {
    SceneTree other = speciesAt(root, 0);
    other["name"] = SceneTree("other");
    root.listAt("species").append(other);
  }
  if (!root.listAt("pairs").items().empty())
    return;
  SceneTree pair = SceneTree::map();
  pair.listAt("species").append(nameOf(root, 0));
  pair.listAt("species").append(nameOf(root, 1));
  root.listAt("pairs").append(pair);
}

void requireInitial(SceneTree& root)
{
  root.remove("density");
  if (!root.listAt("initial").items().empty())
    return;
  SceneTree disk = SceneTree::map();
  disk["species"] = nameOf(root, 0);
  disk["x"] = SceneTree("0");
  disk["y"] = SceneTree("0.1");
  root.listAt("initial").append(disk);
}

void addBrokenRules(std::vector<Spoiler>& spoilers)
{
  spoilers.push_back({"count missing", missingCount});
  spoilers.push_back({"settle beyond duration", settleBeyondDuration});
  spoilers.push_back({"feed without share", feedWithoutShare});
  spoilers.push_back({"stretch off the base", stretchOffTheBase});
  spoilers.push_back({"density without share", densityWithoutShare});
  spoilers.push_back({"density of too many", densityOfTooMany});
  spoilers.push_back({"density with initial", densityWithInitial});
  spoilers.push_back({"disk too wide", tooWide});
  spoilers.push_back({"disk too fine", tooFine});
  spoilers.push_back({"disks too fast", tooFast});
  spoilers.push_back({"species twice", speciesTwice});
  spoilers.push_back({"no species", noSpecies});
  spoilers.push_back({"pair twice", pairTwice});
  // Each of these two is several ways: drawn as often.
  for (int i = 0; i < 6; ++i)
  {
    spoilers.push_back({"wrong pair", wrongPair});
    spoilers.push_back({"no scene", noScene});
  }
}

}  // namespace ratchet_sieve

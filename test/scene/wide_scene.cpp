#include <numeric>

#include "draws.h"
#include "random_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "scene_keys.h"
#include "scene_spelling.h"

namespace ratchet_sieve
{
namespace
{

const std::vector<std::string> NAMES = {"A", "b-2", "true", "1e3"};

std::string drawnText(const SceneKey& key)
{
  switch (key.kind)
  {
    case ValueKind::NUMBER:
      return spelledNumber(drawnNumber(key.lowest, key.highest));
    case ValueKind::INTEGER:
      return std::to_string(drawnCount(static_cast<int>(key.lowest), static_cast<int>(key.highest)));
    case ValueKind::SEED:
      return drawnChance(10) ? "18446744073709551615" : std::to_string(*rc::gen::arbitrary<std::uint64_t>());
    case ValueKind::TRUTH:
      return drawnChance(50) ? "true" : "false";
    case ValueKind::WORD:
      return key.words[drawnIndex<std::size_t>(0, key.words.size())];
    default:
      return "A";
  }
}

/// Every key of the part, or only some of those that need not be there.
SceneTree drawnPart(const std::string& part)
{
  SceneTree map = SceneTree::map();
  for (const SceneKey& key : sceneKeys())
    if (key.part == part && (key.required || drawnChance(60)))
      map[key.name] = SceneTree(drawnText(key));
  return map;
}

double valueOf(SceneTree& map, const std::string& key, double default_value)
{
  return map.has(key) ? std::strtod(map[key].flowText().c_str(), nullptr) : default_value;
}

void drawSpecies(SceneTree& root, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    SceneTree species = drawnPart("species");
    species["name"] = SceneTree(NAMES[i]);
    root.listAt("species").append(species);
  }
}

void drawPairs(SceneTree& root, std::size_t species)
{
  for (std::size_t i = 0; i < species; ++i)
    for (std::size_t j = 0; j < i; ++j)
    {
      if (!drawnChance(40))
        continue;
      SceneTree pair = drawnPart("pairs");
      SceneTree& names = pair.listAt("species");
      const bool turned = drawnChance(50);
      names.append(NAMES[turned ? j : i]);
      names.append(NAMES[turned ? i : j]);
      root.listAt("pairs").append(pair);
    }
}

/// Where the disks come from: `initial`, a density, or counts.
void drawPlacing(SceneTree& root)
{
  const std::size_t species = root.listAt("species").items().size();
  root.remove("density");
  const int placing = drawnIndex(0, 3);
  if (placing == 1)
    for (std::size_t i = drawnIndex<std::size_t>(1, 4); i > 0; --i)
    {
      SceneTree disk = drawnPart("initial");
      disk["species"] = SceneTree(NAMES[drawnIndex<std::size_t>(0, species)]);
      root.listAt("initial").append(disk);
    }
  if (placing == 2)
    // The most that splits up into counts is left to the spoilers.
    root["density"] = SceneTree(spelledNumber(drawnMagnitude(1e-12, 1e-6)));
  for (auto& item : root.listAt("species").items())
    if (placing == 0 && !item.second.has("count"))
      item.second["count"] = SceneTree(std::to_string(drawnIndex(0, 1000)));
}

void limit(SceneTree& root, const char* section, const char* key, double highest)
{
  SceneTree& map = root.mapAt(section);
  if (std::abs(valueOf(map, key, 0.0)) > highest)
    map[key] = SceneTree(spelledNumber(highest * drawnFraction()));
}

/// Nothing so large or so fast that places and times would be too coarse for the smallest disk: by simpler
/// and narrower bounds than the rule's.
void enforceResolution(SceneTree& root, double width)
{
  double radius = 1e3;
  for (auto& item : root.listAt("species").items())
  {
    const double least = 1e-6 * width;
    if (valueOf(item.second, "radius", 0.0) < least)
      item.second["radius"] = SceneTree(spelledNumber(std::min(1e3, least * drawnMagnitude(1.0, 1e3))));
    radius = std::min(radius, valueOf(item.second, "radius", 0.0));
  }
  const double fall = std::sqrt(valueOf(root.mapAt("base"), "tooth_width", 0.02) /
                                std::max(1e-300, valueOf(root, "gravity", 9.81)));
  const double frequency = valueOf(root.mapAt("base"), "frequency", 23.0);
  for (auto& item : root.mapAt("base").listAt("harmonics").items())
    for (const char* key : {"amplitude", "horizontal_amplitude"})
      item.second[key] = SceneTree(spelledNumber(std::min(1e3, radius) * drawnSigned(-1.0, 1.0)));
  const double time_scale = std::min({1.0, fall, frequency > 0.0 ? 1.0 / frequency : 1.0});
  // A fall from as high as this comes as fast: v = sqrt(2 g h).
  const double speed = std::min(1e4, 1e4 * radius / std::max(time_scale, fall > 1.0 ? fall : 0.0));
  const double height =
      std::min({1e3, 1e5 * radius, speed * speed / (2.0 * std::max(1e-300, valueOf(root, "gravity", 9.81)))});
  limit(root, "base", "tooth_height", std::min(1e3, 1e6 * radius));
  limit(root, "base", "wall_height", std::min(1e3, 1e6 * radius));
  limit(root, "base", "amplitude", std::min(1e3, 1e3 * radius));
  if (!root.mapAt("base").has("amplitude"))
    root.mapAt("base")["amplitude"] = SceneTree(spelledNumber(std::min(0.002, 1e3 * radius)));
  limit(root, "base", "horizontal_amplitude", std::min(1e3, 1e3 * radius));
  limit(root, "contact", "min_rebound_speed", speed);
  limit(root, "pour", "speed", 0.5 * speed);
  limit(root, "pour", "drop_height", 0.5 * height);
  for (auto& item : root.listAt("initial").items())
  {
    for (const char* key : {"vx", "vy"})
      if (std::abs(valueOf(item.second, key, 0.0)) > 0.5 * speed)
        item.second[key] = SceneTree(spelledNumber(0.5 * speed * drawnFraction()));
    for (const char* key : {"x", "y"})
      if (std::abs(valueOf(item.second, key, 0.0)) > 0.5 * height)
        item.second[key] = SceneTree(spelledNumber(0.5 * height * drawnFraction()));
  }
}

/// The rules that join several keys.
void enforceRules(SceneTree& root)
{
  SceneTree& base = root.mapAt("base");
  double width = valueOf(base, "teeth", 20.0) * valueOf(base, "tooth_width", 0.02);
  if (width < 4e-9)
  {
    base["teeth"] = SceneTree("4");
    width = 4.0 * valueOf(base, "tooth_width", 0.02);
  }
  double shares = 0.0;
  for (auto& item : root.listAt("species").items())
  {
    // An unlucky density over minute disks could be too many of them.
    if (2.0 * valueOf(item.second, "radius", 0.0) > width || root.has("density"))
      item.second["radius"] =
          SceneTree(spelledNumber(std::min(1e3, width * drawnMagnitude(std::max(1e-3, 1e-9 / width), 0.5))));
    shares += valueOf(item.second, "share", 1.0);
  }
  if (shares <= 0.0)
    root.listAt("species").items()[0].second["share"] = SceneTree("1");
  const double duration = valueOf(root, "duration", 100.0);
  if (valueOf(root, "settle", 0.0) > duration)
    root["settle"] = SceneTree(spelledNumber(duration * drawnFraction()));
  for (const char* part : {"pour", "feed"})
  {
    limit(root, part, "to", width);
    limit(root, part, "from", std::min(width, valueOf(root.mapAt(part), "to", width)));
  }
  enforceResolution(root, width);
}

SceneTree drawnTree()
{
  SceneTree root = drawnPart("");
  for (const char* section : {"base", "contact", "pour", "feed", "height_profile"})
    if (drawnChance(70))
      root.mapAt(section) = drawnPart(section);
  for (auto harmonics = drawnIndex<std::size_t>(0, 4); harmonics > 0; --harmonics)
  {
    SceneTree harmonic = SceneTree::map();
    harmonic["multiple"] = SceneTree(std::to_string(drawnIndex(2, 101)));
    harmonic["horizontal_phase"] = SceneTree(spelledNumber(drawnSigned(-1e6, 1e6)));
    root.mapAt("base").listAt("harmonics").append(harmonic);
  }
  const auto count = drawnIndex<std::size_t>(1, NAMES.size() + 1);
  drawSpecies(root, count);
  drawPairs(root, count);
  drawPlacing(root);
  enforceRules(root);
  return root;
}

/// Whether all of it together is too much, though each number is legal: too fine, or too many disks.
bool tooMuch(const SceneTree& root)
{
  try
  {
    sceneFromText(root.text(), "wide");
    return false;
  }
  catch (const SceneError& error)
  {
    const std::string refusal = error.what();
    return refusal.find("double precision") != std::string::npos ||
           refusal.find("in total") != std::string::npos;
  }
}

}  // namespace

SceneTree drawnWideScene()
{
  SceneTree root = drawnTree();
  while (tooMuch(root))
    root = drawnTree();
  return root;
}

}  // namespace ratchet_sieve

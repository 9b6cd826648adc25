#include "scene_spoilers.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "draws.h"
#include "scene_keys.h"
#include "spoiling.h"

namespace ratchet_sieve
{
namespace
{

std::string exact(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// A wrong value: what is written, and how an error shows it where that differs.
struct WrongValue
{
  std::string way;
  std::function<std::string()> text;
  std::string shown = "";
};

WrongValue always(const std::string& way, const std::string& text, const std::string& shown = "")
{
  return {way, [text] { return text; }, shown};
}

/// What no single value is.
void addShapes(std::vector<WrongValue>& wrong)
{
  wrong.push_back(always("a map", "{a: 1}", "a map"));
  wrong.push_back(always("a list", "[1, 2]", "a list"));
  wrong.push_back(always("nothing", "", "nothing"));
  wrong.push_back({"null", [] { return drawnOf<const char*>({"~", "null"}); }, "nothing"});
}

std::vector<WrongValue> wrongNumbers(const SceneKey& key)
{
  const double low = key.lowest;
  const double high = key.highest;
  constexpr double INF = std::numeric_limits<double>::infinity();
  std::vector<WrongValue> wrong = {
      {"just below", [=] { return exact(std::nextafter(low, -INF)); }},
      {"below", [=] { return exact(std::min(low - drawnMagnitude(1e-9, 1e12), std::nextafter(low, -INF))); }},
      {"just above", [=] { return exact(std::nextafter(high, INF)); }},
      {"above",
       [=] { return exact(std::max(high + drawnMagnitude(1e-9, 1e300), std::nextafter(high, INF))); }},
      {"not a number",
       [] {
         return drawnOf<const char*>({".nan", "nan", "NaN", "-nan"});
       }},
      {"infinite",
       [] {
         return drawnOf<const char*>({".inf", "-.inf", "inf", "Infinity", "1e999", "-1e999"});
       }},
      {"text",
       [] {
         return drawnOf<const char*>({"wide", "one", "true", "half"});
       }},
      {"with a tail",
       [] {
         return drawnOf<const char*>({"0.5m", "1 2", "0.5.1", "1e", "1e-", "0x1", "1_0", "--1"});
       }},
      {"in quotes",
       [] {
         return drawnOf<const char*>({"\"0.5\"", "\"1\""});
       }},
  };
  addShapes(wrong);
  return wrong;
}

std::vector<WrongValue> wrongIntegers(const SceneKey& key)
{
  const auto low = static_cast<long long>(key.lowest);
  const auto high = static_cast<long long>(key.highest);
  std::vector<WrongValue> wrong = {
      {"just below", [=] { return std::to_string(low - 1); }},
      {"below", [=] { return std::to_string(low - drawnIndex(1LL, 1LL << 60)); }},
      {"just above", [=] { return std::to_string(high + 1); }},
      {"above", [=] { return std::to_string(high + drawnIndex(1LL, 1LL << 60)); }},
      always("too long", "99999999999999999999999"),
      {"with a fraction",
       [] {
         return drawnOf<const char*>({"1.5", "2.0", "1e3", "1."});
       }},
      {"not a number",
       [] {
         return drawnOf<const char*>({".nan", "nan", ".inf", "many", "true", "0x10", "1 2"});
       }},
      always("in quotes", "\"1\""),
  };
  addShapes(wrong);
  return wrong;
}

std::vector<WrongValue> wrongWords(std::vector<const char*> texts)
{
  std::vector<WrongValue> wrong;
  for (const char* text : texts)
    wrong.push_back(always(text, text));
  addShapes(wrong);
  return wrong;
}

std::vector<WrongValue> wrongNames()
{
  std::vector<WrongValue> wrong = {
      {"of a bad character",
       []
       {
         const char* const bad = " !#$%&()*+,/:;<=>?@[]^`{|}";
         return "\"a" + std::string(1, bad[drawnIndex<std::size_t>(0, 26)]) + "b\"";
       }},
      always("empty", "\"\""),
      always("not ASCII", "\xc3\xa4"),
      {"too long", [] { return std::string(drawnIndex<std::size_t>(65, 200), 'a'); },
       std::string(60, 'a') + "..."},
  };
  addShapes(wrong);
  return wrong;
}

std::vector<WrongValue> wrongValues(const SceneKey& key)
{
  switch (key.kind)
  {
    case ValueKind::NUMBER:
      return wrongNumbers(key);
    case ValueKind::INTEGER:
      return wrongIntegers(key);
    case ValueKind::SEED:
      return wrongWords({"-1", "18446744073709551616", "1.5", "1e3", "+1", "abc", ".nan", "\"1\""});
    case ValueKind::TRUTH:
      return wrongWords({"1", "0", "yes", "no", "True", "FALSE", "on", "\"true\""});
    case ValueKind::WORD:
      return wrongWords({"closed", "PERIODIC", "\"\"", "1", "true", ".nan"});
    case ValueKind::NAME:
      return wrongNames();
    case ValueKind::SPECIES:
      return wrongWords({"nobody", "a", "1", "\"\"", "\"A B\""});
    case ValueKind::TWO_SPECIES:
      break;
  }
  return {};
}

void addWrongValues(std::vector<Spoiler>& spoilers)
{
  for (const SceneKey& key : sceneKeys())
    for (const WrongValue& wrong : wrongValues(key))
      spoilers.push_back(
          {key.part + "." + key.name + " " + wrong.way, [key, wrong](SceneTree& root)
           {
             if (key.name == "density")
               root.remove("initial");
             const PartPlace place = placeOf(root, key.part);
             const std::string text = wrong.text();
             (*place.map)[key.name] = SceneTree(text);
             return Expected{place.prefix + key.name, wrong.shown.empty() ? text : wrong.shown, ""};
           }});
}

/// A key that is nearly right.
std::string misspelt(const std::string& name)
{
  std::string word = name;
  const std::size_t at = drawnIndex<std::size_t>(1, word.size());
  switch (drawnIndex(0, 3))
  {
    case 0:
      return word.insert(at, 1, 'z');
    case 1:
      word[at] = word[at] == 'z' ? 'q' : 'z';
      return word;
    default:
      return word + "_";
  }
}

void addWrongKeys(std::vector<Spoiler>& spoilers)
{
  for (const SceneKey& key : sceneKeys())
  {
    spoilers.push_back(
        {key.part + "." + key.name + " misspelt", [key](SceneTree& root)
         {
           // Of shorter words another may be as near.
           constexpr std::size_t LONG_ENOUGH = 4;
           const PartPlace place = placeOf(root, key.part);
           const std::string wrong = key.name.size() > 1 ? misspelt(key.name) : key.name + "_long_word";
           place.map->force(wrong, SceneTree("1"));
           return Expected{place.prefix + wrong, "",
                           key.name.size() >= LONG_ENOUGH ? "did you mean " + key.name + "?" : "unknown key"};
         }});
    spoilers.push_back({key.part + "." + key.name + " twice", [key](SceneTree& root)
                        {
                          const PartPlace place = placeOf(root, key.part);
                          if (!place.map->has(key.name))
                            place.map->force(key.name, SceneTree("1"));
                          place.map->force(key.name, SceneTree((*place.map)[key.name]));
                          return Expected{place.prefix + key.name, "", "is given twice"};
                        }});
    if (key.required)
      spoilers.push_back({key.part + "." + key.name + " missing", [key](SceneTree& root)
                          {
                            const PartPlace place = placeOf(root, key.part);
                            place.map->remove(key.name);
                            return Expected{place.prefix + key.name, "", "missing"};
                          }});
  }
}

void addWrongParts(std::vector<Spoiler>& spoilers)
{
  for (const char* part :
       {"base", "species", "pairs", "contact", "pour", "feed", "height_profile", "initial"})
  {
    const std::string name = part;
    const auto add = [&](const std::string& text, const std::string& shown)
    {
      spoilers.push_back({name + " is " + shown, [=](SceneTree& root)
                          {
                            root[name] = SceneTree(text);
                            return Expected{name, shown, ""};
                          }});
    };
    add("20", "20");
    add("", "nothing");
    add(isList(name) ? "{a: 1}" : "[1, 2]", isList(name) ? "a map" : "a list");
    if (isList(name))
      spoilers.push_back({name + " of a single value", [=](SceneTree& root)
                          {
                            placeOf(root, name);
                            auto& items = root.listAt(name).items();
                            const auto at = drawnIndex<std::size_t>(0, items.size());
                            items[at].second = SceneTree("7");
                            return Expected{name + "." + std::to_string(at), "7", ""};
                          }});
  }
}

std::vector<Spoiler> allSpoilers()
{
  std::vector<Spoiler> spoilers;
  addWrongValues(spoilers);
  addWrongKeys(spoilers);
  addWrongParts(spoilers);
  addBrokenRules(spoilers);
  return spoilers;
}

}  // namespace

PartPlace placeOf(SceneTree& root, const std::string& part)
{
  if (part.empty())
    return {&root, ""};
  if (!isList(part))
    return {&root.mapAt(part), part + "."};
  if (part == "pairs")
    requirePair(root);
  if (part == "initial")
    requireInitial(root);
  auto& items = root.listAt(part).items();
  const auto at = drawnIndex<std::size_t>(0, items.size());
  return {&items[at].second, part + "." + std::to_string(at) + "."};
}

const std::vector<Spoiler>& sceneSpoilers()
{
  static const std::vector<Spoiler> SPOILERS = allSpoilers();
  return SPOILERS;
}

}  // namespace ratchet_sieve

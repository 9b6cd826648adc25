#include <algorithm>
#include <cctype>
#include <set>

#include "ratchet_sieve/sweep/case_result.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;
using Columns = std::vector<std::pair<std::string, Json>>;

/// Stand in every row, or say what the scene is and not what came of it.
const std::set<std::string> LEFT_OUT = {"scene_hash", "seed", "version", "wall_time", "plan"};

bool isScalar(const Json& value)
{
  return value.is_number() || value.is_boolean() || value.is_null();
}

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// SQL takes no notice of a letter's case in a column's name.
bool haveColumns(const Json& species)
{
  std::set<std::string> names;
  for (const Json& each : species)
    names.insert(lowerCase(each.at("name").get<std::string>()));
  return names.size() == species.size() && species.size() <= MOST_COLUMN_SPECIES;
}

/// @param prefix of the columns' names
void addSpecies(const std::string& prefix, const Json& species, Columns& columns)
{
  if (!haveColumns(species))
    return;
  for (const Json& each : species)
    for (const auto& [field, value] : each.items())
      if (isScalar(value))
        columns.emplace_back(
            std::string(prefix).append(field).append(".").append(each.at("name").get<std::string>()), value);
}

bool isOfSpecies(const Json& list)
{
  return list.is_array() && !list.empty() && list[0].is_object() && list[0].contains("name");
}

/// A vector of the plane by its components, a map by its keys, however deep.
void addParts(const std::string& key, const Json& value, Columns& columns)
{
  if (value.is_array() && value.size() == 2 && value[0].is_number())
  {
    columns.emplace_back(key + ".x", value[0]);
    columns.emplace_back(key + ".y", value[1]);
  }
  if (value.is_object())
    for (const auto& [part, scalar] : value.items())
    {
      const std::string name = std::string(key).append(".").append(part);
      if (isScalar(scalar))
        columns.emplace_back(name, scalar);
      else if (isOfSpecies(scalar))
        addSpecies(name + '.', scalar, columns);
      else
        addParts(name, scalar, columns);
    }
}

}  // namespace

std::vector<std::pair<std::string, Json>> summaryColumns(const Json& summary)
{
  Columns columns;
  if (!summary.is_object())
    return columns;
  for (const auto& [key, value] : summary.items())
  {
    if (LEFT_OUT.count(key) > 0)
      continue;
    if (isScalar(value))
      columns.emplace_back(key, value);
    else if (key == "species")
      addSpecies("", value, columns);
    else
      addParts(key, value, columns);
  }
  return columns;
}

}  // namespace ratchet_sieve

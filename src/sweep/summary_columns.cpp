#include <map>
#include <set>

#include <fmt/format.h>

#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/database.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

/// In every row already, part of the scene rather than of the result, or as long as the scene makes it.
const std::set<std::string> LEFT_OUT = {"scene_hash", "seed", "version",
                                        "wall_time",  "plan", "contacts_by_face"};

/// A map, or null for the reason, a text.
constexpr const char* STEADY = "steady";
constexpr const char* STEADY_REASON = "steady_reason";

bool isScalar(const Json& value)
{
  return value.is_number() || value.is_boolean() || value.is_null();
}

/// Calls `add(each, name)` with each of the species, unless they are too many, and its name in columns. SQL
/// ignores case in column names: if names differ only in case, the second in byte order gets the suffix `
/// (2)`, and so on.
template <typename Add>
void forSpecies(const Json& species, const Add& add)
{
  if (species.size() > MOST_COLUMN_SPECIES)
    return;
  std::map<std::string, std::string> names;
  for (const Json& each : species)
    names[each.at("name").get<std::string>()];
  std::map<std::string, int> alike;
  for (auto& [name, column] : names)
  {
    const int place = ++alike[lowerCase(name)];
    column = place == 1 ? name : name + " (" + std::to_string(place) + ')';
  }
  for (const Json& each : species)
    add(each, names.at(each.at("name").get<std::string>()));
}

/// Adds the scalars of a map, and of those in it, as `PREFIX FIELD.NAME`.
void addScalars(const std::string& prefix, const Json& map, const std::string& name, SummaryColumns& columns)
{
  for (const auto& [field, value] : map.items())
    if (isScalar(value))
      columns.emplace_back(fmt::format("{}{}.{}", prefix, field, name), value);
    else if (value.is_object())
      addScalars(fmt::format("{}{}.", prefix, field), value, name, columns);
}

bool isOfSpecies(const Json& list)
{
  return list.is_array() && !list.empty() && list[0].is_object() && list[0].contains("name");
}

/// A scalar; or those of each species, the components of a vector or the parts of a map, at any depth.
void addParts(const std::string& key, const Json& value, SummaryColumns& columns)
{
  if (isScalar(value))
    columns.emplace_back(key, value);
  else if (isOfSpecies(value))
    forSpecies(value,
               [&, prefix = key == "species" ? "" : key + '.'](const Json& each, const std::string& name)
               { addScalars(prefix, each, name, columns); });
  else if (value.is_array() && value.size() == 2 && value[0].is_number())
  {
    columns.emplace_back(key + ".x", value[0]);
    columns.emplace_back(key + ".y", value[1]);
  }
  else if (value.is_object())
    for (const auto& [part, scalar] : value.items())
      addParts(fmt::format("{}.{}", key, part), scalar, columns);
}

/// The number of warnings, and their texts.
void addWarnings(const Json& warnings, SummaryColumns& columns)
{
  std::string texts;
  for (const Json& warning : warnings)
    texts += (texts.empty() ? "" : " | ") + warning.get<std::string>();
  columns.emplace_back("warnings", warnings.size());
  columns.emplace_back("warning_text", texts.empty() ? Json(nullptr) : Json(texts));
}

/// Disks of all species that left.
void addCounted(const Json& species, SummaryColumns& columns)
{
  std::uint64_t counted = 0;
  for (const Json& each : species)
    counted += each.value("left", std::uint64_t{0}) + each.value("right", std::uint64_t{0});
  columns.emplace_back("counted", counted);
}

/// The scalars of each size class, numbered from 1.
void addSizeClasses(const Json& species, SummaryColumns& columns)
{
  const auto add = [&columns](const Json& each, const std::string& name)
  {
    std::size_t number = 0;
    for (const Json& one : each.value("size_classes", Json::array()))
      addScalars(fmt::format("size_classes.{}.", ++number), one, name, columns);
  };
  forSpecies(species, add);
}

}  // namespace

SummaryColumns summaryColumns(const Json& summary)
{
  SummaryColumns columns;
  if (!summary.is_object())
    return columns;
  for (const auto& [key, value] : summary.items())
  {
    if (key == STEADY_REASON)
      columns.emplace_back(key, value);
    else if (LEFT_OUT.count(key) == 0 && !(key == STEADY && value.is_null()))
      addParts(key, value, columns);
    if (key == "species")
      addCounted(value, columns);
    if (key == "warnings")
      addWarnings(value, columns);
  }
  // Last, for they are many and there may be no room for all.
  addSizeClasses(summary.value("species", Json::array()), columns);
  return columns;
}

}  // namespace ratchet_sieve

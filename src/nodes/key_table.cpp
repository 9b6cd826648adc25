#include "key_table.h"

#include <fmt/format.h>

#include "command_line.h"
#include "ratchet_sieve/scene/key_list.h"

namespace ratchet_sieve
{
namespace
{

std::string row(const KeyText& text)
{
  return fmt::format("{:<38}  {:<7}  {:<6}  {:<25}  {}\n", text.key, text.type,
                     text.unit.empty() ? "-" : text.unit, text.values, text.default_text);
}

}  // namespace

std::string keyTable(const std::string& part)
{
  std::string table;
  for (const KeyGroup& group : sceneKeyGroups())
  {
    std::string rows;
    for (const KeyText& key : group.keys)
      if (key.key.find(part) != std::string::npos)
        rows += row(key) + wrappedText(key.meaning, 4);
    if (!rows.empty())
      table += fmt::format("{}{}: {}\n\n", table.empty() ? "" : "\n",
                           group.name.empty() ? "scene" : group.name, group.meaning) +
               rows;
  }
  if (table.empty())
    return "";
  return row({"KEY", "TYPE", "UNIT", "ALLOWED", "DEFAULT", ""}) + "\n" + table;
}

}  // namespace ratchet_sieve

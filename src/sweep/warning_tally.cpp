#include "ratchet_sieve/sweep/warning_tally.h"

#include <algorithm>
#include <set>

#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

constexpr std::size_t MOST_LINES = 5;

}  // namespace

void WarningTally::add(const std::vector<std::string>& warnings, std::uint64_t cases)
{
  std::set<std::string> counted;
  for (const std::string& text : warnings)
  {
    const std::string id = warningId(text);
    Group& group = groups_.try_emplace(id, Group{text}).first->second;
    group.alike = group.alike && text == group.first;
    if (counted.insert(id).second)
      group.cases += cases;
  }
  warned_ += warnings.empty() ? 0 : cases;
}

std::vector<std::string> WarningTally::lines(std::uint64_t cases, const std::string& noun) const
{
  std::vector<const Group*> order;
  for (const auto& [id, group] : groups_)
    order.push_back(&group);
  std::stable_sort(order.begin(), order.end(),
                   [](const Group* a, const Group* b) { return a->cases > b->cases; });
  std::vector<std::string> lines;
  for (const Group* group : order)
  {
    if (lines.size() == MOST_LINES)
    {
      lines.push_back("and " + countText(order.size() - MOST_LINES, "other warning"));
      break;
    }
    const std::string where = group->cases == cases
                                  ? "every " + noun
                                  : std::to_string(group->cases) + " of " + countText(cases, noun);
    lines.push_back("in " + where + (group->alike ? ": " : ", such as: ") + group->first);
  }
  return lines;
}

}  // namespace ratchet_sieve

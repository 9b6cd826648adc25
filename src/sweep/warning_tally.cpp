#include "ratchet_sieve/sweep/warning_tally.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "ratchet_sieve/core/count_text.h"

namespace ratchet_sieve
{
namespace
{

constexpr std::size_t MOST_LINES = 5;

bool isDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Whether the text after this character continues a name or a number.
bool isWithinWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_';
}

/// The end of a number that begins at a digit: all of `1.5e-05`, without a full stop after it.
std::size_t endOfNumber(const std::string& text, std::size_t at)
{
  const auto digit_at = [&text](std::size_t k) { return k < text.size() && isDigit(text[k]); };
  while (at < text.size())
  {
    const char c = text[at];
    const bool has_sign = at + 1 < text.size() && (text[at + 1] == '-' || text[at + 1] == '+');
    if (isDigit(c) || (c == '.' && digit_at(at + 1)) || (c == 'e' && digit_at(at + 1)))
      ++at;
    else if (c == 'e' && has_sign && digit_at(at + 2))
      at += 2;
    else
      break;
  }
  return at;
}

std::string withoutNumbers(const std::string& text)
{
  std::string pattern;
  for (std::size_t at = 0; at < text.size();)
  {
    if (!isDigit(text[at]) || (at > 0 && isWithinWord(text[at - 1])))
    {
      pattern += text[at++];
      continue;
    }
    pattern += '#';
    at = endOfNumber(text, at);
  }
  return pattern;
}

}  // namespace

void WarningTally::add(const std::vector<std::string>& warnings, std::uint64_t cases)
{
  std::set<std::string> counted;
  for (const std::string& text : warnings)
  {
    const std::string pattern = withoutNumbers(text);
    Group& group = groups_.try_emplace(pattern, Group{text}).first->second;
    group.alike = group.alike && text == group.first;
    if (counted.insert(pattern).second)
      group.cases += cases;
  }
  warned_ += warnings.empty() ? 0 : cases;
}

std::vector<std::string> WarningTally::lines(std::uint64_t cases, const std::string& noun) const
{
  std::vector<const Group*> order;
  for (const auto& [pattern, group] : groups_)
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

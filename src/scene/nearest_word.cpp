#include "nearest_word.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace ratchet_sieve
{
namespace
{

std::size_t editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string> nearestWord(const std::string& word, const std::set<std::string>& known)
{
  std::optional<std::string> nearest;
  std::size_t least = word.size() / 2 + 1;
  for (const std::string& candidate : known)
  {
    // The difference in length is a lower bound of the distance. Saves time on words of megabytes.
    if (word.size() >= candidate.size() + least)
      continue;
    const std::size_t distance = editDistance(word, candidate);
    if (distance >= least)
      continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace ratchet_sieve

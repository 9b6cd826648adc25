#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ratchet_sieve
{

/// Groups the warnings of cases by warningId().
class WarningTally
{
public:
  /// @param warnings of one case, or of each of `cases` cases
  void add(const std::vector<std::string>& warnings, std::uint64_t cases = 1);

  std::uint64_t warned() const { return warned_; }  ///< cases with a warning

  /// One line for each of the most frequent warnings, for example `in 3 of 12 cases: ...`; if their texts
  /// differ, that of the first. @param cases total number @param noun for the items counted, for example
  /// `case`
  std::vector<std::string> lines(std::uint64_t cases, const std::string& noun) const;

private:
  struct Group
  {
    std::string first;  ///< text of the first
    bool alike = true;  ///< all texts are equal to `first`
    std::uint64_t cases = 0;
  };
  std::map<std::string, Group> groups_;  ///< by id
  std::uint64_t warned_ = 0;
};

}  // namespace ratchet_sieve

#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ratchet_sieve/core/results.h"

/// What a run has observed, by name.
namespace ratchet_sieve::test
{

template <typename Named>
const Named& named(const std::vector<Named>& all, const std::string& name)
{
  for (const Named& one : all)
    if (one.name == name)
      return one;
  throw std::out_of_range(name);
}

inline std::optional<double> numberOf(const ObservedRow& row, const std::string& name)
{
  return named(row.numbers, name).value;
}

inline const std::vector<std::optional<double>>& columnOf(const ObservedRow& row, const std::string& name)
{
  return named(row.table, name).values;
}

}  // namespace ratchet_sieve::test

#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/fields.h"

/// What a scene can ask to be observed (`observe`), and what is then seen.
namespace ratchet_sieve
{

/// A number of an observable; nothing where it is undefined.
struct ObservedNumber
{
  std::string name;
  std::string unit;
  std::optional<double> value;
};

RATCHET_SIEVE_FIELDS(ObservedNumber)
{
  RATCHET_SIEVE_FIELD(name, "");
  RATCHET_SIEVE_FIELD(unit, "");
  RATCHET_SIEVE_OPTIONAL(value, "");
}

/// A column of a row's table.
struct ObservedColumn
{
  std::string name;
  std::string unit;
  std::vector<std::optional<double>> values;
};

RATCHET_SIEVE_FIELDS(ObservedColumn)
{
  RATCHET_SIEVE_FIELD(name, "");
  RATCHET_SIEVE_FIELD(unit, "");
  RATCHET_SIEVE_OPTIONAL(values, "");
}

/// Adds a value to each column.
inline void addLine(std::vector<ObservedColumn>& table, std::initializer_list<std::optional<double>> values)
{
  auto column = table.begin();
  for (const std::optional<double>& value : values)
    (column++)->values.push_back(value);
}

/// What was observed of one species at one place.
struct ObservedRow
{
  std::string place;    ///< the bin, left or right; empty: the whole machine
  std::string species;  ///< its name
  std::vector<ObservedNumber> numbers;
  std::vector<ObservedColumn> table;  ///< columns of the same length
};

RATCHET_SIEVE_FIELDS(ObservedRow)
{
  RATCHET_SIEVE_FIELD(place, "");
  RATCHET_SIEVE_FIELD(species, "");
  RATCHET_SIEVE_FIELD(numbers, "");
  RATCHET_SIEVE_FIELD(table, "");
}

/// One observable: rows by place, of all species in order.
struct Observed
{
  std::string name;
  std::vector<ObservedRow> rows;
};

RATCHET_SIEVE_FIELDS(Observed)
{
  RATCHET_SIEVE_FIELD(name, "");
  RATCHET_SIEVE_FIELD(rows, "");
}

/// What `observe` can name.
std::vector<std::string> observableNames();

}  // namespace ratchet_sieve

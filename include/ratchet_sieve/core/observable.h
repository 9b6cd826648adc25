#pragma once

#include <optional>
#include <string>
#include <vector>

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

/// A column of a row's table.
struct ObservedColumn
{
  std::string name;
  std::string unit;
  std::vector<std::optional<double>> values;
};

/// What was observed of one species at one place.
struct ObservedRow
{
  std::string place;    ///< the bin, left or right; empty: the whole machine
  std::string species;  ///< its name
  std::vector<ObservedNumber> numbers;
  std::vector<ObservedColumn> table;  ///< columns of the same length
};

/// One observable: rows by place, of all species in order.
struct Observed
{
  std::string name;
  std::vector<ObservedRow> rows;
};

/// What `observe` can name.
std::vector<std::string> observableNames();

}  // namespace ratchet_sieve

#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/database.h"

namespace ratchet_sieve
{

/// The table `cases` of a results file: one row per completed case, of any physics version. Its key is
/// runHash() and version().
class ResultStore
{
public:
  /// @throws DatabaseError if the file is no results file or cannot be opened
  ResultStore(const std::string& path, Database::Access access);

  Database& database() { return database_; }
  const Database& database() const { return database_; }

  /// Adds a column for each key that has none. @throws DatabaseError
  void addColumns(const std::vector<std::string>& names);

  bool hasColumn(const std::string& name) const;
  std::vector<std::string> columnNames() const;

  /// `done` or `failed`; nothing if the case has no row of this physics version. @throws DatabaseError
  std::optional<std::string> statusOf(const std::string& run_hash) const;

  /// Adds a row unless the case has one. Scalars of the summary without a column are stored in its JSON only.
  /// @pre a transaction is open @throws DatabaseError
  void record(const CaseResult& result);

  /// Adds the rows of this physics version in another file, whole, for cases that have no row here or have
  /// failed. @pre a transaction is open @throws DatabaseError
  void copyFrom(const ResultStore& other);

private:
  void makeTables();
  std::set<std::string> columns() const;  ///< of the table, in lower case

  /// @param known columns(), to which a new one is added
  void addColumn(const std::string& name, std::set<std::string>& known);
  void insert(const SummaryColumns& row, std::set<std::string>& known);

  Database database_;
};

/// What the file has of a case, but for the summary's scalars.
SummaryColumns rowOf(const CaseResult& result);

/// YAML text as an integer, a number or text, according to its form; nothing as null.
nlohmann::ordered_json sqlValue(const std::optional<std::string>& value);

}  // namespace ratchet_sieve

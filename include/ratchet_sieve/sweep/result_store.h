#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/case_result.h"
#include "ratchet_sieve/sweep/database.h"

namespace ratchet_sieve
{

/// The table `cases` of a results file: a row for each case that came to its end, in which version of the
/// physics it may be. A case is known by runHash() and version().
class ResultStore
{
public:
  /// @throws DatabaseError if it is no results file, or cannot be opened
  ResultStore(const std::string& path, Database::Access access);

  Database& database() { return database_; }
  const Database& database() const { return database_; }

  /// Sees that there is a column for each of the keys. @throws DatabaseError
  void addColumns(const std::vector<std::string>& names);

  bool hasColumn(const std::string& name) const;
  std::vector<std::string> columnNames() const;

  /// Adds a row, if there is none of this case yet. @param keys of `result.values` @pre a transaction is open
  /// @throws DatabaseError
  void record(const std::vector<std::string>& keys, const CaseResult& result);

  /// To be called where a transaction was undone: columns that it added are gone with it.
  void forgetColumns();

private:
  void makeTables();
  void loadColumns();
  Statement& insertion(const std::vector<std::string>& columns);

  Database database_;
  std::set<std::string> columns_;  ///< in lower case
  std::map<std::string, std::unique_ptr<Statement>> insertions_;
};

/// Binds YAML text as what it is: an integer, a number or text; nothing as NULL.
void bindValue(Statement& statement, int parameter, const std::optional<std::string>& value);

}  // namespace ratchet_sieve

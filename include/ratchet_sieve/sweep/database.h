#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/recording/locked_file.h"

struct sqlite3;
struct sqlite3_stmt;

namespace ratchet_sieve
{

/// A database that cannot be read or written. One line names the file.
struct DatabaseError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// No space is left: the disk is full, or a size limit is reached. Earlier commits are intact.
struct DatabaseFull : DatabaseError
{
  using DatabaseError::DatabaseError;
};

/// What SQLite calls a database that is in no file. It is refused: nothing of it would be left.
constexpr const char* IN_MEMORY = ":memory:";

/// Values for SQL: null, numbers, texts, and booleans as 0 and 1. An integer of 2^63 or more becomes a text.
using SqlValues = std::vector<nlohmann::ordered_json>;

/// A connection to an SQLite file. For one thread.
class Database
{
public:
  enum class Access
  {
    READ,   ///< of an existing file, possibly in a read-only directory
    WRITE,  ///< of an existing or a new file, by one program at a time
  };
  /// @throws DatabaseError, also if another program has the file open for writing
  Database(const std::string& path, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::string& path() const { return path_; }

  /// Runs SQL, and ignores the rows. @throws DatabaseError
  void execute(const std::string& sql);

  /// Runs a statement with values of ?1, ?2, ... @throws DatabaseError
  void execute(const std::string& sql, const SqlValues& values);

  /// The first value of the first row of such a statement, null if there is none. @throws DatabaseError
  nlohmann::ordered_json value(const std::string& sql, const SqlValues& values = {}) const;

  /// @throws DatabaseError if the path now names another file or none
  void requireInPlace() const;

  [[noreturn]] void fail() const;
  sqlite3* handle() const { return connection_; }

private:
  void lock();
  void open(const std::string& name, int flags);
  bool needsWritableDirectory() const;
  void openUnchanging();

  std::string path_;
  std::unique_ptr<LockedFile> lock_;  ///< of a writer
  sqlite3* connection_ = nullptr;
};

/// `"name"`: a quoted SQL identifier, for any text.
std::string quotedName(const std::string& name);

/// A text with its ASCII letters in lower case: SQL compares names so.
std::string lowerCase(std::string text);

/// A prepared statement, run from its first row on by step(). Columns are numbered from 0.
class Statement
{
public:
  /// @param values of ?1, ?2, ... @throws DatabaseError
  Statement(const Database& database, const std::string& sql, const SqlValues& values = {});
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Advances to the next row. @return whether there is one @throws DatabaseError
  bool step();

  int columns() const;
  std::string columnName(int column) const;
  nlohmann::ordered_json value(int column) const;
  std::int64_t integer(int column) const;  ///< 0 for what is no number
  std::string text(int column) const;      ///< of a number as well; empty for NULL

private:
  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// A transaction, rolled back unless it is committed. Waits for other writers at its start.
class Transaction
{
public:
  /// @throws DatabaseError
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// @throws DatabaseError, also if the file was replaced or removed
  void commit();

private:
  Database& database_;
  bool open_ = true;
};

}  // namespace ratchet_sieve

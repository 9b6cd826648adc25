#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace ratchet_sieve
{

/// A node of a scene's YAML tree, with its position for error lines.
class Entry
{
public:
  /// @param source a file or parameter, named in errors @param name of the root, for errors without a key
  Entry(const YAML::Node& node, std::string source, std::string name = "scene")
      : node_(node), source_(std::move(source)), name_(std::move(name))
  {
  }

  const YAML::Node& node() const { return node_; }
  const std::string& key() const { return key_; }
  const std::string& source() const { return source_; }

  /// Whether a map has the key. @pre keys() was called
  bool has(const std::string& name) const;

  /// The entry of a map. @pre has(name)
  Entry at(const std::string& name) const;

  /// The entries of a list, in order. @throws SceneError if it is not a list
  std::vector<Entry> list() const;

  /// The keys of a map, in order. @throws SceneError if it is not a map, or if a key is given twice
  std::vector<std::string> keys() const;

  /// Checks the keys of a map. @throws SceneError as keys(), or if a key is not in `known` (the error
  /// suggests the nearest one), or if one of `required` is missing
  void requireKeys(const std::set<std::string>& known, const std::set<std::string>& required) const;

  /// "FILE:LINE: KEY = VALUE: ALLOWED". @throws SceneError always
  [[noreturn]] void refuseValue(const std::string& allowed) const;

  /// "FILE:LINE: KEY: REASON". @throws SceneError always
  [[noreturn]] void refuse(const std::string& reason) const;

  /// KEY.name, or name at the root.
  std::string keyOf(const std::string& name) const;

private:
  Entry child(const YAML::Node& node, const std::string& name) const;
  std::string place() const;
  std::string shownKey() const;

  YAML::Node node_;
  std::string source_;
  std::string name_;
  std::string key_;  ///< dotted path from the root; empty at the root
  YAML::Mark mark_ = YAML::Mark::null_mark();
};

}  // namespace ratchet_sieve

#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace ratchet_sieve
{

/// A scene's YAML before it is text: as a hand could write it.
class SceneTree
{
public:
  enum class Sort
  {
    SCALAR,
    MAP,
    LIST
  };

  /// A single value, as it will stand in the text.
  SceneTree(std::string text = "") : text_(std::move(text)) {}
  static SceneTree map() { return SceneTree(Sort::MAP); }
  static SceneTree list() { return SceneTree(Sort::LIST); }

  Sort sort() const { return sort_; }
  bool has(const std::string& key) const;

  /// A map's entry; made, as a single value of nothing, if it is not there.
  SceneTree& operator[](const std::string& key);

  /// A list's entries, or a map's with their keys.
  std::vector<std::pair<std::string, SceneTree>>& items() { return items_; }
  const std::vector<std::pair<std::string, SceneTree>>& items() const { return items_; }

  void append(SceneTree entry) { items_.emplace_back("", std::move(entry)); }

  void force(const std::string& key, SceneTree entry) { items_.emplace_back(key, std::move(entry)); }
  void remove(const std::string& key);

  /// As a scene file: one key of the root a line, and one line for every entry of its lists.
  std::string text() const;

  /// In one line.
  std::string flowText() const;

private:
  explicit SceneTree(Sort sort) : sort_(sort) {}

  Sort sort_ = Sort::SCALAR;
  std::string text_;
  std::vector<std::pair<std::string, SceneTree>> items_;
};

/// How rapidcheck shows a scene that fails.
inline std::ostream& operator<<(std::ostream& out, const SceneTree& tree)
{
  return out << tree.text();
}

}  // namespace ratchet_sieve

#include "scene_tree.h"

#include <algorithm>

namespace ratchet_sieve
{

bool SceneTree::has(const std::string& key) const
{
  return std::any_of(items_.begin(), items_.end(), [&](const auto& item) { return item.first == key; });
}

SceneTree& SceneTree::operator[](const std::string& key)
{
  for (auto& [name, entry] : items_)
    if (name == key)
      return entry;
  items_.emplace_back(key, SceneTree());
  return items_.back().second;
}

void SceneTree::remove(const std::string& key)
{
  items_.erase(
      std::remove_if(items_.begin(), items_.end(), [&](const auto& item) { return item.first == key; }),
      items_.end());
}

std::string SceneTree::flowText() const
{
  if (sort_ == Sort::SCALAR)
    return text_;
  std::string text;
  for (const auto& [key, entry] : items_)
    text += (text.empty() ? "" : ", ") + (sort_ == Sort::MAP ? key + ": " : "") + entry.flowText();
  return sort_ == Sort::MAP ? "{" + text + "}" : "[" + text + "]";
}

std::string SceneTree::text() const
{
  if (sort_ != Sort::MAP)
    return flowText() + "\n";
  std::string text;
  for (const auto& [key, entry] : items_)
  {
    text += key + ":";
    if (entry.sort_ == Sort::LIST && !entry.items_.empty())
      for (const auto& item : entry.items_)
        text += "\n  - " + item.second.flowText();
    else
      text += " " + entry.flowText();
    text += "\n";
  }
  return text;
}

}  // namespace ratchet_sieve

#include "ratchet_sieve/scene/entry.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

std::string valueText(const YAML::Node& node)
{
  if (node.IsMap())
    return "a map";
  if (node.IsSequence())
    return "a list";
  if (!node.IsScalar())
    return "nothing";
  const std::string text = shownText(node.Scalar());
  return node.Tag() == "!" ? '"' + text + '"' : text;
}

std::size_t editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// The known word with the least Levenshtein distance to `word`; nothing if the distance is more than half of
/// the length of `word`.
std::optional<std::string> nearestWord(const std::string& word, const std::set<std::string>& known)
{
  std::optional<std::string> nearest;
  std::size_t least = word.size() / 2 + 1;
  for (const std::string& candidate : known)
  {
    // The difference in length is a lower bound of the distance. Saves time on words of megabytes.
    if (word.size() >= candidate.size() + least)
      continue;
    const std::size_t distance = editDistance(word, candidate);
    if (distance >= least)
      continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

std::string suggestion(const std::string& name, const std::set<std::string>& known)
{
  if (const std::optional<std::string> nearest = nearestWord(name, known))
    return "did you mean " + *nearest + "?";
  return fmt::format("must be one of {}", fmt::join(known, ", "));
}

}  // namespace

bool Entry::has(const std::string& name) const
{
  return node_[name].IsDefined();
}

Entry Entry::at(const std::string& name) const
{
  Entry entry = child(node_[name], name);
  // For an empty value yaml-cpp gives the line of whatever follows; take the line of the key.
  if (entry.node_.IsDefined() && entry.node_.IsNull())
    for (const auto& item : node_)
      if (item.first.Scalar() == name)
        entry.mark_ = item.first.Mark();
  return entry;
}

Entry Entry::child(const YAML::Node& node, const std::string& name) const
{
  Entry entry(node, source_, name_);
  entry.key_ = keyOf(name);
  if (node.IsDefined())
    entry.mark_ = node.Mark();
  return entry;
}

std::string Entry::keyOf(const std::string& name) const
{
  return key_.empty() ? name : key_ + "." + name;
}

std::vector<Entry> Entry::list() const
{
  if (!node_.IsSequence())
    refuseValue("must be a list");
  std::vector<Entry> entries;
  for (const YAML::Node& node : node_)
    entries.push_back(child(node, std::to_string(entries.size())));
  return entries;
}

std::vector<std::string> Entry::keys() const
{
  if (!node_.IsMap())
    refuseValue("must be a map");
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const auto& item : node_)
  {
    if (!item.first.IsScalar())
    {
      Entry here = *this;
      here.mark_ = item.first.Mark();
      here.refuse("a key must be a word");
    }
    const std::string& name = item.first.Scalar();
    if (!seen.insert(name).second)
      child(item.first, name).refuse("is given twice");
    names.push_back(name);
  }
  return names;
}

void Entry::requireKeys(const std::set<std::string>& known, const std::set<std::string>& required) const
{
  const std::vector<std::string> names = keys();
  for (const auto& item : node_)
  {
    const std::string& name = item.first.Scalar();
    if (known.count(name) == 0)
      child(item.first, name).refuse("unknown key; " + suggestion(name, known));
  }
  for (const std::string& name : required)
    if (std::find(names.begin(), names.end(), name) == names.end())
      child(node_, name).refuse("missing");
}

std::string Entry::place() const
{
  std::string text = source_;
  if (!mark_.is_null())
    text += ":" + std::to_string(mark_.line + 1);
  return text + ": ";
}

std::string Entry::shownKey() const
{
  return key_.empty() ? name_ : shownText(key_);
}

void Entry::refuseValue(const std::string& allowed) const
{
  throw SceneError(place() + shownKey() + " = " + valueText(node_) + ": " + allowed, key_, valueText(node_),
                   allowed);
}

void Entry::refuse(const std::string& reason) const
{
  throw SceneError(place() + shownKey() + ": " + reason, key_, "", reason);
}

}  // namespace ratchet_sieve

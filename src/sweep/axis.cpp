#include "ratchet_sieve/sweep/axis.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "ratchet_sieve/scene/parsed.h"
#include "ratchet_sieve/scene/scalars.h"

namespace ratchet_sieve
{
namespace
{

constexpr double MOST_VALUES = 1e15;  ///< of one range: below 2^53, so that a double counts them

/// Characters that end a plain scalar within a flow map or list, or might.
constexpr const char* FLOW_MARKS = ",[]{}#:&*!|>'\"%@`\n\t";

std::string quoted(const std::string& text)
{
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << text;
  return emitter.c_str();
}

std::string scalarFlowText(const YAML::Node& node)
{
  const std::string& text = node.Scalar();
  const bool plain =
      node.Tag() != "!" && !text.empty() && text.find_first_of(FLOW_MARKS) == std::string::npos;
  return plain ? text : quoted(text);
}

SweptValues readRange(const Entry& entry)
{
  entry.requireKeys({"from", "to", "count"}, {"from", "to", "count"});
  double from = 0.0;
  double to = 0.0;
  std::uint64_t count = 0;
  double checked_count = 0.0;
  readScalar(entry.at("from"), {}, from);
  readScalar(entry.at("to"), {}, to);
  readScalar(entry.at("count"), {1.0, MOST_VALUES, ""}, checked_count);
  readScalar(entry.at("count"), {}, count);
  return {count, [from, to, count](std::uint64_t k) { return scalarText(rangeValue(from, to, count, k)); }};
}

SweptValues readList(const Entry& entry)
{
  const auto values = std::make_shared<std::vector<std::string>>();
  for (const Entry& value : entry.list())
  {
    if (value.node().IsNull())
      value.refuse("must have a value");
    values->push_back(flowText(value.node()));
  }
  if (values->empty())
    entry.refuse("must have one value or more");
  return {values->size(), [values](std::uint64_t k) { return (*values)[k]; }};
}

}  // namespace

std::string flowText(const YAML::Node& node)
{
  if (node.IsScalar())
    return scalarFlowText(node);
  if (!node.IsMap() && !node.IsSequence())
    return "~";
  std::string text;
  for (const auto& item : node)
  {
    text += text.empty() ? "" : ", ";
    text += node.IsMap() ? flowText(item.first) + ": " + flowText(item.second) : flowText(item);
  }
  return node.IsMap() ? '{' + text + '}' : '[' + text + ']';
}

double rangeValue(double from, double to, std::uint64_t count, std::uint64_t k)
{
  if (k + 1 == count && count > 1)
    return to;
  if (k == 0)
    return from;
  const double value = from + (to - from) * (static_cast<double>(k) / static_cast<double>(count - 1));
  return parsed<double>(fmt::format("{:.15g}", value)).value();
}

SweptValues readValues(const Entry& entry)
{
  if (entry.node().IsMap())
    return readRange(entry);
  if (!entry.node().IsSequence())
    entry.refuseValue("must be a list of values, or {from: .., to: .., count: ..}");
  return readList(entry);
}

Axis readGridAxis(const Entry& grid, const std::string& key)
{
  SweptValues values = readValues(grid.at(key));
  return {{key},
          values.count,
          [key, at = std::move(values.at)](std::uint64_t k) {
            return std::vector<Assignment>{{key, at(k)}};
          },
          key + ": " + flowText(grid.at(key).node())};
}

Axis readZip(const Entry& zip)
{
  Axis axis;
  axis.keys = zip.keys();
  if (axis.keys.empty())
    zip.refuse("must have one key or more");
  std::vector<SweptValues> columns;
  for (const std::string& key : axis.keys)
  {
    columns.push_back(readValues(zip.at(key)));
    if (columns.back().count != columns.front().count)
      zip.at(key).refuse("has " + std::to_string(columns.back().count) + " values, but " + axis.keys.front() +
                         " has " + std::to_string(columns.front().count) +
                         "; the lists of a zip must be equally long");
  }
  axis.size = columns.front().count;
  axis.text = flowText(zip.node());
  axis.at = [keys = axis.keys, columns = std::move(columns)](std::uint64_t k)
  {
    std::vector<Assignment> assignments;
    for (std::size_t i = 0; i < keys.size(); ++i)
      assignments.push_back({keys[i], columns[i].at(k)});
    return assignments;
  };
  return axis;
}

std::vector<Assignment> readAssignments(const Entry& map)
{
  std::vector<Assignment> assignments;
  for (const std::string& key : map.keys())
  {
    if (map.at(key).node().IsNull())
      map.at(key).refuse("must have a value");
    assignments.push_back({key, flowText(map.at(key).node())});
  }
  return assignments;
}

Axis readCases(const Entry& cases)
{
  Axis axis;
  const auto steps = std::make_shared<std::vector<std::vector<Assignment>>>();
  for (const Entry& entry : cases.list())
  {
    steps->push_back(readAssignments(entry));
    for (const Assignment& assignment : steps->back())
      if (std::find(axis.keys.begin(), axis.keys.end(), assignment.key) == axis.keys.end())
        axis.keys.push_back(assignment.key);
  }
  if (steps->empty())
    cases.refuse("must have one case or more");
  axis.size = steps->size();
  axis.text = flowText(cases.node());
  axis.at = [steps](std::uint64_t k) { return (*steps)[k]; };
  return axis;
}

}  // namespace ratchet_sieve

#pragma once

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// A reader of trajectories, as far as the tests need it.
namespace ratchet_sieve
{

/// A frame of extended XYZ.
struct XyzFrame
{
  std::map<std::string, std::string> head;                                       ///< the values of its keys
  std::size_t rows = 0;                                                          ///< as its first line says
  std::map<std::string, std::vector<std::vector<std::string>>> columns_of = {};  ///< per property, per row

  std::vector<double> numbers(const std::string& property, std::size_t column = 0) const
  {
    std::vector<double> numbers;
    for (const auto& row : columns_of.at(property))
      numbers.push_back(std::strtod(row.at(column).c_str(), nullptr));
    return numbers;
  }

  std::vector<double> headNumbers(const std::string& key) const
  {
    std::istringstream values(head.at(key));
    std::vector<double> numbers;
    for (std::string value; values >> value;)
      numbers.push_back(std::strtod(value.c_str(), nullptr));
    return numbers;
  }
};

/// key=value or key="values", separated by spaces.
inline std::map<std::string, std::string> xyzHead(const std::string& line)
{
  std::map<std::string, std::string> head;
  for (std::size_t at = 0; at < line.size();)
  {
    const std::size_t equals = line.find('=', at);
    const bool quoted = line.at(equals + 1) == '"';
    const std::size_t from = equals + (quoted ? 2 : 1);
    const std::size_t to = std::min(line.find(quoted ? '"' : ' ', from), line.size());
    head[line.substr(at, equals - at)] = line.substr(from, to - from);
    at = to + (quoted ? 2 : 1);
  }
  return head;
}

/// The names of the properties of a frame, with their numbers of columns.
inline std::vector<std::pair<std::string, std::size_t>> xyzProperties(const XyzFrame& frame)
{
  std::vector<std::pair<std::string, std::size_t>> properties;
  std::istringstream text(frame.head.at("Properties"));
  for (std::string name, type, columns;
       std::getline(text, name, ':') && std::getline(text, type, ':') && std::getline(text, columns, ':');)
    properties.emplace_back(name, std::stoul(columns));
  return properties;
}

inline std::vector<XyzFrame> xyzFrames(const std::string& text)
{
  std::vector<XyzFrame> frames;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    XyzFrame frame;
    frame.rows = std::stoul(line);
    std::getline(lines, line);
    frame.head = xyzHead(line);
    const auto properties = xyzProperties(frame);
    for (const auto& [name, columns] : properties)
      frame.columns_of[name] = {};
    for (std::size_t k = 0; k < frame.rows; ++k)
    {
      std::getline(lines, line);
      std::istringstream words(line);
      for (const auto& [name, columns] : properties)
        for (std::string& word : frame.columns_of[name].emplace_back(columns))
          words >> word;
      if (std::string rest; !words || words >> rest)
        throw std::runtime_error("not as many words as columns: " + line);
    }
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace ratchet_sieve

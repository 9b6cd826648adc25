#pragma once

#include <set>
#include <stdexcept>
#include <string>

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

namespace ratchet_sieve
{

/// An illegal parameter. One line names it, its value and what is allowed.
struct ParameterError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A parameter's value, if it is a finite number in [least, most]. @param name full name
/// @throws ParameterError
double numberFrom(const std::string& name, const XmlRpc::XmlRpcValue& value, double least, double most);

/// Reads and checks a node's parameters, and keeps track of which were read.
class ParameterReader
{
public:
  explicit ParameterReader(const ros::NodeHandle& node) : node_(node) {}

  /// A finite number in [least, most]; `fallback` if the parameter is not set.
  /// @throws ParameterError
  double number(const std::string& name, double fallback, double least, double most);

  /// A whole number from 0 to `most`.
  std::size_t count(const std::string& name, std::size_t fallback, std::size_t most);

  /// @throws ParameterError
  bool flag(const std::string& name, bool fallback);

  /// @throws ParameterError
  std::string text(const std::string& name, const std::string& fallback);

  /// The full name, as in error messages.
  std::string fullName(const std::string& name) const { return node_.resolveName(name); }

  /// Parameters of the node that were never read, except those under `ignored`: most likely misspelt.
  std::set<std::string> unknown(const std::set<std::string>& ignored) const;

private:
  bool get(const std::string& name, XmlRpc::XmlRpcValue& value);
  ros::NodeHandle node_;
  std::set<std::string> asked_;
};

}  // namespace ratchet_sieve

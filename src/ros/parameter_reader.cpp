#include "ratchet_sieve/ros/parameter_reader.h"

#include <cmath>
#include <sstream>
#include <vector>

namespace ratchet_sieve
{
namespace
{
[[noreturn]] void refuse(const std::string& name, const XmlRpc::XmlRpcValue& value,
                         const std::string& allowed)
{
  using ::operator<<;  // the messages' operators would hide it
  std::ostringstream text;
  text << "parameter " << name << ": " << value << ": must be " << allowed;
  throw ParameterError(text.str());
}
}  // namespace

// A copy, because XmlRpcValue converts only through non-const references.
double numberFrom(const std::string& name, const XmlRpc::XmlRpcValue& given, double least, double most)
{
  XmlRpc::XmlRpcValue value = given;
  std::ostringstream allowed;
  allowed << "a number from " << least << " to " << most;
  double number = 0.0;
  if (value.getType() == XmlRpc::XmlRpcValue::TypeDouble)
    number = static_cast<double&>(value);
  else if (value.getType() == XmlRpc::XmlRpcValue::TypeInt)
    number = static_cast<int&>(value);
  else
    refuse(name, value, allowed.str());
  if (!std::isfinite(number) || number < least || number > most)
    refuse(name, value, allowed.str());
  return number;
}

bool ParameterReader::get(const std::string& name, XmlRpc::XmlRpcValue& value)
{
  asked_.insert(name);
  return node_.getParam(name, value);
}

double ParameterReader::number(const std::string& name, double fallback, double least, double most)
{
  XmlRpc::XmlRpcValue value;
  if (!get(name, value))
    return fallback;
  return numberFrom(node_.resolveName(name), value, least, most);
}

std::size_t ParameterReader::count(const std::string& name, std::size_t fallback, std::size_t most)
{
  XmlRpc::XmlRpcValue value;
  if (!get(name, value))
    return fallback;
  const int number = value.getType() == XmlRpc::XmlRpcValue::TypeInt ? static_cast<int&>(value) : -1;
  if (number < 0 || static_cast<std::size_t>(number) > most)
    refuse(node_.resolveName(name), value, "a whole number from 0 to " + std::to_string(most));
  return static_cast<std::size_t>(number);
}

bool ParameterReader::flag(const std::string& name, bool fallback)
{
  XmlRpc::XmlRpcValue value;
  if (!get(name, value))
    return fallback;
  if (value.getType() != XmlRpc::XmlRpcValue::TypeBoolean)
    refuse(node_.resolveName(name), value, "true or false");
  return static_cast<bool&>(value);
}

std::string ParameterReader::text(const std::string& name, const std::string& fallback)
{
  XmlRpc::XmlRpcValue value;
  if (!get(name, value))
    return fallback;
  if (value.getType() != XmlRpc::XmlRpcValue::TypeString)
    refuse(node_.resolveName(name), value, "text");
  return static_cast<std::string&>(value);
}

std::set<std::string> ParameterReader::unknown(const std::set<std::string>& ignored) const
{
  const std::string prefix = node_.getNamespace() + "/";
  std::vector<std::string> names;
  node_.getParamNames(names);
  std::set<std::string> unknown;
  for (const std::string& full_name : names)
  {
    if (full_name.compare(0, prefix.size(), prefix) != 0)
      continue;
    const std::string name = full_name.substr(prefix.size());
    const std::string first = name.substr(0, name.find('/'));
    if (asked_.count(name) == 0 && ignored.count(first) == 0)
      unknown.insert(full_name);
  }
  return unknown;
}

}  // namespace ratchet_sieve

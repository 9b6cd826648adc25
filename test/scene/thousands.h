#pragma once

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>

#include <rapidcheck.h>

namespace ratchet_sieve
{

/// rc::check over `times` as many cases as rapidcheck is told to make (100, if it is told nothing).
template <typename Testable>
bool checkManyTimes(double times, const std::string& description, Testable&& testable)
{
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = std::max(1, static_cast<int>(params.maxSuccess * times));
  rc::detail::TestMetadata metadata;
  metadata.id = description;
  metadata.description = description;
  const auto result = rc::detail::checkTestable(std::forward<Testable>(testable), metadata, params);
  rc::detail::printResultMessage(result, std::cerr);
  std::cerr << std::endl;
  return result.template is<rc::detail::SuccessResult>();
}

}  // namespace ratchet_sieve

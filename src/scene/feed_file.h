#pragma once

#include <functional>
#include <set>
#include <string>

#include "ratchet_sieve/scene/entry.h"

namespace ratchet_sieve
{

/// Visits each row of feed.file, those of feed.side alone if it is given. A row is a map whose errors name
/// file and line.
/// @param columns that the rows have @throws SceneError
void forEachRow(const Entry& feed, const std::set<std::string>& columns,
                const std::function<void(const Entry&)>& visit);

}  // namespace ratchet_sieve

#pragma once

namespace ratchet_sieve
{

constexpr double PI = 3.14159265358979323846;
constexpr double GRAVITY = 9.81;  ///< [m/s^2]

}  // namespace ratchet_sieve

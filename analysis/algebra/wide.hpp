// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <utility>

namespace shortfall {

// -Wpedantic knows no 128-bit integers.
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// |value|, also of the least value.
inline std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}
inline UInt128 magnitude(Int128 value) {
  return value < 0 ? 0 - static_cast<UInt128>(value) : static_cast<UInt128>(value);
}

inline bool fits_64(Int128 value) { return value == static_cast<std::int64_t>(value); }

/// The greatest common divisor; of zero and b it is b.
inline std::uint64_t gcd(std::uint64_t a, std::uint64_t b) {
  if (a == 1 || b == 1) return 1;
  if (a < b) std::swap(a, b);
  if (b == 0) return a;
  // Subtractions are slow only for operands of very different sizes: there, one division first.
  if (a >> 16 >= b) {
    a %= b;
    if (a == 0) return b;
  }
  const int twos_a = std::countr_zero(a), twos_b = std::countr_zero(b);
  a >>= twos_a;
  b >>= twos_b;
  // Stein's algorithm without branches that could be predicted wrongly: (a, b) becomes (the smaller, |b - a|
  // made odd).
  for (std::uint64_t difference; (difference = b - a) != 0;) {
    const std::uint64_t mask = 0 - static_cast<std::uint64_t>(b < a);
    const int twos = std::countr_zero(difference);
    a += difference & mask;
    b = ((difference ^ mask) - mask) >> twos;
  }
  return a << (twos_a < twos_b ? twos_a : twos_b);
}

inline UInt128 gcd(UInt128 a, UInt128 b) {
  while (b >> 64 != 0) a = std::exchange(b, a % b);
  if (b == 0) return a;
  return gcd(static_cast<std::uint64_t>(a % b), static_cast<std::uint64_t>(b));
}

}  // namespace shortfall

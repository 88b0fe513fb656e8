// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/lyndon_basis.hpp"

namespace shortfall {

/// Tables that depend on a degree (and on which of two kinds) alone: each is made when it is first asked for,
/// and kept.
template <class T>
class KeptByDegree {
 public:
  /// throws  Unable  when the degree is not from `least` to the highest of the Lyndon basis
  template <class Make>
  const T& at(std::size_t kind, int degree, int least, const Make& make) {
    if (degree < least || degree > LyndonBasis::kHighestDegree)
      throw Unable("brackets are known from degree " + std::to_string(least) + " to degree " +
                   std::to_string(LyndonBasis::kHighestDegree) + ", not in degree " + std::to_string(degree));
    const auto d = static_cast<std::size_t>(degree);
    std::call_once(made_[kind][d], [&] { objects_[kind][d].reset(make()); });
    return *objects_[kind][d];
  }

 private:
  static constexpr std::size_t kDegrees = LyndonBasis::kHighestDegree + 1;
  std::array<std::array<std::once_flag, kDegrees>, 2> made_;
  std::array<std::array<std::unique_ptr<const T>, kDegrees>, 2> objects_;
};

}  // namespace shortfall

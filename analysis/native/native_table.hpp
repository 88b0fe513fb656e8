// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string_view>

#include "analysis/native/native_run.hpp"

namespace shortfall::native {

/// What a run is made from, besides the integrator.
template <class S>
struct NativeSetup {
  const Values& parameters;  ///< of all parameters
  S h;
  std::size_t dimension;
  ForceReference<S> force;
};

template <class S>
using NativeMaker = std::unique_ptr<NativeRun<S>> (*)(const NativeSetup<S>&);

/// Makers by the name of the integrator.
template <class S>
using NativeTable = std::map<std::string_view, NativeMaker<S>>;

/// The whole catalogue, as far as it has native code.
const NativeTable<float>& native_table_float();
const NativeTable<double>& native_table_double();

}  // namespace shortfall::native

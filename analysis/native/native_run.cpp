// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/native/native_run.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/native/native_table.hpp"
#include "analysis/program/catalogue.hpp"
#include "native/refusals.hpp"

namespace shortfall {

namespace {

template <class S>
const native::NativeTable<S>& table() {
  if constexpr (std::is_same_v<S, float>)
    return native::native_table_float();
  else
    return native::native_table_double();
}

}  // namespace

std::optional<std::string> why_not_native(const Program& program) {
  for (const native::Refusal& r : native::kRefusals)
    if (r.integrator == program.name) return std::string(r.reason);
  const auto own = std::ranges::find(catalogue(), program.name, &Program::name);
  if (own == catalogue().end() || !same(*own, program))
    return program.name +
           " is no integrator of the catalogue: only these were compiled when shortfall was built";
  return std::nullopt;
}

template <class S>
std::unique_ptr<NativeRun<S>> native_run(const Program& program, const Values& parameters, S h,
                                         std::size_t dimension, ForceReference<S> force) {
  if (const auto reason = why_not_native(program)) throw Unable(*reason);
  if (dimension < 1 || dimension > kMostNativeComponents)
    throw Unable("a native run has from 1 to " + std::to_string(kMostNativeComponents) + " dimensions, not " +
                 std::to_string(dimension));
  const Values values = parameter_values(program, parameters);
  lower(program, values);  // refuses what is no number of substeps
  return table<S>().at(program.name)({values, h, dimension, force});
}

template std::unique_ptr<NativeRun<float>> native_run(const Program&, const Values&, float, std::size_t,
                                                      ForceReference<float>);
template std::unique_ptr<NativeRun<double>> native_run(const Program&, const Values&, double, std::size_t,
                                                       ForceReference<double>);

}  // namespace shortfall

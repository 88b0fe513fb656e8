// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/native/native_many.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/native/lane_code.hpp"

namespace shortfall {

namespace {

using native::LaneCode;

template <class S>
S nearest(const char* text) {
  const Rational value = Rational::parse(text);
  if constexpr (std::is_same_v<S, float>)
    return value.to_float();
  else
    return value.to_double();
}

template <class S>
native::LaneTable<S> compiled_lanes() {
#ifdef SHORTFALL_AVX2
  if (!__builtin_cpu_supports("avx2")) return {nullptr, 0};
  if constexpr (std::is_same_v<S, float>) {
    static const native::LaneTable<float> table = native::avx2_lanes_float();
    return table;
  } else {
    static const native::LaneTable<double> table = native::avx2_lanes_double();
    return table;
  }
#else
  return {nullptr, 0};
#endif
}

template <class S>
const LaneCode<S>* lane_code(const Program& program) {
  const native::LaneTable<S> table = compiled_lanes<S>();
  const LaneCode<S>* end = table.codes + table.count;
  const auto found = std::find_if(table.codes, end, [&](const LaneCode<S>& code) {
    return std::string_view(code.integrator) == program.name;
  });
  return found == end ? nullptr : found;
}

template <class S>
void one_by_one(const Program& program, const Values& parameters, S h, ForceReference<S> force,
                std::span<S> x, std::span<S> v, S t0, std::int64_t steps) {
  const auto run = native_run<S>(program, parameters, h, 1, force);
  for (std::size_t i = 0; i < x.size(); ++i) {
    run->begin(x.subspan(i, 1), v.subspan(i, 1), t0);
    run->run(steps);
    run->read_out(x.subspan(i, 1), v.subspan(i, 1));
  }
}

template <class S>
void in_lanes(const LaneCode<S>& code, const Values& values, S h, ForceReference<S> force, std::span<S> x,
              std::span<S> v, S t0, std::int64_t steps) {
  std::vector<native::LaneParameter<S>> parameters;
  for (const auto& [name, value] : values) {
    std::int64_t whole = 0;
    value.fits_int64(whole);
    parameters.push_back({name.c_str(), nearest<S>(value.str().c_str()), static_cast<int>(whole)});
  }
  const native::LaneForce<S> call{
      &force, [](void* object, const S* position, const S* velocity, S t, S* a, std::size_t count) {
        (*static_cast<ForceReference<S>*>(object))({position, count}, {velocity, count}, t, {a, count});
      }};
  const native::LaneSetup<S> setup{h, call, parameters.data(), parameters.size(), nearest<S>};
  const std::unique_ptr<void, void (*)(void*)> stepper(code.made(setup), code.deleted);
  std::vector<S> position(code.lanes), velocity(code.lanes);
  for (std::size_t first = 0; first < x.size(); first += code.lanes) {
    const std::size_t count = std::min(code.lanes, x.size() - first);
    for (std::size_t lane = 0; lane < code.lanes; ++lane) {  // the last one fills what is left
      const std::size_t source = first + std::min(lane, count - 1);
      position[lane] = x[source];
      velocity[lane] = v[source];
    }
    code.run(stepper.get(), position.data(), velocity.data(), t0, steps);
    std::copy_n(position.begin(), count, x.begin() + static_cast<long>(first));
    std::copy_n(velocity.begin(), count, v.begin() + static_cast<long>(first));
  }
}

}  // namespace

bool has_lanes(const Program& program) {
  return !why_not_native(program) && lane_code<double>(program) != nullptr;
}

template <class S>
void native_many(const Program& program, const Values& parameters, S h, ForceReference<S> force,
                 std::span<S> x, std::span<S> v, S t0, std::int64_t steps, NativeLanes lanes) {
  if (const auto reason = why_not_native(program)) throw Unable(*reason);
  if (x.size() != v.size())
    throw Error(std::to_string(x.size()) + " positions and " + std::to_string(v.size()) +
                " velocities are no trajectories");
  const LaneCode<S>* code = lanes == NativeLanes::never ? nullptr : lane_code<S>(program);
  if (!code) return one_by_one(program, parameters, h, force, x, v, t0, steps);
  const Values values = parameter_values(program, parameters);
  lower(program, values);  // refuses what is no number of substeps
  in_lanes(*code, values, h, force, x, v, t0, steps);
}

template void native_many(const Program&, const Values&, float, ForceReference<float>, std::span<float>,
                          std::span<float>, float, std::int64_t, NativeLanes);
template void native_many(const Program&, const Values&, double, ForceReference<double>, std::span<double>,
                          std::span<double>, double, std::int64_t, NativeLanes);

}  // namespace shortfall

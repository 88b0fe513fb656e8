// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/interpreted_run.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/native/vectors.hpp"
#include "analysis/problems/functions.hpp"
#include "analysis/program/run.hpp"
#include "analysis/trade/rounded_number.hpp"

namespace shortfall {

namespace {

/// Bodies in space, in numbers of any kind that rounds.
template <class S>
struct DenseNumbers {
  using Scalar = S;
  using Vector = native::BoundedVector<S, kMostNativeComponents>;

  std::size_t dimension;
  ForceReference<S> force;
  std::int64_t evaluations = 0;

  Scalar number(const Rational& value) const { return rounded_number<S>(value); }
  std::optional<Scalar> parameter(int, bool) const { return std::nullopt; }
  Vector zero() const { return Vector(dimension); }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar& t) {
    ++evaluations;
    Vector a(dimension);
    force(std::span<const S>(x.data(), dimension), std::span<const S>(v.data(), dimension), t,
          std::span<S>(a.data(), dimension));
    return a;
  }
  Scalar function(Function f, const Scalar& a, const Scalar& b) const { return value_of(f, a, b); }
  Scalar root(const RealRoot& root, const std::string&) const {
    return rounded_number<S>(root.is_rational() ? root.rational() : near(root, kRoundedRootDigits));
  }
  S length(const Vector& v) const {
    using std::sqrt;
    S sum = v[0] * v[0];
    for (std::size_t i = 1; i < dimension; ++i) sum = sum + v[i] * v[i];
    return dimension == 1 ? (v[0] < S(0) ? S(-v[0]) : v[0]) : S(sqrt(sum));
  }
  bool longer(const Vector& measured, const Scalar& size, bool) const { return size < length(measured); }
  Vector shortened(const Vector& v, const Vector& measured, const Scalar& size) const {
    return S(size / length(measured)) * v;
  }
  template <class F>
  void solve(std::vector<Vector>& unknowns, F&& f) const {
    solve_stages(unknowns, f, S(0), S(1));
  }
};

template <class S>
class InterpretedRun : public NativeRun<S> {
 public:
  InterpretedRun(const Program& program, const Values& parameters, const Rational& h, std::size_t dimension,
                 ForceReference<S> force)
      : tape_(lower(program, parameters)),
        problem_{dimension, force},
        run_(tape_, problem_, rounded_number<S>(h)) {}
  InterpretedRun(const InterpretedRun&) = delete;
  InterpretedRun& operator=(const InterpretedRun&) = delete;

  void begin(std::span<const S> x0, std::span<const S> v0, S t0) override {
    run_.begin(vector(x0), vector(v0), t0);
  }
  void run(std::int64_t steps) override {
    for (std::int64_t n = 0; n < steps; ++n) run_.step();
  }
  void read_out(std::span<S> x, std::span<S> v) const override {
    const auto [position, velocity] = run_.read_out();
    std::copy_n(position.data(), problem_.dimension, x.data());
    std::copy_n(velocity.data(), problem_.dimension, v.data());
  }
  S time() const override { return run_.time(); }
  void give_impulse(std::span<const S> impulse) override { run_.give_impulse(vector(impulse)); }
  std::int64_t force_evaluations() const override { return problem_.evaluations; }
  std::size_t dimension() const override { return problem_.dimension; }

 private:
  typename DenseNumbers<S>::Vector vector(std::span<const S> values) const {
    typename DenseNumbers<S>::Vector result(problem_.dimension);
    std::copy(values.begin(), values.end(), result.data());
    return result;
  }

  Tape tape_;
  DenseNumbers<S> problem_;
  mutable Run<DenseNumbers<S>> run_;  ///< reading it out runs `finish`, and leaves it as it was
};

}  // namespace

template <class S>
std::unique_ptr<NativeRun<S>> interpreted_run(const Program& program, const Values& parameters,
                                              const Rational& h, std::size_t dimension,
                                              ForceReference<S> force) {
  if (dimension < 1 || dimension > kMostNativeComponents)
    throw Unable("scenes of more than " + std::to_string(kMostNativeComponents) +
                 " coordinates cannot be stepped");
  return std::make_unique<InterpretedRun<S>>(program, parameters, h, dimension, force);
}

template std::unique_ptr<NativeRun<float>> interpreted_run(const Program&, const Values&, const Rational&,
                                                           std::size_t, ForceReference<float>);
template std::unique_ptr<NativeRun<double>> interpreted_run(const Program&, const Values&, const Rational&,
                                                            std::size_t, ForceReference<double>);
template std::unique_ptr<NativeRun<DoubleDouble>> interpreted_run(const Program&, const Values&,
                                                                  const Rational&, std::size_t,
                                                                  ForceReference<DoubleDouble>);

}  // namespace shortfall

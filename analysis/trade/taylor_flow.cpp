// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/taylor_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/taylor_numbers.hpp"

namespace shortfall {

using Op = SmoothTape::Op;

template <class T>
TaylorFlow<T>::TaylorFlow(SmoothTape tape, Settings settings)
    : tape_(std::move(tape)),
      settings_(std::move(settings)),
      m_(static_cast<int>(tape_.outputs.size())),
      width_(static_cast<std::size_t>(settings_.order) + 1) {
  for (int k = 0; k <= settings_.order + 1; ++k) whole_.push_back(settings_.number(k));
  const T zero = settings_.number(0);
  values_.assign(tape_.nodes.size() * width_, zero);
  x_.assign(static_cast<std::size_t>(m_) * width_, zero);
  v_ = x_;
  side_.assign(tape_.nodes.size(), 0);
  for (std::size_t i = 0; i < tape_.nodes.size(); ++i)
    if (tape_.nodes[i].op == Op::constant)
      values_[i * width_] = settings_.number(tape_.constants[static_cast<std::size_t>(tape_.nodes[i].a)]);
}

/// Sum of a_j b_(k-j) for j = from .. to.
template <class T>
T TaylorFlow<T>::product(int a, int b, int from, int to, int k) const {
  T sum = whole_[0];
  for (int j = from; j <= to; ++j) add_product(sum, values_[index(a, j)], values_[index(b, k - j)]);
  return sum;
}

/// Sum of j a_j b_(k-j) for j = 1 .. k, over k.
template <class T>
T TaylorFlow<T>::weighted(int a, int b, int k) const {
  T sum = whole_[0];
  for (int j = 1; j <= k; ++j)
    add_product(sum, whole_[static_cast<std::size_t>(j)] * values_[index(a, j)], values_[index(b, k - j)]);
  return sum / whole_[static_cast<std::size_t>(k)];
}

template <class T>
void TaylorFlow<T>::absolute(std::size_t node, int k) {
  const int a = tape_.nodes[node].a;
  if (k == 0) side_[node] = 0;
  int& side = side_[node];
  if (side == 0) {
    // A value that is next to nothing beside its slope is the zero at which the last series ended.
    const double u = rough(values_[index(a, k)]);
    const bool is_zero = k == 0 ? std::fabs(u) <= settings_.tolerance * (largest_x_ + largest_v_) : u == 0;
    if (!is_zero) side = u < 0 ? -1 : 1;
  }
  const T& value = values_[index(a, k)];
  values_[index(static_cast<int>(node), k)] = side < 0 ? -value : side > 0 ? value : whole_[0];
}

template <class T>
void TaylorFlow<T>::operation(std::size_t node, int k) {
  using std::cos;
  using std::exp;
  using std::log;
  using std::pow;
  using std::sin;
  using std::sqrt;
  const auto [op, a, b] = tape_.nodes[node];
  const auto value = [&](int n, int j) -> const T& { return values_[index(n, j)]; };
  const int self = static_cast<int>(node);
  T result = whole_[0];
  switch (op) {
    case Op::input:
      result = a < m_       ? x_[index(a, k)]
               : a < 2 * m_ ? v_[index(a - m_, k)]
               : k == 0     ? values_[index(self, 0)]
                            : whole_[k == 1 ? 1 : 0];
      break;
    case Op::constant:
      return;
    case Op::add:
      result = value(a, k) + value(b, k);
      break;
    case Op::subtract:
      result = value(a, k) - value(b, k);
      break;
    case Op::negate:
      result = -value(a, k);
      break;
    case Op::absolute:
      absolute(node, k);
      return;
    case Op::multiply:
      if (tape_.nodes[static_cast<std::size_t>(a)].op == Op::constant)
        result = value(a, 0) * value(b, k);
      else if (tape_.nodes[static_cast<std::size_t>(b)].op == Op::constant)
        result = value(b, 0) * value(a, k);
      else if (a == b) {
        result = product(a, a, 0, (k - 1) / 2, k);
        if (k == 0)
          result = value(a, 0) * value(a, 0);
        else {
          result = result + result;
          if (k % 2 == 0) add_product(result, value(a, k / 2), value(a, k / 2));
        }
      } else
        result = product(a, b, 0, k, k);
      break;
    case Op::divide:
      result = (value(a, k) - product(b, self, 1, k, k)) / value(b, 0);
      break;
    case Op::sqrt:
      if (k == 0)
        result = sqrt(value(a, 0));
      else
        result = (value(a, k) - product(self, self, 1, k - 1, k)) / (whole_[2] * value(self, 0));
      break;
    case Op::exp:
      result = k == 0 ? T(exp(value(a, 0))) : weighted(a, self, k);
      break;
    case Op::log:
      if (k == 0)
        result = log(value(a, 0));
      else {
        T sum = whole_[0];
        for (int j = 1; j < k; ++j)
          add_product(sum, whole_[static_cast<std::size_t>(j)] * value(self, j), value(a, k - j));
        result = (value(a, k) - sum / whole_[static_cast<std::size_t>(k)]) / value(a, 0);
      }
      break;
    case Op::sin:
      result = k == 0 ? T(sin(value(a, 0))) : weighted(a, self + 1, k);
      break;
    case Op::cos:
      result = k == 0 ? T(cos(value(a, 0))) : -weighted(a, self - 1, k);
      break;
    case Op::power: {
      const T& r = values_[index(b, 0)];
      if (k == 0) {
        result = pow(value(a, 0), r);
        break;
      }
      T sum = whole_[0];
      for (int j = 1; j <= k; ++j) {
        const T weight = r * whole_[static_cast<std::size_t>(j)] - whole_[static_cast<std::size_t>(k - j)];
        add_product(sum, weight * value(a, j), value(self, k - j));
      }
      result = sum / (whole_[static_cast<std::size_t>(k)] * value(a, 0));
      break;
    }
  }
  values_[index(self, k)] = result;
}

template <class T>
void TaylorFlow<T>::coefficients(int k) {
  for (std::size_t node = 0; node < tape_.nodes.size(); ++node) operation(node, k);
}

template <class T>
void TaylorFlow<T>::expand(std::span<const T> x, std::span<const T> v, const T& t) {
  for (int i = 0; i < m_; ++i) {
    x_[index(i, 0)] = x[static_cast<std::size_t>(i)];
    v_[index(i, 0)] = v[static_cast<std::size_t>(i)];
    largest_x_ = std::max(largest_x_, std::fabs(rough(x[static_cast<std::size_t>(i)])));
    largest_v_ = std::max(largest_v_, std::fabs(rough(v[static_cast<std::size_t>(i)])));
  }
  values_[index(2 * m_, 0)] = t;
  for (int k = 0; k < settings_.order; ++k) {
    for (int i = 0; i < m_; ++i)
      x_[index(i, k + 1)] = v_[index(i, k)] / whole_[static_cast<std::size_t>(k) + 1];
    coefficients(k);
    for (int i = 0; i < m_; ++i)
      v_[index(i, k + 1)] = values_[index(tape_.outputs[static_cast<std::size_t>(i)], k)] /
                            whole_[static_cast<std::size_t>(k) + 1];
  }
  for (int i = 0; i < m_; ++i)
    if (!std::isfinite(rough(x_[index(i, settings_.order)])) ||
        !std::isfinite(rough(v_[index(i, settings_.order)])))
      throw Undefined("the force is singular at t = " + std::to_string(rough(t)) +
                      ": its power series there has no value");
  length_ = to_corner(step_length());
}

template <class T>
double TaylorFlow<T>::step_length() {
  double length = settings_.longest;
  double scale_x = largest_x_, scale_v = largest_v_;
  for (int i = 0; i < m_; ++i) {  // at rest at the origin: what the force will make of it
    if (scale_x == 0)
      scale_x =
          std::fabs(rough(x_[index(i, 1)])) * length + std::fabs(rough(x_[index(i, 2)])) * length * length;
    if (scale_v == 0) scale_v = std::fabs(rough(v_[index(i, 1)])) * length;
  }
  for (int back = 0; back < 2; ++back) {
    const int k = settings_.order - back;
    double last_x = 0, last_v = 0;
    for (int i = 0; i < m_; ++i) {
      last_x = std::max(last_x, std::fabs(rough(x_[index(i, k)])));
      last_v = std::max(last_v, std::fabs(rough(v_[index(i, k)])));
    }
    if (last_x > 0) length = std::min(length, std::pow(settings_.tolerance * scale_x / last_x, 1.0 / k));
    if (last_v > 0) length = std::min(length, std::pow(settings_.tolerance * scale_v / last_v, 1.0 / k));
  }
  return length;
}

template <class T>
double TaylorFlow<T>::to_corner(double length) const {
  constexpr int kSamples = 24;
  if (side_.empty()) return length;
  for (std::size_t node = 0; node < tape_.nodes.size(); ++node) {
    if (tape_.nodes[node].op != Op::absolute || side_[node] == 0) continue;
    const int a = tape_.nodes[node].a;
    const auto u = [&](double tau) {
      double sum = 0;
      for (int k = settings_.order - 1; k >= 0; --k) sum = sum * tau + rough(values_[index(a, k)]);
      return sum * side_[node];
    };
    for (int s = 1; s <= kSamples; ++s) {
      double high = length * s / kSamples, low = length * (s - 1) / kSamples;
      if (!(u(high) < 0)) continue;
      if (s == 1) low = std::numeric_limits<double>::min();
      for (;;) {  // as many halvings as a double has exponents and digits, at most
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) break;
        (u(middle) < 0 ? high : low) = middle;
      }
      length = low;
      break;
    }
  }
  return length;
}

template <class T>
T TaylorFlow<T>::at(int i, const T& tau) const {
  T sum = coefficient(i, settings_.order);
  for (int k = settings_.order - 1; k >= 0; --k) sum = sum * tau + coefficient(i, k);
  return sum;
}

template <class T>
void follow(TaylorFlow<T>& flow, std::vector<T>& x, std::vector<T>& v, T& t, const T& duration) {
  const int m = flow.coordinates();
  T left = duration;
  for (int series = 0; rough(left) > 0; ++series) {
    if (series == kMostSeriesOfFollow)
      throw Undefined("beyond t = " + std::to_string(rough(t)) + " the motion is too wild to be followed");
    flow.expand(x, v, t);
    T step = left;
    if (flow.length() < rough(left)) step = T(flow.length());
    if (!(rough(step) > 0))
      throw Undefined("the motion cannot be followed beyond t = " + std::to_string(rough(t)));
    for (int i = 0; i < m; ++i) {
      x[static_cast<std::size_t>(i)] = flow.at(i, step);
      v[static_cast<std::size_t>(i)] = flow.at(m + i, step);
    }
    t = t + step;
    left = left - step;
  }
}

template class TaylorFlow<DoubleDouble>;
template class TaylorFlow<Real>;
template void follow(TaylorFlow<DoubleDouble>&, std::vector<DoubleDouble>&, std::vector<DoubleDouble>&,
                     DoubleDouble&, const DoubleDouble&);
template void follow(TaylorFlow<Real>&, std::vector<Real>&, std::vector<Real>&, Real&, const Real&);

}  // namespace shortfall

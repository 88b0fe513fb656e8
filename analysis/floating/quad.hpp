// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace shortfall {

/// IEEE binary128, as the compiler and libquadmath compute it: sums, products, quotients and roots are
/// correctly rounded.
class Quad {
 public:
  __extension__ typedef __float128 Native;  // an extension, and meant

  Quad() = default;
  explicit Quad(Native value) : value_(value) {}
  Native value() const { return value_; }

  Quad operator-() const { return Quad(-value_); }
  friend Quad operator+(Quad a, Quad b) { return Quad(a.value_ + b.value_); }
  friend Quad operator-(Quad a, Quad b) { return Quad(a.value_ - b.value_); }
  friend Quad operator*(Quad a, Quad b) { return Quad(a.value_ * b.value_); }
  friend Quad operator/(Quad a, Quad b) { return Quad(a.value_ / b.value_); }
  friend bool operator==(Quad a, Quad b) { return a.value_ == b.value_; }
  friend bool operator<(Quad a, Quad b) { return a.value_ < b.value_; }

 private:
  Native value_ = 0;
};

Quad fma(Quad a, Quad b, Quad c);
Quad sqrt(Quad a);
Quad exp(Quad a);  ///< libquadmath: the last digit is not always right; so are log and pow
Quad log(Quad a);
Quad pow(Quad a, Quad b);

}  // namespace shortfall

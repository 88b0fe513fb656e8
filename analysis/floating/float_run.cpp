// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/float_run.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/floating/float_access.hpp"
#include "analysis/problems/functions.hpp"

namespace shortfall {

namespace {

/// A number of the question as the format stores it.
class Storage {
 public:
  explicit Storage(const FloatFormat& format) : format_(format) {}

  Rational operator()(const Rational& value, const std::string& what) {
    Rational kept = as_kept(value, what);
    changes_ = changes_ || kept != value;
    return kept;
  }
  /// Whether a number so far is kept as another.
  bool changes() const { return changes_; }

 private:
  Rational as_kept(const Rational& value, const std::string& what) const {
    if (format_.variant == FloatFormat::Variant::offset && what == "x0") return offset(value);
    const auto r = rounded(value, format_.storage(), format_.rounding());
    if (!r) throw Unable(what + " = " + value.significant(6) + " is infinite in " + format_.words());
    if (format_.kind == FloatFormat::Kind::double_double) return double_double(value);
    return *r;
  }
  /// An origin in binary64 and the rest in binary32.
  static Rational offset(const Rational& value) {
    const Rational origin = value.abs().floor() * Rational(value.sign());
    return Rational::from_double(origin.to_double()) + Rational::from_double((value - origin).to_float());
  }
  static Rational double_double(const Rational& value) {
    const Rational high = Rational::from_double(value.to_double());
    return high + Rational::from_double((value - high).to_double());
  }
  const FloatFormat& format_;
  bool changes_ = false;
};

Expr stored(const Expr& e, Storage& storage) {
  if (!e) return e;
  if (e->op == Expression::Op::number) return number(storage(e->value, "a number of the step"), e->place);
  if (e->operands.empty() || e->op == Expression::Op::power) return e;  // exponents are counts
  auto copy = std::make_shared<Expression>(*e);
  for (Expr& operand : copy->operands) operand = stored(operand, storage);
  return copy;
}

void store(std::vector<Statement>& block, Storage& storage) {
  for (Statement& s : block) {
    if (s.kind != Statement::Kind::substeps) s.value = stored(s.value, storage);
    for (Unknown& u : s.unknowns) u.value = stored(u.value, storage);
    store(s.body, storage);
  }
}

void check_numeric(const Force& force) {
  if (force.spring && !force.k) throw BadInput("the spring needs a number: --force spring:k=4");
  if (force.damper && !force.c) throw BadInput("the damper needs a number: --force damped-spring:k=4,c=1/2");
}

}  // namespace

std::string FloatNumber::str(int digits) const {
  if (kind == Kind::not_a_number) return "NaN";
  if (kind == Kind::infinite) return value.sign() < 0 ? "-infinity" : "infinity";
  return value.significant(digits);
}

BinaryPieces binary_pieces(const Rational& dyadic) {
  BinaryPieces result;
  result.negative = dyadic.sign() < 0;
  mpz_class whole = abs(gmp_numerator(dyadic));
  const mpz_class below = gmp_denominator(dyadic);
  result.exponent = -static_cast<long>(mpz_sizeinbase(below.get_mpz_t(), 2) - 1);
  if (whole == 0) return result;
  // Zeros at the end go to the exponent, so that what is left fits into the format's precision.
  const mp_bitcnt_t zeros = mpz_scan1(whole.get_mpz_t(), 0);
  whole >>= zeros;
  result.exponent += static_cast<long>(zeros);
  while (whole != 0) {
    result.pieces.push_back(static_cast<std::uint32_t>(mpz_class(whole & 0xFFFFFFFFu).get_ui()));
    whole >>= 32;
  }
  std::ranges::reverse(result.pieces);
  return result;
}

Rational scaled_by_two(const Rational& value, long exponent) {
  return value * Rational(2).pow(static_cast<int>(exponent));
}

std::unique_ptr<FloatRun> float_run(const FloatFormat& format, const FloatQuestion& question) {
  check_numeric(question.force);
  switch (format.kind) {
    case FloatFormat::Kind::binary16:
    case FloatFormat::Kind::bfloat16:
      return small_float_run(format, question);
    case FloatFormat::Kind::binary32:
    case FloatFormat::Kind::binary64:
    case FloatFormat::Kind::x87:
      return native_float_run(format, question);
    case FloatFormat::Kind::binary128:
    case FloatFormat::Kind::double_double:
    case FloatFormat::Kind::mpfr:
      break;
  }
  return wide_float_run(format, question);
}

std::unique_ptr<FloatRun> tracked_run(const FloatFormat& format, const FloatQuestion& question) {
  check_numeric(question.force);
  switch (format.kind) {
    case FloatFormat::Kind::binary16:
    case FloatFormat::Kind::bfloat16:
      return small_tracked_run(format, question);
    case FloatFormat::Kind::binary32:
    case FloatFormat::Kind::binary64:
    case FloatFormat::Kind::x87:
      return native_tracked_run(format, question);
    case FloatFormat::Kind::binary128:
    case FloatFormat::Kind::double_double:
    case FloatFormat::Kind::mpfr:
      break;
  }
  return nullptr;
}

bool reads_time(const Tape& tape) {
  using Kind = Instruction::Kind;
  const auto reads = [](const Instruction& i) {
    switch (i.kind) {
      case Kind::scalar_copy:
      case Kind::scalar_negate:
      case Kind::scalar_power:
      case Kind::scale:
        return i.a == Tape::kTimeRegister;
      case Kind::scalar_add:
      case Kind::scalar_subtract:
      case Kind::scalar_multiply:
      case Kind::scalar_divide:
      case Kind::function:
        return i.a == Tape::kTimeRegister || i.b == Tape::kTimeRegister;
      case Kind::vector_divide:
        return i.b == Tape::kTimeRegister;
      default:
        return false;
    }
  };
  const auto any = [&](const Block& block) { return std::ranges::any_of(block, reads); };
  return any(tape.start) || any(tape.step) || any(tape.finish) ||
         std::ranges::any_of(tape.solves, [&](const Tape::Solve& s) { return any(s.body); }) ||
         std::ranges::any_of(tape.repeats, [&](const Tape::Repeat& r) { return any(r.body); }) ||
         std::ranges::any_of(
             tape.whens,
             [&](const Tape::When& w) { return w.speed == Tape::kTimeRegister || any(w.body); }) ||
         std::ranges::any_of(tape.limits, [](const Tape::Limit& l) { return l.size == Tape::kTimeRegister; });
}

std::unique_ptr<FloatRun> exact_run(const FloatQuestion& question) {
  check_numeric(question.force);
  FloatAccess<Rational> access;
  access.rounded = [](const Rational& value) { return value; };
  access.exact = [](const Rational& value) { return FloatNumber{FloatNumber::Kind::finite, value}; };
  access.rough = [](const Rational& value) { return value.to_double(); };
  return std::make_unique<TypedFloatRun<Rational>>(question, access);
}

FloatQuestion stored(const FloatQuestion& question, const FloatFormat& format) {
  check_numeric(question.force);
  Storage storage(format);
  FloatQuestion q = question;
  q.h = storage(q.kept_h.value_or(q.h), "h");
  q.kept_h.reset();
  q.x0 = storage(q.x0, "x0");
  q.v0 = storage(q.v0, "v0");
  for (auto& [degree, f] : q.force.push) f = storage(f, "f" + std::to_string(degree));
  if (q.force.k) q.force.k = storage(*q.force.k, "k");
  if (q.force.c) q.force.c = storage(*q.force.c, "c");
  for (const Parameter& p : q.program.parameters) {
    // What follows from others is computed by the run, as the program says.
    if (!literal_value(p.fallback) && !q.parameters.contains(p.name)) continue;
    const Rational value = parameter_values(q.program, q.parameters).at(p.name);
    q.parameters[p.name] = storage(value, p.name);
  }
  for (Approximation& a : q.program.approximations) a.value = storage(a.value, a.name);
  for (const Root& r : q.program.roots)
    q.program.approximations.push_back(
        {r.name, storage(near(*r.value, kRoundedRootDigits), r.name), r.value->significant(20), r.place});
  q.program.roots.clear();
  store(q.program.start, storage);
  store(q.program.step, storage);
  store(q.program.finish, storage);
  q.as_meant = !storage.changes() && q.h == question.h && question.program.roots.empty();
  return q;
}

}  // namespace shortfall

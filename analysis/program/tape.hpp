// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/program/program.hpp"

namespace shortfall {

/// Values given to parameters by name.
using Values = std::map<std::string, Rational>;

/// One operation on registers. Scalars and vectors live in register files of their own.
struct Instruction {
  enum class Kind {
    number,         ///< scalar out = numbers[a]
    scalar_copy,    ///< scalar out = a
    scalar_negate,  ///< scalar out = -a
    scalar_add,
    scalar_subtract,
    scalar_multiply,
    scalar_divide,
    scalar_power,  ///< scalar out = a ^ b, b the exponent itself
    function,      ///< scalar out = functions c of scalars a, b (b = a for functions of one value)
    root,          ///< scalar out = roots[a]
    zero,          ///< vector out = 0
    vector_copy,
    vector_negate,
    vector_add,
    vector_subtract,
    scale,          ///< vector out = scalar a * vector b
    vector_divide,  ///< vector out = vector a / scalar b
    force,          ///< vector out = a(vector a, vector b, scalar c)
    solve,          ///< solves[a]
    repeat,         ///< repeats[a]
    limit,          ///< limits[a]
    when,           ///< whens[a]
    // Made by quickened() only: this product, and with it the sum or difference in the next instruction.
    scale_then_add,       ///< vector a + this
    scale_then_added,     ///< this + vector b
    scale_then_subtract,  ///< vector a - this
  };
  Kind kind;
  int out = 0;
  int a = 0;
  int b = 0;
  int c = 0;
};

using Block = std::vector<Instruction>;

/// A program lowered to instructions on numbered registers, once, for whatever it will be run in.
///
/// Scalar registers begin with h, t and the parameters; vector registers with x, v and the states.
struct Tape {
  struct Solve {
    std::vector<int> unknowns;  ///< vector registers that hold the guess
    std::vector<int> results;   ///< vector registers with the right-hand sides
    std::vector<Dimension> dimensions;
    Block body;
  };
  struct Repeat {
    int count;
    bool whole_steps;  ///< an impulse acts in the first of them only
    Block body;
  };
  /// v is scaled down to a size that it (or h v) must not exceed.
  struct Limit {
    bool move;         ///< h v is measured; otherwise v
    int size;          ///< scalar register
    std::string text;  ///< "limit speed 500"
  };
  /// What is done only when v is faster than a speed.
  struct When {
    int speed;  ///< scalar register
    Block body;
    std::string text;  ///< "when speed > 1/100"
  };
  struct AssumptionSlot {
    Block body;
    int positive;  ///< scalar register
    std::string text;
  };
  struct ParameterSlot {
    std::string name;
    std::optional<Rational> fixed;  ///< given by the user, or needed as a number (substeps)
    bool derived;                   ///< the default is an expression in other parameters
    Block fallback;                 ///< computes the default into the parameter's register
  };

  static constexpr int kStep = 0;
  static constexpr int kTimeRegister = 1;
  static constexpr int kPosition = 0;
  static constexpr int kVelocityRegister = 1;

  std::string name;
  std::vector<std::string> states;  ///< names of all carried vectors: x, v, then the program's own
  std::vector<Dimension> state_dimensions;
  std::vector<ParameterSlot> parameters;
  std::vector<Rational> numbers;
  std::vector<Solve> solves;
  std::vector<Repeat> repeats;
  std::vector<Limit> limits;
  std::vector<When> whens;
  std::vector<std::shared_ptr<const RealRoot>> roots;
  std::vector<std::string> root_names;
  std::vector<AssumptionSlot> assumptions;
  int impulse = -1;  ///< vector register of the impulse; -1 when there is none
  Block constants;   ///< roots and approximate coefficients into their registers
  Block start;
  Block step;
  Block finish;
  int scalar_registers = 0;
  int vector_registers = 0;
};

/// The tape of a program.
///
/// throws  BadInput  for a value of an unknown parameter, or a number of substeps that is no whole number
/// from 1 to 10000
Tape lower(const Program& program, const Values& given = {});

/// The value of every parameter: what is given, otherwise its default.
///
/// throws  BadInput  for a value of an unknown parameter; Undefined when a default divides by zero
Values parameter_values(const Program& program, const Values& given = {});

}  // namespace shortfall

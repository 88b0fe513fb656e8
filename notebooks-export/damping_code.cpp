// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/damping_code.hpp"

namespace shortfall {

namespace {

// Written out, and not by the writer of formulas: loops and two returned values have a shape of their own
// everywhere. With u = c dt the motion needs three numbers:
//   decay = exp(-u),   q/dt = (1 - exp(-u))/u = 1 - u p,   p = (exp(-u) - 1 + u)/u^2 = 1/2 - u/6 + u^2/24 -
//   ...
// Below 1/2 the series ends with u^14/16!, which is less than half a unit in the last place of p in binary64.

constexpr const char* kCSharpMove =
    R"(static void DampedMove(ref double x, ref double v, double a, double c, double dt)
{
    double u = c * dt, decay = System.Math.Exp(-u), q, p;
    if (System.Math.Abs(u) < 0.5)
    {
        double term = 0.5;
        p = 0.5;
        for (int k = 3; k <= 16; ++k) { term *= -u / k; p += term; }
        q = dt * (1 - u * p);
    }
    else
    {
        q = (1 - decay) / c;
        p = (decay - 1 + u) / (u * u);
    }
    x += q * v + dt * dt * p * a;
    v = decay * v + q * a;
}
)";

constexpr const char* kCppMove =
    R"(inline void damped_move(double& x, double& v, double a, double c, double dt) {
  const double u = c * dt, decay = std::exp(-u);
  double q, p;
  if (std::abs(u) < 0.5) {
    double term = 0.5;
    p = 0.5;
    for (int k = 3; k <= 16; ++k) { term *= -u / k; p += term; }
    q = dt * (1 - u * p);
  } else {
    q = (1 - decay) / c;
    p = (decay - 1 + u) / (u * u);
  }
  x += q * v + dt * dt * p * a;
  v = decay * v + q * a;
}
)";

constexpr const char* kGdscriptMove =
    "func damped_move(x: float, v: float, a: float, c: float, dt: float) -> Array:\n"
    "\tvar u := c * dt\n"
    "\tvar decay := exp(-u)\n"
    "\tvar q := dt\n"
    "\tvar p := 0.5\n"
    "\tif absf(u) < 0.5:\n"
    "\t\tvar term := 0.5\n"
    "\t\tfor k in range(3, 17):\n"
    "\t\t\tterm *= -u / k\n"
    "\t\t\tp += term\n"
    "\t\tq = dt * (1 - u * p)\n"
    "\telse:\n"
    "\t\tq = (1 - decay) / c\n"
    "\t\tp = (decay - 1 + u) / (u * u)\n"
    "\treturn [x + q * v + dt * dt * p * a, decay * v + q * a]\n";

constexpr const char* kPythonMove =
    R"(def damped_move(x, v, a, c, dt):
    u = c * dt
    decay = math.exp(-u)
    if abs(u) < 0.5:
        term = p = 0.5
        for k in range(3, 17):
            term *= -u / k
            p += term
        q = dt * (1 - u * p)
    else:
        q = (1 - decay) / c
        p = (decay - 1 + u) / (u * u)
    return x + q * v + dt * dt * p * a, decay * v + q * a
)";

constexpr const char* kRustMove =
    R"(pub fn damped_move(x: f64, v: f64, a: f64, c: f64, dt: f64) -> (f64, f64) {
    let u = c * dt;
    let decay = (-u).exp();
    let (q, p) = if u.abs() < 0.5 {
        let (mut term, mut p) = (0.5, 0.5);
        for k in 3..=16 {
            term *= -u / k as f64;
            p += term;
        }
        (dt * (1.0 - u * p), p)
    } else {
        ((1.0 - decay) / c, (decay - 1.0 + u) / (u * u))
    };
    (x + q * v + dt * dt * p * a, decay * v + q * a)
}
)";

constexpr const char* kJavascriptMove =
    R"(function dampedMove(x, v, a, c, dt) {
  const u = c * dt, decay = Math.exp(-u);
  let q, p;
  if (Math.abs(u) < 0.5) {
    let term = 0.5;
    p = 0.5;
    for (let k = 3; k <= 16; ++k) { term *= -u / k; p += term; }
    q = dt * (1 - u * p);
  } else {
    q = (1 - decay) / c;
    p = (decay - 1 + u) / (u * u);
  }
  return [x + q * v + dt * dt * p * a, decay * v + q * a];
}
)";

}  // namespace

std::string damping_code(Language language) {
  const std::string mark = language == Language::python || language == Language::gdscript ? "# " : "// ";
  const std::string about = mark +
                            "Moves a body by dt under the constant acceleration a and the drag -c v (c >= 0, "
                            "in 1/s): exact, so the\n" +
                            mark +
                            "same at every frame rate. Written by shortfall. What it writes is yours.\n";
  switch (language) {
    case Language::csharp:
      return about + kCSharpMove;
    case Language::cpp:
      return "#include <cmath>\n\n" + about + kCppMove;
    case Language::gdscript:
      return about + kGdscriptMove;
    case Language::python:
      return "import math\n\n\n" + about + kPythonMove;
    case Language::rust:
      return about + kRustMove;
    case Language::javascript:
      return about + kJavascriptMove;
  }
  return {};
}

}  // namespace shortfall

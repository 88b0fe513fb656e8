// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Everything that the library offers. Numbers of MPFR (analysis/algebra/real.hpp) stay apart, for their
// weight.

#include "analysis/algebra/ball.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/linear_solve.hpp"
#include "analysis/algebra/polynomial.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/correction/jump.hpp"
#include "analysis/audit/program_audit.hpp"
#include "analysis/audit/tableau_audit.hpp"
#include "analysis/correction/kit.hpp"
#include "analysis/correction/kit_numbers.hpp"
#include "analysis/correction/linear_kit.hpp"
#include "analysis/motion/derivation.hpp"
#include "analysis/motion/linear_derivation.hpp"
#include "analysis/motion/numeric_motion.hpp"
#include "analysis/motion/verify.hpp"
#include "analysis/problems/linear_force.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/series/splitting_corrector.hpp"
#include "analysis/series/splitting_report.hpp"
#include "analysis/stability/stability.hpp"

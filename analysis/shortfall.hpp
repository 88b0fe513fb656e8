// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Everything that the library offers, in the order of its layers.

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/linear_solve.hpp"
#include "analysis/algebra/polynomial.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/program/catalogue_data.hpp"

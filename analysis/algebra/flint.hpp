// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one place that includes FLINT (2.9 of Debian 12, 3.x of Debian 13), so that its macros reach few files
// and differences between its versions are settled here. GMP comes first: FLINT declares its conversions only
// then.

#include <gmpxx.h>

#include <flint/flint.h>
#include <flint/fmpz.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_mpoly_factor.h>

// FLINT 2.9 defines ulong as a macro.
using FlintWord = ulong;
using FlintSize = slong;
#ifdef ulong
#undef ulong
#endif

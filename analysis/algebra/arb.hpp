// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one place that includes Arb: a library of its own beside FLINT 2.9 (Debian 12), a part of FLINT 3
// (Debian 13, Ubuntu 24.04).

#include <gmpxx.h>
#if __has_include(<flint/arb.h>)
#include <flint/acb.h>
#include <flint/arb.h>
#include <flint/arb_fmpz_poly.h>
#include <flint/fmpq.h>
#else
#include <acb.h>
#include <arb.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpq.h>
#endif

// FLINT 2.9 defines ulong as a macro.
using FlintSize = slong;
#ifdef ulong
#undef ulong
#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace shortfall::bench {

/// The most that a piece of work has on the heap at a time beyond what was there before, by operator new and
/// by GMP and MPFR. A program that this is linked to counts every allocation, which makes all of them a
/// little slower.
///
/// units   bytes
double peak_heap(const std::function<void()>& work);

}  // namespace shortfall::bench

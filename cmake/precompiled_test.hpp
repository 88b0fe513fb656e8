// SPDX-License-Identifier: GPL-3.0-or-later
// What nearly every test includes, parsed once.
#pragma once

#include "precompiled.hpp"

#include <doctest/doctest.h>

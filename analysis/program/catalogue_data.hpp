// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/program/embedded_file.hpp"

namespace shortfall {

/// The whole catalogue, the .integrator files of integrators/, sorted by path:
/// "euler/symplectic-euler.integrator".
std::span<const EmbeddedFile> catalogue_files();

}  // namespace shortfall

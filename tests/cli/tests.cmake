# SPDX-License-Identifier: GPL-3.0-or-later
if(SHORTFALL_MPI)
  target_compile_definitions(test_cli PRIVATE SHORTFALL_MPIRUN="${SHORTFALL_MPIRUN}")
endif()

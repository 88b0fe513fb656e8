# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DNM=... -DLIBRARY=... -P shared_functions.cmake: in the files of a library that are compiled for AVX2, every
# function that the linker may share with other files has to say so in its name.
execute_process(COMMAND "${NM}" -A -C "${LIBRARY}" OUTPUT_VARIABLE symbols RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${NM} cannot read ${LIBRARY}")
endif()
string(REPLACE ";" "," symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
set(seen 0)
set(tagged 0)
foreach(line IN LISTS symbols)
  if(NOT line MATCHES "lanes_avx2_[a-z]+\\.cpp\\.o:")
    continue()
  endif()
  math(EXPR seen "${seen} + 1")
  if(NOT line MATCHES "\\.cpp\\.o:[^ ]* [WVu] ")
    continue()
  elseif(line MATCHES "Avx2")
    math(EXPR tagged "${tagged} + 1")
  elseif(NOT line MATCHES " V DW\\.ref\\.")  # a pointer, no code
    message(SEND_ERROR "compiled for AVX2, and could be taken for every processor: ${line}")
  endif()
endforeach()
# A compiler may put every function into its callers: then there is none to share, but the files are there.
if(seen EQUAL 0)
  message(FATAL_ERROR "no symbol of the AVX2 files was found in ${LIBRARY}")
endif()
message(STATUS "${seen} symbols, ${tagged} of shared functions, all of these with Avx2 in their names")

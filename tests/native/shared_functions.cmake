# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DNM=... -DLIBRARY=... -P shared_functions.cmake: in the files of a library that are compiled for AVX2, every
# function that the linker may share with other files has to say so in its name.
execute_process(COMMAND "${NM}" -A -C "${LIBRARY}" OUTPUT_VARIABLE symbols RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${NM} cannot read ${LIBRARY}")
endif()
string(REPLACE ";" "," symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
set(tagged 0)
foreach(line IN LISTS symbols)
  if(NOT line MATCHES "lanes_avx2_[a-z]+\\.cpp\\.o:[^ ]* [WVu] ")
    continue()
  elseif(line MATCHES "Avx2")
    math(EXPR tagged "${tagged} + 1")
  elseif(NOT line MATCHES " V DW\\.ref\\.")  # a pointer, no code
    message(SEND_ERROR "compiled for AVX2, and could be taken for every processor: ${line}")
  endif()
endforeach()
if(tagged EQUAL 0)
  message(FATAL_ERROR "no function of the AVX2 files was found in ${LIBRARY}")
endif()
message(STATUS "${tagged} functions, all with Avx2 in their names")

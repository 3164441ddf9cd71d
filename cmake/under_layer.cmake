# SPDX-License-Identifier: MIT
# add_test, but with the layer under the program.
#
#   add_layer_test(NAME name COMMAND cmd args... [DEVICE d] [CLOCK c] [REPORT file] [ENVIRONMENT K=V ...]
#                  [LABELS l...] [TIMEOUT s])
#
# The preload line stands here once: with a sanitizer its runtime has to come first.
set(GLEXT_EMU_PRELOAD $<TARGET_FILE:glext_emu>)
if(SANITIZE STREQUAL "address")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libasan.so
                  OUTPUT_VARIABLE asan_runtime OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(GLEXT_EMU_PRELOAD "${asan_runtime}:${GLEXT_EMU_PRELOAD}")
elseif(SANITIZE STREQUAL "thread")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libtsan.so
                  OUTPUT_VARIABLE tsan_runtime OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(GLEXT_EMU_PRELOAD "${tsan_runtime}:${GLEXT_EMU_PRELOAD}")
endif()

function(add_layer_test)
  cmake_parse_arguments(T "" "NAME;DEVICE;CLOCK;REPORT;TIMEOUT" "COMMAND;ENVIRONMENT;LABELS" ${ARGN})
  add_test(NAME ${T_NAME} COMMAND ${T_COMMAND})
  set(settings "")
  foreach(key DEVICE CLOCK REPORT)
    if(T_${key})
      string(TOLOWER ${key} lower)
      list(APPEND settings "${lower}=${T_${key}}")
    endif()
  endforeach()
  list(JOIN settings "," settings)
  set(environment "LD_PRELOAD=${GLEXT_EMU_PRELOAD}" "ASAN_OPTIONS=detect_leaks=0" ${T_ENVIRONMENT})
  if(settings)
    list(APPEND environment "GLEXT_EMU=${settings}")
  endif()
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 120)
  endif()
  set_tests_properties(${T_NAME} PROPERTIES ENVIRONMENT "${environment}" LABELS "${T_LABELS}"
                       TIMEOUT ${T_TIMEOUT} SKIP_RETURN_CODE 77)
endfunction()

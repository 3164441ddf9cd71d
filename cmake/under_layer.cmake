# SPDX-License-Identifier: MIT
# add_test, but with the layer under the program.
#
#   add_layer_test(NAME name COMMAND cmd args... [DEVICE d] [CLOCK c] [REPORT file] [FRONT f] [ENVIRONMENT K=V ...]
#                  [LABELS l...] [TIMEOUT s])
#
# FRONT says how the layer gets under the program: seam (without it), vendor or export. The preload lines stand here
# once: with a sanitizer its runtime has to come first.
set(GLEXT_EMU_PRELOAD $<TARGET_FILE:glext_emu>)
set(GLEXT_EMU_EXPORTS $<TARGET_FILE:glext_emu_exports>)
set(sanitizer_runtime "")
if(SANITIZE STREQUAL "address")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libasan.so
                  OUTPUT_VARIABLE sanitizer_runtime OUTPUT_STRIP_TRAILING_WHITESPACE)
elseif(SANITIZE STREQUAL "thread")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libtsan.so
                  OUTPUT_VARIABLE sanitizer_runtime OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
set(GLEXT_EMU_VENDOR
    __GLX_VENDOR_LIBRARY_NAME=glextemu
    __EGL_VENDOR_LIBRARY_FILENAMES=$<TARGET_FILE_DIR:glext_emu_vendor>/50_glextemu.json
    LD_LIBRARY_PATH=$<TARGET_FILE_DIR:glext_emu_vendor>)
if(sanitizer_runtime)
  set(GLEXT_EMU_PRELOAD "${sanitizer_runtime}:${GLEXT_EMU_PRELOAD}")
  set(GLEXT_EMU_EXPORTS "${sanitizer_runtime}:${GLEXT_EMU_EXPORTS}")
  list(APPEND GLEXT_EMU_VENDOR "LD_PRELOAD=${sanitizer_runtime}")
endif()

function(add_layer_test)
  cmake_parse_arguments(T "" "NAME;DEVICE;CLOCK;REPORT;FRONT;TIMEOUT" "COMMAND;ENVIRONMENT;LABELS" ${ARGN})
  add_test(NAME ${T_NAME} COMMAND ${T_COMMAND})
  set(settings "")
  foreach(key DEVICE CLOCK REPORT)
    if(T_${key})
      string(TOLOWER ${key} lower)
      list(APPEND settings "${lower}=${T_${key}}")
    endif()
  endforeach()
  list(JOIN settings "," settings)
  if(NOT T_FRONT OR T_FRONT STREQUAL "seam")
    set(environment "LD_PRELOAD=${GLEXT_EMU_PRELOAD}")
  elseif(T_FRONT STREQUAL "vendor")
    set(environment ${GLEXT_EMU_VENDOR})
  elseif(T_FRONT STREQUAL "export")
    set(environment "LD_PRELOAD=${GLEXT_EMU_EXPORTS}")
  else()
    message(FATAL_ERROR "${T_NAME}: FRONT is seam, vendor or export, not ${T_FRONT}")
  endif()
  list(APPEND environment "ASAN_OPTIONS=detect_leaks=0" ${T_ENVIRONMENT})
  if(settings)
    list(APPEND environment "GLEXT_EMU=${settings}")
  endif()
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 120)
  endif()
  set_tests_properties(${T_NAME} PROPERTIES ENVIRONMENT "${environment}" LABELS "${T_LABELS}"
                       TIMEOUT ${T_TIMEOUT} SKIP_RETURN_CODE 77)
endfunction()

# SPDX-License-Identifier: MIT
# How an extension's program is built, and on which machines ctest runs it.
#
#   add_conformance_program(EXTENSION sources...)
#   add_native_conformance(EXTENSION [NAME n] [REQUIRE e] [PLATFORM p] [SOFTPIPE] [ONLY t...] [WITHOUT t...])
#   add_emulated_conformance(EXTENSION [NAME n] [REQUIRE e] [PLATFORM p] [SOFTPIPE] [ONLY t...] [WITHOUT t...]
#                            [DEVICE d] [CLOCK c] [FRONT seam|vendor|export])
#
# A run is the test conformance.native.EXTENSION or conformance.emu.EXTENSION, followed by what it is run with, each
# part where it is given: NAME, FRONT, PLATFORM, `softpipe`.
#
#   REQUIRE   the name in the extension string: a machine without it fails instead of being skipped
#   PLATFORM  egl (without it), glx (on a display of its own) or osmesa (skipped where the library is missing); GLX
#             alone is PLATFORM glx
#   SOFTPIPE  on Mesa's second software driver, which shares no rasteriser with the first
#   ONLY      the tests that make sense on a machine made for them
#   WITHOUT   what a machine is known to do otherwise than the text says: those tests run apart, one each, and have to
#             fail (not to crash, nor to be missing), so that a mended machine is noticed
#
# Every run writes what became of each of its tests (GoogleTest's JSON), and stands as one line in the list of runs;
# table.py makes the table of statements of both.
set(CONFORMANCE_OUTPUT ${CMAKE_BINARY_DIR}/conformance CACHE INTERNAL "where the runs leave their results")
file(WRITE ${CONFORMANCE_OUTPUT}/runs.tsv
     "run\tresults\tfolder\tkind\tdriver\tfront\tplatform\tdevice\tclock\tdeparture\n")

function(add_conformance_program extension)
  add_executable(conformance_${extension} ${ARGN})
  target_link_libraries(conformance_${extension} PRIVATE conformance_harness)
endfunction()

function(conformance_filter out_variable only without)
  list(JOIN only ":" chosen)
  list(JOIN without ":" left_out)
  set(filter "")
  if(only OR without)
    set(filter "--gtest_filter=${chosen}")
    if(without)
      string(APPEND filter "-${left_out}")
    endif()
  endif()
  set(${out_variable} ${filter} PARENT_SCOPE)
endfunction()

# One test of ctest: T_* as parsed by add_conformance_run.
function(conformance_run kind extension name departure filter)
  string(REPLACE "/" "_" file ${name})
  set(results ${CONFORMANCE_OUTPUT}/results/${file}.json)
  get_target_property(folder conformance_${extension} SOURCE_DIR)
  cmake_path(GET folder FILENAME folder)
  set(driver llvmpipe)
  set(environment GTEST_OUTPUT=json:${results})
  if(T_SOFTPIPE)
    set(driver softpipe)
    list(APPEND environment GALLIUM_DRIVER=softpipe)
  endif()
  string(JOIN "\t" line ${name} ${results} ${folder} ${kind} ${driver} ${T_FRONT} ${T_PLATFORM}
         "${T_DEVICE}" "${T_CLOCK}" "${departure}")
  file(APPEND ${CONFORMANCE_OUTPUT}/runs.tsv "${line}\n")

  set(command $<TARGET_FILE:conformance_${extension}>)
  if(T_REQUIRE AND NOT departure)
    list(APPEND command --require ${T_REQUIRE})
  endif()
  list(APPEND command --platform ${T_PLATFORM})
  if(T_PLATFORM STREQUAL "glx")
    set(command xvfb-run --auto-servernum "--server-args=-noreset +iglx -screen 0 640x480x24"
                ${command})
  endif()
  if(kind STREQUAL "native")
    add_test(NAME ${name} COMMAND ${command} ${filter})
    set_tests_properties(${name} PROPERTIES LABELS conformance SKIP_RETURN_CODE 77 TIMEOUT 120
                         ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0;${environment}")
  else()
    set(front "")
    if(NOT T_FRONT STREQUAL "seam")
      set(front FRONT ${T_FRONT})
    endif()
    add_layer_test(NAME ${name} COMMAND ${command} ${filter} DEVICE ${T_DEVICE} CLOCK ${T_CLOCK} ${front}
                   LABELS conformance ENVIRONMENT ${environment})
  endif()
  if(departure)
    set_tests_properties(${name} PROPERTIES PASS_REGULAR_EXPRESSION "FAILED  . ${departure}")
    # No skip but of an optional library: a departure that does not run is not noticed when it is mended.
    if(NOT T_PLATFORM STREQUAL "osmesa")
      set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE -1)
    endif()
  endif()
endfunction()

function(add_conformance_run kind extension)
  cmake_parse_arguments(T "GLX;SOFTPIPE" "NAME;REQUIRE;PLATFORM;DEVICE;CLOCK;FRONT" "ONLY;WITHOUT" ${ARGN})
  if(T_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "conformance of ${extension}: ${T_UNPARSED_ARGUMENTS} is no argument of a run")
  endif()
  if(T_GLX)
    set(T_PLATFORM glx)
  endif()
  set(parts ${T_NAME} ${T_FRONT} ${T_PLATFORM})
  if(T_SOFTPIPE)
    list(APPEND parts softpipe)
  endif()
  list(REMOVE_DUPLICATES parts)  # NAME glx PLATFORM glx
  list(JOIN parts "." parts)
  set(name conformance.${kind}.${extension})
  if(parts)
    string(APPEND name .${parts})
  endif()
  if(NOT T_PLATFORM)
    set(T_PLATFORM egl)
  endif()
  if(kind STREQUAL "native")
    set(T_FRONT none)
  elseif(NOT T_FRONT)
    set(T_FRONT seam)
  endif()
  conformance_filter(filter "${T_ONLY}" "${T_WITHOUT}")
  conformance_run(${kind} ${extension} ${name} "" "${filter}")
  foreach(departure ${T_WITHOUT})
    conformance_run(${kind} ${extension} ${name}.departure.${departure} ${departure} --gtest_filter=${departure})
  endforeach()
endfunction()

# The program of an extension on the bare driver.
function(add_native_conformance extension)
  add_conformance_run(native ${extension} ${ARGN})
endfunction()

# The same program with the layer under it, on a device.
function(add_emulated_conformance extension)
  add_conformance_run(emu ${extension} ${ARGN})
endfunction()

# SPDX-License-Identifier: MIT
# What a row of CMakeLists.txt is made of: load_target and load_path.
set(window_system_glx X11::X11)
set(window_system_egl "")
set(window_system_osmesa "")
set(define_glx LOAD_GLX)
set(define_egl "")
set(define_osmesa LOAD_OSMESA)

# load_target(kind name platform SOURCES... LINK...): one target, load_<name>_<platform>.
function(load_target kind name platform)
  cmake_parse_arguments(L "" "" "SOURCES;LINK" ${ARGN})
  set(target load_${name}_${platform})
  if(kind STREQUAL "program")
    add_executable(${target} ${L_SOURCES})
  else()
    add_library(${target} MODULE ${L_SOURCES})
    set_target_properties(${target} PROPERTIES PREFIX "")
  endif()
  target_compile_definitions(${target} PRIVATE ${define_${platform}})
  target_link_libraries(${target} PRIVATE house ${window_system_${platform}} ${CMAKE_DL_LIBS} ${L_LINK})
endfunction()

# The layer's own part of a preload line that a test writes itself: without a sanitizer's runtime.
set(preloaded_by_seam $<TARGET_FILE:glext_emu>)
set(preloaded_by_export $<TARGET_FILE:glext_emu_exports>)
set(preloaded_by_vendor "")

# load_path(NAME COMMAND cmd... [FRONTS f...] [BEFORE library] [AFTER library] [ENVIRONMENT K=V...] [LABELS l...]
#           [NO_CONTROL])
# registers load.NAME with the layer by the seam, load.NAME.vendor and load.NAME.export by the other front ends
# (FRONTS: by these only), and load.NAME.control, without the layer. BEFORE and AFTER: another preload.
function(load_path name)
  cmake_parse_arguments(L "NO_CONTROL" "BEFORE;AFTER" "COMMAND;FRONTS;ENVIRONMENT;LABELS" ${ARGN})
  if(NOT L_FRONTS)
    set(L_FRONTS seam vendor export)
  endif()
  foreach(front ${L_FRONTS})
    set(test load.${name})
    if(NOT front STREQUAL "seam")
      string(APPEND test .${front})
    endif()
    set(preload "")
    if(L_BEFORE OR L_AFTER)
      set(libraries ${L_BEFORE} ${preloaded_by_${front}} ${L_AFTER})
      list(JOIN libraries ":" preload)
      set(preload "LD_PRELOAD=${preload}")
    endif()
    add_layer_test(NAME ${test} COMMAND ${L_COMMAND} FRONT ${front} DEVICE visualize-fx LABELS load ${L_LABELS}
                   ENVIRONMENT EXPECT=layer ${L_ENVIRONMENT} ${preload})
  endforeach()
  if(L_NO_CONTROL)
    return()
  endif()
  add_test(NAME load.${name}.control COMMAND ${L_COMMAND})
  set(environment EXPECT=nothing ASAN_OPTIONS=detect_leaks=0 ${L_ENVIRONMENT})
  if(L_BEFORE OR L_AFTER)
    list(APPEND environment "LD_PRELOAD=${L_BEFORE}${L_AFTER}")
  endif()
  set_tests_properties(load.${name}.control PROPERTIES ENVIRONMENT "${environment}"
                       LABELS "load;${L_LABELS}" TIMEOUT 120 SKIP_RETURN_CODE 77)
endfunction()

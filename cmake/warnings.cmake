# SPDX-License-Identifier: MIT
# Every target of ours links `house`: warnings are errors, and the sanitizer of the preset.
add_library(house INTERFACE)
set_property(TARGET house PROPERTY INTERFACE_COMPILE_OPTIONS
  $<$<COMPILE_LANGUAGE:C,CXX>:-Wall> $<$<COMPILE_LANGUAGE:C,CXX>:-Wextra>
  $<$<COMPILE_LANGUAGE:C,CXX>:-Wpedantic> $<$<COMPILE_LANGUAGE:C,CXX>:-Wshadow>
  $<$<COMPILE_LANGUAGE:C,CXX>:-Wcast-align> $<$<COMPILE_LANGUAGE:C,CXX>:-Wvla>
  $<$<COMPILE_LANGUAGE:C,CXX>:-Werror>
  $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor> $<$<COMPILE_LANGUAGE:CXX>:-Woverloaded-virtual>
  $<$<COMPILE_LANGUAGE:CXX>:-Wextra-semi>)
# GCC 12 sees overlaps in `"literal" + std::string` that are not there (GCC bug 105651).
target_compile_options(house INTERFACE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict>)
if(SANITIZE)
  target_compile_options(house INTERFACE -fsanitize=${SANITIZE} -fno-omit-frame-pointer)
  target_link_options(house INTERFACE -fsanitize=${SANITIZE})
endif()

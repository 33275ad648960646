# Flags that decide the bits of a result travel with the engine (sudar_numerics); warnings do not.
add_library(sudar_numerics INTERFACE)
target_compile_features(sudar_numerics INTERFACE cxx_std_20)
# No contraction to fused multiply-add: with it the bits differ between compilers and processors.
target_compile_options(sudar_numerics INTERFACE -ffp-contract=off)
if(SUDAR_DOUBLE)
  target_compile_definitions(sudar_numerics INTERFACE SUDAR_DOUBLE)
endif()
if(SUDAR_SANITIZE)
  target_compile_options(sudar_numerics INTERFACE -fsanitize=${SUDAR_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(sudar_numerics INTERFACE -fsanitize=${SUDAR_SANITIZE})
endif()

set(warnings -Wall -Wextra -Wconversion -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Interposition is never wanted, and forbids inlining inside a shared library. (clang does not honour it anyway.)
  # -Wno-psabi: g++ notes that vectors wider than SSE's are passed otherwise where AVX is on; here it is on nowhere.
  list(APPEND warnings -fno-semantic-interposition -Wno-psabi)
  set(no_float_warning -Wno-float-conversion)
else()
  # A new clang blames us for what the stable_sort of an old libstdc++ calls.
  list(APPEND warnings -Wno-deprecated-declarations)
  set(no_float_warning -Wno-implicit-float-conversion)
endif()
add_library(sudar_warnings INTERFACE)
target_compile_options(sudar_warnings INTERFACE ${warnings})
# Outside src/ and include/ a user may write 0.8 for a Real. (For clang the exception must follow -Wconversion.)
add_library(sudar_user_warnings INTERFACE)
target_compile_options(sudar_user_warnings INTERFACE ${warnings} ${no_float_warning})
# What takes time while it runs is the engine, which keeps its flags; all else is compiled for longer than it computes.
target_compile_options(sudar_user_warnings INTERFACE $<$<CONFIG:Release>:-O1>)
if(SUDAR_QUICK_BUILD)
  target_compile_options(sudar_user_warnings INTERFACE -O0)
endif()

# sudar_folder(FILE…): the files of one folder of the engine, in the order in which they may include each other.
function(sudar_folder)
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  target_sources(sudar PRIVATE ${ARGN})
endfunction()

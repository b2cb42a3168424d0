# SPDX-License-Identifier: Apache-2.0
# Compiles kernels/BODY.inl once for each instruction set that the compiler can make; the machine decides at run time.
# BODY_body.h declares `struct NAMEBody` and `extern const Variants<NAMEBody> kNAME`.
function(ilot_simd_body target body name)
  set(BODY ${body})
  set(NAME ${name})
  set(isas baseline)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND isas avx2 avx512)
  endif()
  # GCC 12's own AVX-512 header sets off the uninitialized warnings, its bug 105593.
  set(flags_avx2 -mavx2 -mfma)
  set(flags_avx512 -mavx512f -mavx512vl -mavx512dq -mavx512bw
    $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized> $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  foreach(ISA IN LISTS isas)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/simd/${body}_${ISA}.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/kernels/simd/body.cpp.in ${source} @ONLY)
    target_sources(${target} PRIVATE ${source})
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${flags_${ISA}}" SKIP_PRECOMPILE_HEADERS ON)
  endforeach()
  set(variants ${CMAKE_CURRENT_BINARY_DIR}/simd/${body}_variants.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/kernels/simd/variants.cpp.in ${variants} @ONLY)
  target_sources(${target} PRIVATE ${variants})
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set_source_files_properties(${variants} ${PROJECT_SOURCE_DIR}/kernels/simd/variants.cpp
      PROPERTIES COMPILE_DEFINITIONS "ILOT_HAVE_X86_VARIANTS=1")
  endif()
endfunction()

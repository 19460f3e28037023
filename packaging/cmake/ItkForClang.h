// Debian's ITK knows only the compiler that built it: its itk_compiler_detection.h refuses any other than GCC. Clang
// compiles the rest of ITK's headers, so here it reads that one header as GCC 12 does. Every source that uses ITK is compiled
// with this file included first.
#pragma once

#pragma push_macro("__clang__")
#pragma push_macro("__GNUC__")
#undef __clang__
#undef __GNUC__
#define __GNUC__ 12
#include <itk_compiler_detection.h>
#pragma pop_macro("__GNUC__")
#pragma pop_macro("__clang__")

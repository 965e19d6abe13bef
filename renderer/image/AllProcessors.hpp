#pragma once

/// Compiles a function of vectors for several processors; which one is taken is decided when the program starts.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define THINWALL_FOR_ALL_PROCESSORS __attribute__((target_clones("avx2", "default")))
#else
#define THINWALL_FOR_ALL_PROCESSORS
#endif

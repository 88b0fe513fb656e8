// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/harness/heap.hpp"

#include <gmp.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> in_use = 0, most = 0;

void* counted(void* block) {
  if (!block) std::abort();
  const long now = in_use += static_cast<long>(malloc_usable_size(block));
  for (long known = most; now > known && !most.compare_exchange_weak(known, now);) {
  }
  return block;
}

void uncounted(void* block) { in_use -= static_cast<long>(malloc_usable_size(block)); }

void* allocate(std::size_t bytes) { return counted(std::malloc(bytes)); }

void release(void* block, std::size_t) {
  uncounted(block);
  std::free(block);
}

void* reallocate(void* block, std::size_t, std::size_t bytes) {
  uncounted(block);
  return counted(std::realloc(block, bytes));
}

}  // namespace

void* operator new(std::size_t bytes) { return counted(std::malloc(bytes > 0 ? bytes : 1)); }
void operator delete(void* block) noexcept {
  if (!block) return;
  uncounted(block);
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept { operator delete(block); }

namespace shortfall::bench {

double peak_heap(const std::function<void()>& work) {
  static const bool gmp_counts = [] {
    mp_set_memory_functions(allocate, reallocate, release);
    return true;
  }();
  static_cast<void>(gmp_counts);
  work();  // what is made once and kept
  const long before = in_use;
  most = before;
  work();
  return static_cast<double>(most - before);
}

}  // namespace shortfall::bench

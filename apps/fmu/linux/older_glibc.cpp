// SPDX-License-Identifier: BSD-3-Clause
// The C++ runtime of the compiler, linked into this library, asks the C library of the computer it was built on for
// four names that older versions lack. They are defined here and stay inside this library, so that it also loads where
// the C library is ten years older.
#include <dlfcn.h>
#include <link.h>
#include <pthread.h>

#include <atomic>
#include <cstddef>

#if defined(__GLIBC__)

#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>
/// Since 2.32. False, so that reference counts are always atomic.
char __libc_single_threaded = 0;
#endif

#if __GLIBC_PREREQ(2, 34)
/// In the C library itself since 2.34, in the library of threads before. The runtime only asks whether it exists.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name is that of the C library
extern "C" int __pthread_key_create(pthread_key_t*, void (*)(void*)) { return -1; }

/// Likewise. The other threads wait until the first one is ready.
extern "C" int pthread_once(pthread_once_t* control, void (*initialize)()) {
  constexpr int untouched = PTHREAD_ONCE_INIT, busy = 1, ready = 2;
  const std::atomic_ref<pthread_once_t> state(*control);
  int found = untouched;
  if (state.compare_exchange_strong(found, busy)) {
    initialize();
    state = ready;
  }
  while (state != ready) {
  }
  return 0;
}
#endif

#if defined(DLFO_STRUCT_HAS_EH_DBASE)
namespace {

struct Search {
  ElfW(Addr) address;
  dl_find_object* result;
};

/// Fills the part of the result that the runtime reads, if this object contains the address. @returns 1 if it does,
/// which ends the search
int describe(dl_phdr_info* object, std::size_t, void* data) {
  const Search& search = *static_cast<Search*>(data);
  const ElfW(Phdr)* table = nullptr;
  bool contains = false;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = object->dlpi_phdr[i];
    const ElfW(Addr) begin = object->dlpi_addr + part.p_vaddr, end = begin + part.p_memsz;
    if (part.p_type == PT_GNU_EH_FRAME) table = &part;
    if (part.p_type == PT_LOAD && search.address >= begin && search.address < end) contains = true;
  }
  if (!contains || table == nullptr) return 0;
  // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader gives addresses as integers
  search.result->dlfo_eh_frame = reinterpret_cast<void*>(object->dlpi_addr + table->p_vaddr);
  return 1;
}

}  // namespace

/// Since 2.35. The table with which the runtime finds the handler of an exception, for code at an address.
extern "C" int _dl_find_object(void* address, dl_find_object* result) {
  *result = {};
  Search search = {reinterpret_cast<ElfW(Addr)>(address), result};
  return dl_iterate_phdr(describe, &search) == 1 ? 0 : -1;
}
#endif

#endif  // __GLIBC__

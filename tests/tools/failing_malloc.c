/* Preloaded into the program under test: the call number FAILING_MALLOC of malloc and the like fails, and with
 * FAILING_MALLOC_AND_ALL_LATER every later one too. Calls before main count, those of other threads too. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* The names under which glibc offers its allocator to libraries that stand before it. */
extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* old, size_t size);
extern void* __libc_memalign(size_t alignment, size_t size);

static atomic_long calls;
static long failing = -1;
static int and_all_later;

static long number_of(const char* name) {
    const char* text = getenv(name);
    return text == NULL ? 0 : atol(text);
}

static int fails(void) {
    if (failing < 0) {
        failing = number_of("FAILING_MALLOC");
        and_all_later = getenv("FAILING_MALLOC_AND_ALL_LATER") != NULL;
    }
    const long call = atomic_fetch_add(&calls, 1) + 1;
    const int failed = failing > 0 && (call == failing || (and_all_later && call > failing));
    if (failed) {
        errno = ENOMEM;
    }
    return failed;
}

/* dlopen of glibc 2.36, by which oneTBB looks for its allocator, writes the error of a library that it cannot load through
 * a null pointer where it found no memory for the error itself (dlfcn/dlerror.c). That call, for 24 bytes and from the C
 * library, is left alone: nothing that the program does would help. */
static int is_for_dlerror(size_t size, const void* caller) {
    Dl_info info;
    return size == 24 && dladdr(caller, &info) != 0 && strstr(info.dli_fname, "/libc.so") != NULL;
}

void* malloc(size_t size) {
    return fails() && !is_for_dlerror(size, __builtin_return_address(0)) ? NULL : __libc_malloc(size);
}

void* calloc(size_t count, size_t size) { return fails() ? NULL : __libc_calloc(count, size); }

void* realloc(void* old, size_t size) { return fails() ? NULL : __libc_realloc(old, size); }

void* memalign(size_t alignment, size_t size) { return fails() ? NULL : __libc_memalign(alignment, size); }

void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }

int posix_memalign(void** result, size_t alignment, size_t size) {
    void* found = memalign(alignment, size);
    if (found == NULL) {
        return ENOMEM;
    }
    *result = found;
    return 0;
}

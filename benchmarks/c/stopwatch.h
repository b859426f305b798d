/* The clock of the C contestants. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static inline double now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1e9 + now.tv_nsec;
}

/* Everything in memory may be read or changed here: the compiler leaves nothing out and keeps nothing in mind. */
static inline void everything_counts(void)
{
    __asm__ volatile("" ::: "memory");
}
